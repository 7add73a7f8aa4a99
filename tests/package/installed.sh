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
# An optional engine that is not installed is said to come by its package, and a repository around the prefix is no baseline.
rm -f "$prefix/libexec/cylon/cylon-worker-mujoco"
says './cylon-mujoco_*.deb' engines mujoco
says 'cd SOURCES && ./run engines' engines jolt  # of scripts there is no package
git init -q "$scratch" && git -C "$scratch" -c user.name=a -c user.email=a@b commit -q --allow-empty -m first
says 'no git revision' track gate projectile --engine ode --baseline HEAD --no-time
says 'same binary' track gate projectile --engine ode --baseline "$prefix" --no-time
echo "Installed, moved and used from $PWD."
