#!/usr/bin/env bash
# Installs what cmake/packages.txt and reference/simulators/engines.txt list and this machine lacks; says clearly what it cannot do.
#   cmake/install_packages.sh          what the program needs
#   cmake/install_packages.sh engines  and the optional engines
#   cmake/install_packages.sh package  and what makes Debian packages
#   cmake/install_packages.sh tests    and the optional engines, what makes packages, and what only the tests need
#   cmake/install_packages.sh fuzz     and what only ./test fuzz needs
set -euo pipefail
cd "$(dirname "$0")/.."

# Of an optional engine: who asks for it.
engines() {
  awk '!/^#/ && $6 ~ /^npm:/ { print "command:node nodejs engines\ncommand:npm npm engines"; exit }' reference/simulators/engines.txt
  awk '!/^#/ && $8 && !seen[$7]++ { print "header:" $8, $7, $4 == "optional" ? "engines" : "" }' reference/simulators/engines.txt
}

# Without the first list nothing works; without the second something is left out.
missing=() missing_of_choice=()
while read -r probe package only; do
  if [ -z "$only" ]; then
    declare -n list=missing
  elif [ "$only" = "${1:-}" ] || [[ "$only for ${1:-}" =~ ^(engines|package)" for tests"$ ]]; then
    declare -n list=missing_of_choice
  else
    continue
  fi
  case "$probe" in
    '#'* | '') continue ;;
    file:*) compgen -G "${probe#file:}" >/dev/null || list+=("$package") ;;
    command:*) command -v "${probe#command:}" >/dev/null || list+=("$package") ;;
    header:*) compgen -G "/usr/include/${probe#header:}" >/dev/null || compgen -G "/usr/include/*-linux-gnu/${probe#header:}" >/dev/null || list+=("$package") ;;
  esac
done < <(cat cmake/packages.txt && engines)

# The engines of npm, of the versions in the lock file: of choice too.
modules() {
  case "${1:-}" in engines | tests) ;; *) return 0 ;; esac
  local folder
  for folder in $(awk '!/^#/ && $6 ~ /^npm:/ && !seen[$5]++ { print $5 }' reference/simulators/engines.txt); do
    command -v npm >/dev/null || { echo "npm is not here: the engines of reference/simulators/$folder are left out" >&2; return 0; }
    (
      cd "reference/simulators/$folder"
      exec 9>.packages.lock
      flock 9
      { [ node_modules/.package-lock.json -nt package-lock.json ] && npm ls --all >/dev/null 2>&1; } || npm ci --ignore-scripts --no-audit --no-fund --no-progress >&2
    ) || echo "npm could not install the engines of reference/simulators/$folder; they are left out" >&2
  done
}
if [ ${#missing[@]} -eq 0 ] && [ ${#missing_of_choice[@]} -eq 0 ]; then
  modules "$@"
  exit 0
fi

echo "Installing these Debian packages, which takes a few minutes: ${missing[*]} ${missing_of_choice[*]}" >&2
sudo=""
# What is left out is no reason to stop.
asked=${1:-}
give_up() {
  echo "$1" >&2
  [ ${#missing[@]} -eq 0 ] || exit 2
  modules "$asked"
  exit 0
}
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || give_up "Not root and no sudo: please install these Debian packages and try again."
  sudo="sudo"
fi
command -v apt-get >/dev/null || give_up "No apt-get here: please install the counterparts of these Debian 12 packages and try again."
export DEBIAN_FRONTEND=noninteractive
$sudo apt-get update -qq >&2
install() { $sudo apt-get install -y -qq --no-install-recommends "$@" >&2 </dev/null; }
[ ${#missing[@]} -eq 0 ] || install "${missing[@]}" ||
  { echo "apt-get could not install: ${missing[*]}" >&2; exit 2; }
[ ${#missing_of_choice[@]} -eq 0 ] || install "${missing_of_choice[@]}" ||
  echo "apt-get could not install: ${missing_of_choice[*]}; what needs them is left out" >&2
modules "$@"
