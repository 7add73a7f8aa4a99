#!/usr/bin/env bash
# What `cylon track` finds on this machine, as busy as it is now: a build against itself (no alarm), against builds whose
# steps take 5 and 10 % longer, and against one with a constant that is 20 % wrong.  Rows on stdout, a summary last.
#   bench/tracking_proof.sh [A/A comparisons, 200] [trials of each slow-down, 20]
# Times are the least of 8 repetitions of a millisecond: a comparison takes seconds, all of it half an hour.
set -euo pipefail
cd "$(dirname "$0")/.."
same=${1:-200} trials=${2:-20}

# The same source in four builds: a baseline, and three that are worse by a known amount (cmake/injection.cmake).
build() {  # folder, options…
  local folder=build/proof/$1 && shift
  cmake --preset release -B "$folder" "$@" >/dev/null
  cmake --build "$folder" --target cylon-worker-in-house >/dev/null
}
build base
build slow5 -DCYLON_INJECT_SLOWDOWN=5
build slow10 -DCYLON_INJECT_SLOWDOWN=10
build fault -DCYLON_INJECT_FAULT=scheme-constant
cmake --build build/proof/base --target tracking_proof >/dev/null

proof() { build/proof/base/tracking_proof . "$@"; }  # kind, baseline, candidate, trials
rows=$(mktemp)
trap 'rm -f "$rows"' EXIT
{
  proof A/A build/proof/base build/proof/base "$same"
  proof slow5 build/proof/base build/proof/slow5 "$trials"
  proof slow10 build/proof/base build/proof/slow10 "$trials"
  proof fault build/proof/base build/proof/fault 1
} | tee "$rows"

echo
awk -F, '{ n[$1]++; found[$1] += $5 == "regressed"; better[$1] += $5 == "improved"; pairs[$1] += $9 }
  END { for (kind in n) if (kind == "fault") printf "%-7s %d of %d found\n", kind, found[kind], n[kind]
    else printf "%-7s %d comparisons: %d regressed, %d improved, %.0f pairs on average\n", kind, n[kind], found[kind],
    better[kind], pairs[kind] / n[kind] }' "$rows" | sort
