#!/usr/bin/env python3
"""Measures in which circumstances each engine repeats its bits; prints the table of docs/engines.md, Determinism.

    docs/determinism.py [--cylon build/release/cylon] [--other build/dev] [--write]

Each engine runs each scene 1000 steps: twice in one process, in a new process, in a process that has run another scene
before, without the processor's newer instructions (GLIBC_TUNABLES), and, with --other, by the workers of another build (else
that column stays as the page has it).
The load message of `cylon simulate` is recorded once and sent again.  A cell says in how many scenes all states had the
bits of the first run, of those that the engine takes, and names the others.

The column of threads: build/release/bits and bits-f32 run generated piles and fields of free bodies of the in-house engine on 1,
2 and 4 threads, and the cell counts those whose last states have one hash.  Workers of other engines are asked for 1, 2 and
4 by the environment (OMP_NUM_THREADS, which OpenBLAS reads too), on the twelve scenes and one with many rods.
"""
import collections
import argparse
import json
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parent.parent
page = root / "docs" / "engines.md"

SCENES = ["projectile", "heavy_top", "dzhanibekov", "spring_orbit", "double_pendulum", "chain_44", "two_sphere_oblique",
          "bouncing_sphere", "eight_balls", "box_settles", "cube_stack", "dominoes"]
STEPS = 1000
MASK = "glibc.cpu.hwcaps=-AVX512F,-AVX2,-AVX,-FMA,-FMA4,-BMI2,-ERMS,-SSE4_2"
COLUMNS = ["same process", "new process", "after another scene", "older processor", "other build"]
# Beside SCENES, of the column of threads: a net of rods, whose large matrices a library divides among threads.
DIVIDED = "net"
# Engines with threads of their own: the tool that runs their models on 1, 2 and 4.
THREADS = {"cylon-worker-in-house": "bits", "cylon-worker-in-house-f32": "bits-f32"}


class Worker:
    """A worker and its conversation (docs/protocol.md)."""

    def __init__(self, command, **environment):
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                                        env={**os.environ, **environment})
        self.ask({"cmd": "hello", "protocol": 1})

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.stdin.close()
        self.process.stdout.close()
        self.process.wait()

    def ask(self, message):
        """All frames up to the answer, as bytes, and the answer."""
        self.process.stdin.write((json.dumps(message) + "\n").encode())
        self.process.stdin.flush()
        return self.answer()

    def answer(self):
        frames = b""
        while True:
            start = self.process.stdout.read(4)
            if start == b"CYLF":
                header = self.process.stdout.read(28)
                frames += self.process.stdout.read(struct.unpack("<IQQQ", header)[3])
            else:
                line = start + self.process.stdout.readline()
                if not line:
                    raise EOFError("the worker ended")
                message = json.loads(line)
                if "event" not in message:
                    return frames, message

    def states(self, load):
        """The bytes of all states of a run, or None where the engine refuses the scene, or its worker ends."""
        try:
            return self.run(load)
        except (EOFError, BrokenPipeError):
            return None

    def run(self, load):
        _, answer = self.ask(load)
        if answer.get("ok") != "load":
            return None
        initial, _ = self.frame()
        frames, answer = self.ask({"cmd": "run", "steps": STEPS, "every": 1, "at": [], "watch": []})
        return initial + frames if answer.get("ok") == "run" else None

    def frame(self):
        assert self.process.stdout.read(4) == b"CYLF"
        header = self.process.stdout.read(28)
        return self.process.stdout.read(struct.unpack("<IQQQ", header)[3]), header


def relay(log, command):
    """As the worker `command`, with the harness's lines in `log`."""
    with subprocess.Popen(command, stdin=subprocess.PIPE) as worker, open(log, "wb") as kept:
        for line in sys.stdin.buffer:
            kept.write(line)
            kept.flush()
            worker.stdin.write(line)
            worker.stdin.flush()
        worker.stdin.close()


def load_message(cylon, scene, folder):
    """What the harness sends to load the scene, for an engine that takes any."""
    log = folder / f"{scene}.jsonl"
    worker = pathlib.Path(cylon).resolve().parent / "cylon-worker-in-house"
    spy = f"spy={sys.executable} {__file__} --relay {log} {worker}"
    subprocess.run([cylon, "simulate", scene, "--engine", "spy", "--worker", spy, "--every", "1e9", "--out", os.devnull],
                   check=True, stderr=subprocess.DEVNULL)
    for line in log.read_text().splitlines():
        if '"cmd":"load"' in line:
            return json.loads(line)
    sys.exit(f"{scene}: no load message")


