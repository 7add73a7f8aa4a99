#!/usr/bin/env python3
"""Writes the generated blocks of README.md and docs/ from the output of the program, or checks that they are current.

    docs/update.py [--check] [--cylon build/release/cylon]
    docs/update.py --optional        # the blocks of optional engines too, which take minutes and need all of them (./run engines)

BLOCKS says which page has which block.  A block stands between '<!-- name -->' and '<!-- /name -->'.
Generated blocks contain verdicts and never times, so that they are the same on every run.  The table of all engines has
times: it is written from stored measurements (docs/engine_table.py).
Links and the paths of files in the text are checked too: each must exist.
"""
import argparse
import difflib
import fnmatch
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib

sys.dont_write_bytecode = True  # no __pycache__ beside the pages
import engine_table
import key_tables

root = pathlib.Path(__file__).resolve().parent.parent


def output(*command, folder=root):
    """What a command prints, 100 columns wide.  Exit code 1 is allowed: a verdict differs; and 5, where JSON tells that an engine crashed."""
    environment = {**os.environ, "COLUMNS": "100", "LC_ALL": "C.UTF-8"}
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, env=environment)
    if done.returncode not in ((0, 1, 5) if "--json" in command else (0, 1)):
        sys.exit(f"{' '.join(command)} ended with {done.returncode}:\n{done.stderr}")
    return done.stdout


def digits(verdict):
    """log10(allowed / measured), as the console shows it."""
    if verdict["measured"] is None:
        return -99.0
    if verdict["measured"] == 0:
        return 99.0
    return math.log10(verdict["allowed"] / verdict["measured"]) if verdict["allowed"] else -99.0


def digits_text(digits):
    return "exact" if digits >= 99 else f"{max(-99, digits):+.1f}"


MARKS = {"pass": "✓", "undecided": "?", "low-quality": "~", "fail": "✗", "unsupported": "–", "non-finite": "∞"}


