#!/usr/bin/env bash
# What it costs to share work out: the same cells by one process of two workers; by eight shards of one worker each, two
# at a time, with the merge that joins them; and by a farm of two ranks of MPI of one worker each; in turns.  Of each the
# wall time, which says something on an idle machine alone, and the CPU time of all its processes.
#
#     bench/shards.sh [CYLON [ROUNDS [STEPS [PATTERNS…]]]]
#
# Without arguments 10 020 cells: ten scenes that last one or two whole seconds, so that every step fits, three engines, 334
# steps from 1/401 s on.  Such cells take some 12 ms each, of which starting an engine is the greater part: what sharing costs
# shows most.  COARSEST=8000 begins at 1/8001 s, with cells of 50 ms.
set -euo pipefail
cylon=$(realpath "${1:-build/release/cylon}")
rounds=${2:-1} count=${3:-334} coarsest=${COARSEST:-400}
shift $(($# < 3 ? $# : 3))
[ $# -gt 0 ] || set -- slide_to_roll two_sphere_head_on two_sphere_oblique bouncing_sphere_quarter sphere_threshold_slips \
  slipping_sphere_incline two_sphere_head_on_half rough_ball_bounce near_miss spring_damper \
  --engine in-house --engine ode --engine bullet
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

steps=$(for n in $(seq 1 "$count"); do echo "--dt 1/$((coarsest + n))"; done)
one() { "$cylon" run "$@" $steps -j2 --json one.json >/dev/null 2>one.err || [ $? -le 2 ]; }
shards() {
  seq 1 8 | xargs -P 2 -I K sh -c '"$@" --shard K/8 -j1 >/dev/null 2>K.err || [ $? -le 2 ]' sh "$cylon" run "$@" $steps
  "$cylon" merge .cylon/journal-*-of-8.jsonl --json all.json >/dev/null 2>merge.err || [ $? -eq 1 ]
}
farm() {
  mpirun --oversubscribe -n 2 "$cylon" farm run "$@" $steps -j1 --json farm.json >/dev/null 2>farm.err || [ $? -le 2 ]
}
measured() { # wall and CPU seconds of a function
  local start=$EPOCHREALTIME
  (
    "$@"
    times >times # not in a pipe, which would count its own children
    awk 'NR == 2 { split($1, u, /[ms]/); split($2, s, /[ms]/); printf "%.2f ", 60 * (u[1] + s[1]) + u[2] + s[2] }' times
  )
  awk "BEGIN { printf \"%.2f\", $EPOCHREALTIME - $start }"
}
ratio() { awk "BEGIN { printf \"%.3f\", $1 / $2 }"; }

one "$@"
echo "cells: $(python3 -c 'import json; print(len({(v["scenario"], v["engine"], v["dt_text"]) for v in json.load(open("one.json"))["verdicts"]}))')"
for round in $(seq "$rounds"); do
  read -r cpu_one wall_one < <(measured one "$@"; echo)
  for way in shards farm; do
    read -r cpu wall < <(measured "$way" "$@"; echo)
    echo "round $round, $way: CPU $cpu s of $cpu_one s, ratio $(ratio "$cpu" "$cpu_one"); wall $wall s of $wall_one s, ratio $(ratio "$wall" "$wall_one")"
  done
done
