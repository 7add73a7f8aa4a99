#!/usr/bin/env python3
"""Lets one call of the system fail in a command, and lets the command go on afterwards.

    tests/hostile/faults.py CYLON [--trials N] [--anew] [--sample N] [--seed S] [run/malloc|trade/fork|…]

Kinds of calls: malloc, fork, pipe, thread, write, sync, rename (fault.cc, which is loaded before the C library and counts in
the harness's process alone).  Of every command and kind each call fails once, in a run of its own; allocations, which are
many, by their place, the chain of callers: of each place the first, and of every fourth that has several the last too.  The
run must end by itself with an exit code 0, 1, 2 or 5.  With 0 and 1 its output must be that of an undisturbed run.  With 2
and 5 it must say why, and the command that goes on, undisturbed, must give that output.  No draft of a file may be left.

Calls are tried in an order that spreads over the whole run.  Counts are kept in counts/faults.json with the program and the
commit that they are of, and a later call goes on where the last one stopped.  Counts of another program are left as they
are, unless --anew puts them aside and begins again.  --trials limits the trials of this call, --sample makes N trials of each
and keeps no count.  The last line is JSON: tried (runs in which a call failed), failed, the same of each part, with the
number of its calls.  Exit codes: 0, 1 where a trial failed, 2 where counts of another program stood in the way."""
import argparse
import bisect
import json
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile

from counted import Counted, program_of
from kills import COMMANDS

HERE = pathlib.Path(__file__).resolve().parent
KINDS = ["malloc", "fork", "pipe", "thread", "write", "sync", "rename"]
SECONDS = 600  # after which a run hangs
BY_PLACE = "malloc"
ANY, LIST = "0", "1"  # in the word of fault.cc for a place
# Calls whose failure once was a crash, or the timeout of an engine; a sample tries them first.
FOUND = {"run/malloc": (929, 4830), "run/write": (6, 8), "trade/write": (1,), "trade/malloc": (7584,)}


def compile_library(folder):
    library = folder / "fault.so"
    subprocess.run(["c++", "-std=c++20", "-O1", "-Wall", "-Wextra", "-Werror", "-shared", "-fPIC", "-o", str(library),
                    str(HERE / "fault.cc"), "-ldl"], check=True)
    return library


def started(command, words, here, library=None, kind="", n=0, place=ANY):
    """Exit code (None where it hangs), stderr, and what the library tells."""
    log = here.parent / (here.name + ".log")
    log.unlink(missing_ok=True)
    environment = dict(os.environ)
    if library:
        environment |= {"LD_PRELOAD": str(library), "CYLON_FAULT": f"{kind}:{n}:{place}:{log}"}
    try:
        ran = subprocess.run([command.cylon, *words], cwd=here, env=environment, stdin=subprocess.DEVNULL,
                             stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, timeout=SECONDS, check=False)
    except subprocess.TimeoutExpired:
        return None, b"", "failed"
    return ran.returncode, ran.stderr, log.read_text() if log.exists() else ""


def difference(facts, expected):
    """The first, in few words; "" where there is none."""
    if facts == expected:
        return ""
    if len(facts) != len(expected):
        return f"{len(facts)} facts, not {len(expected)}"
    one, other = next((a, b) for a, b in zip(facts, expected) if a != b)
    if isinstance(one, dict):
        one, other = ({k: v for k, v in a.items() if v != b.get(k)} for a, b in ((one, other), (other, one)))
    return f"{one!r:.300} in place of {other!r:.300}"


def judged(code, said, kind, facts, expected):
    """What is wrong with how a run ended.  `facts` gives those of its output, `expected` is (exit code, facts)."""
    if code is None:
        return "it hangs"
    if code < 0:
        return f"killed by signal {-code}: {said[:200]!r}"
    if code in (2, 5):
        return "" if said or kind == "write" else f"exit code {code} without a word"
    if code != expected[0]:
        return f"exit code {code}: {said[:200]!r}"
    changed = difference(facts(), expected[1])
    return f"exit code {code}, but another output: {changed} after {said[:200]!r}" if changed else ""


def trial(command, here, library, kind, call, expected):
    """What is wrong with a run in which this call (number, place) fails, or "", or None where there is no such call."""
    code, said, told = started(command, command.first, here, library, kind, *call)
    if told != "failed":
        return None
    if why := judged(code, said, kind, lambda: command.facts(here), expected):
        return why
    if drafts := [file.name for file in here.rglob("*.partial")]:
        return f"left: {drafts}"
    if code in (2, 5):
        words = command.words(here)
        if words is not None:
            code, again, _ = started(command, words, here)
            if code != expected[0]:
                return f"exit code {code} of the run that goes on: {again[:200]!r} after {said[:200]!r}"
        if changed := difference(command.facts(here), expected[1]):
            return f"another output of the run that goes on: {changed} after {said[:200]!r}"
    return ""


def order(calls):
    """1 … calls, each once, any first part of it spread over all."""
    stride = max(1, round(calls * 0.618))
    while math.gcd(stride, calls) != 1:
        stride += 1
    return lambda k: 1 + (k * stride) % calls if k < calls else k + 1


def by_place(lines):
    """Which call of each place fails, from "place calls first last" of each: key, number from which on, place.  Numbers
    differ a little from run to run."""
    for place, count, first, last in map(str.split, lines):
        for key, number in [(place, first)] + [(place + "+", last)] * (int(count) > 1 and int(place, 16) % 4 == 0):
            yield key, max(1, int(int(number) * 0.98) - 200), place


