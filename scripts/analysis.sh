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

# static_analysis ALL AGAIN: of the files that differ from those that tests/analysed.txt names, or of all. Files that are
# as they were when this build folder found nothing in them are left out, unless AGAIN is true.
static_analysis() {
  local all=$1 again=$2 folder=$build/tidy since file headers key
  # Without precompiled headers, which hide a missing #include, and which are the compiler's own.
  configure "$folder" -DMVGL_TESTS=ON -DMVGL_BENCH=ON -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON
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

  local files=() keys=() same=0
  while read -r file headers; do
    # shellcheck disable=SC2086  # several names
    key=$(cd "$root" && { clang-tidy --version; cat .clang-tidy tests/.clang-tidy "$file" $headers; } | sha256sum)
    if ! $again && [ "$(cat "$folder/clean/${file//\//-}.sum" 2>/dev/null)" = "$key" ]; then
      same=$((same + 1))
    else
      rm -f "$folder/clean/${file//\//-}.sum"
      files+=("$file") keys+=("$key")
    fi
  done < <(cd "$root" && awk -f scripts/analysed_by.awk "$folder/changed.txt" "$folder/code.txt")
  echo "$since: ${#files[@]} files to analyse; $same more are as they were when nothing was found in them"

  local status seconds done=0 found=0 number
  declare -A clean=()
  if [ ${#files[@]} -gt 0 ]; then
    export root && export -f analyse_one
    while read -r status seconds file; do
      done=$((done + 1))
      echo "[$done of ${#files[@]}] $file: $seconds s"
      if [ "$status" = 0 ]; then clean[$file]=1; else found=$((found + 1)) && cat "$folder/clean/${file//\//-}.words"{,.err}; fi
    done < <(printf '%s\n' "${files[@]}" | xargs -P "$jobs" -I{} bash -c 'analyse_one "$1" "$2"' analyse "$folder" {})
  fi
  for number in "${!files[@]}"; do
    file=${files[number]}
    [ -z "${clean[$file]:-}" ] || echo "${keys[number]}" >"$folder/clean/${file//\//-}.sum"
  done
  [ "$done" = ${#files[@]} ] || fail "clang-tidy: must look at every file, at $done of ${#files[@]}"
  [ "$found" = 0 ] || fail "clang-tidy: must find nothing; see above; in $found files"
  ! $all || note_analysed "$folder/sums.txt"
}

# note_analysed SUMS: writes tests/analysed.txt where the files are others than it says.
note_analysed() {
  local commit="no commit"
  ! $has_git || commit=$(git -C "$root" rev-parse HEAD)
  if [ -f "$analysed" ] && cmp -s "$1" <(grep -v '^#' "$analysed"); then return; fi
  { echo "# Static analysis found nothing in any of these files; ./test analyses what differs, ./test --long all, and writes this."
    echo "# commit $commit"
    cat "$1"; } >"$analysed.part"
  mv "$analysed.part" "$analysed"
  echo "tests/analysed.txt is new: commit it"
}
