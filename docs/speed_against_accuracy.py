#!/usr/bin/env python3
"""Writes the tables of docs/speed-against-accuracy.md and its plots from what `cylon trade` measures here and now.

    docs/speed_against_accuracy.py [--cylon build/release/cylon]

Takes about an hour and needs the optional engines (./run engines).  It works in build/speed-against-accuracy, where a call
goes on that was interrupted.  Errors and orders are the same on every run; times are of the machine, and of its load.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys

import engine_table
import measured

root = pathlib.Path(__file__).resolve().parent.parent
page = root / "docs" / "speed-against-accuracy.md"
begin, end = "<!-- begin: tables -->", "<!-- end: tables -->"

scenarios = ["projectile", "bouncing_sphere", "bouncing_sphere_elastic", "spring_zero_length", "spring_orbit",
             "free_symmetric_top", "dzhanibekov", "heavy_top"]
optional = [engine for title, engines, _ in engine_table.families for engine in engines
            if title not in ("in-house", "Bullet", "ODE") and "integrator=" not in engine]  # trade takes all integrators
# Engines, options, the title of plots, and what is in their names.  Optional engines have fewer steps: they
# cost up to a hundred times as much a step.
groups = {
    "core": (["in-house", "in-house-float/integrator=velocity-verlet", "bullet", "bullet/gyro=none", "bullet-float",
              "bullet-multibody", "ode"], ["--rounds", "2"], "error against cost", ""),
    "optional": (optional, ["--rounds", "1", "--work", "65536", "--timeout", "120",
                            *(word for tolerance in ("1e-2", "1e-4", "1e-6", "1e-8") for word in ("--tolerance", tolerance))],
                 "error against cost of optional engines", "-optional"),
}


def measure(cylon, group):
    """The command, and its table of each scenario."""
    engines, options, _, suffix = groups[group]
    words = ["trade", ":".join(scenarios), *(word for engine in engines for word in ("--engine", engine)), *options]
    plots = root / "docs" / "plots" / f"trade{suffix}.svg"
    folder = root / "build" / "speed-against-accuracy" / group
    folder.mkdir(parents=True, exist_ok=True)
    done = subprocess.run([cylon, *words, "--svg", plots, "--resume"], cwd=folder, stdout=subprocess.PIPE, text=True,
                          env={**os.environ, "COLUMNS": "130"})
    if done.returncode != 0:
        sys.exit(f"cylon trade ended with {done.returncode}")
    parts = re.split(rf"^(?=(?:{'|'.join(scenarios)}): )", done.stdout, flags=re.M)
    return "cylon " + " ".join(words), {part.split(":", 1)[0]: part.rstrip() for part in parts if part.strip()}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cylon", type=pathlib.Path, default="build/release/cylon")
    cylon = parser.parse_args().cylon.resolve()
    made = {group: measure(cylon, group) for group in groups}
    commands = "\n".join(command for command, _ in made.values())
    text = [f"Measured on {measured.processor()} by\n\n```sh\n{commands}\n```"]
    for name in scenarios:
        text.append(f"### {name}")
        for group, (_, tables) in made.items():
            *_, title, suffix = groups[group]
            text.append(f"![{name}: {title}](plots/trade{suffix}-{name}.svg)\n\n```\n{tables.get(name, 'No engine runs it.')}\n```")
    measured.put(page, begin, end, "\n\n".join(text))


main()
