#!/bin/bash
# A morning's level, made in a real window by real X events alone: ground sculpted, a picture of heights taken in, a rule,
# a path, rocks and benches placed, a pond, two species and flowers, a scatter, a lamp, a camera, a fit to a budget
# adopted, a walk, saved, exported, opened again with the same files.
#   morning.sh SWARD PROJECTS
# PROJECTS: the folder of the samples. SHOTS=DIR keeps pictures of the steps. Ends with 77, which CTest takes as skipped,
# where the X server or the programs that press its keys are not installed.
set -eu
sward=$1 park=$2/park
for tool in Xvfb xdotool matchbox-window-manager; do
  command -v "$tool" >/dev/null || { echo "$tool is not installed"; exit 77; }
done

work=$(mktemp -d)
widgets=$work/widgets
pids=()
finish() {
  for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || true; done
  wait 2>/dev/null || true
  rm -rf "$work"
}
trap finish EXIT
fail() {
  echo "$1"
  cat "$work/out" 2>/dev/null || true
  grep -E "Status/Message|Viewport/Error" "$widgets" 2>/dev/null || true
  shot failed
  [ -z "${SHOTS:-}" ] || cp "$widgets" "$SHOTS/failed.txt"
  exit 1
}
. "$(dirname "$0")/hand.sh"
export XDG_CONFIG_HOME=$work/config XDG_STATE_HOME=$work/state
step() { echo "$(date +%T) $1"; shot "$2"; }

# Where a place on level ground is in the window, seen from the template's camera as it is set below: 100 m wide, from
# the south and above.
eye="100 90 235" target="100 0 110" fov=50
screen() { # x z y
  local rect
  rect=$(awk -F'\t' '$1 == "Viewport" { print $2, $3, $4, $5 }' "$widgets")
  awk -v eye="$eye" -v target="$target" -v fov=$fov -v rect="$rect" -v x="$1" -v z="$2" -v y="${3:-0}" 'BEGIN {
    split(eye, e, " "); split(target, t, " "); split(rect, r, " ")
    fx = t[1] - e[1]; fy = t[2] - e[2]; fz = t[3] - e[3]
    length3 = sqrt(fx * fx + fy * fy + fz * fz); flat = sqrt(fx * fx + fz * fz)
    rx = -fz / flat; rz = fx / flat
    fx /= length3; fy /= length3; fz /= length3
    ux = -rz * fy; uy = rz * fx - rx * fz; uz = rx * fy
    dx = x - e[1]; dy = y - e[2]; dz = z - e[3]
    half = (r[4] - r[2]) / 2 / (sin(fov * 3.14159265 / 360) / cos(fov * 3.14159265 / 360))
    scale = half / (dx * fx + dy * fy + dz * fz)
    print int((r[1] + r[3]) / 2 + (dx * rx + dz * rz) * scale), int((r[2] + r[4]) / 2 - (dx * ux + dy * uy + dz * uz) * scale)
  }'
}
ground() { click $(screen "$@"); }
stroke() { drag $(screen "$1" "$2") $(screen "$3" "$4"); }
brush() { # tool radius strength falloff
  press "Tools/$1"
  number Brush/Radius "$2"
  number Brush/Strength "$3"
  number Brush/Falloff "$4"
}
saved() { # whether project.json has a text
  grep -q "$1" "$project/project.json"
}

open_screen 1440 900
mkdir "$work/levels"
project=$work/levels/glade
cd "$work" # nothing of the checkout lies here
"$sward" edit --widgets "$widgets" >"$work/out" 2>&1 &
editor=$!
pids+=("$editor")
patience=60 until_true "the start screen" there "Panel/Start/New project..."
step "start screen" 01-start

# A new project from a template: 200 x 200 m, level.
press "Panel/Start/New project..."
press Files/Template/field
number Files/Size 200
number Files/Relief 0
write Files/Path "$project"
patience=60 until_true "the new project" there Outliner/lawn
press Outliner/camera
write_vector() { # PATH x y z
  number "$1.x" "$2" && number "$1.y" "$3" && number "$1.z" "$4"
}
write_vector Inspector/camera.Camera.eye $eye
write_vector Inspector/camera.Camera.target $target
number Inspector/camera.Camera.fovDeg $fov
choose Viewport/Camera camera
step "new project" 02-new

# Two hills and a hollow.
brush Raise 22 1 1
number Brush/Height 5
stroke 45 60 55 65
stroke 150 70 145 60
brush Lower 16 1 1
number Brush/Height 2
stroke 105 120 112 124
step "hills and a hollow" 03-hills

# A picture of heights into the far corner: looked at, placed, taken.
menu Maps "Place Heights..."
write Image/Path "$park/maps/ground.height.exr"
until_true "the picture of heights" there Image/Preview
press Image/Place
for place in "X 150" "Z 0" "Width 50" "Depth 40" "Falloff 0.3"; do number "Place heights/${place% *}" "${place#* }"; done
step "heights in a corner, seen before they are taken" 04-corner
press "Place heights/Accept"
until_true "the taken heights" gone "Place heights/Accept"

# No grass on steep ground, nor on what lies low.
rule=lawn.MapLayers.layers[rule]
press Tools/Add
tab Layers
press "Layers/Add rule"
until_true "the rule" there "Layers/$rule/On"
press "Layers/$rule/Add mask"
until_true "the second mask" there "Layers/$rule.masks[mask-2].by"
choose "Layers/$rule.masks[mask-2].by" height
number "Layers/$rule.masks[mask-2].from" -1
number "Layers/$rule.masks[mask-2].to" inf
step "a rule" 05-rule

# A winding path.
key p
for point in "20 180" "60 150" "80 110" "110 90" "105 50"; do ground $point; done
key Return
step "a path" 06-path
