#!/usr/bin/env bash
# first_picture.sh SWARD PROJECT: seconds from starting the editor to its first frame with a picture of the project, in
# a window of its own X server, with nothing cached: neither programs nor slices. Prints nothing if that fails.
set -u
work=$(mktemp -d)
server= app=
end() {
  kill $app $server 2>/dev/null
  wait 2>/dev/null
  rm -rf "$work"
}
trap end EXIT
Xvfb -displayfd 3 -screen 0 1440x900x24 -nolisten tcp 3>"$work/display" >/dev/null 2>&1 &
server=$!
for _ in $(seq 100); do [ -s "$work/display" ] && break; sleep 0.05; done
[ -s "$work/display" ] || exit 1
DISPLAY=:$(cat "$work/display")
export DISPLAY MESA_SHADER_CACHE_DISABLE=true
export XDG_CACHE_HOME="$work/cache" XDG_STATE_HOME="$work/state" XDG_CONFIG_HOME="$work/config"
begun=$(date +%s%N)
"$1" edit "$2" --widgets "$work/widgets" >"$work/out" 2>&1 &
app=$!
for _ in $(seq 6000); do
  [ -e "$work/widgets" ] && break
  kill -0 "$app" 2>/dev/null || exit 1
  sleep 0.01
done
[ -e "$work/widgets" ] || exit 1
awk -v a="$begun" -v b="$(date +%s%N)" 'BEGIN { printf "%.3f\n", (b - a) / 1e9 }'
