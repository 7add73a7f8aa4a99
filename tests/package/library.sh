#!/usr/bin/env bash
# An engine outside the tree: configures, builds and tests docs/examples/engine against an installed, moved prefix, as its
# author would, and breaks it, as nobody would.
#   tests/package/library.sh BUILD
set -euo pipefail
build=$(realpath "${1:?the build folder}") sources=$(cd "$(dirname "$0")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "FAILED: $*" >&2; exit 1; }
run() { "$@" >"$scratch/log" 2>&1 || { cat "$scratch/log" >&2; fail "$*"; }; }
says() { grep -qF -- "$1" "$scratch/log" || { cat "$scratch/log" >&2; fail "$2 does not say '$1'"; }; }

# What was compiled before in a folder of another name is in ccache, where that is installed.
if command -v ccache >/dev/null; then
  export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_BASEDIR=$scratch CCACHE_NOHASHDIR=1
fi
compile() { run ${CMAKE_CXX_COMPILER_LAUNCHER-} "$@"; }

run cmake --install "$build" --prefix "$scratch/first" --strip
prefix=$scratch/moved/to
mkdir "$scratch/moved" && mv "$scratch/first" "$prefix"
cylon=$prefix/bin/cylon

# Each public header compiles alone, in the languages that it is for, with all warnings.
warnings=(-Wall -Wextra -Wpedantic -Werror)
includes=(-I "$prefix/include" -I "$prefix/include/cylon" -isystem /usr/include/eigen3 -DCYLON_SCENARIOS_FOLDER='""')
cd "$scratch"
alone() { # header, language, compiler and flags…
  printf '#include "%s"\n' "$1" >"alone.$2"
  compile "${@:3}" "${warnings[@]}" -c "alone.$2" -o alone.o
}
while IFS= read -r header; do
  alone "${header#"$prefix/include/"}" cc g++ -std=c++20 "${includes[@]}"
done < <(find "$prefix/include" -name '*.h')
for header in cylon/engine.h cylon/force.h; do
  alone $header c gcc -std=c99 -I "$prefix/include"
  alone $header c gcc -std=c17 -Wstrict-prototypes -I "$prefix/include"
done

# The example, copied out of the prefix: built and green.
cp -r "$prefix/share/doc/cylon/examples/engine" "$scratch/mine"
cd "$scratch/mine"
configure() { run cmake -B "$1" -DCMAKE_PREFIX_PATH="$prefix" "${@:2}" && run cmake --build "$1" -j 2; }
begin=$SECONDS
configure build
run ctest --test-dir build --output-on-failure
says '100% tests passed' 'the example'
echo "The example, configured, built and tested: $((SECONDS - begin)) s"

# From an empty folder to a red test, as the page says it, and in the time that an author needs, who has compiled nothing before.
mkdir "$scratch/author"
(cd "$scratch/author" && CCACHE_DISABLE=1 CMAKE_PREFIX_PATH=$prefix "$sources/tests/package/author.sh" "$sources/docs/library.md") || fail "the walk of an author"

# An engine in C, in a project that knows no C++: linked by the C compiler, its test is cylon itself.
mkdir "$scratch/c" && cp engine.c "$scratch/c"
cat >"$scratch/c/CMakeLists.txt" <<'C'
cmake_minimum_required(VERSION 3.25)
project(my_engine LANGUAGES C)
find_package(cylon 0.3 REQUIRED)
enable_testing()
add_executable(my-engine engine.c)
target_link_libraries(my-engine PRIVATE cylon::worker)
add_test(NAME projectile COMMAND cylon run projectile --worker mine=$<TARGET_FILE:my-engine> --engine mine)
C
run cmake -S "$scratch/c" -B "$scratch/c/build" -DCMAKE_PREFIX_PATH="$prefix"
run cmake --build "$scratch/c/build"
PATH=$prefix/bin:$PATH run ctest --test-dir "$scratch/c/build" --output-on-failure
says '100% tests passed' 'the example in C alone'

# The same workers in the program, beside the Python example of the protocol.
for worker in build/my-engine build/my-engine-c "python3 $prefix/share/doc/cylon/examples/foreign_engine.py"; do
  run "$cylon" run projectile --worker "mine=$worker" --engine mine
  says '4 pass' "cylon run on $worker"
done

# Forces of one's own, outside the tree: refused, let in, and one of a later version refused.
cp -r "$prefix/share/doc/cylon/examples/force" "$scratch/forces"
run cmake -S "$scratch/forces" -B "$scratch/forces/build" -DCMAKE_PREFIX_PATH="$prefix"
run cmake --build "$scratch/forces/build"
if "$cylon" simulate "$scratch/forces/duffing.toml" --at 1 >"$scratch/log" 2>&1; then fail "a scenario loads code"; fi
says '--plugin laws=FILE' 'a scenario with a plug-in'
run "$cylon" simulate "$scratch/forces/duffing.toml" --at 1 --plugin "laws=$scratch/forces/build/laws.so"
says '1,mass,-0.407408442' 'the example of a plug-in'  # as RK4 in 20 000 steps has it
sed 's/CYLON_FORCE_VERSION,/CYLON_FORCE_VERSION + 1,/' "$scratch/forces/laws.cc" >"$scratch/forces/later.cc"
run g++ -std=c++17 -shared -fPIC -I "$prefix/include" "$scratch/forces/later.cc" -o "$scratch/forces/later.so"
if "$cylon" simulate "$scratch/forces/duffing.toml" --at 1 --plugin "laws=$scratch/forces/later.so" >"$scratch/log" 2>&1; then fail "a later plug-in is taken"; fi
says 'was compiled with version 2 of cylon/force.h' 'a later plug-in'

# The engine in a program of one's own, which looks at each step and kicks.
cp -r "$prefix/share/doc/cylon/examples/callback" "$scratch/callback"
run cmake -S "$scratch/callback" -B "$scratch/callback/build" -DCMAKE_PREFIX_PATH="$prefix"
run cmake --build "$scratch/callback/build"
run ctest --test-dir "$scratch/callback/build" --output-on-failure
says '100% tests passed' 'the engine in a program'

# One sign wrong: red, and the message names claim, error, tolerance and reason.
sed -i 's|position += a \* (dt_|position -= a * (dt_|' engine.cc
grep -q 'position -= a' engine.cc || fail "the example has no line to break"
run cmake --build build
if ctest --test-dir build -R FliesTheParabola --output-on-failure >"$scratch/log" 2>&1; then fail "a wrong engine is green"; fi
for text in 'position follows projectile: ' ' measured 0.00' ' m, allowed 0.00' 'tolerance: convention: a thousandth of the scale'; do
  says "$text" 'the red test'
done
cp "$prefix/share/doc/cylon/examples/engine/engine.cc" .

# Flags of the engine do not reach the judge: the same digits where every source of the tests has -ffast-math.
cat >shows.cc <<'C'
#include <cylon/gtest.h>
#include <cylon/worker.h>
TEST(Heavy, Top) {
  ASSERT_EQ(cylon::core::gravity({}).norm(), 0);  // both libraries in one program
  EXPECT_CONFORMS(WORKER, "heavy_top", cylon::judge::Asked{.tolerance_scale = 0});
}
C
cat >>CMakeLists.txt <<'C'
foreach(kind plain fast)
  add_executable(shows_${kind} shows.cc)
  target_link_libraries(shows_${kind} PRIVATE cylon::judge cylon::worker GTest::gtest_main)
  target_compile_definitions(shows_${kind} PRIVATE WORKER="${WORKER}")
endforeach()
target_compile_options(shows_fast PRIVATE -O2 -ffast-math -march=x86-64-v3)
add_executable(shows_flushed shows.cc)
target_link_libraries(shows_flushed PRIVATE cylon::judge cylon::worker GTest::gtest_main -ffast-math)
target_compile_definitions(shows_flushed PRIVATE WORKER="${WORKER}")
C
configure build -DWORKER="$prefix/libexec/cylon/cylon-worker-in-house"
digits() { "$1" 2>&1 | sed -n 's/^  \(.*: fail: measured [^,]*\).*/\1/p'; }
[ "$(digits build/shows_plain | wc -l)" -ge 3 ] || fail "no digits of heavy_top"
[ "$(digits build/shows_plain)" = "$(digits build/shows_fast)" ] || fail "-ffast-math of a test changes what the judge measures"
# At the link it makes the processor flush subnormal numbers: refused, not judged.
if build/shows_flushed >"$scratch/log" 2>&1; then fail "judged in fast arithmetic"; fi
says 'link the tests without -ffast-math' 'a program in fast arithmetic'

# Another layout of a scene is refused with a sentence.
compile g++ -std=c++20 -D_GLIBCXX_DEBUG -DEIGEN_MAX_STATIC_ALIGN_BYTES=32 "${includes[@]}" -c engine.cc -o checked.o
run g++ checked.o "$prefix/lib/libcylon_worker.a" "$prefix/lib/libcylon_simulator.a" -lfmt -o checked
if ./checked </dev/null >"$scratch/log" 2>&1; then fail "an engine with checked containers is taken"; fi
says 'lay out a scene in two ways' 'an engine with checked containers'

# Other versions and unknown components are not found.
mkdir "$scratch/asks"
asks() { # text, arguments of find_package…
  printf 'cmake_minimum_required(VERSION 3.25)\nproject(asks CXX)\nfind_package(cylon %s REQUIRED)\n' "${*:2}" >"$scratch/asks/CMakeLists.txt"
  if cmake -S "$scratch/asks" -B "$scratch/asks/build" -DCMAKE_PREFIX_PATH="$prefix" >"$scratch/log" 2>&1; then fail "find_package(cylon ${*:2}) is found"; fi
  says "$1" "find_package(cylon ${*:2})"
}
asks 'requested version "9.9"' 9.9
asks "no component 'oracle'" 0.3 COMPONENTS oracle
"$sources/tests/package/interface.py" "$prefix" || fail "the interface"
echo "The library was used from $PWD."
