#!/usr/bin/env python3
"""Kills commands at random moments and lets them go on.

    tests/hostile/kills.py CYLON [--kills 1000] [--anew] [--sample N] [--seed S] [run|shards|farm|trade|record|import …]

A trial of run, shards, trade or record is killed (SIGKILL) one to three times and resumed each time; one of import is
repeated.  Shards are three parts of a run and their merge, one after the other.  A farm is two ranks of MPI, of which one is killed;
where MPI is not here there is none.
In the end its output must be that of a command that nobody killed, times left out, and no whole line of a journal may be
lost on the way.  Trial n is a function of seed and n.  Counts are kept in counts/kills.json with the program and the commit
that they are of, and a later call goes on with new trials until each command was killed as often as asked for.  Counts of
another program are left as they are, unless --anew puts them aside and begins again.  --sample makes N trials of each and
keeps no count.  The last line is JSON: tried (kills that met a living command), failed (trials), the same of each command.
Exit codes: 0, 1 where a trial failed, 2 where counts of another program stood in the way."""
import argparse
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from counted import Counted, program_of

# Two scenes, as small as scenes can be: what is looked at is what is kept, not what moves.
SCENE = """duration = 0.2
step = 0.01
gravity = [0, -9.81, 0]
[[body]]
name = "stone"
mass = {mass}
position = [0.3, 2, 0.1]
velocity = [1, 0.5, -0.2]
[[claim]]
conserves = "energy"
tolerance = {{ absolute = 1, reason = "of 35 J" }}
[[claim]]
follows = "projectile"
observable = "position"
tolerance = {{ absolute = 0.1, reason = "of 0.4 m" }}
"""
MASSES = {"light.toml": 1.5, "heavy.toml": 2.5}
ENGINES = ["--engine", "in-house", "--engine", "ode"]
SAMPLES = ("exact", "error")  # kinds of samples that are the same on every run


class Command:
    """One command: how it begins, how it goes on, and what of its output must come again."""

    def __init__(self, cylon, folder):
        self.cylon, self.folder = cylon, folder
        for name, mass in MASSES.items():
            (folder / name).write_text(SCENE.format(mass=mass))
        self.first, self.again = self.lines([str(folder / name) for name in MASSES])

    def start(self, words, here):
        return subprocess.Popen([self.cylon, *words], cwd=here, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                stderr=subprocess.PIPE, text=True)

    def whole(self, here):
        """Runs it, and nobody kills it."""
        self.start(self.first, here).communicate()

    def words(self, here):
        """Of the next call in this folder; None where there is nothing left to do."""
        return self.again if self.kept(here) else self.first

    def prepare(self):
        """What all trials need."""

    def kept(self, _here):
        """What a kill must leave."""

    def lost(self, _here, _before):
        """What is wrong after a kill, or ""."""
        return ""


def journal_lines(file):
    """Whole lines of a journal."""
    return file.read_bytes().split(b"\n")[:-1] if file.exists() else []


class Run(Command):
    journal = ".cylon/journal.jsonl"

    def lines(self, scenes):
        return ["run", *scenes, *ENGINES, "--json", "out.json"], ["run", "--resume", "--json", "out.json"]

    def kept(self, here):
        return journal_lines(here / self.journal)

    def lost(self, here, before):
        now = set(journal_lines(here / self.journal))
        return "" if all(line in now for line in before) else "a line of the journal is lost"

    def facts(self, here):
        rows = json.loads((here / "out.json").read_text())["verdicts"]
        return [{k: v for k, v in row.items() if k not in ("cpu_seconds", "cpu_verified", "reproduce")} for row in rows]


