# Sourced by ./run and ./test: installs what is missing, configures and builds.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build

# Each with its reason in the README's table of dependencies.
run_packages=(g++ cmake ninja-build libglfw3-dev libimgui-dev libglm-dev libstb-dev libpng-dev libcli11-dev
  nlohmann-json3-dev libgl-dev libegl-dev libegl1 libgl1-mesa-dri fonts-dejavu-core gnuplot-nox libosmesa6)
test_packages=(git libgtest-dev libboost-dev xvfb x11-utils xdotool imagemagick clang-format clang-tidy clang libclang-rt-dev
  libembree-dev)
# What serves in the place of a package that not every distribution has.
declare -A instead=([libosmesa6]="EGL draws the pictures instead"
  [libclang-rt-dev]="pictures and command lines are not fuzzed, and g++ builds what the sanitizers test"
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
  found=$("${CXX:-g++}" -dumpfullversion -dumpversion)
  at_least "$found" 12 || fail "${CXX:-g++}: must be 12 or newer (Debian 12, Ubuntu 24.04), $found"
}

# configure FOLDER OPTION...: quietly where it succeeds, but for its notes.
configure() {
  local folder=$1 log
  shift
  mkdir -p "$folder"
  log=$folder/configure.log
  cmake -S "$root" -B "$folder" -G Ninja "$@" >"$log" 2>&1 || {
    cat "$log" >&2
    fail "configuring: must succeed; see above"
  }
  sed -n 's/^-- note: /note: /p' "$log" >&2
}

# build_targets FOLDER TARGET...: ninja's own progress where there is something to do, else silent.
build_targets() {
  local folder=$1
  shift
  ninja -C "$folder" "$@" > >(grep --line-buffered -vE 'Re-checking globbed|Entering directory|no work to do' >&2) ||
    fail "building: must succeed; see above"
}
