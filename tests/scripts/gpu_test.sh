#!/usr/bin/env bash
# gpu_test.sh SOURCE FOLDER: what scripts/gpu.sh packs runs where it is unpacked, on this machine's renderer, with three demos; and a
# picture that differs fails there.
set -euo pipefail
source=$1 folder=$2
fail() {
    echo "$*" >&2
    exit 1
}
rm -rf "$folder" && mkdir -p "$folder"
"$source/scripts/gpu.sh" pack "$folder/gpu.tar.gz"
[ "$(stat -c %s "$folder/gpu.tar.gz")" -lt 60000000 ] || fail "the pack must be below 60 MB"
tar -xzf "$folder/gpu.tar.gz" -C "$folder"
cd "$folder/mvgl"
echo cube-shadows >studies.txt
MVGL_GPU_DEMOS='cube_cull:shading:shadow' ./gpu.sh osmesa >out || fail "$(cat out)"
for line in '^host ' '^time ' '^ok      presets: 3 of 3$' '^ok      goldens: 6 of 6$' '^ok      claims: ' '^ok      ends: 3 of 3$' '^ok      study of cube-shadows$'; do
    grep -q "$line" report.txt || fail "no line $line: $(cat report.txt)"
done
# The sources of this build may be anywhere: what is compared is what was packed.
cp tests/goldens/shading.png tests/goldens/cube-cull.png
: >studies.txt
! MVGL_GPU_DEMOS='cube_cull' ./gpu.sh osmesa >out || fail "another golden picture must fail"
grep -q '^FAILED  goldens: 1 of 2$' report.txt || fail "$(cat report.txt)"
grep -q 'Golden.first_picture/cube_cull: ' report.txt || fail "$(cat report.txt)"
