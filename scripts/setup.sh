# Sourced by ./run and ./test: installs what is missing, configures and builds.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build

# Each with its reason in the README's table of dependencies.
run_packages=(clang cmake ninja-build libglfw3-dev libimgui-dev libglm-dev libeigen3-dev libstb-dev libpng-dev
  libjpeg-dev libcli11-dev nlohmann-json3-dev libgl-dev libegl-dev libegl1 libgl1-mesa-dri fonts-dejavu-core
  libosmesa6)
site_packages=(nodejs cmark-gfm highlight esbuild)
web_packages=(emscripten binaryen libharfbuzz-bin)
test_packages=(git libgtest-dev libboost-dev libmpfr-dev libx11-dev xvfb x11-utils xdotool imagemagick clang-format)
full_packages=("${site_packages[@]}" "${web_packages[@]}" chromium libgles2 mesa-vulkan-drivers clang-tidy g++ libclang-rt-dev libembree-dev)
# Node's own packages bring npm; Debian's has it apart.
command -v npm >/dev/null || full_packages+=(npm)
# What serves in the place of a package that not every distribution has.
declare -A instead=([libosmesa6]="EGL draws the pictures instead"
  [libclang-rt-dev]="pictures and command lines are not fuzzed, and g++ builds what the sanitizers test"
  [mesa-vulkan-drivers]="pictures and claims are not met by zink"
  [chromium]="what the pages' scripts do is not tested"
  [emscripten]="the pages have pictures in the place of live demos"
  [binaryen]="the pages have pictures in the place of live demos"
  [libharfbuzz-bin]="the pages have pictures in the place of live demos"
  [libembree-dev]="mvgl-bench leaves out the rays beside it")

fail() {
  echo "error: $*" >&2
  exit 1
}

installed() { dpkg-query -W -f='${Status}' "$1" 2>/dev/null | grep -q 'ok installed'; }

as_root() {
  if [ "$(id -u)" = 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    fail "packages: must be installed by root or with sudo; as root run: apt-get install ${missing[*]}"
  fi
}

# missing_packages NAME...: sets `missing` to those that are not installed; of those with an `instead` only what is to
# be had, and `absent` to the others.
missing_packages() {
  missing=()
  absent=()
  local name
  for name in "$@"; do
    installed "$name" && continue
    if [ -n "${instead[$name]:-}" ] && ! apt-cache show "$name" >/dev/null 2>&1; then
      absent+=("$name")
    else
      missing+=("$name")
    fi
  done
}

tell_absent() {
  local name
  for name in "${absent[@]}"; do echo "note: this distribution has no $name; ${instead[$name]}" >&2; done
}

# install_packages NAME...: those that are missing, by apt-get, with its progress on the terminal.
install_packages() {
  missing_packages "$@"
  [ ${#missing[@]} = 0 ] && tell_absent && return
  command -v apt-get >/dev/null || fail "packages: need apt-get (Debian 12, Ubuntu 24.04 or newer); missing: ${missing[*]}"
  echo "== installing ${missing[*]}" >&2
  as_root apt-get update -q >&2 || echo "note: apt-get update failed; trying with the lists that are there" >&2
  missing_packages "$@"  # again: the lists may have been empty before
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}" >&2 ||
    fail "packages: could not be installed: ${missing[*]}"
  tell_absent
}

# at_least FOUND NEEDED
at_least() { [ "$(printf '%s\n%s\n' "$2" "$1" | sort -V | head -n 1)" = "$2" ]; }

check_versions() {
  local found
  found=$(cmake --version | sed -n '1s/.* //p')
  at_least "$found" 3.25 || fail "cmake: must be 3.25 or newer (Debian 12, Ubuntu 24.04), $found"
  local compiler=${CXX:-clang++} least=12
  command -v "$compiler" >/dev/null || fail "CXX: must be a compiler that is installed, $compiler"
  ! "$compiler" --version | grep -q clang || least=14
  found=$("$compiler" -dumpfullversion -dumpversion)
  at_least "$found" "$least" || fail "$compiler: must be $least or newer (Debian 12, Ubuntu 24.04), $found"
  # clang++ takes the library of the newest g++ that there is any part of.
  [ -f "$build/build.ninja" ] || echo '#include <vector>' | "$compiler" -x c++ -fsyntax-only - 2>/dev/null ||
    fail "$compiler: must find a C++ library; install libstdc++-VERSION-dev of the newest folder in /usr/lib/gcc/*/, or take CXX=g++"
}

# wait_for_others DESCRIPTOR FILE WHO: holds FILE of the build folder alone, until that file descriptor is closed by all that
# have it; where another WHO holds it, says so and waits. (Two that build in one folder break what the other makes.)
wait_for_others() {
  mkdir -p "$build"
  eval "exec $1>\"\$build/$2\""
  flock -n "$1" && return
  echo "note: waiting for another $3 that is at work in ${build#"$root"/}" >&2
  flock "$1"
}

# watched WHAT LOG COMMAND...: COMMAND, with what it prints in LOG. From the second second on it is said that, and for how
# long, it works: in one line on a terminal, else in a line each half minute.
watched() {
  local what=$1 log=$2 ticker status=0
  shift 2
  (
    exec {never}<> <(:)
    started=$SECONDS
    read -rt 2 -u "$never" || true
    while kill -0 $$ 2>/dev/null; do
      if [ -t 2 ]; then
        printf '\r%s ... %d s' "$what" $((SECONDS - started)) >&2
        read -rt 1 -u "$never" || true
      else
        echo "$what ... $((SECONDS - started)) s" >&2
        read -rt 30 -u "$never" || true
      fi
    done
  ) &
  ticker=$!
  "$@" >"$log" 2>&1 || status=$?
  kill "$ticker" 2>/dev/null || true
  wait "$ticker" 2>/dev/null || true
  [ ! -t 2 ] || printf '\r\033[K' >&2
  return "$status"
}

# make_at_home FOLDER [SOURCES]: a build folder knows its place and its sources' by their paths. One that was moved or copied would
# be configured in the old place, or build the old sources: what CMake noted in it is removed, and all is built anew.
make_at_home() {
  local folder=$1 home=${2:-$root} sources place
  [ -f "$folder/CMakeCache.txt" ] || return 0
  # (Without these lines no configuring has come to its end.)
  sources=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$folder/CMakeCache.txt")
  place=$(sed -n 's/^CMAKE_CACHEFILE_DIR:INTERNAL=//p' "$folder/CMakeCache.txt")
  [ -z "$sources$place" ] || { [ "$sources" -ef "$home" ] && [ "$place" -ef "$folder" ]; } && return
  echo "note: $folder was made in $place, of the sources in $sources; configuring and building it anew" >&2
  rm -rf "$folder"/{CMakeCache.txt,CMakeFiles,build.ninja,.ninja_deps,.ninja_log}
}

run_cmake() {
  local folder=$1
  shift
  case ${1:-} in
    --preset) (cd "$root" && cmake "$@") ;;  # which has its folder from the preset
    --web) emcmake cmake -S "$root/web" -B "$folder" -G Ninja ;;
    # A new folder takes the compiler; one that was configured keeps its own.
    *) CXX=${CXX:-clang++} cmake -S "$root" -B "$folder" -G Ninja "$@" ;;
  esac
}

