#!/bin/bash
# Exports of sample projects held against the public glTF validator: no error, no warning.
#   validate_glb.sh SWARD PROJECTS-FOLDER
# Ends with 77, which CTest takes as skipped, where node or its package gltf-validator is not installed. The package is
# looked for where node looks, and in npm's global folder: `npm install --global gltf-validator` puts it there.
set -eu
sward=$1 projects=$2
command -v node >/dev/null || { echo "node is not installed"; exit 77; }
globals=$(npm root --global 2>/dev/null || true)
export NODE_PATH=${NODE_PATH:-}${NODE_PATH:+:}$globals
node -e 'require("gltf-validator")' 2>/dev/null || { echo "the package gltf-validator is not installed"; exit 77; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/validate.js" <<'JS'
const validator = require("gltf-validator"), fs = require("fs");
const file = process.argv[2];
// It knows no EXT_mesh_gpu_instancing, and so takes what that alone uses for unused; all else that it says counts. What
// the extension holds is checked by Sward (engine/exchange/glb_check.h).
const ignoredIssues = ["UNSUPPORTED_EXTENSION", "UNUSED_OBJECT"];
validator.validateBytes(new Uint8Array(fs.readFileSync(file)), { uri: file, maxIssues: 0, ignoredIssues }).then((report) => {
    const { numErrors, numWarnings, numInfos, numHints, messages } = report.issues;
    console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos, ${numHints} hints`);
    for (const m of messages.slice(0, 20)) console.log(`  ${["error", "warning", "info", "hint"][m.severity]} ${m.code} ${m.pointer}: ${m.message}`);
    process.exit(numErrors + numWarnings > 0 ? 1 : 0);
});
JS

failed=0
validate() { # project metres
  local file=$work/$1.glb
  "$sward" export "$projects/$1" --blades-within "$2" --out "$file" >/dev/null
  (cd "$work" && node validate.js "$1.glb") || failed=1
  rm -f "$file"
}
validate park 4
validate forest 1
validate rockery 8
validate oasis 3
validate football 1
exit $failed
