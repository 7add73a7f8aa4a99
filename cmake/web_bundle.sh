#!/usr/bin/env bash
# Script and style of the report and the viewer, for the build to embed.
#   cmake/web_bundle.sh FOLDER    bundles reports/web/src into FOLDER; without npm it takes the committed bundle,
#                                 if that was made of these very sources
#   cmake/web_bundle.sh --commit  renews the committed bundle
#   cmake/web_bundle.sh --check   says whether the committed bundle is of these sources and, with npm, these bytes
set -euo pipefail
cd "$(dirname "$0")/../reports/web"
committed=$PWD/bundle
sources() { find package.json package-lock.json tsconfig.json build.mjs src -type f | LC_ALL=C sort | xargs sha256sum | sha256sum | cut -d' ' -f1; }

packages() { # there and of this lock file
  command -v node >/dev/null && command -v npm >/dev/null || return 1
  exec 9>.packages.lock
  flock 9
  [ node_modules/.package-lock.json -nt package-lock.json ] || npm ci --ignore-scripts --no-progress >&2 || return 1
  flock -u 9
}
bundle() { # folder
  node build.mjs "$1"
  sources >"$1/sources.sha256"
}
taken() { # folder
  [ "$(cat "$committed/sources.sha256" 2>/dev/null)" = "$(sources)" ] ||
    { echo "reports/web/bundle is not of these sources, and npm is not there to bundle them" >&2; return 1; }
  mkdir -p "$1" && cp "$committed"/* "$1"
}

case "${1:?a folder, --commit or --check}" in
  --commit) packages && bundle "$committed" ;;
  --check)
    fresh=$(mktemp -d)
    trap 'rm -rf "$fresh"' EXIT
    if packages; then bundle "$fresh"; else taken "$fresh"; fi
    diff -q "$committed" "$fresh" >&2 || { echo "cmake/web_bundle.sh --commit renews it" >&2; exit 1; }
    ;;
  *)
    folder=$(realpath -m "$OLDPWD/$1")
    case "$1" in /*) folder=$1 ;; esac
    if packages; then bundle "$folder"; else taken "$folder"; fi
    ;;
esac
