#!/usr/bin/env bash
# Do gcc -O2, gcc -O3 and clang -O2 give the same bits, and any number of threads?  Builds the in-house worker three
# times, simulates every scenario that the engine takes with each, and compares the CSV (17 digits of every state).
# Not part of ctest: it wants clang and builds for minutes.  Exit codes: 0 the same bits, 1 they differ, 2 something
# is missing.
#
#   tests/determinism.sh [SCHEME…]            every scheme of `cylon engines`, or those named: tests/determinism.sh auto rk4
#   FILES="scenarios/gas.toml …" tests/determinism.sh       those scenarios alone
#   ENGINE=in-house-float tests/determinism.sh              the engine in single precision
#   CYLON=build/mine/cylon tests/determinism.sh             another harness than build/release/cylon
#
# The environment variable CYLON_WORKERS tells the harness where the workers stand.
set -euo pipefail
cd "$(dirname "$0")/.."

cylon=${CYLON:-build/release/cylon}
engine=${ENGINE:-in-house}
worker=cylon-worker-${engine/float/f32}
builds=(gcc-O2 gcc-O3 clang-O2)
[ -x "$cylon" ] || { echo "determinism: build the release preset first" >&2; exit 2; }
command -v clang++ >/dev/null || { echo "determinism: no clang++ here: apt-get install clang" >&2; exit 2; }

build() {  # NAME COMPILER OPTIMISATION
  echo "building $1" >&2
  cmake -S . -B "build/determinism/$1" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$2" \
    -DCMAKE_CXX_FLAGS_RELEASE="$3 -DNDEBUG" >/dev/null
  ninja -C "build/determinism/$1" "$worker" >"build/determinism/$1.log" || { tail "build/determinism/$1.log" >&2; exit 2; }
}
build gcc-O2 g++ -O2
build gcc-O3 g++ -O3
build clang-O2 clang++ -O2

# gcc's own contraction, which no flag forbids: cmake/toolchain.cmake.
for build in gcc-O2 gcc-O3; do
  for object in $(find "build/determinism/$build/CMakeFiles/engine.dir" -name '*.o'); do
    ! objdump -d "$object" | grep -qE 'vfm(addsub|subadd)' ||
      { echo "determinism: contracted in spite of -ffp-contract=off: $object" >&2; exit 1; }
  done
done

out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
same=0 differ=0 left=0

compare() {  # WHAT REFERENCE OTHER
  local where
  if where=$(cmp "$2" "$3"); then
    same=$((same + 1))
  else
    echo "DIFFERS: $1: $where"
    differ=$((differ + 1))
  fi
}

# Steps and sums that threads share: every build prints the same, and the same for every number of threads.
suffix=$([ "$engine" = in-house-float ] && echo -f32 || true)
for build in "${builds[@]}"; do
  ninja -C "build/determinism/$build" "bits$suffix" >>"build/determinism/$build.log"
  "build/determinism/$build/bits$suffix" >"$out/$build.bits"
done
while read -r name threads hash; do
  for build in "${builds[@]}"; do
    grep -qx "$name $threads $hash" "$out/$build.bits" && same=$((same + 1)) ||
      { echo "DIFFERS: $name, $threads threads, $build"; differ=$((differ + 1)); }
  done
  first=$(awk -v n="$name" '$1 == n {print $3; exit}' "$out/gcc-O2.bits")
  [ "$first" = "$hash" ] || { echo "DIFFERS: $name, $threads threads"; differ=$((differ + 1)); }
done <"$out/gcc-O2.bits"
echo "piles and fields with 1, 2, 4 threads: $(wc -l <"$out/gcc-O2.bits") runs of each build"

schemes=("$@")
[ $# -gt 0 ] || mapfile -t schemes < <($cylon engines "$engine" | sed -n 's/^ *integrator \([^:]*\):.*/\1/p')
for file in ${FILES:-scenarios/*.toml}; do
  [ "$file" = scenarios/expected.toml ] && continue
  # Seventeen samples of the whole run: a difference of one bit anywhere before shows in the later ones.
  every=$(awk -F' *= *' '/^duration/ {print $2 / 16}' "$file")
  for scheme in "${schemes[@]}"; do
    taken=1
    rm -f "$out"/*.csv
    for build in "${builds[@]}"; do
      CYLON_WORKERS="$PWD/build/determinism/$build" $cylon simulate "$file" --engine "$engine" \
        --integrator "$scheme" --every "$every" --nearest --out "$out/$build.csv" 2>"$out/said" && continue
      code=$?
      # 1: not all states are finite, which is no matter here; else the engine does not take the scene
      [ $code = 1 ] && continue
      taken=0
      break
    done
    if [ $taken = 0 ]; then
      echo "left out: $file $scheme: $(head -n 1 "$out/said")"
      left=$((left + 1))
      continue
    fi
    for build in gcc-O3 clang-O2; do
      compare "$file $scheme gcc-O2 $build" "$out/gcc-O2.csv" "$out/$build.csv"
    done
  done
done
echo "$same the same, $differ differ, $left left out"
[ $differ = 0 ]
