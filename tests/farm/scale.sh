#!/usr/bin/env bash
# What a farm takes, measured on this one machine: tests/farm/scale.sh SWARD [NODES [PARTS]]   (200 and 400; root)
# First a part by the program, 1/NODES of a picture, by samples. Then NODES daemons of Slurm, each a node, and PARTS parts
# for which a stand-in for the program sleeps as long as the real part would compute; once undisturbed, once with a node
# killed in the middle. Last NODES real parts, of a project that is quick, and their merge. Slurm, tools/farm and files are
# real; but this machine's cores stand for all nodes', so that overheads are upper bounds.
# Prints a line a number, with how it was got. PROJECT, CAMERA, SIZE, SLEEP (s, the mean that parts sleep) are variables;
# ALONE is a file with the seconds of parts at 1 and 5 samples that an earlier run measured (it prints them).
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
sward=$(readlink -f "$1")
nodes=${2:-200} parts=${3:-400}
project=$(readlink -f "${PROJECT:-$here/../../projects/football}") camera=${CAMERA:-human} size=${SIZE:-1920x1080} sleep=${SLEEP:-60}
farm=$here/../../tools/farm
. "$here/cluster.sh"
export PATH=$PATH:/usr/sbin:/sbin XDG_CACHE_HOME MESA_SHADER_CACHE_DISABLE=true SWARD_FARM_LOCAL
work=$(mktemp -d)
XDG_CACHE_HOME=$work/cache SWARD_FARM_LOCAL=$work/local
mkdir "$work/local"
trap 'cluster_stop; [ -n "${KEEP-}" ] && echo "kept: $work" || rm -rf "$work"' EXIT
cd "$work"

now() { date +%s.%N; }
reckon() { awk "BEGIN { printf \"%.${2:-1}f\", $1 }"; }  # reckon FORMULA [DIGITS]
tell() { printf '%-58s %s\n' "$1" "$2"; }
took() { # took COMMAND...: its seconds, in `seconds`
    local began
    began=$(now)
    "$@" >said 2>&1 || { cat said >&2; exit 1; }
    seconds=$(reckon "$(now) - $began" 2)
}
kib() { du -s --apparent-size -k "$@" | awk '{ n += $1 } END { print n }'; }
median() { sort -g | awk '{ v[NR] = $1 } END { printf "%.2f (95 %%: %.2f, most: %.2f)", v[int((NR + 1) / 2)], v[int(NR * 0.95 + 0.5)], v[NR] }'; }
receipts() { # receipts JOB: a line a part: number, node, begin, seconds, when it was there
    local r
    for r in "$1"/parts/*/receipt; do
        echo "$(sed -n 's/^\(part\|node\|began\|seconds\)=//p' "$r" | paste -sd ' ') $(stat -c %.9Y "$r")"
    done
}
gaps() { receipts "$1" | sort -k 2,2 -k 3,3g | awk '$2 == node { print $3 - end } { node = $2; end = $3 + $4 }'; }

# --- a part alone: what it takes by samples, and what tools/farm adds to it
cpu_of() { # cpu_of COMMAND...: its seconds of the clock, in `seconds`, and of all cores, in `cpu`, which others' work leaves
    local TIMEFORMAT='%R %U %S'
    read -r seconds cpu < <({ time "$@" >said 2>&1; } 2>&1 | awk '{ print $1, $2 + $3 }')
}
one_part() { # one_part SAMPLES SHARD: sets `cpu`
    cpu_of "$sward" reference "$project" --camera "$camera" --size "$size" --samples "$1" --shard "$2/$nodes" --out alone.part
    [ -s alone.part ] || { cat said >&2; exit 1; }
}
few=1 many=5 cores=$(nproc)
tell "project, camera, size, nodes" "$(basename "$project"), $camera, $size, $nodes"
tell "machine" "$(nproc) cores, $(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -n 1), load $(cut -d ' ' -f 1 /proc/loadavg) at the start"
one_part 1 0
[ -z "${ALONE-}" ] || cp "$ALONE" alone
for ((i = 0; i < 8; ++i)); do
    [ -z "${ALONE-}" ] || break
    shard=$((i * nodes / 8))
    one_part $few $shard
    a=$cpu
    one_part $many $shard
    echo "$a $cpu" >>alone
done
tell "a part alone, s of one core at $few and $many samples" "$(paste -sd , alone)"
read -r fixed slope < <(awk -v f=$few -v m=$many '{ s = ($2 - $1) / (m - f); k += s; c += $1 - f * s } END { print c / NR, k / NR }' alone)
tell "a part alone: fixed, s of one core" "$(reckon "$fixed" 2) (8 parts at $few and $many samples; the line through the means)"
tell "a part alone: a sample more, s of one core" "$(reckon "$slope" 4) (the same line)"
tell "a part of 1024 samples on an idle node of $cores cores, s" "$(reckon "$fixed + 1024 * $slope / $cores") (= fixed + 1024 * a sample more / $cores)"
samples=$(reckon "($sleep - $fixed) * $cores / $slope" 0)
tell "samples for a part of $sleep s" "$samples (= ($sleep - fixed) * $cores / a sample more)"

# --- NODES nodes, PARTS parts that sleep
bytes=$(stat -c %s alone.part)
tell "shared: a part, KiB" "$(reckon "$bytes / 1024")"
mkdir -p sim/bin
awk -v f=$few -v m=$many -v n="$samples" -v c="$cores" '{ s = ($2 - $1) / (m - f); print $1 - f * s + n * s / c }' alone >sim/sleeps
cat >sim/bin/sward <<STANDIN
#!/usr/bin/env bash
# Sleeps as long as the part of the arguments' last word, I/N, would compute, and writes as much.
[ "\$1" = reference ] || { echo stand-in; exit; }
part=\${!#}
sleep "\$(sed -n "\$((\${part%/*} % 8 + 1))p" "$work/sim/sleeps")"
head -c $bytes /dev/zero >"$camera.\${part/\//-of-}.part"
STANDIN
chmod +x sim/bin/sward
export SWARD=$work/sim/bin/sward
# As Slurm comes, but for who is dead sooner than after 300 s: by 30.
cluster_scheduler=${SCHEDULER-} cluster_timeout=30
cluster_start "$work/slurm" "$nodes"
left() { [ -n "$(squeue -h 2>&1 || true)" ]; }  # whether Slurm has anything left to do, or does not answer now
ideal() { # the whole's seconds if all but the sleeping took none: each part goes to the node that is free first
    awk -v nodes="$nodes" -v parts="$parts" '{ t[NR - 1] = $1 } END {
        for (p = 0; p < parts; ++p) { b = 0; for (n = 1; n < nodes; ++n) if (free[n] + 0 < free[b] + 0) b = n
            free[b] += t[p % NR]; if (free[b] > all) all = free[b] } printf "%.1f", all }' sim/sleeps
}
# simulated JOB [NODE]: NODE is killed when half of its first part is done
simulated() {
    local job=$1 began killed=0 part='' id lost_began=0
    began=$(now)
    took "$farm" submit "$job" reference "$project" --parts "$parts" -- --camera "$camera" --samples "$samples"
    tell "  farm submit, s" "$seconds"
    id=$(cat "$job/runs/0.id")
    if [ $# = 2 ]; then
        while [ -z "$part" ]; do sleep 0.5; part=$(squeue -h -r -w "n$2" -o %K | head -n 1); done
        lost_began=$(now)
        sleep "$(reckon "$sleep / 2")"
        killed=$(now)
        node_kill "$2"
    fi
    while left; do sleep 2; done
    [ "$(find "$job/parts" -mindepth 2 -name receipt | wc -l)" = "$parts" ] || { "$farm" status "$job" >&2; exit 1; }
    receipts "$job" >"$job.receipts"
    local first=$((nodes < parts ? nodes : parts)) wall
    wall=$(awk -v b="$began" '$5 > end { end = $5 } END { printf "%.1f", end - b }' "$job.receipts")
    tell "  until the ${first}th part began, s" "$(sort -g -k 3,3 "$job.receipts" | awk -v b="$began" -v n="$first" 'NR == n { printf "%.1f", $3 - b }')"
    tell "  between two parts of a node, s" "$(gaps "$job" | median)"
    tell "  wall, s" "$wall (from submit to the last receipt; ideal $(ideal), overhead $(reckon "$wall - $(ideal)"))"
    [ $# = 2 ] || return 0
    local restarts
    restarts=$(scontrol show job -o "$id" | sed 's/.* Restarts=\([0-9]*\) .*/\1/' | awk '{ n += $1 } END { print n + 0 }')
    tell "  parts that Slurm gave anew" "$restarts"
    tell "  work that the kill lost, s" "$(reckon "$killed - $lost_began") (from its beginning to the kill)"
    tell "  from the kill to the lost part's new beginning, s" "$(awk -v p="$part" -v k="$killed" '$1 == p { printf "%.1f, on %s", $3 - k, $2 }' "$job.receipts")"
}
# Slurm by itself, for what is its own of the times below.
began=$(now)
sbatch -o /dev/null --array="0-$((nodes - 1))" --exclusive -N 1 >/dev/null \
    < <(printf '#!/usr/bin/env bash\ndate +%%s.%%N >"%s/begun.$SLURM_ARRAY_TASK_ID"\nsleep 20\n' "$work")
