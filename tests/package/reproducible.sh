#!/usr/bin/env bash
# Builds the packages of HEAD twice, from two folders, with another umask, time zone and language, the second time without
# the compiler cache: the same bytes.
#   tests/package/reproducible.sh
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(git -C "$here" rev-parse --show-toplevel)
for program in dpkg-shlibdeps file; do
  command -v "$program" >/dev/null || { echo "skipped: there is no $program here" >&2; exit 77; }
done
git -C "$root" diff --quiet HEAD || echo "What is not committed takes no part."
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

packages_of() { # folder: clones into it, builds, and packs into PACKAGES
  git clone -q "$root" "$1"
  (cd "$1" && cmake --preset release && cmake --build --preset release --target installable) >"$1.log" 2>&1 ||
    { tail -40 "$1.log" >&2; exit 1; }
  "$1/cmake/package/pack.sh" "$1/build/release" "$1.packages"
  (cd "$1.packages" && sha256sum ./*.deb)
}
first=$(umask 022 && TZ=UTC LC_ALL=C packages_of "$scratch/a")
second=$(umask 077 && mkdir -p "$scratch/another/folder" && TZ=Asia/Kathmandu LC_ALL=C.UTF-8 CCACHE_DISABLE=1 packages_of "$scratch/another/folder/b")
echo "$first"
[ "$first" = "$second" ] || { echo "FAILED: the second time it was" >&2; echo "$second" >&2; exit 1; }
echo "The same bytes twice."
