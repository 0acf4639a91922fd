#!/bin/sh
# How near to the frontier each sample project ships: sweeps all its cameras at both sizes and prints the table of
# docs/accuracy.md. Takes an hour and more; run again it goes on where it stopped. Plots and reports are kept in OUT.
#   tools/cost_tables.sh OUT [SIZES [PROJECT...]]      SIZES as of sward cost: 320x240,1024x768
set -eu
here=$(cd "$(dirname "$0")/.." && pwd)
out=$1
sizes=${2:-320x240,1024x768}
[ $# -lt 2 ] || shift
shift
[ $# -gt 0 ] || set -- football park meadow wheat tornado lawn prairie
for project in "$@"; do
    for size in $(echo "$sizes" | tr , ' '); do
        "$here/build/release/sward" cost "$here/projects/$project" --size "$size" --samples "${RAYS:-16}" --rounds 3 \
            --out "$out/$project-$size" >"$out/$project-$size.txt"
    done
done
cat "$out"/*/shipped.md | awk '!seen[$0]++'
