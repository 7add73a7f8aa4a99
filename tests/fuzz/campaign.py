#!/usr/bin/env python3
"""Feeds the fuzz targets by libFuzzer under AddressSanitizer and UndefinedBehaviorSanitizer, in turns, and counts.

    tests/fuzz/campaign.py [--build build/fuzz] [--seconds 60] [--rounds N] [--executions N] [--minutes N] [TARGET…]

Each round gives every target that many seconds on one core; it goes on until the rounds are done, the executions of all
rounds that ever were are as many as asked for, or the minutes are over.  Counts are kept in tests/hostile/counts/fuzz.json,
with the program and the commit that they are of; those of another program are put aside there.  What a target has learned is
kept in BUILD/campaign/TARGET/.  Bytes that it did not take (crash, more than 10 s, more than 1 GB) are open until it takes
them: they stand in the counts, so that every clone knows them, and in BUILD/campaign/findings/.  The last line is JSON:
executions of these programs and open findings, together and of each target; --rounds 0 gives it alone.  Exit codes: 0 no open
finding, 1 open findings, 2 a target is not built, or does not run."""
import argparse
import base64
import itertools
import json
import os
import pathlib
import re
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/hostile"))
from counted import Counted, program_of  # noqa: E402

LONGEST = 4096  # bytes of an input
OPTIONS = ["-timeout=10", "-rss_limit_mb=1024", f"-max_len={LONGEST}", "-print_final_stats=1", "-verbosity=0"]
# Stacks of allocations cost half of the speed; three frames say enough.
ENVIRONMENT = {"ASAN_OPTIONS": "malloc_context_size=3:quarantine_size_mb=32", "UBSAN_OPTIONS": "print_stacktrace=1",
               "CYLON_KEY": "/dev/null", "CYLON_CACHE": "off"}
EXECUTED = re.compile(r"stat::number_of_executed_units:\s+(\d+)")


def targets():
    """Name and glob of shipped seeds of each row of targets.txt."""
    rows = (ROOT / "tests/fuzz/targets.txt").read_text().splitlines()
    return dict(row.split() for row in rows if row and not row.startswith("#"))


def seed(name, glob, folder):
    """Copies the seeds that are short enough to where the target keeps its corpus."""
    folder.mkdir(parents=True, exist_ok=True)
    shipped = [] if glob == "-" else sorted(ROOT.glob(glob))
    for file in [*sorted((ROOT / "tests/fuzz/corpus" / name).glob("*")), *shipped]:
        if file.stat().st_size <= LONGEST:
            (folder / f"seed-{file.name}").write_bytes(file.read_bytes())


def findings_of(name, build):
    """Files of bytes that the target did not take, and when each was written."""
    return {file: file.stat().st_mtime_ns for file in (build / "campaign/findings").glob(f"{name}-*")}


def still_open(name, build, counted):
    """How many of the findings the target still does not take; the others are forgotten.  Those of other machines are asked
    too.  Where the target is not built nobody can tell, and all that are known stay open."""
    known = counted.get(name, "open") or {}
    if (build / f"fuzz-{name}").exists():
        folder = build / "campaign/findings"
        folder.mkdir(parents=True, exist_ok=True)
        for file, content in known.items():
            (folder / file).write_bytes(base64.b64decode(content))
        for file in sorted(findings_of(name, build)):
            if subprocess.run([build / f"fuzz-{name}", *OPTIONS, file], env={**os.environ, **ENVIRONMENT}, capture_output=True,
                              check=False).returncode == 0:
                file.unlink()
        now = {file.name: base64.b64encode(file.read_bytes()).decode() for file in sorted(findings_of(name, build))}
        if now != known:
            counted.set(name, open=now)
        known = now
    return len(known)


def turn(name, build, seconds, counted):
    """One target for some seconds, or until its first finding.  False where it does not run, and so finds nothing."""
    corpus, findings = build / "campaign" / name, build / "campaign/findings"
    findings.mkdir(parents=True, exist_ok=True)
    before, start = findings_of(name, build), time.monotonic()
    ran = subprocess.run([build / f"fuzz-{name}", *OPTIONS, f"-max_total_time={seconds}",
                          f"-artifact_prefix={findings}/{name}-", corpus],
                         env={**os.environ, **ENVIRONMENT}, capture_output=True, check=False)
    said = ran.stderr.decode("utf8", "replace")
    executed = EXECUTED.search(said)
    executions = int(executed[1]) if executed else 0
    found = ran.returncode != 0
    if (found or not executed) and findings_of(name, build) == before:
        print(f"{name} does not run: exit code {ran.returncode}, no finding\n{said[-6000:]}", file=sys.stderr, flush=True)
        return False
    counted.may_go_on(name, program_of(build / f"fuzz-{name}"), anew=True)
    counted.add(name, executions=executions)
    print(f"{name}: {executions} executions, {executions / (time.monotonic() - start):.0f} a second"
          + (", a finding" if found else ""), flush=True)
    if found:
        print(said[-6000:], flush=True)
        still_open(name, build, counted)  # noted at once: who stops the campaign keeps it
    return True


def executed_ever(counted):
    """Of all programs."""
    return sum(row.get("executions", 0) for part in counted.parts.values() for row in [part, *part.get("before", [])])


def told(counted, name, build):
    """What the last line says of a target."""
    part = {"tried": counted.get(name, "executions"), "failed": still_open(name, build, counted)}
    row = counted.parts.get(name, {})
    before = [{"commit": old.get("commit"), "tried": old["executions"]} for old in row.get("before", [])]
    return part | {key: value for key, value in (("commit", row.get("commit")), ("before", before)) if value}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/fuzz")
    parser.add_argument("--seconds", type=int, default=60)
    parser.add_argument("--rounds", type=int)
    parser.add_argument("--executions", type=float)
    parser.add_argument("--minutes", type=float)
    parser.add_argument("targets", nargs="*")
    options = parser.parse_args()
    build, rows = options.build.resolve(), targets()
    wanted = options.targets or list(rows)
    missing = [name for name in wanted if name not in rows or not (build / f"fuzz-{name}").exists()]
    if missing and options.rounds != 0:
        print(f"not built: {', '.join(missing)}; ./test fuzz builds all", file=sys.stderr)
        return 2
    counted = Counted("fuzz")
    for name in wanted if options.rounds != 0 else []:
        seed(name, rows[name], build / "campaign" / name)
    rounds = options.rounds if options.rounds is not None or options.executions or options.minutes else 1
    end = time.monotonic() + 60 * options.minutes if options.minutes else None
    turns = itertools.cycle(wanted)
    for name in turns if rounds is None else itertools.islice(turns, rounds * len(wanted)):
        if options.executions and executed_ever(counted) >= options.executions or end and time.monotonic() >= end:
            break
        if not turn(name, build, options.seconds, counted):
            return 2
    parts = {name: told(counted, name, build) for name in wanted}
    total = {key: sum(part[key] for part in parts.values()) for key in ("tried", "failed")}
    print(json.dumps({**total, "parts": parts}))
    return 1 if total["failed"] else 0


if __name__ == "__main__":
    sys.exit(main())
