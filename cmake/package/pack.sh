#!/usr/bin/env bash
# Packs a build whose target `installable` is built: the Debian packages, in a folder.
#   cmake/package/pack.sh BUILD FOLDER [OPTION OF CPACK…]
set -euo pipefail
build=$(realpath "${1:?the build folder}") folder=$(realpath -m "${2:?a folder}")
umask 022  # CPack makes the folders of a package with the umask that it finds
shift 2
mkdir -p "$folder"
cpack --config "$build/CPackConfig.cmake" "$@" -B "$folder" >"$folder/log" 2>&1 || { cat "$folder/log" >&2; exit 1; }
rm -r "$folder/_CPack_Packages"
