#!/usr/bin/env bash
# Installs what cmake/packages.txt lists and this machine lacks; says clearly what it cannot do.
#   cmake/install_packages.sh        what the program needs
#   cmake/install_packages.sh tests  and what only the tests need
set -euo pipefail
cd "$(dirname "$0")/.."

missing=()
while read -r probe package only; do
  [ -z "$only" ] || [ "$only" = "${1:-}" ] || continue
  case "$probe" in
    '#'* | '') continue ;;
    command:*) command -v "${probe#command:}" >/dev/null || missing+=("$package") ;;
    header:*) compgen -G "/usr/include/${probe#header:}" >/dev/null || compgen -G "/usr/include/*-linux-gnu/${probe#header:}" >/dev/null || missing+=("$package") ;;
  esac
done <cmake/packages.txt
[ ${#missing[@]} -eq 0 ] && exit 0

echo "Installing: ${missing[*]}" >&2
sudo=""
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "Not root and no sudo: please install these Debian packages and try again." >&2; exit 2; }
  sudo="sudo"
fi
command -v apt-get >/dev/null || { echo "No apt-get here: please install the counterparts of these Debian 12 packages and try again." >&2; exit 2; }
export DEBIAN_FRONTEND=noninteractive
$sudo apt-get update -qq >&2
$sudo apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2 </dev/null ||
  { echo "apt-get could not install: ${missing[*]}" >&2; exit 2; }
