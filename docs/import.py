#!/usr/bin/env python3
"""Imports every scene of a corpus, runs what can be said for one second on every engine, and writes the tables of
docs/import.md, all from this one run.

    docs/import.py CORPUS [--cylon build/release/cylon] [--engine ID …] [--no-runs | --relations] [--keep FOLDER]
    docs/import.py --of FILE… [--relations]

CORPUS is a folder of folders, one per project, or $CYLON_CORPUS; nothing of it is part of this repository.  --relations
asks the relations of `cylon run --metamorphic` in place of the claims, and writes their tables alone.  --keep leaves the
scenarios and a file `results.jsonl`, one line a file, in a folder; files that it has already are not done again, so that
an interrupted run goes on.  --of writes the tables of such files anew, of runs of other engines side by side.
"""
import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parent.parent
page = root / "docs/import.md"
FORMATS = {".xml": "MJCF", ".mjcf": "MJCF", ".sdf": "SDFormat", ".world": "SDFormat", ".urdf": "URDF"}
ENGINES = ["in-house", "bullet", "bullet-multibody", "ode", "mujoco", "mujoco3", "simbody", "dart", "siconos", "jolt", "rapier", "physx", "havok",
           "crashcat", "cannon-es"]
PATIENCE = 20  # [s] of one run on one engine

# From the best to the worst; a scene counts by the worst of its claims.
OUTCOMES = ["pass", "undecided", "low-quality", "fail", "non-finite", "timeout", "crash", "protocol", "no report"]


def scenes(corpus):
    """The files of a format that hold a scene; an MJCF file that is only included by others holds none."""
    for file in sorted(corpus.rglob("*")):
        if file.suffix in FORMATS and file.is_file():
            text = file.read_text(encoding="utf-8", errors="replace")
            if file.suffix != ".xml" or "<mujoco" in text and "<worldbody" in text:
                yield file


# What a library says of a file that it refuses, and the row of the table.
SAYINGS = [
    (r" is not there|Unable to find uri|Cannot open file|could not open|Error opening file|is no file of this machine",
     "a file that it names is missing"),
    (r"plugin .* not found", "a plugin of MuJoCo that its build for Node does not have"),
    (r"Schema violation|no longer supported", "another version of the format than the library's"),
    (r"it moves, but its mass", "a body without inertia"),
    (r"its inertia:", "an inertia that no body has"),
    (r"its limits are", "limits the wrong way"),
]


def why(message):
    """The kinds of loss for which a file is refused, or who refuses it."""
    # "FILE:LINE: ELEMENT: KIND (DETAIL): REASON"
    if "a scene cannot say what this file says" in message:
        kinds = re.findall(r"^  .*?: (?:option: |model: |contacts: )?([a-z_]+)(?: \(|:)", message, re.MULTILINE)
        return [f"`{kind}`" for kind in sorted(set(kinds))]
    if "as a scenario:" in message or "the imported scenario:" in message:
        return ["the reader of scenarios"]
    return next(([reason] for saying, reason in SAYINGS if re.search(saying, message)), ["the format's own library"])


def called(command, patience, folder=None):
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace", timeout=patience)
    except subprocess.TimeoutExpired:
        return 5, "", f"no answer in {patience} s"
    return done.returncode, done.stdout, done.stderr


def outcome(rows):
    """One engine's worst claim, or why it refuses the scene; a claim that nobody can judge there does not count."""
    judged = [row["status"] for row in rows if row["status"] != "unsupported"]
    if not judged:
        return "refused", min(row["detail"] for row in rows)
    return max(judged, key=lambda status: OUTCOMES.index(status) if status in OUTCOMES else len(OUTCOMES)), ""


def verdicts(cylon, scene, engines, patience, *options):
    """engine -> its rows, and a complaint where there are none."""
    command = [cylon, "run", scene, "--jobs", "1", "--timeout", str(PATIENCE), "--json", "-", *options,
               *(word for engine in engines for word in ("--engine", engine))]
    with tempfile.TemporaryDirectory() as own:  # one cylon at a time keeps its journal in a folder
        _, out, error = called(command, patience * len(engines) + 60, own)
    try:
        rows = json.loads(out)["verdicts"]
    except (json.JSONDecodeError, KeyError):
        return {}, error.strip()[-300:]
    return {engine: [row for row in rows if row["engine"] == engine] for engine in engines}, ""


def runs(cylon, scene, engines):
    """engine -> (outcome, reason)."""
    found, complaint = verdicts(cylon, scene, engines, 2 * PATIENCE)
    return {engine: outcome(found[engine]) if found.get(engine) else ("no report", complaint) for engine in engines}


# Runs that begin one ulp apart may get so far from each other, as a part of what a relation allows: its transformed run is
# many roundings away from the plain one.
ROUNDING = 0.01


