#!/usr/bin/env bash
# Packs a build and lets lintian look at every package: no error, no warning that is not overridden with a reason.
#   tests/package/packages.sh BUILD
# Exits 77, which ctest takes for skipped, where the tools are not there.
set -euo pipefail
build=$(realpath "${1:?the build folder}") here=$(cd "$(dirname "$0")" && pwd)
for program in dpkg-shlibdeps file lintian; do
  command -v "$program" >/dev/null || { echo "skipped: there is no $program here" >&2; exit 77; }
done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "FAILED: $*" >&2; exit 1; }

# Compressed by gzip, which takes a tenth of the time of a release's xz.
"$here/../../cmake/package/pack.sh" "$build" "$scratch" -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip
packages=("$scratch"/*.deb)
[ ${#packages[@]} -ge 1 ] && [ -e "$scratch"/cylon_*.deb ] || fail "no package cylon: ${packages[*]}"
lintian --fail-on error,warning --allow-root "${packages[@]}" || fail "lintian says the above"
# cylon needs no library of an optional engine; each of these is a package of its own.
for package in "${packages[@]}"; do
  depends=$(dpkg-deb -f "$package" Depends)
  case $(dpkg-deb -f "$package" Package) in
    cylon) [[ $depends == *libbullet* && $depends == *libode* && ! $depends =~ mujoco|simbody|dart|siconos|sdformat|urdfdom|mpi ]] ;;
    libcylon-dev) [[ $depends == *"cylon (= $(dpkg-deb -f "$package" Version))"* && $depends == *libeigen3-dev* && $depends == *libtbb-dev* ]] ;;
    cylon-mpi) [[ $depends == *"cylon (= $(dpkg-deb -f "$package" Version))"* && $depends =~ lib(openmpi|mpich) && $(dpkg-deb -f "$package" Recommends) == openmpi-bin ]] ;;
    cylon-*) [[ $depends == *"cylon (= $(dpkg-deb -f "$package" Version))"* && $depends =~ lib(mujoco|simbody|dart|siconos|sdformat|urdfdom) ]] ;;
  esac || fail "$package depends on: $depends"
done
[ ! -e "$build/libcylon-mpi.so" ] || compgen -G "$scratch/cylon-mpi_*.deb" >/dev/null || fail "cylon farm is built, and there is no package of it"
[[ $(dpkg-deb -c "$scratch"/cylon_*.deb) == *usr/share/man/man1/cylon-run.1.gz* ]] || fail "no man pages, or not compressed"
echo "Clean: $(basename -a "${packages[@]}" | xargs)"
