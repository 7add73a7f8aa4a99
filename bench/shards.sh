#!/usr/bin/env bash
# What shards cost: the same cells by one process of two workers, and by eight shards of one worker each, two at a time,
# with the merge that joins them; in turns.
#
#     bench/shards.sh [CYLON [ROUNDS [PATTERNS…]]]
set -euo pipefail
cylon=$(realpath "${1:-build/release/cylon}")
rounds=${2:-5}
shift $(($# < 2 ? $# : 2))
[ $# -gt 0 ] || set -- '*'
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

steps=$(for n in $(seq 1 40); do echo "--dt 1/$((40 * n))"; done)
# Cells of which a step does not fit the duration are refused, by both.
one() { "$cylon" run "$@" $steps -j2 --json one.json >/dev/null 2>one.err || [ $? -le 2 ]; }
shards() {
  seq 1 8 | xargs -P 2 -I K sh -c '"$@" --shard K/8 -j1 >/dev/null 2>K.err || [ $? -le 2 ]' sh "$cylon" run "$@" $steps
  "$cylon" merge .cylon/journal-*-of-8.jsonl --json all.json >/dev/null 2>merge.err || [ $? -eq 1 ]
}
seconds() {
  local start=$EPOCHREALTIME
  "$@"
  awk "BEGIN { printf \"%.2f\", $EPOCHREALTIME - $start }"
}

one "$@"
echo "cells: $(python3 -c 'import json; print(len({(v["scenario"], v["engine"], v["dt_text"]) for v in json.load(open("one.json"))["verdicts"]}))')"
for round in $(seq "$rounds"); do
  a=$(seconds one "$@")
  b=$(seconds shards "$@")
  echo "round $round: one process $a s, eight shards $b s, ratio $(awk "BEGIN { printf \"%.3f\", $b / $a }")"
done
