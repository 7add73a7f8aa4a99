#!/usr/bin/env python3
"""Asks every part that gets a scene whether it takes what the reader accepts, over random scenes (targets/random_scene.h).

    cmake/build.py release accepted
    tests/fuzz/accepted.py build/release/accepted [--scenes 100000] [--minutes N] [--anew] [--sample N]

Scene n is a function of n and of the shipped scenes.  Counts are kept in tests/hostile/counts/accepted.json with the program
and the commit that they are of, and a later call goes on with new scenes until as many were tried as asked for.  Counts of
another program are left as they are, unless --anew puts them aside and begins again; --sample tries the next N scenes and
keeps no count.  A scene is a finding if a part refuses it, or if a unit of
scenes crashes or takes too long; later calls ask it again until it is none.  The last line is JSON: tried, failed (units with
findings), the same of each part; --scenes 0 gives it without new scenes.
Exit codes: 0, 1 where a scene is a finding, 2 where counts of another program stood in the way."""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "hostile"))
from counted import Counted, program_of  # noqa: E402

UNIT = 250  # scenes of one process
SECONDS = 600  # that a unit may take; most take ten
PART = "random scenes"


def unit(program, first):
    """How many scenes of a unit were accepted, and what was said of those that failed, or ""."""
    try:
        ran = subprocess.run([program, str(first), str(UNIT)], capture_output=True, timeout=SECONDS, check=False,
                             env={**os.environ, "CYLON_CACHE": "off"})
    except subprocess.TimeoutExpired:
        return 0, f"scenes from {first} on do not end within {SECONDS} s"
    if ran.returncode:
        return 0, f"scenes from {first} on: exit code {ran.returncode}: {ran.stderr[-300:]!r}"
    *findings, numbers = ran.stdout.decode("utf8", "replace").splitlines()
    return int(numbers.split()[1]), "\n".join(findings)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", nargs="?", default="build/release/accepted")
    parser.add_argument("--scenes", type=int, default=100000)
    parser.add_argument("--minutes", type=float, default=1e9)
    parser.add_argument("--anew", action="store_true")
    parser.add_argument("--sample", type=int)
    options = parser.parse_args()
    counted, before = Counted("accepted"), 0
    if options.sample:
        before, counted = counted.get(PART, "tried"), Counted()
        counted.set(PART, tried=before)
        options.scenes = before + options.sample

    def ask(first):
        """Notes the unit as open where it has a finding."""
        accepted, said = unit(options.program, first)
        still = [other for other in counted.get(PART, "open") or [] if other != first]
        counted.set(PART, open=still + [first] * bool(said), failed=len(still) + bool(said))
        if said:
            print(said, flush=True)
        return accepted

    of_this = options.sample or not options.scenes or counted.may_go_on(PART, program_of(options.program), options.anew)
    for first in counted.get(PART, "open") or []:
        ask(first)
    end = time.monotonic() + 60 * options.minutes
    while of_this and counted.get(PART, "tried") < options.scenes and time.monotonic() < end:
        accepted = ask(counted.get(PART, "tried"))
        counted.add(PART, tried=UNIT, accepted=accepted)
    failed = counted.total("failed")
    print(json.dumps({"tried": counted.total("tried") - before, "failed": failed, "parts": counted.parts}))
    return 1 if failed else 0 if of_this else 2


if __name__ == "__main__":
    sys.exit(main())
