#!/usr/bin/env bash
# The report and the viewer in a real browser, and the pages' own logic in node.
#   tests/reports/web/run.sh FOLDER_OF_CYLON [FILE…]   all of tests/reports/web/**/*.test.mjs, or those files
# Exits 77, which ctest takes for skipped, where node, npm or Chromium are not there.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
export CYLON_BINARY_DIR=$(cd "${1:?the folder with cylon}" && pwd)
shift
for program in node npm chromium; do
  command -v "$program" >/dev/null || { echo "skipped: there is no $program here" >&2; exit 77; }
done
packages() { # folder: those of its lock file
  [ "$1/node_modules/.package-lock.json" -nt "$1/package-lock.json" ] ||
    (cd "$1" && npm ci --ignore-scripts --no-progress >&2) || { echo "skipped: npm cannot fetch the packages of $1" >&2; exit 77; }
}
exec 9>"$here/.packages.lock"
flock 9
packages "$here"
packages "$here/../../../reports/web"
flock -u 9
cd "$here"
[ $# -gt 0 ] || mapfile -t files < <(find . -name '*.test.mjs' -not -path '*/node_modules/*' | LC_ALL=C sort)
exec node --test --test-concurrency=2 "${@:-${files[@]}}"
