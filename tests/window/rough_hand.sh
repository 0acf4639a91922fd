#!/bin/bash
# What a window meets beside well-behaved hands: its focus is taken in the middle of a stroke, and its size becomes one
# pixel and many again. What was painted until then is there, is one step, and nothing is painted after.
#   rough_hand.sh SWARD
# Ends with 77, which CTest takes as skipped, where the X server or the programs that press its keys are not installed.
set -eu
sward=$1
for tool in Xvfb xdotool; do
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
  echo "failed: $1"
  cat "$work/out" 2>/dev/null || true
  grep -E "Status|History" "$widgets" 2>/dev/null || true
  shot failed
  exit 1
}
. "$(dirname "$0")/hand.sh"
export XDG_CONFIG_HOME=$work/config XDG_STATE_HOME=$work/state
project=$work/glade
"$sward" new "$project" >/dev/null
unmanaged=1 open_screen 1280 800 # a window may then have any size, and the focus goes where it is sent
"$sward" edit "$project" --widgets "$widgets" >"$work/out" 2>&1 &
editor=$!
pids+=("$editor")
until_true "the window" xdotool search --onlyvisible --name glade
id=$(xdotool search --onlyvisible --name glade | head -1)
nobody=$(xdotool search --maxdepth 0 '.*' 2>/dev/null | head -1) # the screen itself
xdotool windowmove "$id" 0 0 windowsize "$id" 1280 800
xdotool windowfocus "$id"
until_true "its widgets" there Tools/Subtract
wide() { # the window is where it was put, and its widgets are of that size
  xdotool getwindowgeometry "$id" | tr -d '\n' | grep -q "Position: 0,0.*Geometry: 1280x800" && [ "$(field Status/Message 5)" -gt 700 ] &&
    [ "$(field Status/Message 5)" -lt 800 ]
}
until_true "the whole window" wide

# The focus goes to nobody while the left button is down: the stroke ends there, though the button is held on.
# What lies above the tools takes other rows a frame after the window's size changed; on a busy machine a frame is long
# enough to be clicked into, and another tool is hit.
for try in 1 2 3 4; do
  press Tools/Subtract
  within 30 is Tools/Subtract true && break
done
is Tools/Subtract true || fail "the tool is not chosen"
tab History
until_true "the history" there "History/0 nothing was changed yet"
read -r left top right low < <(awk -F'\t' '$1 == "Viewport" { print $2, $3, $4, $5 }' "$widgets")
x=$(((left + right) / 2)) y=$((top + (low - top) * 3 / 4))
xdotool mousemove $((x - 100)) $y mousedown 1
rest
xdotool mousemove $x $y
painting() { there Status/Stroke; }
until_true "the stroke" painting
steps() { grep -c "^History/[1-9]" "$widgets" || true; }
xdotool windowfocus "$nobody"
one_step() { [ "$(steps)" -eq 1 ]; }
until_true "the stroke's end with the focus" one_step
label=$(grep "^History/1" "$widgets" | cut -f1)
for i in 1 2 3 4 5; do xdotool mousemove $((x + i * 30)) $((y - i * 10)); rest; done
xdotool mouseup 1
xdotool windowfocus "$id"
rest 0.5
one_step || fail "there are $(steps) steps: what came without the focus was painted"
[ "$(grep "^History/1" "$widgets" | cut -f1)" = "$label" ] || fail "the stroke went on without the focus"

# No key stays down that was held when the focus went.
xdotool keydown ctrl
rest
xdotool windowfocus "$nobody"
rest
xdotool keyup ctrl
xdotool windowfocus "$id"
key z # with Ctrl held on it would undo
rest 0.5
one_step || fail "Ctrl stayed down without the focus"

# One pixel, and back.
xdotool windowsize "$id" 1 1
small() { [ "$(field Viewport 4)" -lt 100 ] || gone Viewport; }
until_true "the window of one pixel" small
xdotool mousemove 0 0
click 0 0
xdotool windowsize "$id" 1280 800
until_true "the whole window again" wide
find_widget Tools/Subtract
one_step || fail "the small window changed something"
key ctrl+z
undone() { [ "$(value Status/Saved)" = true ]; }
until_true "the stroke to be undone" undone
key ctrl+q
ended() { ! kill -0 "$editor" 2>/dev/null; }
until_true "the editor's end" ended
wait "$editor" || fail "the editor ended with $?"
"$sward" check "$project" --strict || fail "the project is unsound"
echo "a rough hand: nothing lost"
