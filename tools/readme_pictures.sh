#!/bin/sh
# Makes the pictures of README.md and docs/ that show sample projects, docs/images/PROJECT-CAMERA.jpg, and those of the
# tour of the editor, docs/images/edit-NAME.jpg (the name "editing" for all of them). To be run by hand after a change of
# how they look; the samples must be there (the default build). Needs ImageMagick's convert.
#   tools/readme_pictures.sh [path/to/sward] [NAME...]
# The level in the window makes pictures of its own: SHOTS=FOLDER tests/window/morning.sh. Plots and truths are made by
# hand.
set -eu
here=$(cd "$(dirname "$0")/.." && pwd)
sward=${1:-$here/build/release/sward}
[ $# -gt 0 ] && shift
names="$*"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# NAME SIZE [OPTIONS of render]
while read -r name size options; do
    [ -n "$name" ] || continue
    case "$names" in '') ;; *) case " $names " in *" $name "*) ;; *) continue ;; esac ;; esac
    camera=${name##*-}
    [ "$camera" != tiers ] || camera=human
    # shellcheck disable=SC2086
    "$sward" render "$here/projects/${name%-*}" --camera "$camera" --size "$size" $options --out "$work/$name.png" >"$work/said"
    convert "$work/$name.png" -quality 85 "$here/docs/images/$name.jpg"
    echo "docs/images/$name.jpg"
done <<'LIST'
football-whole 1024x768
football-human 1024x768
football-low 1024x768
park-whole 1024x768
park-human 1024x768
park-low 1024x768
park-tiers 640x480 --view tiers
meadow-human 800x450 --time 1.5
wheat-low 800x450 --time 1.5
prairie-human 1024x768 --time 1.5
lawn-low 960x540
rockery-human 800x450
oasis-human 1024x768
forest-valley 1024x640
grove-human 1024x640
LIST

case " $names " in '  ' | *" editing "*)
    { echo "OUT, PARK = '$work', '$here/projects/park'"; cat "$here/tools/editing_pictures.lua"; } >"$work/editing.lua"
    "$sward" script "$work/editing.lua" --size 1440x900 >"$work/said"
    for picture in "$work"/edit-*.png; do
        name=$(basename "$picture" .png)
        convert "$picture" -resize 900x -quality 85 "$here/docs/images/$name.jpg"
        echo "docs/images/$name.jpg"
    done ;;
esac
