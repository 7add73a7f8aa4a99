#!/usr/bin/env python3
"""Writes scenarios/data/expected_rows.toml from the causes of scenarios/expected.toml, or checks that it is current.

    docs/expected.py [--check] [--cylon build/release/cylon]

Runs every shipped suite and the relations of the suite conformance, which takes a minute.  Each verdict that is no pass gets a
row: the first cause of expected.toml that explains it, its status, and what was measured.  A verdict that no cause explains, and
a cause that explains no verdict, is an error.  --check fails where a verdict differs from its row: by its status, or by more than
the factor of its cause.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib

root = pathlib.Path(__file__).resolve().parent.parent
causes_file, rows_file = root / "scenarios/expected.toml", root / "scenarios/data/expected_rows.toml"

# What is asked of whom; the catalogue in single precision is no suite of its own.
RUNS = [["--suite", "conformance"], ["--suite", "conformance", "--metamorphic"], ["--suite", "catalogue"],
        ["--suite", "catalogue", "--engine", "in-house-float"], ["--suite", "extremes"], ["--suite", "simbenchmark"]]
KEYS = ("scenario", "engine", "dt", "claim")
HEAD = """# Written by docs/expected.py from the causes of scenarios/expected.toml and from what was measured: do not edit.
"""


def verdicts(cylon):
    for run in RUNS:
        with tempfile.TemporaryDirectory() as folder:  # one run at a time may work in a folder
            done = subprocess.run([cylon, "run", *run, "--json", "-"], cwd=folder, capture_output=True, text=True)
        if done.returncode not in (0, 1, 5):  # 5: a crash that no row expects, as where there are no rows yet
            sys.exit(f"cylon run {' '.join(run)} ended with {done.returncode}:\n{done.stderr}")
        yield from json.loads(done.stdout)["verdicts"]


def matches(globs, text):
    return any(re.fullmatch(re.escape(glob).replace(r"\*", ".*").replace(r"\?", "."), text, re.DOTALL)
               for glob in globs.split(":"))


def explains(symptoms, verdict):
    return all(matches(symptoms.get(key, "*"), verdict[key]) for key in ("engine", "scenario", "claim"))


def sized(verdict):
    """Whether the measured value says all of a verdict that is no pass; it does not where an event did not come."""
    measured = verdict["measured"]
    return verdict["status"] in ("low-quality", "fail") and measured is not None and measured > verdict["allowed"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--cylon", default=str(root / "build/release/cylon"))
    arguments = parser.parse_args()
    causes = tomllib.loads(causes_file.read_text(encoding="utf-8"))["cause"]

    found, complaints, differing = [], [], []
    for verdict in verdicts(pathlib.Path(arguments.cylon).resolve()):
        if not verdict["as_expected"]:
            differing.append(f"{verdict['claim']} of {verdict['scenario']} on {verdict['engine']}: {verdict['status']} "
                             f"{verdict['measured']}, expected {verdict['expected']} {verdict['expected_size']}")
        if verdict["status"] == "pass":
            continue
        place = next(((i, cause) for i, cause in enumerate(causes)
                      if any(explains(symptoms, verdict) for symptoms in cause["explains"])), None)
        if place is None:
            complaints.append(f"no cause explains '{verdict['claim']}' of {verdict['scenario']} on {verdict['engine']}: "
                              f"{verdict['status']} {verdict['measured']}, allowed {verdict['allowed']}")
        else:
            found.append((*place, verdict))
    for cause in causes:
        for symptoms in cause["explains"]:
            if not any(of is cause and explains(symptoms, verdict) for _, of, verdict in found):
                complaints.append(f"{cause['name']} explains nothing: {symptoms}")
    if complaints:
        sys.exit("\n".join(complaints))
    if arguments.check:
        if differing:
            sys.exit("\n".join(differing))
        return

    lines = {}  # a cell may stand in two suites; it has the same bits in both
    for order, cause, v in sorted(found, key=lambda f: (f[0], *(f[2][k] for k in KEYS))):
        fields = {"cause": cause["name"], "scenario": v["scenario"], "engine": v["engine"], "dt": v["dt_text"], "claim": v["claim"],
                  "status": v["status"]}
        line = ", ".join(f"{key} = {json.dumps(value, ensure_ascii=False)}" for key, value in fields.items())
        if sized(v):
            line += f", measured = {v['measured']:.3g}"
        lines[tuple(v[k] for k in KEYS)] = f"  {{ {line} }},\n"
    rows_file.write_text(HEAD + "row = [\n" + "".join(lines.values()) + "]\n", encoding="utf-8")
    print(f"{len(causes)} causes, {len(lines)} verdicts that are no pass")


if __name__ == "__main__":
    main()
