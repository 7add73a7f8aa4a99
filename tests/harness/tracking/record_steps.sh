#!/bin/sh
# Records the history in tests/data/tracking/steps.jsonl: 42 revisions of the in-house engine, six of each level, of
# which the second, fourth and sixth are builds slower by 3, 5 and 10 % (cmake/injection.cmake).
#
#     tests/harness/tracking/record_steps.sh BUILD_FOLDER FILE.jsonl
#
# Takes about ten minutes. The folder is configured anew for every level and left without a slow-down.
set -eu
build=$1 file=$2
source=$(cd "$(dirname "$0")/../../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for percent in 3 5 10 0; do
  cmake "$build" -DCYLON_INJECT_SLOWDOWN=$percent > "$work/log"
  cmake --build "$build" --target cylon-worker-in-house > "$work/log" || { cat "$work/log" >&2; exit 1; }
  cp "$build/cylon-worker-in-house" "$work/worker-$percent"
done
cmake --build "$build" --target cylon > "$work/log" || { cat "$work/log" >&2; exit 1; }

store="$work/history.db"
"$build/cylon" track pin anchor --note "no slow-down" --store "$store"
revision=0
for percent in 0 3 0 5 0 10 0; do
  for _ in 1 2 3 4 5 6; do
    revision=$((revision + 1))
    "$build/cylon" track record dzhanibekov --engine in-house --integrator rk4 --repetitions 10 --store "$store" \
      --worker in-house="$work/worker-$percent" --revision "$(printf 'r%02d' $revision)" --note "slower by $percent %"
  done
done
"$build/cylon" track export "$file" --store "$store"
