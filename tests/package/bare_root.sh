#!/usr/bin/env bash
# Installs the packages in a Debian 12 that has nothing but its minimal base (no compiler, no Python), made by mmdebstrap
# from the mirrors that apt uses here, and uses cylon there as a user who is not root.
#   tests/package/bare_root.sh BUILD
# Exits 77, which ctest takes for skipped, where that cannot be: not root, no mmdebstrap, no mirror.
set -euo pipefail
build=$(realpath "${1:?the build folder}") here=$(cd "$(dirname "$0")" && pwd)
skip() { echo "skipped: $*" >&2; exit 77; }
[ "$(id -u)" -eq 0 ] || skip "only root can install packages in a root of its own"
for program in mmdebstrap dpkg-shlibdeps file; do
  command -v "$program" >/dev/null || skip "there is no $program here"
done
sources=/etc/apt/sources.list.d/debian.sources
[ -e $sources ] || sources=/etc/apt/sources.list
[ -s $sources ] || skip "apt has no list of Debian mirrors here"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
chmod 755 "$scratch"  # apt's own user looks for packages here
release=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
[ "$release" = bookworm ] || skip "the packages of this build are for Debian's $release; this tests Debian 12"
url=$(apt-get download --print-uris base-files 2>/dev/null | sed -n "s/^'\([^']*\)'.*/\1/p")
/usr/lib/apt/apt-helper download-file "$url" "$scratch/probe" >/dev/null 2>&1 || skip "no mirror of Debian answers: $url"

"$here/../../cmake/package/pack.sh" "$build" "$scratch/packages"
cp "$here"/{use,author}.sh "$here/../../docs/library.md" "$scratch"
for model in arm.xml world.sdf arm.urdf; do cp "$here/../data/imports/$model" "$scratch/model.${model##*.}"; done
mmdebstrap --quiet --variant=minbase --format=null "$release" /dev/null "$sources" \
  --customize-hook="'$here/in_bare_root.sh' '$scratch'"' "$1"'
