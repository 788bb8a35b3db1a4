# Sourced by ./test: static analysis by clang-tidy.

# The sums of all files in which it has found nothing, and the commit they are of: what differs from them is analysed.
# The contents count, not the commit, so that a shallow clone, a changed history and a tree without git do as well.
analysed=$root/tests/analysed.txt

# The code, and what says how it is analysed.
analysis_sums() {
  tree_files | grep -zE '^(common|demos|tests)/.*\.(cpp|h|inc)$|(^|/)\.clang-tidy$' | (cd "$root" && xargs -0 sha256sum)
}

# One file: its line for the progress, after clang-tidy's words, which stand in a file of their own.
analyse_one() {
  local folder=$1 file=$2 start=$SECONDS words=$1/clean/${2//\//-}.words status=0
  clang-tidy --quiet -p "$folder" "$root/$file" >"$words" 2>"$words.err" || status=1
  echo "$status $((SECONDS - start)) $file"
}

# The sums of each source with all of the tree's headers that it includes, of when nothing was found in it so.
analysed_with=$root/tests/analysed_with_headers.txt

# analysis_key VERSION FILE HEADER...: what clang-tidy's words about the file depend on, but for the system's own headers.
analysis_key() {
  (cd "$root" && { echo "$1"; cat .clang-tidy tests/.clang-tidy "${@:2}"; } | sha256sum | cut -c-64)
}

# static_analysis ALL: of the files that differ from those that tests/analysed.txt names, a header in one file that includes
# it; or of all, each anew if it differs or any header that it includes. Files that are as they were when nothing was found in
# them, by this build folder or by tests/analysed_with_headers.txt, are left out.
static_analysis() {
  local all=$1 folder=$build/tidy since file headers key version
  version=$(clang-tidy --version | grep -io 'version.*' || true)
  # Without precompiled headers, which hide a missing #include, and which are the compiler's own. Files that are compiled together
  # cannot be asked what hides a name, so each is here.
  configure "$folder" -DCMAKE_CXX_FLAGS=-Werror=shadow -DMVGL_TESTS=ON -DMVGL_BENCH=ON -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON
  mkdir -p "$folder/clean"
  analysis_sums >"$folder/sums.txt"
  # Only what the build compiles: a trap that must not compile is none of clang-tidy's business.
  { cut -c67- "$folder/sums.txt" | grep -E '\.(h|inc)$'
    sed -n 's/^ *"file": "\(.*\)".*/\1/p' "$folder/compile_commands.json" | while IFS= read -r file; do
      # Not what the build itself has written.
      [[ $file != "$root"/* || $file == "$build"/* ]] || echo "${file#"$root"/}"
    done | sort -u; } >"$folder/code.txt"

  if $all; then
    since="all files"
  elif [ ! -f "$analysed" ]; then
    since="all files, as tests/analysed.txt is missing" all=true
  else
    since="what differs from $(sed -n 's/^# commit //p' "$analysed")"
    { grep -vxFf "$analysed" "$folder/sums.txt" || true; } | cut -c67- >"$folder/changed.txt"
    ! grep -q clang-tidy "$folder/changed.txt" || { since="all files, as .clang-tidy has changed" all=true; }
  fi
  ! $all || cp "$folder/code.txt" "$folder/changed.txt"

  local files=() same=0
  local -A keys=() known=()
  ! [ -f "$analysed_with" ] || while read -r key file; do known[$file]=$key; done < <(grep -v '^#' "$analysed_with")
  while read -r file headers; do
    # shellcheck disable=SC2086  # several names
    key=$(analysis_key "$version" "$file" $headers)
    keys[$file]=$key
    if [ "${known[$file]:-}" = "$key" ] || [ "$(cat "$folder/clean/${file//\//-}.sum" 2>/dev/null)" = "$key" ]; then
      same=$((same + 1))
    else
      rm -f "$folder/clean/${file//\//-}.sum"
      files+=("$file")
    fi
  done < <(cd "$root" && awk -f scripts/analysed_by.awk "$folder/changed.txt" "$folder/code.txt")
  echo "$since: ${#files[@]} files to analyse; $same more are as they were when nothing was found in them"

  local status seconds done=0 found=0
  if [ ${#files[@]} -gt 0 ]; then
    export root && export -f analyse_one
    while read -r status seconds file; do
      done=$((done + 1))
      echo "[$done of ${#files[@]}] $file: $seconds s"
      if [ "$status" = 0 ]; then
        echo "${keys[$file]}" >"$folder/clean/${file//\//-}.sum"
      else
        found=$((found + 1)) && cat "$folder/clean/${file//\//-}.words"{,.err}
      fi
    done < <(printf '%s\n' "${files[@]}" | xargs -P "$jobs" -I{} bash -c 'analyse_one "$1" "$2"' analyse "$folder" {})
  fi
  [ "$done" = ${#files[@]} ] || fail "clang-tidy: must look at every file, at $done of ${#files[@]}"
  [ "$found" = 0 ] || fail "clang-tidy: must find nothing; see above; in $found files"
  if $all; then
    note_analysed "$folder/sums.txt"
    for file in "${!keys[@]}"; do echo "${keys[$file]} $file"; done | sort -k 2 >"$folder/keys.txt"
    note_list "$analysed_with" "$folder/keys.txt" \
      "Nothing was found in these files, each summed up with clang-tidy's version, what it is asked and the headers that the file includes."
  fi
}

# note_list FILE LINES WORDS: writes the lines to a file of tests/, after the words, where it has others.
note_list() {
  if [ -f "$1" ] && cmp -s "$2" <(grep -v '^#' "$1"); then return; fi
  { sed 's/^/# /' <<<"$3" && cat "$2"; } >"$1.part"
  mv "$1.part" "$1"
  echo "${1#"$root"/} is new: commit it"
}

# note_analysed SUMS: writes tests/analysed.txt where the files are others than it says.
note_analysed() {
  local commit="no commit"
  ! $has_git || commit=$(git -C "$root" rev-parse HEAD)
  note_list "$analysed" "$1" \
    "Static analysis found nothing in any of these files; ./test analyses what differs, ./test --long each with its headers, and writes this.
commit $commit"
}
