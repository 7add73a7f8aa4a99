#!/usr/bin/env bash
# How long a newcomer waits, in a fresh clone and without a compiler cache, packages installed: wall and CPU time of
#   the matrix of steps of ./run, and ./run to its end
#   ./test to its end
#   a change in one file of the engine, rebuilt and the engine's tests run
# Not part of continuous integration: it compiles everything and wants a quiet machine.
#
#   bench/build_times.sh [PHASE…]    run, test, change; all three when none is named.  FOLDER=… keeps the clone there
set -euo pipefail
cd "$(dirname "$0")/.."
folder=${FOLDER:-$(mktemp -d)}
[ -n "${FOLDER:-}" ] || trap 'rm -rf "$folder"' EXIT
[ -d "$folder/.git" ] || git clone -q . "$folder"
cd "$folder"
export CCACHE_DISABLE=1
TIMEFORMAT='%R %U %S'

clock() { # [s] as minutes and seconds
  printf '%d min %02d s' $((${1%.*} / 60)) $((${1%.*} % 60))
}
row() { # what, file with wall, user and system time
  read -r wall user system < <(tail -n 1 "$2")
  echo "$1: $(clock "$wall") wall, $(clock "$(echo "$user + $system" | bc)") CPU"
}
# Each line with the seconds since the start before it.
stamped() { while IFS= read -r line; do printf '%6d  %s\n' "$SECONDS" "$line"; done; }

echo "$(git rev-parse --short HEAD), $(nproc) processors, load $(cut -d' ' -f1 /proc/loadavg), $(c++ --version | head -n 1)"
phases=("$@")
[ $# -gt 0 ] || phases=(run test change)
for phase in "${phases[@]}"; do
  case "$phase" in
    run)
      rm -rf build
      SECONDS=0
      { time ./run </dev/null 2>&1 | stamped >run.log; } 2>run.time || true
      first=$(awk '/verdicts follow/ {print $1; exit}' run.log)
      echo "./run, matrix of steps: $(clock "$first") wall"
      row "./run, to its end" run.time
      ;;
    test)
      { time ./test </dev/null >test.log 2>&1; } 2>test.time || echo "./test failed: $folder/test.log"
      row "./test, to its end" test.time
      tail -n 3 test.log
      ;;
    change)
      ./test suite engine NoSuchTest >/dev/null 2>&1 || true
      echo "// changed" >>engine/body.cc
      { time ./test suite engine </dev/null >change.log 2>&1; } 2>change.time || echo "the engine's tests failed: $folder/change.log"
      git checkout -q engine/body.cc
      row "engine/body.cc changed, rebuilt, the engine's tests run" change.time
      ;;
    *) echo "no phase '$phase': run, test, change" >&2; exit 2 ;;
  esac
done