def related(cylon, scene, engines):
    """engine -> (outcome of the scene, the relations that it breaks)."""
    # some twenty relations of a run or two each, and two runs for the spread
    found, complaint = verdicts(cylon, scene, engines, 40 * PATIENCE, "--metamorphic", "--spread", "2")

    def judged(rows):
        asked = [row for row in rows if row["status"] != "unsupported"]
        if not asked:
            return "refused", []
        stopped = [row["status"] for row in asked if row["status"] not in ("pass", "undecided", "low-quality", "fail")]
        if stopped:
            return max(stopped, key=lambda status: OUTCOMES.index(status) if status in OUTCOMES else len(OUTCOMES)), []
        broken = [row for row in asked if row["status"] in ("low-quality", "fail")]
        lasting = [row for row in broken if row["allowed"] == 0 or (row.get("spread") or 0) < ROUNDING * row["allowed"]]
        return "broken" if lasting else "rounding" if broken else "held", [row["claim"] for row in lasting]

    return {engine: judged(found[engine]) if found.get(engine) else ("no report", complaint) for engine in engines}


def followed(cylon, file, scene, engines, ask):
    """What becomes of one file, from the import to the engines."""
    code, _, message = called([cylon, "import", file, "-o", scene], 120)
    if code != 0:
        return {"code": code, "message": message, "runs": {}}
    valid, _, complaint = called([cylon, "validate", scene], 120)
    if valid != 0:
        return {"code": 5, "message": f"what was imported is not valid: {complaint}", "runs": {}}
    if "[[claim]]" not in pathlib.Path(scene).read_text(encoding="utf-8"):
        return {"code": 0, "message": message, "runs": {engine: ("nothing moves", "") for engine in engines}}
    return {"code": 0, "message": message, "runs": ask(cylon, scene, engines) if engines else {}}


def table(header, rows):
    return "\n".join(["| " + " | ".join(header) + " |", "|---" * len(header) + "|", *("| " + " | ".join(map(str, r)) + " |" for r in rows)])


def replace(text, name, block):
    pattern = re.compile(rf"(<!-- {name} -->\n).*?(<!-- /{name} -->)", re.DOTALL)
    if not pattern.search(text):
        sys.exit(f"{page}: no block {name}")
    return pattern.sub(lambda m: m[1] + block + "\n" + m[2], text)


def what_became(results):
    counts = collections.defaultdict(collections.Counter)
    for result in results:
        word = {0: "imported", 2: "refused"}.get(result["code"], "failed")
        counts[result["project"], result["format"]].update(["files", word])
    rows = [(project, kind, c["files"], c["imported"], c["refused"], c["failed"]) for (project, kind), c in sorted(counts.items())]
    total = [sum(row[i] for row in rows) for i in range(2, 6)]
    return table(["project", "format", "files", "imported", "refused", "neither"], [*rows, ("all", "", *total)])


def why_refused(results):
    formats = sorted(set(FORMATS.values()))
    counts = {kind: collections.Counter() for kind in formats}
    for result in results:
        if result["code"] == 2:
            counts[result["format"]].update(why(result["message"]))
    total = sum(counts.values(), collections.Counter())
    return table(["refused for", *formats], [(reason, *(counts[kind][reason] for kind in formats)) for reason, _ in total.most_common()])


def left_out(results):
    """How many imported files lose something of each kind."""
    kinds = collections.Counter()
    for result in results:
        if result["code"] == 0:
            found = re.findall(r"^left out: .*?: (?:option: |model: |contacts: )?([a-z_]+)(?: \(|:)", result["message"], re.MULTILINE)
            kinds.update(set(found))
    return table(["left out", "imported files"], [(f"`{kind}`", count) for kind, count in kinds.most_common()])


def what_ran(results, engines):
    counts = {engine: collections.Counter(r["runs"][engine][0] for r in results if r["runs"]) for engine in engines}
    shown = [word for word in OUTCOMES if any(c[word] for c in counts.values())]
    others = sorted({word for c in counts.values() for word in c} - set(OUTCOMES) - {"refused"})
    rows = [(f"`{e}`", sum(c.values()), sum(c[w] for w in ("pass", "undecided", "low-quality", "fail")), c["refused"], *(c[w] for w in shown + others))
            for e, c in counts.items()]
    return table(["engine", "scenes", "ran", "refused", *shown, *others], rows)


RELATED = ["held", "rounding", "broken", "refused"]


def what_held(results, engines):
    counts = {engine: collections.Counter(r["runs"][engine][0] for r in results if r["runs"]) for engine in engines}
    others = sorted({word for c in counts.values() for word in c} - set(RELATED))
    rows = [(f"`{e}`", sum(c.values()), *(c[w] for w in RELATED + others)) for e, c in counts.items()]
    return table(["engine", "scenes", *RELATED, *others], rows)


def what_broke(results, engines):
    counts = {engine: collections.Counter(claim for r in results for claim in (r["runs"].get(engine) or ["", []])[1])
              for engine in engines if any(r["runs"].get(engine, [""])[0] == "broken" for r in results)}
    total = sum(counts.values(), collections.Counter())
    return table(["relation", *(f"`{engine}`" for engine in counts)],
                 [(name.removeprefix("relation "), *(c[name] for c in counts.values())) for name, _ in total.most_common()])


