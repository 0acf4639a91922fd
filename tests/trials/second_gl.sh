#!/usr/bin/env bash
# Every sample project is drawn by two OpenGL drivers: tests/trials/second_gl.sh SWARD PROJECTS
# Mesa's llvmpipe, and zink over Mesa's software Vulkan (package mesa-vulkan-drivers): another compiler front, another
# order of states. Pictures are accepted by the first and held by the second against tolerances of 0.1 of 255 on the mean
# and one pixel of a hundred off by more than 8. Prints a line a picture; ends with 1 where one differs. Where the second
# driver itself ends by a signal (Mesa 22.3.6's does on oasis, within libvulkan_lvp) that is printed as missed.
set -euo pipefail
sward=$(readlink -f "$1")
projects=$(readlink -f "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export XDG_CACHE_HOME=$work/cache XDG_STATE_HOME=$work/state XDG_RUNTIME_DIR=$work MESA_SHADER_CACHE_DISABLE=true
zink() {
    VK_ICD_FILENAMES=$icd VK_DRIVER_FILES=$icd LIBGL_ALWAYS_SOFTWARE=1 MESA_LOADER_DRIVER_OVERRIDE=zink "$@"
}
icd=$(find /usr/share/vulkan/icd.d -name 'lvp_icd*.json' -print -quit)
[ -n "$icd" ] || { echo "no software Vulkan is installed (package mesa-vulkan-drivers)"; exit 1; }

failed=0
for project in "$projects"/*/project.json; do
    name=$(basename "$(dirname "$project")")
    cp -r "$(dirname "$project")" "$work/$name"
    "$sward" check --pictures --accept --size 96x72 "$work/$name" >/dev/null
    code=0
    zink "$sward" check --pictures "$work/$name" >"$work/said" 2>&1 || code=$?
    grep -v '^sward:' "$work/said" | sed "s/^/$name: /" || true
    if [ $code -ge 128 ]; then
        echo "$name: MISSED: the driver ended by signal $((code - 128))"
    elif [ $code != 0 ]; then
        failed=1
    fi
done
exit $failed