def matrix(cylon, suite="conformance", *engines):
    chosen = [word for engine in engines for word in ("--engine", engine)]
    verdicts = json.loads(output(cylon, "run", "--suite", suite, *chosen, "--json", "-"))["verdicts"]
    engines = list(dict.fromkeys(v["engine"] for v in verdicts))
    lines = ["| scenario | " + " | ".join(e.replace("in-house/integrator=", "in-house, ") for e in engines) + " |",
             "|---" * (len(engines) + 1) + "|"]
    for scenario in dict.fromkeys(v["scenario"] for v in verdicts):
        cells = []
        for engine in engines:
            rows = [v for v in verdicts if v["scenario"] == scenario and v["engine"] == engine]
            # A claim without an answer is a refusal only where none has one.
            worst = min([v for v in rows if v["status"] != "unsupported"] or rows, key=digits)
            measured = worst["status"] in ("pass", "undecided", "low-quality", "fail")
            cells.append(MARKS.get(worst["status"], worst["status"]) +
                         (f" {digits_text(digits(worst))}" if measured else "") +
                         (" =" if any(v["closed_form"] for v in rows) else ""))
        lines.append(f"| {scenario} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def fenced(text, language=""):
    return f"```{language}\n{text.rstrip()}\n```"


def three_engines(cylon):
    ids = ["in-house", *(f"{engine}{path}" for engine in ("bullet", "ode") for path in ("", "/path=as-expert"))]
    return fenced(output(cylon, "run", *(word for id in ids for word in ("--engine", id))))


EXAMPLES = root / "docs" / "examples"


def tutorial_scene(_):
    return fenced((EXAMPLES / "swing.toml").read_text(), "toml")


def tutorial_run(cylon, *options):
    """What the tutorial's commands print, in a folder like the reader's."""
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(EXAMPLES / "swing.toml", folder)
        shutil.copy(EXAMPLES / "foreign_engine.py", pathlib.Path(folder) / "my_engine.py")
        return fenced(output(str(pathlib.Path(cylon).resolve()), "run", "swing.toml", *options, folder=folder))


def tutorial_engines(cylon):
    return tutorial_run(cylon, "--engine", "in-house", "--engine", "bullet", "--engine", "ode")


def tutorial_steps(cylon):
    return tutorial_run(cylon, "--engine", "ode", "--dt", "1/1000", "--dt", "1/2000", "--dt", "1/4000")


def tutorial_own(cylon):
    return tutorial_run(cylon, "--worker", "mine=python3 my_engine.py", "--engine", "mine", "--dt", "1/250", "--dt", "1/1000")


def scenarios(cylon):
    lines = ["| scenario | what happens | truth | its error | claims |", "|---|---|---|---|---|"]
    for row in json.loads(output(cylon, "list", "--json")):
        if "extreme" in row["tags"]:
            continue  # docs/extremes.md
        followed = [c for c in row["claims"] if c["follows"]]
        truth = followed[0]["follows"] if followed else "–"
        worst = {}  # a bound in each unit
        for c in followed:
            if c["truth_error"] is None:
                continue  # of a measured motion: there is no bound
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
        claims = "; ".join(f"{c['label']}: " + (f"at least {c['at_least']:g} {c['unit']}" if c["at_least"] else
                           f"{c['absolute'] or c['relative']:g} " + (c["unit"] if c["absolute"] else "of its scale"))
                           for c in row["claims"])
        lines.append(f"| {row['name']} | {row['title']} | {row['step']:.4g} s | {claims} | {', '.join(map(link, row['sources'])) or '–'} |")
    return "\n".join(lines)


def extreme_verdicts(cylon):
    return matrix(cylon, "extremes")


def optional_extreme_verdicts(cylon):
    return matrix(cylon, "extremes", *(row.split()[0] for row in engine_rows() if row.split()[3] == "optional"))


def published(cylon):
    text = output(cylon, "run", "--suite", "simbenchmark")
    table = text[text.index("published numbers"):]
    return fenced(table)


def engine_rows():
    lines = (root / "reference/simulators/engines.txt").read_text().splitlines()
    return [line for line in lines if line and not line.startswith("#")]


def fingerprint(cylon):
    """Answers only: the numbers that they rest on stand beside them in the program's own words."""
    compared = [row.split()[0] for row in engine_rows() if row.split()[3] == "compared"]
    engines = json.loads(output(cylon, "engines", "--fingerprint", "--json", *compared))
    lines = ["| | " + " | ".join(e["id"] for e in engines) + " |", "|---" * (len(engines) + 1) + "|"]
    for i, finding in enumerate(engines[0]["findings"]):
        lines.append(f"| {finding['probe']} | " + " | ".join(e["findings"][i]["answer"] for e in engines) + " |")
    return "\n".join(lines)


def counterfactual(c):
    """One tested pair of runs, in words."""
    changed = [f"{what} `{c[key]}`" for key, what in (("other_scenario", "the scene"), ("other_engine", "the engine")) if key in c]
    if "other_dt" in c:
        changed.append(f"a step of {c['other_dt']} s")
    if "becomes" in c:
        then = c["becomes"]
    elif "at_least" not in c:
        then = f"at most {c['at_most']:g} times the error"
    elif "at_most" not in c:
        then = f"at least {c['at_least']:g} times the error"
    else:
        then = f"{c['at_least']:g} to {c['at_most']:g} times the error"
    claim = c["claim"].replace("*", "…")
    return f"{c['scenario']}, {claim}, `{c['engine']}`: with {', '.join(changed)} {then}"


SHOWN = ["Tested", "Changes nothing, and so is not the cause", "Solvable by another engine, which tests no mechanism", "Not expressible"]


def shows(c, rows, power):
    """What a pair of runs shows, as tests/conformance/causes_test.cc has it."""
    refused = any(row["status"] == "unsupported" and row["scenario"] == c["scenario"] and row["engine"] == c["engine"] and
                  fnmatch.fnmatchcase(row["claim"], c["claim"]) for row in rows)
    if refused:
        return SHOWN[3]
    other = c.get("other_engine", c["engine"])
    if "becomes" in c:
        return SHOWN[2] if other.startswith("in-house") and not c["engine"].startswith("in-house") else SHOWN[0]
    stays = other.split("/")[0] == c["engine"].split("/")[0] and c.get("at_least", 0) <= 1 <= c.get("at_most", math.inf)
    return SHOWN[1] if stays and power != 0 else SHOWN[0]


def causes(_):
    rows = tomllib.loads((root / "scenarios/data/expected_rows.toml").read_text())["row"]
    lines = []
    for cause in tomllib.loads((root / "scenarios/expected.toml").read_text())["cause"]:
        own = [row for row in rows if row["cause"] == cause["name"]]
        scenarios = sorted({row["scenario"] for row in own})
        engines = list(dict.fromkeys(row["engine"] for row in own))
        lines += ["", f"## {cause['name']}", "", cause["mechanism"], "",
                  f"- Where: {'; '.join(cause['source'])}.", f"- Size: {cause['law']}.",
                  f"- Explains {len(own)} verdicts on {', '.join(engines)}: {', '.join(scenarios)}."]
        if "note" in cause:
            lines.append(f"- Note: {cause['note']}")
        for kind in SHOWN:
            pairs = [c for c in cause["counterfactual"] if shows(c, own, cause.get("power")) == kind]
            lines += [f"- {kind}:"] * bool(pairs) + [f"  - {counterfactual(c)}" for c in pairs]
    return "\n".join(lines[1:])


def mutants(_):
    """Of tests/mutants/deaths.txt, which mutants_tests holds against the program."""
    lines = (root / "tests/mutants/deaths.txt").read_text().splitlines()
    rows = [line.split("\t") for line in lines if not line.startswith("#")]
    count = {means: sum(row[0] == means for row in rows) for means in ("own", "theory", "relations")}
    return (f"{len(rows)} mutants: {count['own']} die of the scenes' own claims, {count['theory']} more of claims by theory, and "
            f"{count['relations']} of shipped relations\nalone.")


def commands(cylon):
    text = output(cylon, "--help")
    return fenced(text[text.index("Subcommands:"):])


def key_block(make):
    """A table of keys from the JSON Schema that the program prints."""
    return lambda cylon: make(json.loads(output(cylon, "validate", "--schema")))


# page -> its blocks, each with the function that makes it
BLOCKS = {
    "README.md": {"run": three_engines, "engine-table": engine_table.block},
    "docs/speed-against-accuracy.md": {"engine-tables": engine_table.full_block},
    "docs/tutorial.md": {"scene": tutorial_scene, "engines": tutorial_engines, "steps": tutorial_steps, "own": tutorial_own},
    "docs/results.md": {"matrix": matrix},
    "docs/causes.md": {"causes": causes},
    "docs/scenarios.md": {"scenarios": scenarios},
    "docs/published.md": {"published": published},
    "docs/fingerprint.md": {"fingerprint": fingerprint},
    "docs/commands.md": {"commands": commands},
    "docs/scenario-format.md": {"scene-keys": key_block(key_tables.scene_keys)},
    "docs/protocol.md": {"worker-keys": key_block(key_tables.worker_keys), "worker-shapes": key_block(key_tables.worker_shapes)},
    "tests/mutants/README.md": {"counts": mutants},
    "docs/extremes.md": {"extremes": extremes, "extreme-verdicts": extreme_verdicts},
}
# The same of optional engines, which are not on every machine.
OPTIONAL = {"docs/extremes.md": {"extreme-verdicts-optional": optional_extreme_verdicts}}

FOLDERS = "engine|harness|reference|reports|scenarios|tests|bench|cmake|docs"


def without_code(page):
    return re.sub(r"^```.*?^```", "", page.read_text(), flags=re.S | re.M)


def anchors(page):
    """The names that GitHub gives to the headings of a page."""
    headings = re.findall(r"^#+ (.*)", without_code(page), flags=re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def dead_links(name):
    """The links and the paths in backticks of a page that lead nowhere."""
    page = root / name
    text = without_code(page)
    for link in re.findall(r"\]\((?!https?:)([^)\s]+)\)", text):
        path, _, anchor = link.partition("#")
        target = page.parent / path if path else page
        if not target.exists():
            yield f"{name}: there is no {link}"
        elif anchor and anchor not in anchors(target):
            yield f"{name}: there is no heading {link}"
    for path in re.findall(rf"`((?:{FOLDERS})/[\w./-]+)`", text):
        if not (root / path).exists():
            yield f"{name}: there is no {path}"


def pages():
    return subprocess.run(["git", "ls-files", "*.md"], cwd=root, capture_output=True, text=True).stdout.split()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="change nothing; fail where a block is not current")
    parser.add_argument("--cylon", default="build/release/cylon", help="the program to ask")
    parser.add_argument("--optional", action="store_true", help="also what optional engines do")
    options = parser.parse_args()
    wrong = [line for page in pages() for line in dead_links(page)] + list(engine_table.wrong())
    asked = [*BLOCKS.items(), *(OPTIONAL.items() if options.optional else [])]
    for page, blocks in asked:
        file = root / page
        old = new = file.read_text()
        for name, make in blocks.items():
            new, count = re.subn(rf"(<!-- {name} -->\n).*?(<!-- /{name} -->)",
                                 lambda m: m[1] + make(options.cylon) + "\n" + m[2], new, flags=re.S)
            if count != 1:
                sys.exit(f"{page}: needs one block '<!-- {name} --> … <!-- /{name} -->'")
        if not options.check:
            file.write_text(new)
        elif new != old:
            sys.stdout.writelines(difflib.unified_diff(old.splitlines(True), new.splitlines(True), page, "current"))
            wrong.append(f"{page}: not current: run docs/update.py")
    if wrong:
        sys.exit("\n".join(wrong))


main()
