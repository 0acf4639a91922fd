#!/bin/bash
# A morning's level, made in a real window by real X events alone: ground sculpted, a picture of heights taken in, a rule,
# a path, rocks and benches placed, a pond, two species and flowers, a scatter, a lamp, a camera, a fit to a budget
# adopted, a walk, saved, exported, opened again with the same files.
#   morning.sh SWARD PROJECTS
# PROJECTS: the folder of the samples. Takes five to nine minutes, most of it the search. What fails is told with the
# step in which it did, and the screen of that moment is kept: in SHOTS, a folder that also gets a picture of each step,
# else beside the system's temporary files. Ends with 77, which CTest takes as skipped, where the X server or the programs that press its keys
# are not installed.
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
doing="start screen" # the step that is under way
fail() {
  echo "failed in the step \"$doing\": $1"
  cat "$work/out" 2>/dev/null || true
  grep -E "Status/Message|Viewport/Error" "$widgets" 2>/dev/null || true
  SHOTS=${SHOTS:-$(mktemp -d /tmp/sward-morning.XXXXXX)}
  shot failed
  cp "$widgets" "$SHOTS/failed.txt" 2>/dev/null || true
  echo "the screen and its widgets are $SHOTS/failed.xwd and failed.txt"
  exit 1
}
. "$(dirname "$0")/hand.sh"
export XDG_CONFIG_HOME=$work/config XDG_STATE_HOME=$work/state
step() { # what is done, its picture's name, what comes next
  echo "$(date +%T) $1"
  [ -z "${SHOTS:-}" ] || rest 2 # the picture is drawn
  shot "$2"
  doing=${3:-$1}
}

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
patience=60 until_true "the start screen" there "Viewport/Start/New project..."
step "start screen" 01-start "new project"

# A new project from a template: 200 x 200 m, level.
press "Viewport/Start/New project..."
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
step "new project" 02-new "hills and a hollow"

# Two hills and a hollow.
brush Raise 22 1 1
number Brush/Height 3
stroke 45 60 55 65
stroke 150 70 145 60
brush Lower 16 1 1
number Brush/Height 2
stroke 105 120 112 124
step "hills and a hollow" 03-hills "heights in a corner, seen before they are taken"

# A picture of heights into the far corner: looked at, placed, taken.
menu Maps "Place Heights..."
write Image/Path "$park/maps/ground.height.exr"
until_true "the picture of heights" there Image/Preview
press Image/Place
for place in "X 150" "Z 0" "Width 50" "Depth 40" "Falloff 0.3"; do number "Place heights/${place% *}" "${place#* }"; done
step "heights in a corner, seen before they are taken" 04-corner "a rule"
press "Place heights/Accept"
until_true "the taken heights" gone "Place heights/Accept"

# No grass above 35 degrees, nor on what lies low: there is bare sand by a rule, 1 m below the level ground and deeper.
rule=lawn.MapLayers.layers[rule]
press Tools/Add
tab Layers
press "Layers/Add rule"
until_true "the rule" there "Layers/$rule/On"
press "Layers/$rule/Add mask"
until_true "the second mask" there "Layers/$rule.masks[mask2].by"
choose "Layers/$rule.masks[mask2].by" height
number "Layers/$rule.masks[mask2].from" -1
number "Layers/$rule.masks[mask2].to" inf
choose Brush/Map "ground.Terrain.terrainMap (new)"
press "Layers/Add rule"
sand=ground.MapLayers.layers[rule]
until_true "the rule of sand" there "Layers/$sand/On"
choose "Layers/$sand.masks[mask].by" height
number "Layers/$sand.masks[mask].from" -1000
number "Layers/$sand.masks[mask].to" -1
number "Layers/$sand.masks[mask].falloff" 0.2
says_nothing() { gone "Layers/$sand/Note"; }
until_true "sand in the hollow" says_nothing
step "a rule" 05-rule "a path"

# A winding path.
key p
until_true "the path tool" is Tools/Path true
for point in "20 180" "60 150" "80 110" "110 90" "105 50"; do ground $point; done
key Return
until_true "the path" there Outliner/path
step "a path" 06-path "rocks and benches"

