#!/usr/bin/env bash
# Do gcc -O2, gcc -O3 and clang -O2 give the same bits?  Builds the in-house worker three times, simulates every
# scenario with each, and compares the CSV (17 digits of every state).  Not part of ctest: it wants clang and
# builds for minutes.  Exit codes: 0 the same bits, 1 they differ, 2 something is missing.
#
#   tests/determinism.sh [SCHEME…]      the engine's default scheme, or those named: tests/determinism.sh rk4 velocity-verlet
#
# The harness is build/release/cylon; the environment variable CYLON_WORKERS tells it where the workers stand.
set -euo pipefail
cd "$(dirname "$0")/.."

cylon=build/release/cylon
[ -x $cylon ] || { echo "determinism: build the release preset first" >&2; exit 2; }
command -v clang++ >/dev/null || { echo "determinism: no clang++ here" >&2; exit 2; }

build() {  # NAME COMPILER OPTIMISATION
  echo "building $1" >&2
  cmake -S . -B "build/determinism/$1" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$2" \
    -DCMAKE_CXX_FLAGS_RELEASE="$3 -DNDEBUG" >/dev/null
  ninja -C "build/determinism/$1" cylon-worker-in-house >/dev/null
}
build gcc-O2 g++ -O2
build gcc-O3 g++ -O3
build clang-O2 clang++ -O2

out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
[ $# -gt 0 ] || set -- ""
differ=0
for file in scenarios/*.toml; do
  [ "$file" = scenarios/expected.toml ] && continue
  for scheme in "$@"; do
    for build in gcc-O2 gcc-O3 clang-O2; do
      CYLON_WORKERS="$PWD/build/determinism/$build" \
        $cylon simulate "$file" --engine in-house ${scheme:+--integrator "$scheme"} --out "$out/$build.csv" || exit 2
    done
    states=$(($(wc -l <"$out/gcc-O2.csv") - 1))
    for build in gcc-O3 clang-O2; do
      if where=$(cmp "$out/gcc-O2.csv" "$out/$build.csv"); then
        echo "same bits: $file $scheme gcc-O2 $build ($states states)"
      else
        echo "DIFFERS: $file $scheme gcc-O2 $build: $where"
        differ=1
      fi
    done
  done
done
exit $differ
