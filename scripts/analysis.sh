# Sourced by ./test: static analysis by clang-tidy, and g++'s warnings.

# One file: its line for the progress, after clang-tidy's words and g++'s, which stand in a file of their own. (clang-tidy takes a
# header's flags from the file whose name is nearest.) g++ warns of other things than clang++, by which all is built.
analyse_one() {
  local folder=$1 file=$2 start=$SECONDS words=$1/words/${2//\//-} status=0 compile
  clang-tidy --quiet -p "$folder" "$root/$file" >"$words" 2>"$words.err" || status=1
  if [[ $file == *.cpp ]]; then
    compile=$(ninja -C "$folder" -t commands -s "$root/$file^" | sed -n 's| -MD .* -o [^ ]* -c | -o /dev/null -c |p')
    [ -n "$compile" ] && (cd "$folder" && eval "$compile") 2>>"$words" || status=1
  fi
  echo "$status $((SECONDS - start)) $file"
}

# what_differs SINCE: sets `since` to the commit to compare with, the given one, else the last tag, else the commit before the last;
# empty where there is none: then all files are analysed.
what_differs() {
  since=$1
  $has_git || return 0
  [ -n "$since" ] || since=$(git -C "$root" describe --tags --abbrev=0 2>/dev/null || true)
  [ -n "$since" ] || since=$(git -C "$root" rev-parse -q --verify HEAD~1 || true)
  [ -z "$since" ] || git -C "$root" rev-parse -q --verify "$since^{commit}" >/dev/null || fail "--since: must be a commit of this clone, $since"
}

# differing_from COMMIT: the files that do, committed or not.
differing_from() {
  { git -C "$root" diff --name-only --no-renames "$1" && git -C "$root" ls-files --others --exclude-standard; } | sort -u
}

# static_analysis SINCE: of each file that differs from what_differs, committed or not.
static_analysis() {
  local since folder=$build/tidy file files=()
  what_differs "$1"
  # Each file alone, and without precompiled headers, which are another compiler's own.
  configure "$folder" "-DCMAKE_CXX_COMPILER=$(command -v g++ || command -v "${CXX:-clang++}")" -DCMAKE_UNITY_BUILD=OFF -DMVGL_TESTS=ON -DMVGL_BENCH=ON -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON
  mkdir -p "$folder/words"
  # Headers, and of the sources what the build compiles: a trap that must not compile is none of clang-tidy's business.
  { tree_files | tr '\0' '\n' | grep -E '^(common|demos|tests)/.*\.h$'
    sed -n "s|^ *\"file\": \"$root/\(.*\)\".*|\1|p" "$folder/compile_commands.json" | grep -v '^build'; } | sort -u >"$folder/code.txt"
  if [ -n "$since" ]; then
    differing_from "$since" >"$folder/differs.txt"
    grep -q clang-tidy "$folder/differs.txt" || { comm -12 "$folder/code.txt" "$folder/differs.txt" >"$folder/chosen.txt" && mv "$folder/chosen.txt" "$folder/code.txt"; }
  fi
  mapfile -t files <"$folder/code.txt"
  echo "${#files[@]} files to analyse${since:+: what differs from $since}"
  [ ${#files[@]} -gt 0 ] || return 0

  local status seconds done=0 found=0
  export root && export -f analyse_one
  while read -r status seconds file; do
    done=$((done + 1))
    echo "[$done of ${#files[@]}] $file: $seconds s"
    [ "$status" = 0 ] || { found=$((found + 1)) && cat "$folder/words/${file//\//-}"{,.err}; }
  done < <(printf '%s\n' "${files[@]}" | xargs -P "$(nproc)" -I{} bash -c 'analyse_one "$1" "$2"' analyse "$folder" {})
  [ "$done" = ${#files[@]} ] || fail "clang-tidy: must look at every file, at $done of ${#files[@]}"
  [ "$found" = 0 ] || fail "clang-tidy, g++: must find nothing; see above; in $found files"
}