# Twelve rocks and three benches, placed by clicks; one is turned, one scaled, two copies are made and taken back.
mkdir -p "$project/models"
cp "$park/models/stone1.glb" "$park/models/bench.glb" "$project/models/"
tab Objects
place() { # file, then places
  press "Objects/$1"
  shift
  for spot in "$@"; do ground $spot; done
  key Escape
}
place stone1.glb "50 120" "55 125" "62 118" "70 132" "40 140" "130 130" "135 122" "142 138" "150 120" "120 160" "128 168" "90 150"
place bench.glb "70 150" "90 120" "120 95"
until_true "three benches" there "Outliner/bench-3"
until_true "twelve rocks" there "Outliner/stone1-12"
key e
press "Outliner/bench"
handle() { # of the gizmo, and how far it is dragged
  local from
  find_widget "$1"
  stays "$1"
  from=$(middle "$1")
  drag $from $((${from% *} + $2)) $((${from#* } + $3))
}
handle "Viewport/Gizmo turn y" 60 0
key r
press "Outliner/stone1"
handle "Viewport/Gizmo scale" 40 -40
key ctrl+d ctrl+d
until_true "a copy" there "Outliner/stone1-14"
key ctrl+z ctrl+z
until_true "the copies' end" gone "Outliner/stone1-13"
step "rocks and benches" 07-objects "a pond"

# Water in the hollow.
write "Outliner/New entity" pond
press "Outliner/Add entity"
choose "Inspector/Add component" Water
number Inspector/pond.Water.level -0.6
step "a pond" 08-pond "two species and flowers"

# Two more kinds of grass and flowers, in spots by a rule.
in_spots() { # the map that the brush is on; the size of the spots
  tab Layers
  press "Layers/Add rule"
  until_true "the rule" says_rule
  local of
  of=$(topmost)
  choose "Layers/$of.operation" add
  choose "Layers/$of.masks[mask].by" noise
  number "Layers/$of.masks[mask].from" 0.6
  number "Layers/$of.masks[mask].to" 1
  number "Layers/$of.masks[mask].size" "$1"
}
topmost() { awk -F'\t' '$1 ~ /^Layers\/.*\/On$/ { sub("^Layers/", "", $1); sub("/On$", "", $1); print $1; exit }' "$widgets"; }
says_rule() { [ -n "$(topmost)" ]; }
for kind in meadow reed; do
  press Outliner/lawn
  tab Species
  press "Species/Presets/$kind"
  press "Species/Add as New"
  until_true "the brush on $kind" says Brush/Map "$kind"
  in_spots 25
done
menu Add Flowers
until_true "the brush on flowers" says Brush/Map lowers
in_spots 12
step "two species and flowers" 09-species "a lamp and a camera"

# Stones all over by a rule, a lamp, a camera from a view that went round.
press Outliner/stone1
menu Object "Add Scatter"
until_true "the scatter" there Outliner/scatter
menu Add Lamp
until_true "the lamp" there Outliner/lamp
at $(screen 100 110)
xdotool keydown alt
drag $(screen 100 110) 760 430
xdotool keyup alt
menu Add Camera
until_true "the camera" there Outliner/camera-2
step "a lamp and a camera" 10-camera "fitted"

# Settings for a budget, found beside the window and adopted.
tab Accuracy
number Accuracy/Budget 8000
number "Accuracy/Search for" 0.2
press "Accuracy/Fit to budget"
until_true "the search" there "Accuracy/Stop fit"
patience=600 until_true "the search's end" gone "Accuracy/Stop fit"
until_true "its answer" there Accuracy/Adopt
step "fitted" 11-fit "a walk"
fitted=$(value Accuracy/Fitted)
press Accuracy/Adopt

# A walk along the path leaves all as it is.
press Outliner/path
menu Play "Walk Along Path"
until_true "play" is Play/State playing
walked() { awk -v s="$(value Viewport/Playing)" 'BEGIN { exit !(s >= 2) }'; } # seconds of the walk
patience=240 until_true "two seconds of the walk" walked
step "a walk" 12-walk "opened again"
key F5
until_true "the end of play" is Play/State stopped

# Saved, exported, opened again: the same files.
key ctrl+s
until_true "the save" says Status/Message "files written"
menu File "Export..."
write "Files/Blades Within" 15
press Files/Export
glb=$work/levels/glade.glb # beside the project, as the dialog offers
exported() { says Status/Message "exported " && [ -s "$glb" ]; }
patience=300 until_true "the export" exported
hashes() { (cd "$project" && find . -type f ! -name glade.glb -print0 | sort -z | xargs -0 sha256sum); }
made=$(hashes)
tab History
until_true "the steps of the morning" gone "History/0 nothing was changed yet"
menu File "Open..."
write Files/Path "$project"
until_true "the opened project, without a step" there "History/0 nothing was changed yet"
key ctrl+s
until_true "a save of nothing" says Status/Message "nothing had changed"
[ "$(hashes)" = "$made" ] || fail "opened again and saved, the files are others"
step "opened again" 13-again "what the files hold"
key ctrl+q
ended() { ! kill -0 "$editor" 2>/dev/null; }
until_true "the editor's end" ended
wait "$editor" || fail "the editor ended with $?"

"$sward" check "$project" --strict || fail "the project is unsound"
for part in '"GroundPath"' '"models/stone1.glb"' '"models/bench.glb"' '"Water"' '"Scatter"' '"Flowers"' '"Light"' '"by": "slope"' \
  '"by": "height"' '"by": "noise"'; do
  saved "$part" || fail "$part is missing in project.json"
done
[ "$(grep -c '"file": "models/stone1.glb"' "$project/project.json")" -eq 13 ] || fail "there are not twelve rocks and a rule"
saved '"rotationDeg": \[0, -\?[1-9]' || fail "no bench is turned"
grep '"scale":' "$project/project.json" | grep -qv '"scale": 1,\?$' || fail "no rock is scaled"
saved '"map": "Terrain.terrainMap"' || fail "there is no rule of sand"
if saved '"terrainMap": '; then fail "the sand was painted"; fi
"$sward" export "$project" --map terrainMap --out "$work/sand.png" || fail "there is no sand"
adopted=0 # what is as by default is not in the file; samples and the share of blades are the view's
for setting in $fitted; do
  case $setting in msaa=* | detail=* | filtering=*) continue ;; esac
  if saved "\"${setting%%=*}\": ${setting#*=}"; then adopted=$((adopted + 1)); continue; fi
  saved "\"${setting%%=*}\":" && fail "$setting of the fit was not adopted"
done
[ "$adopted" -gt 0 ] || fail "nothing of the fit was adopted: $fitted"
[ -s "$glb" ] || fail "nothing was exported"
echo "a morning's level: all there"
