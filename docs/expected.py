#!/usr/bin/env python3
"""Writes scenarios/data/expected_rows.toml from the causes of scenarios/expected.toml, or checks that it is current.

    docs/expected.py [--check] [--cylon build/release/cylon]

Runs every shipped suite and the relations of the suite conformance, which takes a minute, and every scene on each optional
engine of which a cause speaks, which takes minutes more.  Each verdict that is no pass gets a row: the first cause of
expected.toml that explains it, its status, and what was measured.  A verdict of an engine of every build that no cause explains,
and a cause that explains no verdict, is an error; of optional engines the first are counted and get no row.  An optional engine
that is not here keeps its rows.  --check fails where a verdict differs from its row: by its status, or by more than the factor of
its cause.
"""
import argparse
import collections
import fractions
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
OPTIONAL_WITHOUT_ROWS = ("undecided", "timeout")  # a timeout depends on the machine
HEAD = """# Written by docs/expected.py from the causes of scenarios/expected.toml and from what was measured: do not edit.
"""


def optional_engines():
    """Ids of the engines that no build need have."""
    lines = (root / "reference/simulators/engines.txt").read_text(encoding="utf-8").splitlines()
    return [line.split()[0] for line in lines if not line.startswith("#") and line.split()[3:4] == ["optional"]]


def here(cylon):
    done = subprocess.run([cylon, "engines", "--here"], capture_output=True, text=True, check=True)
    return {line.split(":")[0] for line in done.stdout.splitlines() if ": here" in line}


def verdicts(cylon, engines):
    for run in RUNS + [["*", "--engine", engine] for engine in engines]:
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


def cause_of(causes, verdict):
    """The first cause that explains a verdict or a row, with its place among the causes; or None."""
    return next(((i, cause) for i, cause in enumerate(causes)
                 if any(explains(symptoms, verdict) for symptoms in cause["explains"])), None)


def kept_rows(causes, engines):
    """The rows of these engines as they stand, as if they had just been measured."""
    if not engines or not rows_file.exists():
        return []
    rows = [row for row in tomllib.loads(rows_file.read_text(encoding="utf-8"))["row"] if row["engine"] in engines]
    kept = []
    for row in rows:
        place = cause_of(causes, row)
        if place is None or place[1]["name"] != row["cause"]:
            sys.exit(f"'{row['claim']}' of {row['scenario']} on {row['engine']}, which is not here, is no longer explained by "
                     f"{row['cause']}")
        size = {"measured": row.get("measured"), "allowed": -1}  # what has a size in its row keeps it
        kept.append((*place, row | size | {"dt": float(fractions.Fraction(row["dt"])), "dt_text": row["dt"]}))
    return kept


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--cylon", default=str(root / "build/release/cylon"))
    arguments = parser.parse_args()
    causes = tomllib.loads(causes_file.read_text(encoding="utf-8"))["cause"]
    cylon = pathlib.Path(arguments.cylon).resolve()
    optional = [engine for engine in optional_engines()
                if any(matches(symptoms["engine"], engine) for cause in causes for symptoms in cause["explains"])]
    present = here(cylon)
    absent = [engine for engine in optional if engine not in present]
    if absent:
        print(f"not here, so {'not checked' if arguments.check else 'their rows stay'}: {', '.join(absent)}", file=sys.stderr)

    found, complaints, differing, unexplained = kept_rows(causes, absent), [], [], collections.Counter()
    for verdict in verdicts(cylon, [engine for engine in optional if engine in present]):
        of_optional = verdict["engine"] in optional
        without_row = verdict["status"] == "pass" or of_optional and verdict["status"] in OPTIONAL_WITHOUT_ROWS
        place = None if without_row else cause_of(causes, verdict)
        if not verdict["as_expected"] and not (of_optional and verdict["status"] != "pass" and place is None):
            differing.append(f"{verdict['claim']} of {verdict['scenario']} on {verdict['engine']}: {verdict['status']} "
                             f"{verdict['measured']}, expected {verdict['expected']} {verdict['expected_size']}")
        if place is not None:
            found.append((*place, verdict))
        elif of_optional and verdict["status"] not in ("pass", "undecided"):
            unexplained[verdict["engine"]] += 1
        elif not of_optional and verdict["status"] != "pass":
            complaints.append(f"no cause explains '{verdict['claim']}' of {verdict['scenario']} on {verdict['engine']}: "
                              f"{verdict['status']} {verdict['measured']}, allowed {verdict['allowed']}")
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
    for engine, count in unexplained.items():
        print(f"{engine}: {count} verdicts that no cause explains")


if __name__ == "__main__":
    main()
