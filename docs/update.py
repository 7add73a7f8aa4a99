#!/usr/bin/env python3
"""Writes the generated tables of README.md and docs/extremes.md from what the program says, or checks that they are current.

    docs/update.py [--check] [--cylon build/release/cylon]

Only numbers that are the same on every run stand in generated tables: verdicts, never times.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parent.parent


def output(*command):
    """What a command prints; its exit code is its own affair (1: a verdict differs)."""
    done = subprocess.run(command, cwd=root, capture_output=True, text=True)
    if done.returncode not in (0, 1):
        sys.exit(f"{' '.join(command)} ended with {done.returncode}:\n{done.stderr}")
    return done.stdout


def digits(verdict):
    """log10(allowed / measured), as the console shows it."""
    import math
    if verdict["measured"] is None:
        return -99.0
    if verdict["measured"] == 0:
        return 99.0
    return math.log10(verdict["allowed"] / verdict["measured"]) if verdict["allowed"] else -99.0


MARKS = {"pass": "✓", "low-quality": "~", "fail": "✗", "unsupported": "–", "non-finite": "∞"}


def matrix(cylon, *suite):
    verdicts = json.loads(output(cylon, "run", *suite, "--json", "-"))["verdicts"]
    engines = list(dict.fromkeys(v["engine"] for v in verdicts))
    lines = ["| scenario | " + " | ".join(e.replace("in-house/integrator=", "in-house, ") for e in engines) + " |",
             "|---" * (len(engines) + 1) + "|"]
    for scenario in dict.fromkeys(v["scenario"] for v in verdicts):
        cells = []
        for engine in engines:
            worst = min((v for v in verdicts if v["scenario"] == scenario and v["engine"] == engine), key=digits)
            measured = worst["status"] in ("pass", "low-quality", "fail")
            cells.append(MARKS.get(worst["status"], worst["status"]) +
                         (f" {min(99, max(-99, digits(worst))):+.1f}" if measured else ""))
        lines.append(f"| {scenario} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def scenarios(cylon):
    lines = ["| scenario | what happens | truth | its error | claims |", "|---|---|---|---|---|"]
    for row in json.loads(output(cylon, "list", "--json")):
        if "extreme" in row["tags"]:
            continue  # docs/extremes.md
        followed = [c for c in row["claims"] if c["follows"]]
        truth = followed[0]["follows"] if followed else "–"
        worst = {}  # a bound in each unit
        for c in followed:
            unit = c["unit"]
            worst[unit] = max(worst.get(unit, 0), c["truth_error"])
        error = ", ".join(f"{bound:.0e} {unit}".strip() for unit, bound in worst.items()) or "–"
        observables = ", ".join(dict.fromkeys(c["observable"] for c in row["claims"]))
        lines.append(f"| {row['name']} | {row['title']} | {truth} | {error} | {observables} |")
    return "\n".join(lines)


def link(source):
    """owner/repository#number is an issue or a discussion of GitHub; anything else is a title."""
    name, _, number = source.partition("#")
    return f"[{source}](https://github.com/{name}/issues/{number})" if number.isdigit() else source


def extremes(cylon):
    lines = ["| scenario | what happens | step | criterion | sources |", "|---|---|---|---|---|"]
    for row in json.loads(output(cylon, "list", "--json", "--tag", "extreme")):
        claims = "; ".join(f"{c['label']}: {c['absolute'] or c['relative']:g} " +
                           (c["unit"] if c["absolute"] else "of its size") for c in row["claims"])
        lines.append(f"| {row['name']} | {row['title']} | {row['step']:.4g} s | {claims} | {', '.join(map(link, row['sources'])) or '–'} |")
    return "\n".join(lines)


def extreme_verdicts(cylon):
    return matrix(cylon, "--suite", "extremes")


def published(cylon):
    text = output(cylon, "run", "--suite", "simbenchmark")
    table = text[text.index("published numbers"):]
    return "```\n" + table.rstrip() + "\n```"


def fingerprint(cylon):
    """Answers only: the numbers that they rest on stand beside them in the program's own words."""
    engines = json.loads(output(cylon, "engines", "--fingerprint", "--json", "in-house", "bullet", "bullet-multibody", "ode"))
    lines = ["| | " + " | ".join(e["id"] for e in engines) + " |", "|---" * (len(engines) + 1) + "|"]
    for i, finding in enumerate(engines[0]["findings"]):
        lines.append(f"| {finding['probe']} | " + " | ".join(e["findings"][i]["answer"] for e in engines) + " |")
    return "\n".join(lines)


def commands(cylon):
    text = output(cylon, "--help")
    return "```\n" + text[text.index("Subcommands:"):].rstrip() + "\n```"


PAGES = {"README.md": {"matrix": matrix, "scenarios": scenarios, "published": published, "fingerprint": fingerprint, "commands": commands},
         "docs/extremes.md": {"extremes": extremes, "extreme-verdicts": extreme_verdicts}}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="change nothing; fail where a table is not current")
    parser.add_argument("--cylon", default="build/release/cylon", help="the program to ask")
    options = parser.parse_args()
    stale = []
    for page, blocks in PAGES.items():
        file = root / page
        old = new = file.read_text()
        for name, make in blocks.items():
            new, count = re.subn(rf"(<!-- {name} -->\n).*?(<!-- /{name} -->)",
                                 lambda m: m[1] + make(options.cylon) + "\n" + m[2], new, flags=re.S)
            if count != 1:
                sys.exit(f"{page}: needs one block '<!-- {name} --> … <!-- /{name} -->'")
        if options.check and new != old:
            import difflib
            sys.stdout.writelines(difflib.unified_diff(old.splitlines(True), new.splitlines(True), page, "current"))
            stale.append(page)
        if not options.check:
            file.write_text(new)
    if stale:
        sys.exit(f"{', '.join(stale)}: not current: run docs/update.py")


main()
