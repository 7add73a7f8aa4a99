#!/usr/bin/env bash
# Makes the pictures of README.md and docs/report.md, in docs/pictures: the report and the viewer in Chromium.
#   docs/pictures.sh [FOLDER_OF_CYLON]
cd "$(dirname "$0")/.." && exec tests/reports/web/run.sh "${1:-build/release}" pictures.mjs
