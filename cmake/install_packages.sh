#!/usr/bin/env bash
# Installs what cmake/packages.txt and reference/simulators/engines.txt list and this machine lacks; says clearly what it cannot do.
#   cmake/install_packages.sh        what the program needs
#   cmake/install_packages.sh tests  and what only the tests need
#   cmake/install_packages.sh fuzz   and what only ./test fuzz needs
set -euo pipefail
cd "$(dirname "$0")/.."

engines() { awk '!/^#/ && $8 && !seen[$7]++ { print "header:" $8, $7 }' reference/simulators/engines.txt; }

missing=() missing_for_tests=()
while read -r probe package only; do
  [ -z "$only" ] || [ "$only" = "${1:-}" ] || continue
  declare -n list=missing${only:+_for_tests}
  case "$probe" in
    '#'* | '') continue ;;
    file:*) compgen -G "${probe#file:}" >/dev/null || list+=("$package") ;;
    command:*) command -v "${probe#command:}" >/dev/null || list+=("$package") ;;
    header:*) compgen -G "/usr/include/${probe#header:}" >/dev/null || compgen -G "/usr/include/*-linux-gnu/${probe#header:}" >/dev/null || list+=("$package") ;;
  esac
done < <(cat cmake/packages.txt && engines)
[ ${#missing[@]} -eq 0 ] && [ ${#missing_for_tests[@]} -eq 0 ] && exit 0

echo "Installing these Debian packages, which takes a few minutes: ${missing[*]} ${missing_for_tests[*]}" >&2
sudo=""
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "Not root and no sudo: please install these Debian packages and try again." >&2; exit 2; }
  sudo="sudo"
fi
command -v apt-get >/dev/null || { echo "No apt-get here: please install the counterparts of these Debian 12 packages and try again." >&2; exit 2; }
export DEBIAN_FRONTEND=noninteractive
$sudo apt-get update -qq >&2
install() { $sudo apt-get install -y -qq --no-install-recommends "$@" >&2 </dev/null; }
[ ${#missing[@]} -eq 0 ] || install "${missing[@]}" ||
  { echo "apt-get could not install: ${missing[*]}" >&2; exit 2; }
[ ${#missing_for_tests[@]} -eq 0 ] || install "${missing_for_tests[@]}" ||
  echo "apt-get could not install: ${missing_for_tests[*]}; the tests that need them are skipped" >&2