def by_number(count):
    """Every call, in an order whose every first part is spread over all."""
    number = order(count)
    for k in range(count):
        yield f"{k:09}", number(k), ANY


class Part:
    """A command, a kind of call, and which calls fail: key, number, place."""

    def __init__(self, name, cylon, folder, library, sampled):
        self.name, self.library = name, library
        command, self.kind = name.split("/")
        self.folder = folder / command
        if not self.folder.exists():
            self.folder.mkdir()
            prepared = COMMANDS[command](cylon, self.folder)
            prepared.runs = 8  # of an import
            prepared.prepare()
        self.command = COMMANDS[command](cylon, self.folder)
        self.here = self.folder / self.kind
        self.here.mkdir()
        whole = self.here / "whole"
        whole.mkdir()
        by_places = self.kind == BY_PLACE and not sampled
        code, said, told = started(self.command, self.command.first, whole, library, self.kind, 0, LIST if by_places else ANY)
        if code not in (0, 1):
            sys.exit(f"{name}: exit code {code} undisturbed: {said[:300]!r}")
        self.expected = code, self.command.facts(whole)
        count, *lines = told.splitlines()
        self.calls = int(count)
        self.plan = sorted(by_place(lines) if by_places else by_number(self.calls))
        self.size = {"places": len(lines), "trials_of_places": len(self.plan)} if by_places else {"calls": self.calls}

    def after(self, key):
        """The next call of the plan, or None."""
        at = bisect.bisect([call[0] for call in self.plan], key)
        return self.plan[at] if at < len(self.plan) else None

    def sampled(self, seed, trial):
        """A call that once was a finding, then any."""
        found = FOUND.get(self.name, ())
        chosen = random.Random(f"{seed} {self.name} {trial}").randint(1, max(1, self.calls))
        return "", found[trial] if trial < len(found) else chosen, ANY

    def fails(self, call):
        with tempfile.TemporaryDirectory(dir=self.here) as here:
            return trial(self.command, pathlib.Path(here), self.library, self.kind, call[1:], self.expected)


def control(cylon, folder, library):
    """What must be found: a call that fails, by its number and by its place, a crash, a hang, silence, another output."""
    run = COMMANDS["run"](cylon, folder)

    def of_run(name, *fault):
        (folder / name).mkdir()
        return started(run, run.first, folder / name, library, *fault)

    calls, *places = of_run("listed", "fork", 0, LIST)[2].splitlines()
    # The last is a cell's; the first ask engines for their versions, which need not answer.
    code, said, told = of_run("numbered", "fork", int(calls))
    by_its_place = of_run("placed", "fork", 1, places[0].split()[0])[2]
    return all([code == 5, b"fork" in said, told == "failed", by_its_place == "failed",
                judged(-6, b"x", "fork", list, (0, [])),
                judged(None, b"", "fork", list, (0, [])), judged(5, b"", "fork", list, (0, [])),
                judged(0, b"", "fork", lambda: [1], (0, [])), not judged(0, b"", "fork", lambda: [1], (0, [1]))])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cylon")
    parser.add_argument("--trials", type=int)
    parser.add_argument("--anew", action="store_true")
    parser.add_argument("--sample", type=int)
    parser.add_argument("--seed", type=int, default=20261123)
    parser.add_argument("parts", nargs="*")
    options = parser.parse_intermixed_args()
    counted = Counted(None if options.sample else "faults")
    cylon = os.path.abspath(options.cylon)
    left = options.trials if options.trials is not None else math.inf
    commands = [command for command in COMMANDS if command != "shards"]  # those are several processes
    names = options.parts or [f"{command}/{kind}" for command in commands for kind in KINDS]
    with tempfile.TemporaryDirectory(prefix="cylon-faults-") as folder_name:
        folder = pathlib.Path(folder_name)
        os.environ["CYLON_KEY"] = str(folder / "key")
        library = compile_library(folder) if left else None
        if left and not control(cylon, folder, library):
            sys.exit("the control was not found: what fails would not be seen")
        parts, asked = {}, names
        if left and not options.sample:
            program = program_of(cylon)
            names = [name for name in asked if counted.may_go_on(name, program, options.anew)]
        while left > 0 and (open_parts := [name for name in names if not counted.get(name, "done")]):
            for name in open_parts:  # in turns, so that a campaign that is stopped has asked all alike
                if name not in parts:
                    parts[name] = Part(name, cylon, folder, library, bool(options.sample))
                part, trials = parts[name], counted.get(name, "trials")
                last = counted.get(name, "last") or ""
                call = part.sampled(options.seed, trials) if options.sample else part.after(last)
                bad = part.fails(call) if call else None
                done = trials + 1 >= options.sample + len(FOUND.get(name, ())) if options.sample else not call
                counted.add(name, trials=int(bool(call)), tried=int(bad is not None), failed=int(bool(bad)))
                counted.set(name, done=int(done), last=call[0] if call else last, **part.size)
                if bad:
                    print(f"{name} {call[1:]}: {bad}", flush=True)
                left -= 1
                if left <= 0:
                    break
    failed = counted.total("failed")
    print(json.dumps({"tried": counted.total("tried"), "failed": failed, "parts": counted.parts}))
    return 1 if failed else 0 if names == asked else 2


if __name__ == "__main__":
    sys.exit(main())
