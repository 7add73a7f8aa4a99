#!/usr/bin/env bash
# What the pages cost in Chromium, whose WebGL draws on the processor here: frames of the viewer by bodies and engine, time to open and size of a report.
#   bench/web_bench.sh [FOLDER_OF_CYLON]
cd "$(dirname "$0")/.." && tests/reports/web/run.sh "${1:-build/release}" measure.mjs | sed -n 's/^# //p' | grep -v '^\(Subtest\|tests\|suites\|pass\|fail\|cancelled\|skipped\|todo\|duration\)'