# configure FOLDER OPTION..., configure FOLDER --preset NAME OPTION..., configure FOLDER --web: quietly where it succeeds, but for its
# notes.
configure() {
  local folder=$1 home=$root log
  shift
  [ "${1:-}" != --web ] || home=$root/web
  make_at_home "$folder" "$home"
  mkdir -p "$folder"
  log=$folder/configure.log
  watched "configuring ${folder#"$root"/}" "$log" run_cmake "$folder" "$@" || {
    cat "$log" >&2
    fail "configuring: must succeed; see above"
  }
  sed -n 's/^-- note: /note: /p' "$log" >&2
}

# What ninja and CMake print, without what they say of themselves; on a terminal each step in the place of the last one.
show_steps() {
  local line open=false
  while IFS= read -r line; do
    case $line in
      *"Re-checking globbed"* | *"Re-running CMake"* | "ninja: Entering directory"* | "ninja: no work to do."* | \
        "-- Configuring done"* | "-- Generating done"* | "-- Build files have been"*) ;;
      '['[0-9]*/[0-9]*' left'*']'*)
        if [ -t 1 ]; then
          printf '\r\033[K%s' "${line:0:$((${COLUMNS:-80} - 1))}" && open=true
        else
          printf '%s\n' "$line"
        fi ;;
      *)
        ! $open || echo
        open=false
        printf '%s\n' "$line" ;;
    esac
  done
  ! $open || echo
}

# build_targets FOLDER TARGET...: with ninja's steps where there is something to do, else silent.
build_targets() {
  local folder=$1
  shift
  NINJA_STATUS='[%f/%t, %u left, %e s] ' ninja -C "$folder" "$@" 2>&1 | show_steps >&2 || fail "building: must succeed; see above"
}

# build_web: the demos as a module for browsers, in build/web. False where this system has not what builds it, and a line says so.
build_web() {
  if ! command -v emcmake >/dev/null || ! command -v wasm-opt >/dev/null || ! command -v hb-subset >/dev/null; then
    echo "note: the pages have pictures in the place of live demos: no emcmake, wasm-opt or hb-subset (packages ${web_packages[*]})" >&2
    return 1
  fi
  configure "$build/web" --web
  build_targets "$build/web" mvgl
}

# install_browser_driver: puppeteer-core, which the tests of live pages drive Chromium by, in build/npm as tests/site/package-lock.json
# has it. False where npm cannot install it, and a line says so.
install_browser_driver() {
  local folder=$build/npm file same=true
  mkdir -p "$folder"
  for file in package.json package-lock.json .npmrc; do
    cmp -s "$root/tests/site/$file" "$folder/$file" || { same=false && cp "$root/tests/site/$file" "$folder/$file"; }
  done
  $same && [ -d "$folder/node_modules/puppeteer-core" ] && return
  (cd "$folder" && watched "installing puppeteer-core" "$folder/install.log" npm ci --no-audit --no-fund) && return
  echo "note: npm could not install puppeteer-core ($(grep -m 1 'npm ERR\|npm error' "$folder/install.log" || echo "no npm")); live pages are not tested" >&2
  rm -rf "$folder/node_modules"
  return 1
}
