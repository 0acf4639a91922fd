#!/bin/sh
# Renders the pictures of the start screen: projects/NAME/picture.png of the samples, projects/templates/NAME.png of the
# templates. To be run by hand after a change of how they look; the samples must be there (the default build).
#   tools/pictures.sh [path/to/sward] [NAME...]
set -eu
here=$(cd "$(dirname "$0")/.." && pwd)
sward=${1:-$here/build/release/sward}
[ $# -gt 0 ] && shift
size=320x200
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
wanted() { [ -z "$names" ] || case " $names " in *" $1 "*) true ;; *) false ;; esac; }
names="$*"

for project in "$here"/projects/*/project.json; do
    project=${project%/project.json}
    wanted "$(basename "$project")" || continue
    "$sward" render "$project" --camera human --size $size --out "$project/picture.png" > "$work/said" 2>&1 ||
        "$sward" render "$project" --size $size --out "$project/picture.png"
done
for script in "$here"/projects/templates/*.lua; do
    name=$(basename "$script" .lua)
    wanted "$name" || continue
    "$sward" new "$work/$name" --template "$name" > "$work/said"
    "$sward" render "$work/$name" --size $size --out "$here/projects/templates/$name.png"
done
