#!/usr/bin/env bash
# scripts_test.sh CASE SOURCE BUILD: one test of ./run, ./test and scripts/, in a scratch tree that has them and, in the place of
# mvgl, the small project beside this file. (BUILD is mvgl's own build folder.) Nothing is installed: the scripts are told that every package is there.
set -u
case=$1 source=$2 built=$3
scratch=$(cd "$(mktemp -d)" && pwd -P) || exit 1
trap 'rm -rf "$scratch"' EXIT
unset DISPLAY WAYLAND_DISPLAY CXX MAKEFLAGS
export GIT_CEILING_DIRECTORIES=$scratch GIT_CONFIG_GLOBAL=/dev/null

failures=0
fail() {
    echo "FAILED: $*"
    failures=$((failures + 1))
}
equal() { [ "$2" = "$3" ] || fail "$1: expected '$2', found '$3'"; }
says() { grep -qe "$2" "$1" || fail "no line '$2' in $1: $(cat "$1")"; }
silent() { ! grep -qe "$2" "$1" || fail "a line '$2' in $1: $(cat "$1")"; }

# tool NAME LINE...: a program of that name that goes before the system's.
mkdir "$scratch/bin" && PATH=$scratch/bin:$PATH
tool() {
    printf '#!/usr/bin/env bash\n' >"$scratch/bin/$1"
    printf '%s\n' "${@:2}" >>"$scratch/bin/$1"
    chmod +x "$scratch/bin/$1"
}
tool dpkg-query 'echo "install ok installed"'
tool clang-format 'exit 0'
tool emcmake 'exec "$@"' # the module of the small project is no WebAssembly
tool hb-subset
tool npm 'mkdir -p node_modules/puppeteer-core'
# Finds fault with a file that has the word FAULT.
tool clang-tidy 'file=${@: -1}; echo "$file" >>"$(dirname "$0")/../analysed.log"' '! grep -n FAULT "$file"'

tree=$scratch/tree
mkdir "$tree" && cp -r "$source/tests/scripts/project/." "$source/scripts" "$source/run" "$source/test" "$source/.clang-tidy" "$tree" || exit 1
mkdir "$tree/tests/site" && cp "$source"/tests/site/{package.json,package-lock.json,.npmrc} "$tree/tests/site" || exit 1
touch "$tree/tests/.clang-tidy"
cd "$tree" || exit 1
printf 'build/\nruns.log\nout\nerr\n' >.gitignore
commit() { git init -q . && git add -A && git -c user.name=a -c user.email=a@example.invalid commit -qm all; }
# Which tests have run since the last look, and which files were analysed.
ran() { sort runs.log 2>/dev/null | tr '\n' ' '; rm -f runs.log; }
looked() { sort "$scratch/analysed.log" 2>/dev/null | sed "s|$tree/||" | tr '\n' ' '; rm -f "$scratch/analysed.log"; }
everything() { ./test "$@" >out 2>err || fail "./test $*: $(cat out err)"; }

# Until the command succeeds; a broken script is to be told, not to be waited for.
waitFor() {
    for _ in $(seq 1200); do
        "$@" 2>/dev/null && return
        sleep 0.1
    done
    fail "waited in vain for: $*"
}

flags() {
    ./run one >out 2>err || fail "./run one: $(cat err)"
    says out "one --shot $tree/build/gallery/one.png"
    says err 'no display; the picture is build/gallery/one.png'
    for flag in --study=out '--study out' --audit --report --report=json --knobs --list --help --version --copyable '--frames 1..3' --headless; do
        # shellcheck disable=SC2086  # a flag and its value
        ./run one $flag >out 2>err || fail "./run one $flag: $(cat err)"
        says out "^from $tree: one $flag\$"
        equal "what is said of $flag" "" "$(cat err)"
    done
    for flag in --shot --study; do
        ./run one two $flag out >out 2>err && fail "two demos write one file: $(cat out)"
        says err "^error: $flag: must"
    done
}

