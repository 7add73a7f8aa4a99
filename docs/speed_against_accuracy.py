#!/usr/bin/env python3
"""Writes the tables of docs/speed-against-accuracy.md and its plots from what `cylon trade` measures here and now.

    docs/speed_against_accuracy.py [--cylon build/release/cylon]

Errors and orders are the same on every run; times are of the machine, and of its load.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys

import measured

root = pathlib.Path(__file__).resolve().parent.parent
page = root / "docs" / "speed-against-accuracy.md"
begin, end = "<!-- begin: tables -->", "<!-- end: tables -->"

scenarios = ["projectile", "bouncing_sphere", "bouncing_sphere_elastic", "spring_zero_length", "spring_orbit",
             "free_symmetric_top", "dzhanibekov", "heavy_top"]
engines = ["in-house", "in-house-float/integrator=velocity-verlet", "bullet", "bullet/gyro=none", "bullet-float",
           "bullet-multibody", "ode"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cylon", default="build/release/cylon")
    cylon = parser.parse_args().cylon
    words = [":".join(scenarios)]
    for engine in engines:
        words += ["--engine", engine]
    words += ["--rounds", "2", "--svg", "docs/plots/trade.svg"]
    done = subprocess.run([cylon, "trade", *words], cwd=root, capture_output=True, text=True,
                          env={**os.environ, "COLUMNS": "100"})
    if done.returncode != 0:
        sys.exit(f"cylon trade ended with {done.returncode}:\n{done.stderr}")
    parts = re.split(rf"^(?=(?:{'|'.join(scenarios)}): )", done.stdout, flags=re.M)
    tables = {part.split(":", 1)[0]: part.rstrip() for part in parts if part.strip()}
    text = [f"Measured on {measured.processor()} by\n\n```sh\ncylon trade " + " ".join(words) + "\n```"]
    for name in scenarios:
        text.append(f"### {name}\n\n![{name}: error against cost](plots/trade-{name}.svg)\n\n```\n{tables[name]}\n```")
    measured.put(page, begin, end, "\n\n".join(text))


main()
