#!/usr/bin/env python3
"""Writes the matrices of steps in README.md and docs/speed-against-accuracy.md from what `cylon matrix` measures here and now.

    docs/step_matrix.py [--cylon build/release/cylon]

Steps and orders are the same on every run; times are of the machine, and of its load.
"""
import argparse
import datetime
import os
import pathlib
import subprocess
import sys
import tempfile

import measured

root = pathlib.Path(__file__).resolve().parent.parent
begin, end = "<!-- begin: steps -->", "<!-- end: steps -->"

# The later call takes its numbers from the earlier one, by --resume.
pages = [
    (root / "docs" / "speed-against-accuracy.md",
     ["in-house", "bullet", "bullet/path=as-expert", "bullet-float", "bullet-multibody", "ode", "ode/path=as-expert"]),
    (root / "README.md", ["bullet", "bullet/path=as-expert", "ode", "ode/path=as-expert"]),
]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cylon", default="build/release/cylon")
    cylon = str((root / parser.parse_args().cylon).resolve())
    with tempfile.TemporaryDirectory() as folder:
        for i, (page, engines) in enumerate(pages):
            words = ["matrix", *(word for engine in engines for word in ("--engine", engine))]
            done = subprocess.run([cylon, *words, *(["--resume"] if i else [])], cwd=folder, capture_output=True,
                                  text=True, env={**os.environ, "COLUMNS": "130", "LC_ALL": "C.UTF-8"})
            if done.returncode != 0:
                sys.exit(f"cylon {' '.join(words)} ended with {done.returncode}:\n{done.stderr}")
            text = (f"Measured on {measured.processor()}, {os.cpu_count()} processors, on {datetime.date.today()}, by "
                    f"`cylon {' '.join(words)}`:\n\n```\n{done.stdout.rstrip()}\n```\n\n"
                    f"`docs/{pathlib.Path(__file__).name}` repeats the measurement. Times depend on the machine"
                    f"{', which was busy with other work' + chr(10) + 'as well' if os.getloadavg()[0] > 1.5 else ''};"
                    " steps and orders do not.")
            measured.put(page, begin, end, text)


main()
