#!/usr/bin/env bash
# Installs the distribution packages of a list (default: third_party/packages.txt) that are missing; does nothing if
# none is: tools/install.sh [LIST]
# Needs root or sudo, and the network, only when something is missing. Speaks on standard error.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
say() { echo "Sward: $*" >&2; }

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    say "this system has no apt-get; if the build lacks something, third_party/README.md says what it needs"
    exit 0
fi

list=${1:-third_party/packages.txt}
mapfile -t wanted < <(sed 's/#.*//' "$root/$list" | xargs -n 1)
# Prints those that are not installed.
missing() {
    local installed
    installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${wanted[@]}" 2>/dev/null | sed -n 's/^installed //p' || true)
    printf '%s\n' "${wanted[@]}" | grep -vxF -f <(echo "$installed") || true
}
mapfile -t lacking < <(missing)
[ ${#lacking[@]} -gt 0 ] || exit 0

as_root=()
[ "$(id -u)" = 0 ] || as_root=(sudo)
log=$(mktemp)
trap 'rm -f "$log"' EXIT
fail() { # fail WHAT: shows how apt ended, names the packages, and stops
    tail -n 15 "$log" >&2
    say "$1"
    say "  ${as_root[*]:+${as_root[*]} }apt-get install ${lacking[*]}"
    exit 1
}
apt() {
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get -q -o DPkg::Lock::Timeout=300 -o Acquire::Retries=2 "$@" >>"$log" 2>&1
}

if [ ${#as_root[@]} -gt 0 ]; then
    if ! command -v sudo >/dev/null; then
        as_root=()
        fail "${#lacking[@]} packages are missing, and installing them needs root or sudo; as root:"
    fi
    sudo -v || fail "${#lacking[@]} packages are missing, and sudo did not let us install them; as someone whom it does:"
fi
say "installing ${#lacking[@]} packages: ${lacking[*]}"
apt update || true  # off line this fails, but what apt has fetched before may do
apt install -y --no-install-recommends "${lacking[@]}" || fail "they could not be installed (see above); once that is mended, run this again, or:"
mapfile -t lacking < <(missing)
[ ${#lacking[@]} = 0 ] || fail "still missing after installation:"
