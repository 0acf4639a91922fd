#!/usr/bin/env bash
# Works of all kinds as job arrays on a Slurm of two nodes that runs here: tests/farm/farm_test.sh SWARD
# Nodes are killed in the middle, jobs submitted twice, cancelled and resumed, parts damaged, inputs changed, disks full;
# each result must be one machine's, bit for bit (of a sweep all but times). Prints a line a trial; ends with 1 at the
# first that failed, with 77 and the reason where it cannot run (Slurm is not installed; not root; --need: with 1).
# KEEP=1 keeps its folder.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
SWARD=$(readlink -f "$1")
export SWARD
export PATH=$PATH:/usr/sbin:/sbin
lacking() { # lacking: why it cannot run here; nothing if it can
    local program
    for program in slurmctld slurmd sbatch squeue scancel munged; do
        command -v $program >/dev/null ||
            { echo "Slurm is not installed ($program is not there): tools/install.sh third_party/packages-long.txt"; return; }
    done
    unshare -m --uts true 2>/dev/null || echo "only root may name hosts and mount disks, as it does: run it as root"
}
why=$(lacking)
if [ -n "$why" ]; then
    echo "farm: skipped: $why"
    [ "${2-}" = --need ] && exit 1 || exit 77
fi
farm=$here/../../tools/farm
. "$here/cluster.sh"
work=$(mktemp -d)
mkdir "$work/a studio" "$work/local"
trap 'cluster_stop; [ -n "${KEEP-}" ] && echo "kept: $work" || rm -rf "$work"' EXIT
export XDG_CACHE_HOME=$work/cache XDG_STATE_HOME=$work/state MESA_SHADER_CACHE_DISABLE=true
export SWARD_FARM_LOCAL=$work/local SWARD_FARM_EVERY=0.3
cd "$work/a studio"

die() {
    echo "$1" >&2
    cat "$work/said" >&2 2>/dev/null || true
    find . -path "*/failed/*" -type f -exec cat {} + >&2
    exit 1
}
expect() { # expect CODE COMMAND...: what it says goes to $work/said
    local wanted=$1 code=0
    shift
    "$@" >"$work/said" 2>&1 || code=$?
    [ $code = "$wanted" ] || die "exit code $code instead of $wanted: $*"
}
says() { grep -q -- "$1" "$work/said" || die "it does not say \"$1\""; }
same() { cmp -s "$1" "$2" || die "$1 and $2 differ"; }
made_by() { sed -n 's/^slurm=//p' "$1"/parts/*/receipt | sort | uniq -c | awk '{ print $1 }' | paste -sd ' '; }
# Until the program runs on a node: what dies then dies in the middle.
running_on() { # running_on JOB NODE
    local i pid
    for ((i = 0; i < 400; ++i)); do
        for pid in $(pgrep -x sward); do
            grep -qzx "SLURMD_NODENAME=n$2" "/proc/$pid/environ" 2>/dev/null &&
                grep -qz -- "--shard\|--first" "/proc/$pid/cmdline" 2>/dev/null && return 0
        done
        sleep 0.05
    done
    die "node n$2 gets nothing to do"
}
# How many parts of a job's first array Slurm started anew.
restarts() { scontrol show job -o "$(cat "$1/runs/0.id")" | sed 's/.* Restarts=\([0-9]*\) .*/\1/' | awk '{ n += $1 } END { print n + 0 }'; }
forge() { # forge RECEIPT KEY VALUE: a receipt of another machine
    { sed '$d' "$1" | sed "s/^$2=.*/$2=$3/"; } >receipt
    { cat receipt; echo "receipt=$(sha256sum <receipt | cut -d ' ' -f 1)"; } >"$1"
}
parts_there() { find "$1/parts" -mindepth 1 -maxdepth 1 -name '[0-9]*' | wc -l; }

"$SWARD" new "the project" >/dev/null
sed -i 's/"bladesPerM2": 4000/"bladesPerM2": 100/; s/"size": \[40, 40\]/"size": [12, 12]/' "the project/project.json"
cluster_scheduler=sched_interval=1,sched_min_interval=0,batch_sched_delay=0
cluster_start "$work/slurm" 2
echo "a Slurm of two nodes runs"

# --- a reference, whose node dies: one part is lost, and made anew
view=(--size 48x40 --samples 96)
"$SWARD" reference "the project" "${view[@]}" --out whole.exr >/dev/null
expect 0 "$farm" submit "a reference" reference "the project" --parts 5 --slurm --no-requeue -- "${view[@]}"
running_on "a reference" 1
node_kill 1
expect 0 "$farm" submit "a reference" reference "the project" --parts 5 --slurm --no-requeue -- "${view[@]}"
says "submitted before"
expect 1 "$farm" submit "a reference" reference "the project" --parts 4 -- "${view[@]}"
says "holds another job"
expect 1 "$farm" watch "a reference"
says "4/5 done, 0 running, 0 waiting, 1 lost"
says "farm resume"
expect 1 "$farm" merge "a reference" --out joined.exr
says "is missing"
node_start 1
stat -c '%Y %i' "a reference"/parts/*/receipt >"$work/before"
expect 0 "$farm" resume "a reference"
says "1 of 5 parts submitted"
expect 0 "$farm" watch "a reference"
says "5/5 done"
[ "$(made_by "a reference")" = "4 1" ] || die "parts by job: $(made_by "a reference") instead of 4 1"
[ "$(stat -c '%Y %i' "a reference"/parts/*/receipt | grep -cFx -f "$work/before")" = 4 ] || die "other parts were made anew"
expect 0 "$farm" merge "a reference" --out joined.exr
same whole.exr joined.exr
same whole.error.exr joined.error.exr
echo "reference: a killed node cost 1 of 5 parts, the whole is one machine's"

