# Sourced by ./test: tests of one demo that would read byte for byte what they passed with are not run again.
#
# The build lists them (tests/of-demos.txt, by mvgl_demo_test in tests/CMakeLists.txt). The key of one is a sum over its
# command and environment, what its program is linked from and the files that it may read, but for what is another
# demo's; and over the driver, the processor and the variables that a driver reads.

# The driver's own files, and all the libraries that they load.
driver_files() {
  local file
  { /sbin/ldconfig -p | sed -n 's/.*=> //p' | grep -E '/lib(OSMesa|EGL|EGL_mesa|GLX_mesa|gallium[^/]*)\.so' || true
    ls /usr/lib/*/dri/*swrast_dri.so /usr/lib/*/dri/libdril_dri.so 2>/dev/null || true; } | sort -u |
    while IFS= read -r file; do
      readlink -f "$file"
      ldd "$file" 2>/dev/null | sed -n 's/.*=> \(\/[^ ]*\).*/\1/p' | while IFS= read -r file; do readlink -f "$file"; done
    done | sort -u
}

machine_key() {
  { driver_files | xargs -d '\n' sha256sum
    sed -n '/^$/q; /^vendor_id\|^model name\|^flags/p' /proc/cpuinfo
    env | grep -E '^(LD_|LIBGL|MESA|GALLIUM|LP_|DRAW_|EGL|MVGL|ASAN_|UBSAN_|LSAN_|LANG|LC_)' | sort || true
  } | sha256sum
}

# What a program is linked from, and where it finds shaders: "PROGRAM FILE", the file as ninja names it, relative to the
# build folder.
link_inputs() {
  local folder=$1 program
  while IFS= read -r program; do
    (cd "$folder" && find lib/mvgl-shaders -type f -printf "$program %p\n" 2>/dev/null || true)
    ninja -C "$folder" -t query "$program" | awk -v program="$program" '
      /^  input:/ { inside = 1; next }
      /^  outputs:/ { inside = 0 }
      inside && $1 != "||" { print program, $NF }'
  done
}

machine=

# demo_keys FOLDER: "KEY TEST" for each test of one demo in the build folder.
demo_keys() {
  local folder=$1
  cut -d ' ' -f 3 "$folder/tests/of-demos.txt" | tr , '\n' | sort -u | link_inputs "$folder" >"$folder/tests/linked.txt"
  cut -d ' ' -f 2- "$folder/tests/linked.txt" | sort -u | (cd "$folder" && xargs -d '\n' sha256sum) >"$folder/tests/linked.sums"
  # What a test may read at run time: all that is neither compiled (the objects count) nor another test's. (Golden pictures
  # and pages count for the tests that say so.)
  tree_files | grep -zvE '\.(cpp|h|inc|cmake)$|^tests/(analysed(_with_headers)?.txt|site/|window/|fuzz/|package/|scripts/)|CMakeLists.txt$|^(scripts/|web/|test$|run$|\.)' |
    (cd "$root" && xargs -0 sha256sum) >"$folder/tests/read.sums"
  rm -rf "$folder/tests/keys" && mkdir -p "$folder/tests/keys"
  # One process for all sums: there are hundreds of tests.
  (cd "$root" && awk -v keys="$folder/tests/keys/" -v machine="$machine" -f scripts/demo_keys.awk "$folder/tests/of-demos.txt" \
    "$folder/tests/linked.txt" "$folder/tests/linked.sums" "$folder/tests/read.sums") >"$folder/tests/numbered.txt"
  (cd "$folder/tests/keys" && cut -d ' ' -f 2 ../numbered.txt | xargs -d '\n' sha256sum) |
    paste -d ' ' - "$folder/tests/numbered.txt" | awk '{ print $1, $3 }'
}

# is_demo FOLDER NAME: whether tests there are that demo's.
is_demo() { cut -d ' ' -f 2 "$1/tests/of-demos.txt" | grep -qFx -e "$2"; }

# test_results FOLDER: "TEST STATE SECONDS" for each test of the last run, by ctest's own report.
test_results() {
  sed -n 's/.*<testcase name="\([^"]*\)".* time="\([^"]*\)" status="\([a-z]*\)".*/\1 \3 \2/p' "$1/tests.xml"
}

# most_expensive FOLDER...: the ten tests that took longest in the last runs there, with their seconds, the longest first.
most_expensive() {
  local folder
  for folder in "$@"; do
    [ ! -f "$folder/tests.xml" ] || test_results "$folder" |
      awk -v where="$([ "$folder" = "$build" ] || echo " (${folder#"$build"/})")" '$2 == "run" || $2 == "fail" { printf "%8.1f s  %s%s\n", $3, $1, where }'
  done | sort -rn | sed -n 1,10p
}

# run_tests FOLDER AGAIN CTEST-ARGUMENT...: all tests that the arguments choose, but for those of demos that have passed with
# the same bytes; with AGAIN true all. What passes is noted, unless something changed meanwhile.
run_tests() {
  local folder=$1 again=$2 status=0 key name state skipped=()
  shift 2
  mkdir -p "$folder/passed"
  [ -n "$machine" ] || machine=$(machine_key)
  demo_keys "$folder" >"$folder/tests/keys-before.txt"
  while read -r key name; do
    $again || [ "$(cat "$folder/passed/$name" 2>/dev/null)" != "$key" ] || skipped+=("${name//./\\.}")
  done <"$folder/tests/keys-before.txt"
  if [ ${#skipped[@]} -gt 0 ]; then
    echo "${#skipped[@]} tests of demos are left out: all that they read is as it was when they passed (--all runs them)"
    set -- "$@" -E "^($(IFS='|' && echo "${skipped[*]}"))\$"
  fi
  rm -f "$folder/tests.xml"
  (cd "$root" && ctest "$@" --output-on-failure --output-junit "$folder/tests.xml" 9>&-) || status=$?  # what a test leaves behind holds no lock
  demo_keys "$folder" >"$folder/tests/keys-after.txt"
  local -A unchanged=()
  while read -r key name; do unchanged[$name]=$key; done < <(
    grep -Fx -f "$folder/tests/keys-before.txt" "$folder/tests/keys-after.txt")
  while read -r name state _; do
    rm -f "$folder/passed/$name"
    [ "$state" != run ] || [ -z "${unchanged[$name]:-}" ] || echo "${unchanged[$name]}" >"$folder/passed/$name"
  done < <(test_results "$folder")
  return "$status"
}
