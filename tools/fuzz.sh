#!/usr/bin/env bash
# Fuzzes what reads files and scripts: tools/fuzz.sh SECONDS [NAME...]
# Builds tests/fuzz/ with clang's libFuzzer and the sanitizers, and lets each NAME (default: all) try inputs for so
# long, as many at once as there are cores. Inputs that reached something new stay in build/fuzz/corpus/NAME. Prints how
# many each tried; ends with 1 if one crashed, hung, took too much memory or broke a promise, and says where the input is.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
cd "$root"
seconds=$1
shift
tools/build.sh fuzz fuzz
names=("$@")
[ $# -gt 0 ] || mapfile -t names < <(basename -a -s _fuzz.cpp tests/fuzz/*_fuzz.cpp)
cd build/fuzz
./fuzz_seeds seeds
export ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1:quarantine_size_mb=16 LC_ALL=C
[ -w /dev/shm ] && export TMPDIR=/dev/shm
run() {
    mkdir -p "corpus/$1" findings
    "./$1_fuzz" "corpus/$1" "seeds/$1" -max_total_time="$seconds" -max_len=65536 -timeout=60 -rss_limit_mb=3000 \
        -close_fd_mask=3 -print_final_stats=1 -artifact_prefix="findings/$1-" >"$1.log" 2>&1 || touch "$1.failed"
    echo "$1: $(sed -n 's/^stat::number_of_executed_units: *//p' "$1.log") inputs tried"
}
export -f run
export seconds
rm -f ./*.failed
printf '%s\n' "${names[@]}" | xargs -P "$(nproc)" -I{} bash -c 'run {}'
failed=0
for name in "${names[@]}"; do
    [ -e "$name.failed" ] || continue
    failed=1
    grep -E 'ERROR|SUMMARY|broken promise|runtime error|Test unit written' "$name.log" || tail -n 5 "$name.log"
done
exit $failed
