#!/usr/bin/env bash
# scripts/gpu.sh pack [FILE]   packs what a machine with a GPU needs to try the suite: programs, tests, golden pictures, libraries;
#                              build/gpu.tar.gz where no FILE is named. On the machine that built it (./test --full).
# ./gpu.sh [HOST]              where that is unpacked, with a driver and nothing else: presets, golden pictures, claims, each end of each
#                              knob, studies; within 6 minutes. HOST is egl where it is not named. Writes report.txt, a verdict a line,
#                              and studies/; what differs is in failures/. Ends with 1 where something failed.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

fail() {
  echo "error: $*" >&2
  exit 1
}

# The libraries that a program of ours takes, but for the C library, which is the machine's.
libraries_of() { ldd "$@" | awk '$3 ~ /^\// { print $3 }' | grep -vE '/(libc|libm|libpthread|libdl|librt|ld-linux[^/]*)\.so|/libmvgl' | sort -u; }

pack() {
  local root=$here/.. build=$here/../build file=${1:-$here/../build/gpu.tar.gz} program folder
  local programs=(bin/mvgl tests/test-visits tests/test-goldens tests/test-claims)
  for program in "${programs[@]}"; do
    [ -x "$build/$program" ] || fail "$program: must be built first; run: ./test --full, or ninja -C build ${program##*/}"
  done
  folder=$(mktemp -d)
  # shellcheck disable=SC2064
  trap "rm -rf '$folder'" EXIT
  mkdir -p "$folder"/mvgl/{bin,lib,loaders,tests}
  cp "$here/gpu.sh" "$folder/mvgl/"
  for program in "${programs[@]}"; do strip -o "$folder/mvgl/$program" "$build/$program"; done
  strip -o "$folder/mvgl/lib/libmvgl.so.0" "$(readlink -f "$build/lib/libmvgl.so.0")"
  libraries_of "${programs[@]/#/$build/}" "$build/lib/libmvgl.so.0" | xargs cp -Lt "$folder/mvgl/lib"
  # Of use where a driver was installed without the loaders that find it.
  ldconfig -p | awk '/lib(EGL|GLdispatch|OpenGL)\.so\.[01] .*x86-64/ { print $NF }' | xargs -r cp -Lt "$folder/mvgl/loaders"
  cp -r "$root/tests/goldens" "$folder/mvgl/tests/"
  cp -r "$root/assets" "$folder/mvgl/"
  # But for those of the processor alone
  for program in "$root"/docs/errors-and-times/*.processor.csv; do basename "$program" .processor.csv; done |
    grep -vxE 'ray-cast|ray-trace|springs' >"$folder/mvgl/studies.txt"
  tar -czf "$file" -C "$folder" mvgl
  echo "$file: $(($(stat -c %s "$file") / 1000000)) MB; unpack it on a machine with a GPU, and run mvgl/gpu.sh there"
}

# MVGL_GPU_DEMOS, words between colons ("cube_cull:shading"), leaves the other demos out.
of_demos() { [ -z "${MVGL_GPU_DEMOS:-}" ] && echo "$1*" || echo "$1${MVGL_GPU_DEMOS//:/:$1}"; }
suites_of_demos() { [ -z "${MVGL_GPU_DEMOS:-}" ] && echo '*' || sed -E 's/(^|[:_])([a-z])/\1\u\2/g; s/_//g; s/[^:]+/&.*:&Full.*/g' <<<"$MVGL_GPU_DEMOS"; }

say() { echo "$*" | tee -a "$here/report.txt"; }

# suite NAME SECONDS PROGRAM FILTER: a verdict for the whole, and a line for each test that failed, with what it said first.
suite() {
  local name=$1 seconds=$2 program=$3 filter=$4 log=$here/$1.log status=0
  MVGL_TREE=$here MVGL_TEST_HOST=$host timeout "$seconds" "$here/tests/$program" --gtest_filter="$filter" >"$log" 2>&1 || status=$?
  local good bad
  good=$(grep -c '^\[       OK \]' "$log" || true)
  bad=$(grep '^\[  FAILED  \].*(.*ms)$' "$log" | sed 's/^\[  FAILED  \] //; s/,* where.*//; s/ (.*//' || true)
  if [ "$status" = 124 ]; then
    say "FAILED  $name: ended after $seconds s, $good tests done"
  elif [ "$status" = 0 ] && [ "$good" -gt 0 ]; then
    say "ok      $name: $good of $good"
  else
    say "FAILED  $name: $good of $((good + $(grep -c . <<<"$bad" || true)))"
  fi
  while read -r test; do
    [ -z "$test" ] || say "        $test: $(awk -v begin="[ RUN      ] $test" '$0 == begin { on = 1; next } on && /differ|error|Error|Which is|exception/ { print; exit }' "$log" | cut -c1-200)"
  done <<<"$bad"
  [ "$status" = 0 ] || failed=true
}

try() {
  cd "$here"
  host=${1:-egl} failed=false
  local started=$SECONDS demo status left=()
  ldconfig -p 2>/dev/null | grep -q 'libEGL\.so\.1' || export LD_LIBRARY_PATH=$here/loaders
  : >report.txt
  say "$(bin/mvgl cube-cull --headless="$host" --report 2>&1 | grep -E '^(host|error)' || echo "error: no picture")"
  grep -q '^host' report.txt || exit 1
  say "$(bin/mvgl cube-cull --headless="$host" --report | grep '^time')"
  suite presets 90 test-visits "$(of_demos Demos/AnyRenderer.presets/)"
  suite goldens 60 test-goldens "$(of_demos 'Golden.*/')"
  suite claims 120 test-claims "$(suites_of_demos)"
  suite ends 60 test-visits "$(of_demos Demos/Visits.ends/)"
  for demo in $(cat studies.txt); do
    if [ $((SECONDS - started)) -gt 300 ]; then
      left+=("$demo")
      continue
    fi
    status=0
    timeout 60 bin/mvgl "$demo" --study "studies/$demo" --headless="$host" >"study-$demo.log" 2>&1 || status=$?
    if [ $status = 0 ]; then
      say "ok      study of $demo"
    else
      say "FAILED  study of $demo: $(tail -n 1 "study-$demo.log" | cut -c1-200)" && failed=true
    fi
  done
  [ ${#left[@]} = 0 ] || say "left    for want of time, studies of: ${left[*]}"
  say "$((SECONDS - started)) s"
  ! $failed
}

if [ "${1:-}" = pack ]; then
  pack "${@:2}"
else
  [ -x "$here/bin/mvgl" ] || fail "gpu.sh: must stand where its pack was unpacked; first run: scripts/gpu.sh pack"
  try "$@"
fi