# The pages appear whole or not at all, and are served where it is asked.
site() {
    tool node 'if [ "$(basename "$1")" = serve.mjs ]; then echo "serves ${@:2}"; exit; fi' \
        'mkdir -p "$3" && echo "$(cat words)" >"$3/index.html" && echo "${4:-}" >"$3/module" && echo "$MVGL_SITE" >"$3/address" && [ ! -e broken ]'
    echo first >words
    ./run --site >out 2>err || fail "./run --site: $(cat err)"
    says out "^./run --site --serve shows them"
    equal "the module" "$tree/build/web" "$(cat build/site/module)"
    [ -e build/web/mvgl.wasm ] || fail "no module was built"
    # (PATH without any tool)
    (. scripts/setup.sh && PATH=$scratch/none && build_web) >out 2>err && fail "a module without tools: $(cat out)"
    says err "^note: the pages have pictures in the place of live demos"
    ./run --site=https://example.org/course/ >out 2>err || fail "./run --site=https://example.org/course/: $(cat err)"
    equal "the address" "https://example.org/course/" "$(cat build/site/address)"
    for wrong in --site= --site=example.org/ --site=https://example.org; do
        ./run $wrong >out 2>err && fail "./run $wrong: $(cat out)"
        says err '^error: --site: must be an address'
    done
    echo second >words && touch broken
    ./run --site >out 2>err && fail "a site that could not be made: $(cat out)"
    equal "the pages that stand" first "$(cat build/site/index.html)"
    [ ! -e build/site.new ] || fail "half a site is left"
    rm broken
    ./run --site --serve >out 2>err || fail "./run --site --serve: $(cat err)"
    equal "the new pages" second "$(cat build/site/index.html)"
    says out "^serves $tree/build/site 8000\$"
    ./run --site --serve=81 >out 2>err || fail "./run --site --serve=81: $(cat err)"
    says out "^serves $tree/build/site 81\$"
    for wrong in one --list --serve= --serve=x --serve=123456 --serve=70000 '--serve --serve'; do
        # shellcheck disable=SC2086  # two words
        ./run --site $wrong >out 2>err && fail "./run --site $wrong: $(cat out)"
        says err '^error: --'
    done
}

moved() {
    ./run one --list >out 2>err || fail "./run: $(cat err)"
    # A copied tree is built from its own sources, and a moved one in its own place.
    for change in "cp -r" mv; do
        rm -rf "$scratch/other"
        $change "$tree" "$scratch/other" && cd "$scratch/other" || exit 1
        timeout 120 ./run one --list >out 2>err || fail "./run after $change: $(cat err)"
        says err "^note: $scratch/other/build was made in $tree/build, of the sources in $tree; configuring"
        says out "^from $scratch/other: one --list\$"
        ./run one --list >out 2>err || fail "./run again after $change: $(cat err)"
        equal "what is said the second time" "" "$(cat err)"
        cd "$tree" 2>/dev/null || true
    done
}

# Two at once in a tree that was never built: one builds, and the other says that it waits.
waiting() {
    tool cmake '[ "$1" = --version ] || touch configuring' '[ "$1" = --version ] || until [ -e go-on ]; do sleep 0.1; done' \
        "exec $(PATH=${PATH#*:} command -v cmake) \"\$@\""
    ./run one --list >out 2>err &
    waitFor test -e configuring
    ./run one --list >out2 2>err2 &
    waitFor grep -q waiting err2
    touch go-on
    wait
    says err2 '^note: waiting for another ./run or ./test that is at work in build$'
    says out "one --list"
    says out2 "one --list"
    silent err2 'Building'
}

