#!/usr/bin/env bash
# Lays out sources and shaders by .clang-format: tools/format.sh [--check] [FILES]; all of them if none is named.
#   --check  changes nothing: names each file that is laid out otherwise, and ends with 1 if there is one
# Layout differs from one clang-format to the next. Ours is 14, Debian 12's: without it, it says so and ends with 77.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
version=14
note=
if [ "${1:-}" = --check ]; then
    note=": laid out otherwise; tools/format.sh mends it"
    shift
fi

tool=$(command -v "clang-format-$version" || command -v clang-format || true)
found=$([ -z "$tool" ] || "$tool" --version | sed -n 's/.*version \([0-9]*\).*/\1/p')
if [ "$found" != "$version" ]; then
    echo "Sward: skipped: layout is that of clang-format $version, and this is ${found:-none}" >&2
    exit 77
fi

# Mends C++ files, or with --check names those that are laid out otherwise.
sources() {
    if [ -z "$note" ]; then
        "$tool" -i "$@"
    else
        "$tool" --dry-run "$@" 2>&1 | sed -n "s|:[0-9]*:[0-9]*: .*-Wclang-format-violations.*|$note|p" | sort -u
    fi
}
# Shaders likewise, as C++; but the order of their includes is theirs.
shaders() {
    local file new
    new=$(mktemp)
    for file; do
        "$tool" --sort-includes=0 --assume-filename=shader.h <"$file" >"$new"
        cmp -s "$file" "$new" && continue
        [ -z "$note" ] && cat "$new" >"$file" || echo "$file$note"
    done
    rm -f "$new"
}
export -f sources shaders
export tool note

files() {
    if [ $# -gt 0 ]; then
        printf '%s\n' "$@"
    else
        find engine editor bench tests shaders -name '*.h' -o -name '*.cpp' -o -name '*.glsl'
    fi
}
each() { xargs -r -d '\n' -n 64 -P "$(nproc)" bash -euo pipefail -c "$1"' "$@"' "$1"; }
off=$(mktemp)
trap 'rm -f "$off"' EXIT
files "$@" | grep '\.glsl$' | each shaders | tee "$off" || true
files "$@" | grep -v '\.glsl$' | each sources | tee -a "$off" || true
[ -z "$note" ] || [ ! -s "$off" ]
