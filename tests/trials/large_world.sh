#!/usr/bin/env bash
# A world of 16,384 x 16,384 heights: tests/trials/large_world.sh SWARD
# Makes it, opens it in the editor (after once to fill the cache), paints, undoes, saves and walks, and checks the files.
# Prints seconds and memory of each step. Ends with 1 where a step fails; what misses its limit is printed as MISSED:
# 3 s to the first picture, 1.5 GB of memory, 2 MB written by a save of one stroke, no frame of the walk over twice the
# median, 20 s of `check`.
set -euo pipefail
sward=$(readlink -f "$1")
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export XDG_CACHE_HOME=$work/cache XDG_STATE_HOME=$work/state
cp "$here"/large_world*.lua "$work"
cd "$work"
"$sward" script large_world_make.lua
now() { date +%s.%N; }

# Runs the script; a line for each of its steps: its name, seconds it took, MB of memory now and at most, KB written.
steps() {
    coproc WORLD { exec stdbuf -oL "$sward" script large_world.lua; }
    local pid=$WORLD_PID from=${WORLD[0]} last
    last=$(now)
    while read -r line <&"$from"; do
        awk -v step="$line" -v from="$last" -v to="$(now)" '
            /^VmRSS/ {rss = $2} /^VmHWM/ {most = $2} /^write_bytes/ {written = $2}
            END {printf "%s %.3f %d %d %d\n", step, to - from, rss / 1024, most / 1024, written / 1024}' \
            "/proc/$pid/status" "/proc/$pid/io"
        last=$(now)
    done
    wait "$pid"
}
cp -r world fresh
steps >first || { echo "the script failed"; exit 1; }
rm -rf world && mv fresh world && sync
steps >second || { echo "the script failed"; exit 1; }
grep -v frame second

began=$(now)
"$sward" check world
awk -v began="$began" -v ended="$(now)" '
    function hold(what, seen, most) { printf "%s: %.2f (at most %.2f)%s\n", what, seen, most, (seen > most ? " MISSED" : "") }
    $1 == "opened" {hold("seconds to the first picture", $2, 3)}
    $1 == "redone" {written = $5}
    $1 == "saved" {hold("seconds of a save", $2, 1); hold("MB written by it", ($5 - written) / 1024, 2)}
    $1 == "frame" {frames[++n] = $2; if ($2 > slowest) slowest = $2}
    {if ($4 > most) most = $4}
    END {
        for (i = 2; i <= n; ++i)
            for (j = i; j > 1 && frames[j - 1] > frames[j]; --j) {t = frames[j]; frames[j] = frames[j - 1]; frames[j - 1] = t}
        hold("slowest frame of the walk by their median", slowest / frames[int((n + 1) / 2)], 2)
        hold("GB of memory at most", most / 1000 * 1.048576, 1.5)
        hold("seconds of check", ended - began, 20)
    }' second
