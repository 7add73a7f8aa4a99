#!/usr/bin/env bash
# Follows "From an empty folder to a red test" of docs/library.md as an engine's author would, in the empty folder where
# this starts: takes files and commands from the page, and prints the time of each command.
#   tests/package/author.sh PAGE
# Fails unless the test is red by the amount that the page names, and green with the line that the page mends.
set -euo pipefail
page=$1 log=$PWD/log
fail() { echo "FAILED: $*" >&2; exit 1; }
section=$(sed -n '/^## From an empty folder to a red test/,/^## An example/p' "$page")
block() { # heading: the block of code below the line that begins with the heading
  awk -v heading="$1" 'index($0, heading) == 1 { here = 1 } here && /^```/ { if (inside) exit; inside = 1; next } inside; END { exit !inside }' <<<"$section" ||
    fail "no block below '$1' in $page"
}
timed() { # command: its output goes to the log
  local begin=$EPOCHREALTIME code=0
  bash -c "$1" >"$log" 2>&1 || code=$?
  printf '%6.1f s  %s\n' "$((${EPOCHREALTIME/./} - ${begin/./}))e-6" "$1"
  return $code
}
says() { grep -qF -- "$1" "$log" || { cat "$log" >&2; fail "the test does not say '$1'"; }; }

all=$SECONDS
for file in worker.cc engine_test.cc CMakeLists.txt; do block "\`$file\`" >$file; done
mapfile -t commands < <(block 'Then:')
for command in "${commands[@]}"; do
  if [[ $command == ctest* ]]; then
    if timed "$command"; then fail "the test of an engine of first order is green"; fi
  else
    timed "$command" || { cat "$log" >&2; fail "$command"; }
  fi
done
while IFS= read -r line; do says "$line"; done < <(block 'The test is red.')
took=$((SECONDS - all))
echo "$took s from an empty folder to a red test"
[ $took -lt 600 ] || fail "that is more than ten minutes"
engine=$(<worker.cc)
wrong='      state_[i].position += state_[i].velocity * dt_;'
[[ $engine == *"$wrong"* ]] || fail "worker.cc has no line to mend"
printf '%s\n' "${engine/"$wrong"/"$(block 'The last line of')"}" >worker.cc
for command in "${commands[@]: -2}"; do timed "$command" || { cat "$log" >&2; fail "$command, after the line was mended"; }; done
