#!/usr/bin/env bash
# An hour of play, twice: tests/trials/hour_of_play.sh SWARD
# Both must come to the same hash in each minute; ends with 1 where one is off. The least memory of the process in the
# last twenty minutes may be at most 2 % and 8 MiB over that of the twenty before (in the first twenty the first run
# bakes); where it is more, that is printed as missed.
set -euo pipefail
sward=$(readlink -f "$1")
script=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/hour_of_play.lua
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export XDG_CACHE_HOME=$work/cache XDG_STATE_HOME=$work/state MESA_SHADER_CACHE_DISABLE=true

# Plays; the hashes go to a file, the process's own memory in KiB, as each minute ends, to another.
play() { # play HASHES MEMORY
    coproc PLAYED { exec stdbuf -oL "$sward" script "$script"; }
    local pid=$PLAYED_PID from=${PLAYED[0]}
    while read -r line <&"$from"; do
        echo "$line" >>"$1"
        echo "$(awk '/^VmRSS/ {print $2}' "/proc/$pid/status" 2>/dev/null || true)" >>"$2"
    done
    wait "$pid"
}
for run in 1 2; do
    play "$work/hashes$run" "$work/memory$run" || { echo "the script failed"; exit 1; }
    [ "$(grep -c '^minute' "$work/hashes$run")" = 60 ] || { echo "not an hour"; exit 1; }
    awk -v run=$run '
        $1 > 0 { third = int((NR - 1) / 20); if (!(third in least) || $1 < least[third]) least[third] = $1 }
        END {
            for (i = 0; i < 3; ++i) printf "run %d, minutes %d to %d: at least %.1f MiB\n", run, 20 * i + 1, 20 * i + 20, least[i] / 1024
            if (least[2] > 1.02 * least[1] + 8192) printf "run %d: MISSED: memory grew by %.1f MiB\n", run, (least[2] - least[1]) / 1024
        }' "$work/memory$run"
done
cmp -s "$work/hashes1" "$work/hashes2" || { echo "the same inputs came to another hash"; exit 1; }
echo "the same hash in each of 60 minutes, twice: $(tail -n 1 "$work/hashes1")"
