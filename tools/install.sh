#!/usr/bin/env bash
# Installs the distribution packages of third_party/packages.txt that are missing; does nothing if none is.
# Needs root or sudo, and the network, only when something is missing. Speaks on standard error.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
list=$root/third_party/packages.txt
say() { echo "Sward: $*" >&2; }

command -v dpkg-query >/dev/null && command -v apt-get >/dev/null || {
    say "this system has no apt-get; if the build lacks something, third_party/README.md says what it needs"
    exit 0
}

# Prints the wanted lines of which no alternative is installed.
missing() {
    local -A installed=()
    local status name line
    while read -r status name; do
        [ "$status" != installed ] || installed[$name]=1
    done < <(sed 's/#.*//; s/|/ /g' "$list" | xargs dpkg-query -W -f '${db:Status-Status} ${Package}\n' 2>/dev/null || true)
    while IFS= read -r line; do
        for name in ${line//|/ }; do
            [ -z "${installed[$name]:-}" ] || continue 2
        done
        echo "$line"
    done < <(sed 's/#.*//; s/[[:space:]]*$//; /^$/d' "$list")
}
mapfile -t lacking < <(missing)
[ ${#lacking[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" != 0 ]; then
    as_root=(sudo)
    command -v sudo >/dev/null || {
        say "these packages are missing, and installing them needs root or sudo:"
        say "  apt-get install ${lacking[*]}"
        exit 1
    }
fi

log=$(mktemp)
trap 'rm -f "$log"' EXIT
fail() {
    tail -n 15 "$log" >&2
    say "$1"
    say "  ${as_root[*]:+${as_root[*]} }apt-get install ${lacking[*]}"
    exit 1
}
apt() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 -o Acquire::Retries=2 "$@" >>"$log" 2>&1; }

say "installing ${#lacking[@]} packages: ${lacking[*]}"
if [ ${#as_root[@]} -gt 0 ]; then
    sudo -v || fail "these packages are missing, and sudo did not let us install them; as a user who may:"
fi
apt update || true  # off line this fails, but what the cache holds may do
wanted=()
for line in "${lacking[@]}"; do
    for name in ${line//|/ }; do
        wanted+=("$name")
        [ -z "$(apt-cache show "$name" 2>/dev/null)" ] || break
        unset 'wanted[-1]'
    done
done
[ ${#wanted[@]} = ${#lacking[@]} ] || fail "the package sources of this system do not know some of these packages (is it on line? is it Debian 12 or later?):"
apt install -y --no-install-recommends "${wanted[@]}" || fail "these packages could not be installed; once the cause above is mended, run this again, or:"
mapfile -t lacking < <(missing)
[ ${#lacking[@]} = 0 ] || fail "still missing after installation:"
