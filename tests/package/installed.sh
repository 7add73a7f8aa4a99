#!/usr/bin/env bash
# Installs a build into a temporary prefix, moves it to another, hides sources and build, and uses what is installed from a
# folder elsewhere.
#   tests/package/installed.sh BUILD
set -euo pipefail
build=$(realpath "${1:?the build folder}") sources=$(cd "$(dirname "$0")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "FAILED: $*" >&2; exit 1; }

cmake --install "$build" --prefix "$scratch/first" --strip >"$scratch/log" 2>&1 || { cat "$scratch/log" >&2; fail "cmake --install"; }
prefix=$scratch/moved/to
mkdir "$scratch/moved" && mv "$scratch/first" "$prefix"

diff -r "$sources/scenarios" "$prefix/share/cylon/scenarios" || fail "other scenarios are installed than those of the sources"
for folder in "$sources" "$build" "$scratch"; do
  if grep -rlF -- "$folder" "$prefix"; then fail "these files name $folder"; fi
done

# Installing shortens a path to libraries, but not the table in which it lies: bytes would depend on the build's folder.
if readelf -d "$build"/cylon "$build"/cylon-worker-* | grep -F -- "$build"; then fail "these programs look for libraries in $build"; fi

state() { (cd "$prefix" && find . -type f -print0 | LC_ALL=C sort -z | xargs -0 sha256sum && find . | LC_ALL=C sort); }
before=$(state)
mkdir "$scratch/home"
cp "$sources/tests/package/use.sh" "$scratch"
hidden=(bwrap --dev-bind / / --tmpfs "$sources")
case $build/ in "$sources"/*) ;; *) hidden+=(--tmpfs "$build") ;; esac
if ! "${hidden[@]}" true 2>"$scratch/log"; then
  echo "bubblewrap cannot hide the sources here, so that they stay visible: $(cat "$scratch/log")"
  hidden=()
fi
cd "$scratch/home"
"${hidden[@]}" env -i HOME="$PWD" PATH="$prefix/bin:/usr/bin:/bin" LANG=C.UTF-8 bash ../use.sh "$prefix"
[ "$(state)" = "$before" ] || fail "using cylon changed files in its prefix"
[ -s "$scratch/home/.config/cylon/key" ] || fail "the key of the user is not in ~/.config/cylon"

says() { # text, words…: cylon prints the text, whatever its exit code
  local said
  said=$("$prefix/bin/cylon" "${@:2}" 2>&1) || true
  [[ $said == *"$1"* ]] || fail "cylon ${*:2} does not say '$1': $said"
}

# What says where things are overrides where they are installed.
mkdir "$scratch/mine" && cp "$prefix/share/cylon/scenarios/projectile.toml" "$scratch/mine/thrown.toml"
CYLON_SCENARIOS=$scratch/mine says thrown list --names
# cylon farm, where the build has it: what it loads is installed beside the workers.
if [ -e "$build/libcylon-mpi.so" ]; then
  [ -e "$prefix/libexec/cylon/libcylon-mpi.so" ] || fail "cylon farm is built, and libcylon-mpi.so is not installed"
  if command -v mpirun >/dev/null; then
    # As root, and with more ranks than cores, Open MPI wants to be told.
    mkdir "$scratch/farm"
    (cd "$scratch/farm" && mpirun --allow-run-as-root --oversubscribe -n 2 "$prefix/bin/cylon" farm run projectile --engine in-house) \
      >"$scratch/log" 2>&1 || fail "the installed cylon farm: $(cat "$scratch/log")"
    grep -qF ', 0 differ' "$scratch/log" || fail "the installed cylon farm says: $(cat "$scratch/log")"
  fi
  rm "$prefix/libexec/cylon/libcylon-mpi.so"
fi
says 'apt-get install ./cylon-mpi_*.deb openmpi-bin' farm run projectile --engine in-house
# An optional engine that is not installed is said to come by its package, and a repository around the prefix is no baseline.
rm -f "$prefix/libexec/cylon/cylon-worker-mujoco"
says './cylon-mujoco_*.deb' engines mujoco
says 'cd SOURCES && ./run engines' engines jolt  # of scripts there is no package
git init -q "$scratch" && git -C "$scratch" -c user.name=a -c user.email=a@b commit -q --allow-empty -m first
says 'no git revision' track gate projectile --engine ode --baseline HEAD --no-time
says 'same binary' track gate projectile --engine ode --baseline "$prefix" --no-time
echo "Installed, moved and used from $PWD."
