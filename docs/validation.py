#!/usr/bin/env python3
"""Writes the tables of docs/measured.md from what `cylon fit` and tests/levels find here and now.

    docs/validation.py [--cylon build/release/cylon] [--levels build/release/levels_study] [--only levels|fits|pendulums]

Takes hours.  An interrupted run goes on where it was: --state keeps what is done.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys

import measured

root = pathlib.Path(__file__).resolve().parent.parent
page = root / "docs" / "measured.md"
engines = ["in-house", "bullet", "ode"]
cases = ["ball", "ball, larger errors", "ball, inertia known", "ball, pyramid", "ball, no restitution", "ball, inertia +10 %"]


def fits(cylon, experiment, state):
    """The fit of each engine, as JSON."""
    file = state / f"{experiment.parent.name}.json"
    if not file.exists():
        words = [cylon, "fit", str(experiment), "--resume", "--json", str(file),
                 *(word for engine in engines for word in ("--engine", engine))]
        done = subprocess.run(words, cwd=state)
        if done.returncode not in (0, 1):
            sys.exit(f"{' '.join(words)} ended with {done.returncode}")
    return json.loads(file.read_text())


def with_interval(value, low, high, digits="{:.4g}"):
    if value is None:
        return "not known"
    shown = digits.format(value)
    return shown if low is None else f"{shown} [{digits.format(low)}, {digits.format(high)}]"


def parameters(found):
    rows = ["| engine | parameter | value, if the uncertainties are right | between runs | remarks |", "|---" * 5 + "|"]
    for fit in found["fits"]:
        if fit["failure"]:
            rows.append(f"| {fit['engine']} | | | | {fit['failure']} |")
            continue
        for p in fit["parameters"]:
            remarks = [*(["at its bound"] if p["at_bound"] else []),
                       *(["cannot be told from others"] if p["error"] is None else [])]
            rows.append(f"| {fit['engine']} | {p['name']} | {with_interval(p['value'], p['low'], p['high'])} | "
                        f"{with_interval(p['value'], p['low_between_runs'], p['high_between_runs'])} | {', '.join(remarks)} |")
        rows.append(f"| {fit['engine']} | misfit of a number | {fit['misfit'] / fit['numbers']:.3g} | | "
                    f"{'settled' if fit['settled'] else 'not settled'} after {fit['rounds']} rounds |")
    return "\n".join(rows)


def scaled(estimate, scale, digits="{:.1f}"):
    return with_interval(*(None if estimate[k] is None else scale * estimate[k] for k in ("value", "low", "high")), digits)


def rests(found):
    rows = ["| engine | | distance [mm] | angle [deg] | same side [%] | first touch [ms] | -2 log L a run |", "|---" * 7 + "|"]
    for engine in found["judged"]:
        deviances = [d for d in engine["deviances"] if d is not None]
        for when in ("before", "after"):
            s = engine[when]
            rows.append(f"| {engine['engine']} | {when} | {scaled(s['distance'], 1000)} | {scaled(s['angle'], 57.29577951)} | "
                        f"{scaled(s['same_side'], 100)} | {scaled(s['impact'], 1000, '{:.2f}')} | "
                        f"{f'{sum(deviances) / len(deviances):.1f}' if when == 'after' else ''} |")
    return "\n".join(rows)


def horizons(found):
    rows = ["| engine | | within 0.1 rad for [s] | to the end | by the start alone [s] | exponent [1/s] |", "|---" * 6 + "|"]
    for engine in found["judged"]:
        for when in ("before", "after"):
            s = engine[when]
            held = scaled(s["held"], 1, "{:.3f}") if s["held"]["value"] is not None else "the end"
            expected = scaled(s["expected"], 1, "{:.3f}") if s["expected"]["value"] is not None else "the end"
            rows.append(f"| {engine['engine']} | {when} | {held} | {s['to_the_end']} of {s['runs'] - s['failed']} | {expected} | "
                        f"{scaled(s['exponent'], 1, '{:.2f}')} |")
    return "\n".join(rows)


def likelier(found):
    return "\n".join(f"- {pair['one']} is likelier in {pair['runs_of_one']} runs, {pair['other']} in {pair['runs_of_other']}: "
                     f"{pair['likelier']} (p = {pair['p']:.2g})" for pair in found["likelier"])


def command(experiment):
    shown = experiment.relative_to(root)
    return f"From `cylon fit {shown} {' '.join(f'--engine {engine}' for engine in engines)}`, judged on the half that was not fitted:"


def levels(program, state, counts):
    rows = ["| case | experiments | truth inside, if the uncertainties are right [%] | between runs [%] | refused at 5 % [%] |",
            "|---" * 5 + "|"]
    for case in cases:
        file = state / f"levels {re.sub('[^a-z0-9]+', '-', case)}.txt"
        out = subprocess.run([program, case, str(counts[case]), str(file)], capture_output=True, text=True, check=True).stdout
        lines = out.splitlines()
        found = {}
        for line in lines[1:]:
            name, value = re.fullmatch(r"(.*?)\s+([0-9.]+) % (\[.*\])", line).group(1, 2)
            found[name] = float(value)
        stated = [v for k, v in found.items() if k.endswith(", stated")]
        between = [v for k, v in found.items() if k.endswith(", between runs")]
        interval = next(line for line in lines if line.startswith("refused")).split("%", 1)[1].strip()
        right = cases.index(case) < 3
        rows.append(f"| {case} | {counts[case]} | {f'{min(stated):.1f} to {max(stated):.1f}' if right else ''} | "
                    f"{f'{min(between):.1f} to {max(between):.1f}' if right else ''} | {found['refused']:.1f} {interval} |")
    return "\n".join(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cylon", default="build/release/cylon")
    parser.add_argument("--levels", default="build/release/levels_study")
    parser.add_argument("--state", default="build/release/validation", help="folder that keeps what is done")
    parser.add_argument("--only", choices=["levels", "fits", "pendulums"])
    options = parser.parse_args()
    state = root / options.state
    state.mkdir(parents=True, exist_ok=True)
    cylon = str((root / options.cylon).resolve())
    folder = root / "scenarios" / "measured"

    def put(name, text):
        measured.put(page, f"<!-- {name} -->", f"<!-- /{name} -->", text)

    if options.only in (None, "levels"):
        counts = dict.fromkeys(cases[:2], 1000) | dict.fromkeys(cases[2:], 100)
        put("levels", levels(str((root / options.levels).resolve()), state, counts))
    if options.only in (None, "fits"):
        cubes = folder / "cube_tosses" / "tosses.toml"
        found = fits(cylon, cubes, state)
        put("fits", "\n\n".join([command(cubes), parameters(found), rests(found), likelier(found)]))
    if options.only in (None, "pendulums"):
        texts = []
        for arms in ("single", "double", "triple"):
            swings = folder / f"pendulum_{arms}" / "swings.toml"
            found = fits(cylon, swings, state)
            texts += [f"**{arms.capitalize()}.** " + command(swings), parameters(found), horizons(found), likelier(found)]
        put("pendulums", "\n\n".join(texts))


main()
