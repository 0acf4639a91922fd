#!/usr/bin/env bash
# Every system call by which a save can fail fails in turn: tests/trials/disk_faults.sh SWARD
# A project is changed and saved by a script while strace makes the N-th call of a kind fail as a full, failing or
# read-only disk would. Afterwards the project must be what it was, or what it was to become, and a script that ended
# well must have saved. Prints one line a kind of call; ends with 1 at the first project that is neither. Needs strace.
set -euo pipefail
sward=$(readlink -f "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export XDG_CACHE_HOME=$work/cache XDG_STATE_HOME=$work/state
trace() { strace -f -qq -o log "$@" >/dev/null 2>said; }
hash_of() { "$sward" script hash.lua 2>said | tail -n 1; }

cat >hash.lua <<'LUA'
project.open("p")
print(project.hash())
LUA
cat >nothing.lua <<'LUA'
project.open("p")
LUA
cat >save.lua <<'LUA'
project.open("p")
map.fill("density", 0.25)
project.save()
LUA
"$sward" new made >/dev/null
again() { rm -rf p && cp -r made p; }
again
before=$(hash_of)
trace -e trace=all "$sward" script save.lua
after=$(hash_of)
[ -n "$before" ] && [ "$before" != "$after" ] || { echo "the script saves nothing"; exit 1; }
calls_in() { # calls_in SCRIPT KIND: how many it makes
    trace -e trace="$2" "$sward" script "$1" || true
    grep -c "$2(" log || true
}

faults=0
for kind in openat mkdir write pwrite64 writev fsync fdatasync rename renameat unlink unlinkat ftruncate flock fcntl; do
    again
    first=$(calls_in nothing.lua "$kind")
    again
    last=$(calls_in save.lua "$kind")
    tried=0
    for error in ENOSPC EIO EROFS; do
        # Writing and opening go on in threads: a few calls on either side, lest one is left out.
        for ((n = first > 2 ? first - 1 : 1; n <= last + 1; ++n)); do
            again
            code=0
            trace -e trace="$kind" -e inject="$kind:error=$error:when=$n" "$sward" script save.lua || code=$?
            grep -q INJECTED log || continue
            tried=$((tried + 1))
            now=$(hash_of)
            if [ "$now" = "$after" ] || { [ "$now" = "$before" ] && [ $code != 0 ]; }; then continue; fi
            echo "$kind number $n with $error: exit code $code, and the project is ${now:-unreadable}"
            cat said
            exit 1
        done
    done
    faults=$((faults + tried))
    [ $tried = 0 ] || echo "$kind: $tried faults"
done
echo "$faults faults, and after each the project before or after the save"
[ $faults -ge 50 ] || { echo "fewer than there must be: does strace work here?"; exit 1; }