def engines():
    """(id, worker, path) of each row of the table of engines."""
    for line in (root / "reference/simulators/engines.txt").read_text().splitlines():
        words = line.split()
        if words and not line.startswith("#"):
            yield words[0], f"cylon-worker-{words[1]}", "" if words[2] == "-" else words[2]


def compare(folder, other, worker, loads):
    """For each column: whether each scene that was compared had the same bits."""
    command = [str(folder / worker)]
    same = {column: {} for column in COLUMNS}

    for i, (scene, load) in enumerate(zip(SCENES, loads)):
        def count(column, states, first):
            same[column][scene] = states == first

        with Worker(command) as one:
            first = one.states(load)
            if first is None:
                continue
            count("same process", one.states(load), first)
        with Worker(command) as one:
            count("new process", one.states(load), first)
        with Worker(command) as one:
            one.states(loads[i - 1])
            count("after another scene", one.states(load), first)
        with Worker(command, GLIBC_TUNABLES=MASK) as one:
            count("older processor", one.states(load), first)
        if other and (other / worker).exists():
            with Worker([str(other / worker)]) as one:
                count("other build", one.states(load), first)
    return same


def threads(folder, worker, loads):
    """Models of one hash on every number of threads, and of other engines scenes."""
    if worker not in THREADS:
        same = {}
        for scene, load in zip([*SCENES, DIVIDED], loads):
            states = []
            for number in ("1", "2", "4"):
                with Worker([str(folder / worker)], OMP_NUM_THREADS=number) as one:
                    states.append(one.states(load))
            if states[0] is not None:
                same[scene] = states[0] == states[1] == states[2]
        return cell(same)
    hashes = collections.defaultdict(set)
    for line in subprocess.run([folder / THREADS[worker]], check=True, capture_output=True, text=True).stdout.splitlines():
        model, _, bits = line.split()
        hashes[model].add(bits)
    return cell({model: len(bits) == 1 for model, bits in hashes.items()})


def cell(same):
    """ "10 of 12, not projectile, gas"; "–" where nothing was compared."""
    others = [f"`{name}`" for name, equal in same.items() if not equal]
    return (f"{len(same) - len(others)} of {len(same)}" + (f", not {', '.join(others)}" if others else "")) if same else "–"


def measured_before(column):
    """The cells of a column of the page, by engine."""
    rows = [[part.strip() for part in line.strip("| \n").split(" | ")] for line in
            re.search(r"<!-- determinism -->\n(.*?)<!-- /determinism -->", page.read_text(), re.S)[1].splitlines()]
    return {row[0]: row[rows[0].index(column)] for row in rows[2:] if column in rows[0]}


def table(cylon, other):
    with tempfile.TemporaryDirectory() as folder:
        loads = [load_message(cylon, scene, pathlib.Path(folder)) for scene in [*SCENES, DIVIDED]]
    kept = {} if other else measured_before(COLUMNS[-1])
    lines = ["| engine | " + " | ".join(COLUMNS) + " | 1, 2 and 4 threads |", "|---|" + "---|" * (len(COLUMNS) + 1)]
    folder = pathlib.Path(cylon).resolve().parent
    for name, worker, path in engines():
        if not (folder / worker).exists():  # an optional engine that is not here
            continue
        mine = [{**load, "path": path} for load in loads]
        rows = compare(folder, other, worker, mine[:len(SCENES)])
        cells = [cell(rows[c]) for c in COLUMNS] + [threads(folder, worker, mine)]
        if not other:
            cells[-2] = kept.get(name, cells[-2])
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
        print(lines[-1], file=sys.stderr, flush=True)
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cylon", default=str(root / "build/release/cylon"))
    parser.add_argument("--other", type=pathlib.Path, help="folder of the workers of another build")
    parser.add_argument("--write", action="store_true", help="write the table into docs/engines.md")
    options = parser.parse_args()
    result = table(options.cylon, options.other)
    if not options.write:
        print(result)
        return
    text = page.read_text()
    new, count = re.subn(r"(<!-- determinism -->\n).*?(<!-- /determinism -->)", lambda m: m[1] + result + "\n" + m[2], text,
                         flags=re.S)
    if count != 1:
        sys.exit(f"{page}: no place for the table")
    page.write_text(new)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--relay"]:
        relay(sys.argv[2], sys.argv[3:])
    else:
        main()
