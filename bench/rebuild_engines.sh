#!/usr/bin/env bash
# Bullet and ODE from Debian's own sources with the flags of Cylon's release build, so that no engine is slower for its
# package's sake.  The libraries and their .pc files go to build/engines/<march>.
#   bench/rebuild_engines.sh [MARCH]   x86-64-v3 otherwise; prints the folder for PKG_CONFIG_PATH
set -euo pipefail
cd "$(dirname "$0")/.."
march=${1:-x86-64-v3}
work=$PWD/build/engines
prefix=$work/$march
flags="-O3 -DNDEBUG -march=$march -ffp-contract=off"
[ -e "$prefix/done" ] && { echo "$prefix/pkgconfig"; exit 0; }
mkdir -p "$work/src" "$work/lists/partial" "$prefix/pkgconfig"

# The machine's own Debian mirrors, asked for sources.
sed -n '/^URIs:/p;/^Suites: bookworm/,/^Components/p' /etc/apt/sources.list.d/*.sources /dev/null | awk '
  /^URIs:/ { uri = $2 } /^Suites: bookworm/ { $1 = ""; for (i = 2; i <= NF; ++i) print "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg]", uri, $i, "main" }' |
  sort -u >"$work/sources.list"
grep -hs '^deb .* bookworm' /etc/apt/sources.list | sed 's/^deb /deb-src /' >>"$work/sources.list" || true
apt=(-o "Dir::Etc::sourcelist=$work/sources.list" -o Dir::Etc::sourceparts=- -o "Dir::State::lists=$work/lists")
fetch() { # package
  compgen -G "$work/src/$1-*/" >/dev/null && return
  apt-get "${apt[@]}" update -qq >&2
  (cd "$work/src" && apt-get "${apt[@]}" source -qq --only-source "$1" >&2)
}
build() { # name, source folder, options…
  cmake -S "$2" -B "$work/$1-$march" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="$flags" -DCMAKE_C_FLAGS="$flags" \
    -DBUILD_SHARED_LIBS=OFF -DCMAKE_INSTALL_PREFIX="$prefix/$1" -DCMAKE_POLICY_DEFAULT_CMP0069=NEW "${@:3}" >&2
  ninja -C "$work/$1-$march" install >"$work/$1-$march.log" 2>&1 || { tail -20 "$work/$1-$march.log" >&2; exit 1; }
}
module() { # .pc name, description, version, cflags, libs
  printf 'Name: %s\nDescription: %s, rebuilt\nVersion: %s\nCflags: %s\nLibs: %s\n' "$1" "$2" "$3" "$4" "$5" >"$prefix/pkgconfig/$1.pc"
}

fetch bullet && fetch ode
bullet=$(echo "$work"/src/bullet-*/) ode=$(echo "$work"/src/ode-*/)
bullet_version=$(basename "$bullet" | sed 's/bullet-//') ode_version=$(basename "$ode" | sed 's/ode-//')
for precision in float64 float32; do
  # As Debian's rules, without the demos, extras and tests.
  build "bullet-$precision" "$bullet" -DBUILD_BULLET2_DEMOS=OFF -DBUILD_CPU_DEMOS=OFF -DBUILD_OPENGL3_DEMOS=OFF \
    -DBUILD_EXTRAS=OFF -DBUILD_UNIT_TESTS=OFF -DINSTALL_LIBS=ON -DBULLET2_MULTITHREADING=OFF \
    -DUSE_DOUBLE_PRECISION=$([ $precision = float64 ] && echo ON || echo OFF)
done
build ode "$ode" -DODE_WITH_DEMOS=OFF -DODE_WITH_TESTS=OFF -DODE_DOUBLE_PRECISION=ON
bullet_libs() { echo "-L$prefix/bullet-$1/lib -lBulletDynamics$2 -lBulletCollision$2 -lLinearMath$2"; }
module bullet-float64 Bullet "$bullet_version" "-DBT_USE_DOUBLE_PRECISION -I$prefix/bullet-float64/include/bullet" "$(bullet_libs float64 -float64)"
module bullet Bullet "$bullet_version" "-I$prefix/bullet-float32/include/bullet" "$(bullet_libs float32 "")"
module ode ODE "$ode_version" "-DdIDEDOUBLE -I$prefix/ode/include" "-L$prefix/ode/lib -lode -lpthread"
touch "$prefix/done"
echo "$prefix/pkgconfig"
