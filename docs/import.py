#!/usr/bin/env python3
"""Imports every scene of a corpus, runs what can be said, and writes the tables of docs/import.md.

    docs/import.py CORPUS [--cylon build/release/cylon] [--engine ID …]

CORPUS is a folder of folders, one per project, or $CYLON_CORPUS; nothing of it is part of this repository.  Without
--engine nothing runs and the table of runs stays as it is.
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


def scenes(corpus):
    """The files of a format that hold a scene; an MJCF file that is only included by others holds none."""
    for file in sorted(corpus.rglob("*")):
        if file.suffix in FORMATS and file.is_file():
            text = file.read_text(encoding="utf-8", errors="replace")
            if file.suffix != ".xml" or "<mujoco" in text and "<worldbody" in text:
                yield file


def why(message):
    """The kinds of loss for which a file is refused, or who refuses it."""
    # "FILE:LINE: ELEMENT: KIND (DETAIL): REASON"
    kinds = sorted(set(re.findall(r"^  .*?: (?:option: |model: |contacts: )?([a-z_]+)(?: \(|:)", message, re.MULTILINE)))
    if "a scene cannot say what this file says" in message:
        return [f"`{kind}`" for kind in kinds]
    if "as a scenario:" in message:
        return ["the reader of scenarios"]
    for words, reason in ((" is not there", "a file that it names is missing"), ("Unable to find uri", "a file that it names is missing"),
                          ("Cannot open file", "a file that it names is missing"), ("could not open", "a file that it names is missing"),
                          ("Schema violation", "a newer format than the library's"), ("it moves, but its mass", "a body without inertia"),
                          ("its inertia:", "an inertia that no body has"), ("its limits are", "limits the wrong way")):
        if words in message:
            return [reason]
    return ["the format's own library"]


def imported(cylon, file, out):
    try:
        done = subprocess.run([cylon, "import", file, "-o", out], capture_output=True, text=True, errors="replace", timeout=120)
    except subprocess.TimeoutExpired:
        return 5, "no answer in 120 s"
    return done.returncode, done.stderr


def verdicts(cylon, scene, engines):
    """engine -> its worst status of the claims, each run of one second."""
    command = [cylon, "run", scene, "--json", "-", *(word for engine in engines for word in ("--engine", engine))]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=600)
        rows = json.loads(done.stdout)["verdicts"]
    except (subprocess.TimeoutExpired, json.JSONDecodeError, KeyError):
        return {engine: "no report" for engine in engines}
    worst = {}
    order = ["pass", "low-quality", "unsupported", "fail", "non-finite", "timeout", "crash", "protocol"]
    for row in rows:
        status = row["status"]
        before = worst.get(row["engine"], "pass")
        rank = lambda word: order.index(word) if word in order else len(order)
        worst[row["engine"]] = max(before, status, key=rank)
    return worst


def table(header, rows):
    return "\n".join(["| " + " | ".join(header) + " |", "|---" * len(header) + "|", *("| " + " | ".join(map(str, r)) + " |" for r in rows)])


def replace(text, name, block):
    pattern = re.compile(rf"(<!-- {name} -->\n).*?(<!-- /{name} -->)", re.DOTALL)
    if not pattern.search(text):
        sys.exit(f"{page}: no block {name}")
    return pattern.sub(lambda m: m[1] + block + "\n" + m[2], text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("corpus", nargs="?", default=os.environ.get("CYLON_CORPUS"))
    parser.add_argument("--cylon", default=root / "build/release/cylon")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--engine", action="append", default=[])
    options = parser.parse_args()
    if not options.corpus or not pathlib.Path(options.corpus).is_dir():
        print("no corpus here: name its folder, or set CYLON_CORPUS", file=sys.stderr)
        return 77
    corpus = pathlib.Path(options.corpus)
    counts = collections.defaultdict(collections.Counter)
    reasons = collections.Counter()
    runs = collections.defaultdict(collections.Counter)
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        work = [(file, os.path.join(folder, f"scene_{i}.toml")) for i, file in enumerate(scenes(corpus))]
        for (file, out), (code, message) in zip(work, pool.map(lambda one: imported(options.cylon, *one), work)):
            key = (file.relative_to(corpus).parts[0], FORMATS[file.suffix])
            counts[key]["files"] += 1
            counts[key]["imported" if code == 0 else "refused" if code == 2 else "failed"] += 1
            if code == 2:
                reasons.update(why(message))
            elif code != 0:
                print(f"{file}: exit code {code}: {message.strip()[-300:]}", file=sys.stderr)
            elif options.engine:
                for engine, status in verdicts(options.cylon, out, options.engine).items():
                    runs[engine][status] += 1
    text = page.read_text(encoding="utf-8")
    rows = [(project, kind, c["files"], c["imported"], c["refused"], c["failed"]) for (project, kind), c in sorted(counts.items())]
    total = [sum(row[i] for row in rows) for i in range(2, 6)]
    text = replace(text, "corpus", table(["project", "format", "files", "imported", "refused", "neither"], [*rows, ("all", "", *total)]))
    text = replace(text, "reasons", table(["refused for", "files"], reasons.most_common()))
    if runs:
        statuses = sorted({status for counter in runs.values() for status in counter})
        text = replace(text, "runs", table(["engine", *statuses], [(e, *(c[s] for s in statuses)) for e, c in runs.items()]))
    page.write_text(text, encoding="utf-8")
    kinds = subprocess.run([options.cylon, "import", "--kinds"], capture_output=True, text=True)
    if kinds.returncode == 0:
        rows = [re.match(r"(\S+)\s+(left out|refused)\s+(.*)", line).groups() for line in kinds.stdout.splitlines()]
        page.write_text(replace(page.read_text(encoding="utf-8"), "kinds", table(["kind", "becomes", "why"],
                        [(f"`{k}`", d, w.replace("*", r"\*")) for k, d, w in rows])), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