def why_not_run(results, engines):
    """The reasons without the names and numbers that they state."""
    reasons = collections.Counter()
    for result in results:
        for engine in engines:
            word, reason = result["runs"].get(engine, ("", ""))
            if word == "refused":
                reasons[engine, re.sub(r"(?<!\w)'[^']*'|\d+(\.\d+)?(e[-+]\d+)?", "…", reason).replace("|", r"\|")] += 1
    ordered = sorted(reasons.items(), key=lambda row: (engines.index(row[0][0]), -row[1], row[0][1]))
    return table(["engine", "refuses because", "scenes"], [(f"`{e}`", reason, count) for (e, reason), count in ordered])


def all_of(corpus, engines, options):
    """What becomes of every file of the corpus."""
    with tempfile.TemporaryDirectory() as temporary, concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        folder = (options.keep or pathlib.Path(temporary)).absolute()
        folder.mkdir(parents=True, exist_ok=True)
        asked = ["relations" if options.relations else "claims", *engines]
        kept = folder / "results.jsonl"
        before = kept.read_text(encoding="utf-8").splitlines() if options.keep and kept.exists() else []
        results = [json.loads(line) for line in before]
        if any(result.get("asked") != asked for result in results):
            sys.exit(f"{kept}: holds answers to another question, or of other engines")
        done = {result["file"] for result in results}
        files = [(i, file) for i, file in enumerate(scenes(corpus)) if str(file.relative_to(corpus)) not in done]
        ask = related if options.relations else runs
        work = [(file, folder / f"scene_{i}.toml") for i, file in files]
        for n, ((_, file), result) in enumerate(
                zip(files, pool.map(lambda one: followed(options.cylon, *one, engines, ask), work))):
            place = file.relative_to(corpus)
            result |= {"asked": asked, "file": str(place), "project": place.parts[0], "format": FORMATS[file.suffix]}
            results.append(result)
            with kept.open("a", encoding="utf-8") as lines:
                lines.write(json.dumps(result) + "\n")
            if sys.stderr.isatty():
                print(f"\r{n + 1} of {len(files)} files", end="", file=sys.stderr)
            if result["code"] not in (0, 2):
                print(f"{file}: exit code {result['code']}: {result['message'].strip()[-300:]}", file=sys.stderr)
    return results


def joined(parts):
    """The results of runs of the same corpus, each with engines of its own; of files that all of them have."""
    by_file = [{result["file"]: result for result in part} for part in parts]
    return [result | {"runs": {engine: run for part in by_file for engine, run in part[name]["runs"].items()}}
            for name, result in by_file[0].items() if all(name in part for part in by_file)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("corpus", nargs="?", default=os.environ.get("CYLON_CORPUS"))
    parser.add_argument("--cylon", type=lambda word: pathlib.Path(word).absolute(), default=root / "build/release/cylon")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--engine", action="append", help=f"default: {', '.join(ENGINES)}")
    parser.add_argument("--no-runs", action="store_true", help="import only; the tables of runs stay as they are")
    parser.add_argument("--relations", action="store_true", help="ask the relations in place of the claims")
    parser.add_argument("--of", type=pathlib.Path, nargs="+", help="write the tables of the results.jsonl of earlier runs")
    parser.add_argument("--keep", type=pathlib.Path, help="folder for the scenarios and results.jsonl")
    options = parser.parse_args()
    engines = [] if options.no_runs else options.engine or ENGINES
    if options.of:
        results = joined([[json.loads(line) for line in file.read_text(encoding="utf-8").splitlines()] for file in options.of])
    elif options.corpus and pathlib.Path(options.corpus).is_dir():
        results = all_of(pathlib.Path(options.corpus).absolute(), engines, options)
    else:
        print("no corpus here: name its folder, or set CYLON_CORPUS", file=sys.stderr)
        return 77
    runs = [run for result in results for run in result.get("runs", {}).values()]
    if runs and all(run[0] in ("no report", "nothing moves") for run in runs):
        sys.exit(f"no engine reported anything: {runs[0][1] if len(runs[0]) > 1 else ''}")
    text = page.read_text(encoding="utf-8")
    if options.relations:
        engines = list(next(result["runs"] for result in results if result["runs"]))
        text = replace(text, "relations", what_held(results, engines))
        text = replace(text, "relations broken", what_broke(results, engines))
        page.write_text(text, encoding="utf-8")
        return 0
    text = replace(text, "corpus", what_became(results))
    text = replace(text, "reasons", why_refused(results))
    text = replace(text, "losses", left_out(results))
    if engines:
        text = replace(text, "runs", what_ran(results, engines))
        text = replace(text, "unable", why_not_run(results, engines))
    kinds = subprocess.run([options.cylon, "import", "--kinds"], capture_output=True, text=True)
    if kinds.returncode == 0:
        rows = [re.match(r"(\S+)\s+(left out|refused)\s+(.*)", line).groups() for line in kinds.stdout.splitlines()]
        text = replace(text, "kinds", table(["kind", "becomes", "why"], [(f"`{k}`", d, w.replace("*", r"\*")) for k, d, w in rows]))
    page.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