while left; do sleep 1; done
tell "Slurm alone, $nodes tasks of sleep 20: until the last began, s" "$(sort -g begun.* | tail -n 1 | awk -v b="$began" '{ printf "%.1f", $1 - b }')"
echo "$parts parts on $nodes nodes, $(reckon "$(paste -sd + sim/sleeps | sed 's/.*/(&) \/ 8/')") s each in the mean:"
simulated undisturbed
echo "the same, and node n3 dies in the middle of its first part:"
simulated disturbed 3
tell "shared: job folder of $parts parts, KiB" "$(kib undisturbed)"
cpu_of "$farm" status undisturbed
tell "farm status of $parts parts (as resume and merge read them), s" "$seconds, $cpu s of one core"
tell "local: what the parts left in the nodes' folder, KiB" "$(kib local)"
cluster_stop

# --- real parts of a project that is quick, since what joins them reads pixels alone: their sizes, and the merge
export SWARD=$sward
"$sward" new quick >/dev/null
sed -i 's/"bladesPerM2": 4000/"bladesPerM2": 100/; s/"size": \[40, 40\]/"size": [12, 12]/' quick/project.json
picture=(reference quick --size "$size" --samples 1)
for ((i = 0; i < nodes; ++i)); do "$sward" "${picture[@]}" --shard "$i/$nodes" --out "real/$i.part" >/dev/null 2>&1; done
cpu_of "$sward" merge real/*.part --out joined.exr
tell "sward merge of $nodes real parts, s" "$seconds, $cpu s of one core"
"$sward" "${picture[@]}" --out whole.exr >/dev/null
cmp joined.exr whole.exr && cmp joined.error.exr whole.error.exr
tell "merged equals one machine's" "yes, bit for bit (cmp)"

# --- what is shared and what is local
tell "shared: program and shaders, KiB" "$(kib -L "$sward" "$(dirname "$sward")/../../shaders") (du --apparent-size)"
tell "shared: project, KiB" "$(kib "$project")"
tell "shared: the $nodes real parts, KiB" "$(kib real)"
