#!/bin/bash
# A level made in a real window by real X events: ground raised, a path drawn, an object placed, saved, quit.
#   first_level.sh SWARD OBJECT.glb
# Ends with 77, which CTest takes as skipped, where the X server or the programs that press its keys are not installed.
set -eu
sward=$1 object=$2
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
  grep -E "Status|History" "$widgets" 2>/dev/null || true
  shot failed
  exit 1
}
. "$(dirname "$0")/hand.sh"
export XDG_CONFIG_HOME=$work/config XDG_STATE_HOME=$work/state
project=$work/glade
"$sward" new "$project" >/dev/null
mkdir "$project/models"
cp "$object" "$project/models/object.glb"

open_screen 1280 800
"$sward" edit "$project" --widgets "$widgets" >"$work/out" 2>&1 &
editor=$!
pids+=("$editor")
until_true "the window" xdotool search --onlyvisible --name glade

tab History
until_true "the history" there "History/0 nothing was changed yet"
for i in 1 2 3; do # until the window has its size, its widgets move
  press Tools/Raise
  within 20 is Tools/Raise true && break
done
is Tools/Raise true || fail "the tool is not chosen"
drag 420 480 560 470
steps() { [ "$(grep -c "^History/[1-9]" "$widgets")" -eq "$1" ]; }
until_true "the stroke" steps 1
at 300 520
key p
until_true "the path tool" is Tools/Path true
for x in 250 480 700; do click "$x" 520; done
key Return
until_true "the path" there Outliner/path
tab Objects
press Objects/object.glb       # into the hand
click 600 560
until_true "the object" there Outliner/object
key Escape
key ctrl+s
until_true "the saved heights" test -s "$project/maps/ground.height.exr"
key ctrl+q
editor_gone() { ! kill -0 "$editor" 2>/dev/null; }
until_true "the editor's end" editor_gone
wait "$editor" || fail "the editor ended with $?"

"$sward" check "$project" --strict || fail "the project is unsound"
for part in '"GroundPath"' '"models/object.glb"' '"maps/ground.height.exr"'; do
  grep -q "$part" "$project/project.json" || fail "$part is missing in project.json"
done
[ "$(grep -c '"at":' "$project/project.json")" -eq 3 ] || fail "the path has not three points"
