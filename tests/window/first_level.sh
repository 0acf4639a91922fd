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
  [ -z "${KEEP_SHOT:-}" ] || cp "$work/Xvfb_screen0" "$KEEP_SHOT"
  exit 1
}
export XDG_CONFIG_HOME=$work/config XDG_STATE_HOME=$work/state
project=$work/glade
"$sward" new "$project" >/dev/null
mkdir "$project/models"
cp "$object" "$project/models/object.glb"

# Waits up to two minutes until a command succeeds.
until_true() {
  local what=$1 i
  shift
  for i in $(seq 600); do
    if "$@" >/dev/null 2>&1; then return 0; fi
    sleep 0.2
  done
  fail "waited in vain for $what"
}

Xvfb -displayfd 3 -screen 0 1280x800x24 -nolisten tcp -fbdir "$work" 3>"$work/display" >/dev/null 2>&1 &
pids+=($!)
until_true "the X server" test -s "$work/display"
DISPLAY=:$(cat "$work/display")
export DISPLAY
matchbox-window-manager -use_titlebar no >/dev/null 2>&1 &  # makes every window as large as the screen
pids+=($!)
"$sward" edit "$project" >"$work/out" 2>&1 &
editor=$!
pids+=("$editor")
until_true "the window" xdotool search --onlyvisible --name glade
sleep 3

# The hand: each step longer than a frame or two. What is slower waits in the editor's queue of input.
rest() { sleep 0.3; }
at() { xdotool mousemove "$1" "$2"; rest; }
click() { at "$1" "$2"; xdotool mousedown 1; rest; xdotool mouseup 1; rest; }
key() { xdotool key "$1"; rest; }
drag() { # from x y to x y
  at "$1" "$2"
  xdotool mousedown 1
  rest
  for i in 1 2 3 4 5 6 7 8; do xdotool mousemove $(($1 + ($3 - $1) * i / 8)) $(($2 + ($4 - $2) * i / 8)); sleep 0.05; done
  rest
  xdotool mouseup 1
  rest
}

click 23 542               # the tool Raise
drag 420 480 560 470
at 300 520
key p                      # the path tool
for x in 250 480 700; do click "$x" 520; done
key Return
click 394 622              # the tab Objects
click 92 674               # its one object, into the hand
click 600 560
key Escape
key ctrl+s
until_true "the saved heights" test -s "$project/maps/ground.height.exr"
key ctrl+q
gone() { ! kill -0 "$editor" 2>/dev/null; }
until_true "the editor's end" gone
wait "$editor" || fail "the editor ended with $?"

"$sward" check "$project" --strict || fail "the project is unsound"
for part in '"GroundPath"' '"models/object.glb"' '"maps/ground.height.exr"'; do
  grep -q "$part" "$project/project.json" || fail "$part is missing in project.json"
done
[ "$(grep -c '"at":' "$project/project.json")" -eq 3 ] || fail "the path has not three points"