# --- parts that are damaged or of another job are refused and made anew
part=$(echo "a reference"/parts/000002/*.part)
printf '\x55' | dd of="$part" bs=1 seek=2000 conv=notrunc status=none
expect 1 "$farm" merge "a reference" --out damaged.exr
says "000002: the part is damaged"
[ ! -e damaged.exr ] || die "damaged parts were merged"
expect 0 "$farm" submit other reference "the project" --parts 5 -- --size 48x40 --samples 2
expect 0 "$farm" watch other
rm -r "a reference/parts/000003"
cp -r other/parts/000003 "a reference/parts/"
expect 1 "$farm" status "a reference"
says "part 3 is stale"
says "lost: parts 2-3"
expect 0 "$farm" resume "a reference"
says "2 of 5 parts submitted"
expect 0 "$farm" watch "a reference"
expect 0 "$farm" merge "a reference" --out joined2.exr
same whole.exr joined2.exr
echo "reference: 1 damaged part and 1 of another job were refused and made anew"

# --- a disk that is full, and a project that changes
mv "a reference/parts/000001" aside
echo 1 >one
expect 1 unshare -m bash -c 'mount -t tmpfs -o size=16k farm "a reference/parts" && dd if=/dev/zero of="a reference/parts/full" bs=1k status=none
    "$@"' - "$farm" part "a reference" one
says "is the disk full? make room"
[ -z "$(find "$work/local" -maxdepth 1 -name 'sward-farm-part*')" ] || die "a part that failed left a folder in $work/local"
cp "the project/project.json" kept.json
sed 's/"seed": 1,/"seed": 2,/' kept.json >"the project/project.json"
! cmp -s kept.json "the project/project.json" || echo >>"the project/project.json"
expect 3 "$farm" part "a reference" one
says "is not what it was at the job's submission"
expect 3 "$farm" resume "a reference"
cp kept.json "the project/project.json"
expect 0 "$farm" part "a reference" one
expect 0 "$farm" part "a reference" one
same aside/*.part "a reference"/parts/000001/*.part
rm -r "a reference/parts/000001"
"$farm" part "a reference" one >/dev/null 2>&1 &
expect 0 "$farm" part "a reference" one
wait $! || die "the second of two that make one part fails"
same aside/*.part "a reference"/parts/000001/*.part
[ -z "$(find "a reference/parts" -name '.*')" ] || die "two that made one part left something"
printf '#!/usr/bin/env bash\n[ "$1" != reference ] || eval "${DURING-}"\nexec %q "$@"\n' "$SWARD" >program
chmod +x program
expect 0 env SWARD="$PWD/program" "$farm" submit changing reference "the project" --parts 5 -- "${view[@]}"
expect 0 "$farm" watch changing
rm -r changing/parts/000001
expect 3 env DURING="echo >>'$PWD/the project/project.json'" "$farm" part changing one
says "changed while the part was made"
[ ! -e changing/parts/000001 ] || die "a part is there of a project that changed meanwhile"
cp kept.json "the project/project.json"
echo "two that make one part do no harm"
echo "a full disk and a changed project leave no part, and each names the remedy"

# --- a sweep, cancelled in the middle
sweep=(--size 32x24 --samples 2 --rounds 1 --technique raytraced --max-ms 1000000)
"$SWARD" cost "the project" "${sweep[@]}" --out whole >/dev/null 2>&1
expect 0 "$farm" submit sweep cost "the project" --parts 3 -- "${sweep[@]}"
running_on sweep 0
code=0
timeout --preserve-status -s INT 1 "$farm" watch sweep >"$work/said" 2>&1 || code=$?
[ $code = 130 ] || die "Ctrl+C ends watch with $code instead of 130"
says "the job goes on"
expect 0 "$farm" cancel sweep
for ((i = 0; i < 100; ++i)); do [ -z "$(squeue -h)" ] && break || sleep 0.2; done
[ -z "$(squeue -h)" ] || die "what was cancelled goes on"
[ "$(parts_there sweep)" -lt 3 ] || die "it was cancelled too late to show anything"
expect 1 "$farm" status sweep
expect 0 "$farm" resume sweep
expect 0 "$farm" watch sweep
expect 0 "$farm" merge sweep --out joined
# All but times, what follows from them, and on which of the machines a row was timed.
timeless() { sed '/^  "machines": \[/,/^  \]/d' "$1" | grep -v '"\(ms\|ms_median\|ms_p95\|ms_sigma\|on_frontier\|machine\|digest\)":'; }
timeless whole/cost.json >whole.txt
timeless joined/cost.json >joined.txt
same whole.txt joined.txt
[ "$(grep -c '"technique"' whole.txt)" -gt 3 ] || die "the sweep has too few rows to show anything"
# A table a machine: it has the rows of that machine's parts, with their times, and no others. Frontiers are of a table.
no_frontier() { sed '1d; s/,[01],\("[^"]*"\)\{0,1\}$//' "$@" | sort; }
for n in 0 1; do
    own=()
    for part in sweep/parts/*; do
        if grep -qx "host=$(hostname)-n$n" "$part/receipt"; then own+=("$part/sweep/cost.csv"); fi
    done
    [ ${#own[@]} -gt 0 ] || die "node n$n made no part of the sweep"
    for part in "${own[@]}"; do no_frontier "$part"; done | sort >own.txt
    no_frontier "joined/cost.$(hostname)-n$n.csv" >table.txt
    same own.txt table.txt
    sed 1d "joined/cost.$(hostname)-n$n.csv" | grep -q ',1,\(""\)\{0,1\}$' || die "no row of node n$n is on its frontier"
    [ "$(grep -c "\"host\": \"$(hostname)-n$n\"" joined/cost.json)" = 1 ] || die "node n$n is not once among the machines"
done
[ ! -e joined/cost.csv ] || die "times of two machines are in one table"
echo "cost: cancelled and resumed, $(grep -c '"technique"' whole.txt) rows are one machine's in all but times, which are kept apart"

# --- a film, whose node dies: Slurm gives its part to another
film=(--size 48x32 --fps 10 --frames 9 --time 1)
"$SWARD" render "the project" "${film[@]}" --out whole-film >/dev/null
expect 0 "$farm" submit film film "the project" --parts 4 -- "${film[@]}"
running_on film 1
node_kill 1
expect 0 "$farm" watch film
says "4/4 done"
[ "$(restarts film)" = 1 ] || die "Slurm gave $(restarts film) parts anew instead of 1"
expect 0 "$farm" merge film --out joined-film
diff -r whole-film joined-film >"$work/said" || die "films differ"
[ "$(find joined-film -type f | wc -l)" = 9 ] || die "it has not 9 frames"
node_start 1
echo "film: a killed node's part was made by another, 9 frames are one machine's"

# --- frames of different renderers are not mixed unseen
forge film/parts/000000/receipt renderer another
expect 1 "$farm" merge film --out mixed-film
says "different renderers"
expect 0 "$farm" merge film --out mixed-film --mixed

forge "a reference/parts/000000/receipt" cpu another
expect 0 "$farm" merge "a reference" --out joined3.exr
says "different machines (cpu)"

# --- bakes of two projects
cp -r "the project" second
sed -i 's/"seed": 1,/"seed": 3,/' second/project.json
mkdir one-machine
cp -r "the project" second one-machine/
bakes=(--samples 4 --size 16)
for p in "the project" second; do
    XDG_CACHE_HOME=$work/cache1 "$SWARD" bake "one-machine/$p" "${bakes[@]}" >/dev/null 2>&1
done
expect 0 "$farm" submit bakes bake "the project" second -- "${bakes[@]}"
expect 0 "$farm" watch bakes
says "4/4 done"
expect 0 "$farm" merge bakes --out "$work/cache2"
! grep -q "slices: .* MB (" "$work/said" || die "slices were made again"
diff -r -x '.*' "one-machine/the project" "the project" >"$work/said" || die "baked projects differ"
diff -r -x '.*' one-machine/second second >"$work/said" || die "baked projects differ"
diff -r "$work/cache1/sward" "$work/cache2/sward" >"$work/said" || die "caches differ"
expect 0 env XDG_CACHE_HOME="$work/cache3" "$farm" merge bakes --out -
diff -r "$work/cache1/sward" "$work/cache3/sward" >"$work/said" || die "caches differ"
echo "bake: 4 bakes of 2 projects are one machine's, project and cache"

# --- what is wrong with a command
expect 2 "$farm" submit bad film "the project" --parts 3 -- --fps 25
expect 2 "$farm" submit bad reference "the project" --parts 0
expect 2 "$farm" submit bad reference "the project" --parts 2 -- --shard 0/2
expect 3 "$farm" submit bad reference nowhere --parts 2
expect 2 "$farm" watch nowhere
says "is no job"
kill -9 "$(cat "$cluster/slurmctld.pid")"
expect 1 "$farm" status film
says "is slurmctld up"
echo "farm: all trials held"