# ./run builds what the named demos need, and the window where one opens.
needed() {
    made() { (cd build && find bin lib -type f 2>/dev/null | sort | tr '\n' ' '); }
    ./run one --list >out 2>err || fail "./run one: $(cat err)"
    says out "^from $tree: one --list\$"
    equal "what one demo needs" "bin/one " "$(made)"
    DISPLAY=:9 ./run one --shot out >out 2>err || fail "./run one --shot: $(cat err)"
    equal "what a picture needs" "bin/one " "$(made)"
    DISPLAY=:9 ./run one >out 2>err || fail "./run one on a display: $(cat err)"
    says out "^from $tree: one\$"
    equal "what a window needs" "bin/one lib/libwindow-module.so " "$(made)"
    rm -r build/lib
    ./run one --window >out 2>err || fail "./run one --window: $(cat err)"
    equal "a window that is asked for" "bin/one lib/libwindow-module.so " "$(made)"
    ./run one two --list >out 2>err || fail "./run one two: $(cat err)"
    equal "two demos" "bin/one bin/two lib/libwindow-module.so " "$(made)"
    # What is no demo is the launcher's to refuse, which knows them all.
    for wrong in tow ../demos/one one.cpp; do
        rm -rf build/bin
        ./run one "$wrong" --list >out 2>err || fail "./run one $wrong: $(cat err)"
        says out "^from $tree: $wrong --list\$"
        equal "the launcher for $wrong" "bin/mvgl lib/libwindow-module.so " "$(made)"
    done
    # Of mvgl itself: no other demo is compiled, no test and no window.
    ninja -C "$built" -t commands cube-cull >commands || fail "mvgl's build has no target cube-cull"
    equal "the demos that cube-cull compiles" "demo-cube-cull.dir" "$(grep -o 'CMakeFiles/demo-[^/]*' commands | sed 's|.*/||' | sort -u | xargs)"
    silent commands ' -c [^ ]*/\(tests\|common/mv/window\)/'
    ninja -C "$built" -t commands window >commands || fail "mvgl's build has no target window"
    says commands ' -c [^ ]*/common/mv/window/'
}

# A demo's name chooses its tests, and no other demo's whose name has it in it.
only() {
    sed -i 's/ITEMS one two)/ITEMS one one-more two)/; s/mvgl one one-more two/mvgl one two/; s/\(\$<TARGET_OBJECTS:\)demo-two>/\1demo-one-more> &/' CMakeLists.txt
    sed 's/"one"/"one-more"/' demos/one.cpp >demos/one-more.cpp
    mkdir demos/one demos/one-more # a demo is a folder
    ./test --only one >out 2>err || fail "./test --only one: $(cat out err)"
    equal "a demo" "one " "$(ran)"
    ./test --only one-more >out 2>err || fail "./test --only one-more: $(cat out err)"
    equal "another demo" "one-more " "$(ran)"
    ./test --only on >out 2>err || fail "./test --only on: $(cat out err)"
    equal "a regular expression" "one one-more " "$(ran)"
    ./test --only nothing >out 2>err && fail "no test of that name must fail"
    equal "no test" "" "$(ran)"
}

# All studies are those that a study file adds; none is an error.
studies() {
    ./test --update-studies >out 2>err && fail "no study must be an error"
    says err '^error: --update-studies: demos/\*/study.cpp must hold a study'
    mkdir demos/two && echo 'static const bool added = addStudy("two", study());' >demos/two/study.cpp
    mkdir -p build/studies/two && echo '# renderer: llvmpipe' >build/studies/two/study.csv
    ./test --update-studies >out 2>err || fail "./test --update-studies: $(cat out err)"
    says out ": two --study $tree/build/studies/two --headless$"
    silent out ': one --study'
    says docs/errors-and-times/two.processor.csv '^# renderer: llvmpipe$'
}

# What ./test --full does in its stage of static analysis: with the given commit, or none
analyse() {
    bash -euc '. scripts/setup.sh; . scripts/tree.sh; . scripts/analysis.sh; find_git; static_analysis "$@"' analyse "${1:-}" >out 2>err ||
        fail "analysing what differs from '${1:-}': $(cat out err)"
}

# What differs from the given commit, the last tag, or the commit before.
analysis() {
    commit
    analyse
    says out '^6 files to analyse$'
    equal "of one commit all is analysed" \
        "common/mvgl.cpp common/verdict.h common/window.cpp demos/one.cpp demos/two.cpp tests/claims.cpp " "$(looked)"
    git tag first
    echo '// more' >>common/verdict.h && commit && echo '// new' >demos/three.cpp && echo '// more' >>demos/one.cpp
    analyse
    says out '^2 files to analyse: what differs from first$'
    says out '^\[2 of 2\] '
    equal "what differs from the last tag" "common/verdict.h demos/one.cpp " "$(looked)"
    analyse HEAD
    equal "what differs from a commit" "demos/one.cpp " "$(looked)"
    git tag -d first >out && commit && echo '// FAULT' >>common/verdict.h
    ./test --full >out 2>err && fail "a fault in a header must be found"
    says err 'clang-tidy, g++: must find nothing; see above; in 1 files'
    says out '^== failed: static analysis$'
    equal "without a tag, what differs from the commit before" "common/verdict.h demos/one.cpp " "$(looked)"
    git checkout -q . && printf '#ifndef __clang__\n#error g++ reads it\n#endif\n' >>demos/one.cpp
    ./test --full >out 2>err && fail "what g++ refuses must be found"
    says out '^.*demos/one.cpp.*g++ reads it$'
    equal "g++ compiles what is analysed" "demos/one.cpp " "$(looked)"
    ./test --full --since nowhere >out 2>err && fail "a commit that there is not"
    says err '^error: --since: must be a commit'
    git checkout -q .
    everything
    equal "./test analyses nothing" "" "$(looked)"
    rm -rf .git
    analyse
    equal "without git all is analysed" \
        "common/mvgl.cpp common/verdict.h common/window.cpp demos/one.cpp demos/two.cpp tests/claims.cpp " "$(looked)"
}

