# Sourced by ./test: which files the source tree has, with git or without.

# find_git: whether git answers for this tree; where it does not, one line says why, and what is done instead.
has_git=false
find_git() {
  local says
  if says=$(git -C "$root" rev-parse --show-toplevel 2>&1); then
    [ "$says" -ef "$root" ] && has_git=true && return
    says="this source tree is in no repository of its own"
  elif [[ $says == *"dubious ownership"* ]]; then
    says="git trusts no clone of another user (git config --global --add safe.directory '$root' lets it)"
  elif [[ $says == *"not a git repository"* ]]; then
    says="this source tree is in no git repository"
  fi
  echo "note: ${says%%$'\n'*}; its files are found without git" >&2
}

# tree_files: the tree's files, relative to its root, each followed by a NUL. With git those that it tracks, and new ones
# that it does not ignore; without all that stand in no folder that a build makes.
tree_files() {
  if $has_git; then
    git -C "$root" ls-files -z --cached --others --exclude-standard
  else
    (cd "$root" && find . \( -path './build' -o -path './build-*' -o -name '.cache' -o -name '.git' \) -prune -o \
      -type f ! -name '*.part' ! -name compile_commands.json -printf '%P\0')
  fi | LC_ALL=C sort -zu | (cd "$root" && while IFS= read -r -d '' file; do [ ! -f "$file" ] || printf '%s\0' "$file"; done)
}
