#!/usr/bin/env python3
"""Writes the table of docs/security.md: what is tried against the program, how often, and what fails.

    docs/security.py [--cylon build/release/cylon] [--campaigns]

Scripts run anew, which takes minutes; with --campaigns their rows stay as they are.  Campaigns, which take hours, tell what
they have counted so far, and try again what they have found.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests/hostile"))
from counted import commit  # noqa: E402

ROWS = [
    ("hostile scenarios and documents", "tests/hostile/corpus.py"),
    ("engines that misbehave, beside a healthy one", "tests/hostile/misdeeds.py"),
    ("the same in the sandbox", "tests/hostile/misdeeds.py --sandbox"),
    ("hostile texts through every output", "tests/hostile/texts.py"),
    ("mutated scenarios, reports, stores' exports and journals", "tests/hostile/mutants.py"),
]
# With the words that only ask for the counts.
CAMPAIGNS = [
    ("libFuzzer", "tests/fuzz/campaign.py PART", "--rounds 0"),
    ("accepted by the reader, asked of every other part", "tests/fuzz/accepted.py", "--scenes 0"),
    ("killed at a random moment and resumed", "tests/hostile/kills.py CYLON PART", "--kills 0"),
    ("one call of the system failed, then resumed", "tests/hostile/faults.py CYLON PART", "--trials 0"),
]


def said_last(command):
    """The last line of a script, which is JSON."""
    ran = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    print(ran.stdout + ran.stderr, end="", file=sys.stderr)
    if not ran.stdout:
        sys.exit(f"{command[0]} says nothing")
    return json.loads(ran.stdout.splitlines()[-1])


def rows_of_scripts(cylon):
    """Runs each script: its row, and how often it failed."""
    for what, command in ROWS:
        script, *words = command.split()
        count = said_last([ROOT / script, cylon, *words])
        worst = f"{count['cpu_seconds']} s of CPU, {count['megabytes']} MB" if "megabytes" in count else ""
        shown = " ".join([script, "build/release/cylon", *words])
        yield f"| {what} | {count['tried']} | {count['failed']} | {worst} | {commit()} | `{shown}` |", count["failed"]


def tried(count):
    """How many of how many, where their number is known; a campaign that is not done says so."""
    if "places" in count:
        # Of some places the last allocation fails too, which counts kept before did not tell.
        of = f" of {count.get('trials_of_places', count['places'])} places"
        return f"{count['tried']}{of}" + ("" if count.get("done") else ", unfinished")
    if "calls" in count:
        return f"{count['tried']} of {count['calls']} calls" + ("" if count.get("done") else ", unfinished")
    return f"{count['tried']}"


def commits(count):
    """Of which the count is, and what was tried of others before."""
    before = [f"{old['tried']} of {old.get('commit', 'unknown')}" for old in count.get("before", [])]
    return count.get("commit", "–" if not count["tried"] else "unknown") + (f"; before {', '.join(before)}" if before else "")


def rows_of_campaigns(cylon):
    """A row for each part of each campaign, and how much of it is open."""
    for what, command, ask in CAMPAIGNS:
        words = command.replace(" PART", "").replace("CYLON", cylon).split()
        for part, count in said_last([ROOT / words[0], *words[1:], *ask.split()])["parts"].items():
            if count.get("calls") == 0:  # it makes none
                continue
            accepted = f"{count['accepted']} accepted" if "accepted" in count else ""
            shown = command.replace("CYLON", "build/release/cylon").replace("PART", part)
            yield (f"| {what}: {part} | {tried(count)} | {count['failed']} | {accepted} | {commits(count)} | `{shown}` |",
                   count["failed"])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cylon", default="build/release/cylon")
    parser.add_argument("--campaigns", action="store_true")
    options = parser.parse_args()
    page = ROOT / "docs/security.md"
    text = page.read_text()
    if options.campaigns:
        known = tuple(f"| {what} |" for what, _ in ROWS)
        rows = [(line, 0) for line in text.splitlines() if line.startswith(known)]
    else:
        rows = list(rows_of_scripts(options.cylon))
    rows += rows_of_campaigns(options.cylon)
    lines = ["| what | tried | open | worst | of commit | command |", "|---|---|---|---|---|---|", *(line for line, _ in rows)]
    page.write_text(re.sub(r"(?s)(<!-- security -->\n).*?(<!-- /security -->)",
                           lambda block: block[1] + "\n".join(lines) + "\n" + block[2], text))
    return 1 if any(failed for _, failed in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
