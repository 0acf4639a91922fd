#!/usr/bin/env bash
# Configures (if needed) and builds a preset of CMakePresets.json: tools/build.sh PRESET [TARGET...]
# Speaks on standard error, so that what runs afterwards has standard output to itself.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
preset=$1
shift
cd "$root"
exec >&2
dir=build/$preset
say() { echo "Sward: $*"; }

if [ ! -f "$dir/build.ninja" ] || [ CMakePresets.json -nt "$dir/build.ninja" ]; then
    say "configuring $preset"
    mkdir -p "$dir"
    if ! cmake --preset "$preset" >"$dir/configure.log" 2>&1; then
        cat "$dir/configure.log"
        say "CMake could not configure the $preset preset; third_party/README.md lists what it needs"
        exit 1
    fi
fi

# A home that cannot be written to is no reason to fail.
cache=$(ccache -k cache_dir 2>/dev/null || true)
if [ -n "$cache" ] && ! { mkdir -p "$cache" 2>/dev/null && [ -w "$cache" ]; }; then export CCACHE_DISABLE=1; fi

jobs=${SWARD_JOBS:-$(nproc)}
targets=(--target "$@")
[ $# -gt 0 ] || targets=()
build() { cmake --build --preset "$preset" --parallel "$jobs" "${targets[@]}" "$@"; }
[ -e "$dir/.built" ] || say "building $preset with $jobs jobs (minutes the first time)"

# On a terminal ninja rewrites one line; elsewhere only warnings and errors are worth a log.
code=0
if [ -t 2 ]; then
    build || code=$?
else
    build -- --quiet | { grep -v '^ninja: no work to do\.$' || true; } || code=$?
fi
if [ $code != 0 ]; then
    say "the $preset build failed; the first error above says why"
    exit 1
fi
: >"$dir/.built"