class Shards(Run):
    """Three shards and their union; what is killed is whichever is at work."""

    def lines(self, scenes):
        run = " ".join(["run", *scenes, *ENGINES, "--resume", "--shard"])
        parts = [f"{self.cylon} {run} {k}/3" for k in (1, 2, 3)]
        line = "; ".join([*parts, f"exec {self.cylon} merge .cylon/journal-?-of-3.jsonl --json out.json"])
        return line, line

    def start(self, words, here):
        child = subprocess.Popen(["sh", "-c", words], cwd=here, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                 stderr=subprocess.PIPE, text=True, start_new_session=True)
        child.kill = lambda: self.kill(child)
        return child

    @staticmethod
    def kill(child):
        try:
            os.killpg(child.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass  # it has ended

    def kept(self, here):
        return [line for file in sorted(here.glob(".cylon/journal-?-of-3.jsonl")) for line in journal_lines(file)]

    def lost(self, here, before):
        now = set(self.kept(here))
        return "" if all(line in now for line in before) else "a line of a shard is lost"


class Farm(Run):
    """Two ranks, of which one is killed, or mpirun itself; the next start has another number of ranks."""

    ranks = 2

    def lines(self, scenes):
        line = ["run", *scenes, *ENGINES, "--resume", "--json", "out.json"]
        return line, line

    def start(self, words, here):
        self.ranks = 5 - self.ranks
        child = subprocess.Popen(["mpirun", "--oversubscribe", "-n", str(self.ranks), self.cylon, "farm", *words], cwd=here,
                                 stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                                 env={**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"})
        child.kill = lambda: self.kill(child)
        return child

    @staticmethod
    def kill(child):
        children = pathlib.Path(f"/proc/{child.pid}/task/{child.pid}/children")
        try:
            ranks = [int(word) for word in children.read_text().split()]
            os.kill(ranks[-1] if ranks else child.pid, signal.SIGKILL)
        except (FileNotFoundError, ProcessLookupError):
            pass  # it has ended

    def kept(self, here):
        """Cells with all that they hold, the time too, so that one that is done again counts as lost.  A line moves from a
        rank's journal to that of the folder, where it has another seal."""
        kept = set()
        for file in here.glob(".cylon/journal*.jsonl"):
            for line in journal_lines(file):
                row = json.loads(line)
                row.pop("seal")
                if "cell" in row:
                    kept.add(json.dumps(row, sort_keys=True))
        return kept

    def lost(self, here, before):
        now = self.kept(here)
        if len({json.loads(row)["key"] for row in now}) < len(now):
            return "a cell was done twice"
        return "" if before <= now else "a cell of a rank is lost"


class Trade(Run):
    journal = ".cylon/trade.jsonl"

    def lines(self, scenes):
        first = ["trade", scenes[0], *ENGINES, "--steps", "3", "--rounds", "0", "--json", "out.json"]
        return first, [*first, "--resume"]

    def facts(self, here):
        return json.loads((here / "out.json").read_text())["tables"]


class Record(Command):
    def lines(self, scenes):
        return (["track", "record", *scenes, *ENGINES, "--repetitions", "0", "--store", "h.db"],
                ["track", "record", "--resume", "--store", "h.db"])

    def exported(self, here):
        """The lines of the store's export; none where there is no store yet."""
        ran = subprocess.run([self.cylon, "track", "export", "--store", "h.db", "-"], cwd=here, capture_output=True,
                             text=True, check=False)
        return [json.loads(line) for line in ran.stdout.splitlines()]

    def words(self, here):
        runs = [line["run"] for line in self.exported(here) if "run" in line]
        return None if any(run["complete"] for run in runs) else self.again if runs else self.first

    def facts(self, here):
        checked = subprocess.run([self.cylon, "track", "check", "--store", "h.db"], cwd=here, capture_output=True,
                                 text=True, check=False)
        facts = [f"check: {checked.returncode}"]
        for line in self.exported(here):
            if "run" in line:
                line = {"run": line["run"]["complete"]}
            if "result" in line:
                line["result"].pop("run")
                line["result"]["samples"] = [s for s in line["result"]["samples"] if s["kind"] in SAMPLES]
            facts.append(json.dumps(line, sort_keys=True))
        return sorted(facts)


class Import(Record):
    """All of a file or nothing; and after a kill the same import again gives the same store."""

    runs = 400

    def lines(self, scenes):
        line = ["track", "import", str(self.folder / "many.jsonl"), "--store", "h.db"]
        return line, line

    def prepare(self):
        """A history of some hundred runs, so that there is time to be killed in."""
        here = self.folder / "history"
        here.mkdir()
        Record(self.cylon, self.folder).whole(here)
        head, *rest = [json.dumps(line) for line in self.exported(here)]
        lines = [head, *(line for line in rest if '"cell": {"hash"' in line and '"result"' not in line)]
        of_run = [line for line in rest if line not in lines]
        uid = next(json.loads(line)["run"]["uid"] for line in of_run if '"run": {' in line)
        for n in range(self.runs):
            lines += [line.replace(uid, f"{n:08x}{uid[8:]}") for line in of_run]
        (self.folder / "many.jsonl").write_text("\n".join(lines) + "\n")

    def words(self, here):
        return self.first

    def lost(self, here, _before):
        runs = sum("run" in line for line in self.exported(here))
        return "" if runs in (0, self.runs) else f"{runs} of {self.runs} runs were imported"


COMMANDS = {"run": Run, "shards": Shards, "farm": Farm, "trade": Trade, "record": Record, "import": Import}


def are_here(cylon):
    """The commands; a farm only where MPI is."""
    farm = shutil.which("mpirun") and pathlib.Path(cylon).resolve().with_name("libcylon-mpi.so").exists()
    return [name for name in COMMANDS if name != "farm" or farm]



def trial(command, here, rng, seconds, expected):
    """What is wrong after some kills, or ""; and how many kills met the command alive."""
    kills = 0
    for _ in range(rng.choice([1, 1, 2, 3])):
        words = command.words(here)
        if words is None:
            break
        child = command.start(words, here)
        time.sleep(rng.uniform(0, 1.1 * seconds))
        before = command.kept(here)
        kills += child.poll() is None
        child.kill()
        child.wait()
        child.stderr.close()
        if why := command.lost(here, before):
            return why, kills
    words = command.words(here)
    if words is not None:
        child = command.start(words, here)
        said = child.communicate()[1]
        if child.returncode not in (0, 1):
            return f"exit code {child.returncode} in the end: {said[:300]!r}", kills
    return ("" if command.facts(here) == expected else "another output in the end"), kills


def control(cylon):
    """What a trial must find: a journal that lost a line, a store that has a part of a file, and another output."""
    with tempfile.TemporaryDirectory(prefix="cylon-kills-") as name:
        here = pathlib.Path(name)
        os.environ["CYLON_KEY"] = str(here / "key")
        run, stored = Run(cylon, here), Import(cylon, here)
        run.whole(here)
        whole, facts = run.kept(here), run.facts(here)
        (here / Run.journal).write_bytes(b"\n".join(whole[:-1]) + b"\n")
        Record(cylon, here).whole(here)
        with tempfile.TemporaryDirectory(dir=here) as other:
            another = trial(run, pathlib.Path(other), random.Random(1), 0.01, facts[1:])[0]
        return bool(run.lost(here, whole) and stored.lost(here, None) and another)


def campaign(name, cylon, seed, wanted, add):
    """Trials of one command as long as wanted() gives the number of the next."""
    with tempfile.TemporaryDirectory(prefix="cylon-kills-") as folder_name:
        folder = pathlib.Path(folder_name)
        os.environ["CYLON_KEY"] = str(folder / "key")
        command = COMMANDS[name](cylon, folder)
        command.prepare()
        whole = folder / "whole"
        whole.mkdir()
        start = time.monotonic()
        command.whole(whole)
        seconds, expected = time.monotonic() - start, command.facts(whole)
        while (number := wanted()) is not None:
            with tempfile.TemporaryDirectory(dir=folder) as here:
                bad, kills = trial(command, pathlib.Path(here), random.Random(f"{seed} {name} {number}"), seconds, expected)
            add(name, trials=1, tried=kills, failed=int(bool(bad)))
            if bad:
                print(f"{name} {number}: {bad}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cylon")
    parser.add_argument("--kills", type=int, default=1000)
    parser.add_argument("--anew", action="store_true")
    parser.add_argument("--sample", type=int)
    parser.add_argument("--seed", type=int, default=20261123)
    parser.add_argument("commands", nargs="*")
    options = parser.parse_intermixed_args()
    counted = Counted(None if options.sample else "kills")

    def wanted(name, kills):
        trials = counted.get(name, "trials")
        more = trials < options.sample if options.sample else counted.get(name, "tried") < kills
        return trials if more else None

    if not control(os.path.abspath(options.cylon)):
        sys.exit("the control was not found: what is lost would not be seen")
    asked = names = options.commands or are_here(options.cylon)
    if options.kills and not options.sample:
        program = program_of(options.cylon)
        names = [name for name in asked if counted.may_go_on(name, program, options.anew)]
    # In turns of fifty kills, so that a campaign that is stopped has asked all commands alike.
    for kills in range(50, options.kills + 50, 50):
        for name in names:
            if wanted(name, kills) is not None:
                campaign(name, os.path.abspath(options.cylon), options.seed, lambda: wanted(name, kills), counted.add)
    failed = counted.total("failed")
    print(json.dumps({"tried": counted.total("tried"), "failed": failed, "parts": counted.parts}))
    return 1 if failed else 0 if names == asked else 2


if __name__ == "__main__":
    sys.exit(main())