# Without git, and in a clone that git does not trust, all is tested; and no word of formatting.
git_() {
    everything
    says err '^note: this source tree is in no git repository; its files are found without git$'
    equal "tests without git" "one two " "$(ran)"
    commit
    GIT_TEST_ASSUME_DIFFERENT_OWNER=1 ./test >out 2>err || fail "./test in another's clone: $(cat out err)"
    says err "^note: git trusts no clone of another user (git config --global --add safe.directory '$tree' lets it); its"
    mkdir inner && cp -r ./[!i]* ./.clang-tidy inner
    rm -rf inner/build && cd inner && everything
    says err 'note: this source tree is in no repository of its own'
    silent err formatting
}

# Each command builds and runs what it is to, says what it left, and a failure is told at once and at the end.
tiers() {
    commit
    everything
    equal "./test" "one two " "$(ran)"
    [ ! -e build/tests/test-sweep ] || fail "./test has built what it does not run"
    says out '^left to --full and --long, as are the sanitizers and static analysis, tests: 2$'
    says out '^== processor s, s$'
    for stage in build claims; do says out "^ *[0-9]* *[0-9]*  $stage\$"; done
    everything
    silent err 'Building'
    equal "./test again" "one two " "$(ran)"
    everything --full
    equal "--full, and the same under the sanitizers" "one one sweep sweep two two " "$(ran)"
    says out '^left to --long, as is what others ask longest, tests: 1$'
    everything --long
    equal "--long" "one one pairs pairs sweep sweep two two " "$(ran)"
    silent out '^left to'
    sed -i 's/LABELS claims/LABELS "claims;quick"/' CMakeLists.txt
    everything --full
    equal "--full, where the claims are quick" "sweep sweep " "$(ran)"
    everything
    equal "./test, where they are" "one two " "$(ran)"
    echo '"no"' >shaders/two.frag
    ./test >out 2>err && fail "a failure must fail"
    says out '^== failed: claims$'
    equal "after a failure" "one two " "$(ran)"
    ./test --only claims.one >out 2>err || fail "--only: $(cat out err)"
    equal "--only" "one " "$(ran)"
    ./test --only claims.two >out 2>err && fail "--only must fail, too"
    equal "--only" "two " "$(ran)"
    rm -rf build/tests/test-* build/bin
    ./test --only claims.one --repeat 3 >out 2>err || fail "--repeat: $(cat out err)"
    equal "--repeat 3" "one one one " "$(ran)"
    says out '^each passed 3 times in a row$'
    [ ! -e build/tests/test-sweep ] && [ ! -e build/bin/mvgl ] || fail "--only has built what it does not run"
    ./test --only sweep >out 2>err || fail "--only sweep: $(cat out err)"
    equal "--only what ./test does not build" "sweep " "$(ran)"
    for wrong in "--repeat 3" "--only one --repeat 0" "--only one --repeat x" "--only one --long" "--only" "--full --update-goldens" "--since HEAD" "-x"; do
        # shellcheck disable=SC2086  # several words
        ./test $wrong >out 2>err
        equal "status of ./test $wrong" 2 $?
        says err '^error: -'
    done
}

case $case in
    git) git_ ;;
    flags | site | moved | waiting | needed | analysis | tiers | only | studies) "$case" ;;
    *) fail "there is no case '$case'" ;;
esac
[ $failures -eq 0 ] && echo "passed: $case"
exit $((failures > 0))
