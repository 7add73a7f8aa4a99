#!/usr/bin/env python3
"""Mutated files of every kind that Cylon reads: tests/hostile/mutants.py CYLON [--from SEED] [--count N] [--keep FOLDER].

Mutant n of a kind is a function of n alone, so a run that was stopped goes on with --from; --keep stores what fails.
Of each: a documented exit code, an end within 20 s of CPU time and 4 GB of addresses; of a refused scenario the place of
the fault.  The last line is JSON: tried, failed."""
import argparse
import concurrent.futures
import json
import os
import pathlib
import random
import re
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PLACE = re.compile(r"^error: [^\n]*?:\d+:\d+: ")
NUMBERS = [b"1e308", b"-1", b"1e999", b"null", b"NaN", b"nan", b"inf", b"9223372036854775808", b"-9223372036854775809",
           b'"x"', b"[]", b"{}", b"true", b"0", b"18446744073709551616", b"1e-400", b"1e-320", b"-0.0", b"1000000"]
PIECES = [b"\0", b"\xff", b'"', b"'", b"{", b"[", b"[[", b"]", b"}", b",", b"\n", b"\\u0000", b"\\ud800", b":", b"=", b".",
          b"#", b'"""', b"[[body]]\n", b"[[lattice]]\n", b"[[claim]]\n"]
VALUE = re.compile(rb'-?\d+\.?\d*(?:e[-+]?\d+)?|"[^"\n]{0,80}"')


def mutated(seed, number):
    """The seed with one to five changes of bytes, pieces, values or lines."""
    rng, text = random.Random(number), bytearray(seed)
    for _ in range(1 + rng.randrange(5)):
        at = rng.randrange(len(text) + 1)
        kind = rng.randrange(8)
        if kind == 0 and text:
            text[rng.randrange(len(text))] = rng.randrange(256)
        elif kind == 1:
            del text[at:at + 1 + rng.randrange(60)]
        elif kind == 2:
            text[at:at] = text[rng.randrange(len(text) + 1):][:rng.randrange(200)]
        elif kind == 3 and rng.randrange(4) == 0:
            text = text[:at]
        elif kind == 4:
            text[at:at] = rng.choice(PIECES)
        elif kind == 5:
            lines = bytes(text).split(b"\n")
            line = rng.choice(lines)
            lines.insert(rng.randrange(len(lines) + 1), line)
            text = bytearray(b"\n".join(lines))
        else:
            values = list(VALUE.finditer(bytes(text)))
            if values:
                value = rng.choice(values)
                text[value.start():value.end()] = rng.choice(NUMBERS)
    return bytes(text)


def limits():
    resource.setrlimit(resource.RLIMIT_CPU, (20, 21))
    resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))


class Corpus:
    """Seeds of each kind, made by the program itself, and the command that reads a mutant."""

    def __init__(self, cylon, folder):
        self.cylon, self.folder = cylon, folder
        self.environment = {**os.environ, "CYLON_CACHE": str(folder / "cache"), "CYLON_KEY": str(folder / "key")}
        for words in (["run", "projectile", "--engine", "in-house", "--json", "v.json", "--traces", "t.jsonl"],
                      ["track", "record", "projectile", "--engine", "in-house", "--repetitions", "2", "--store", "g.db"],
                      ["track", "export", "--store", "g.db", "e.jsonl"],
                      ["track", "export", "--store", "g.db", "--format", "csv", "e.csv"]):
            subprocess.run([cylon, *words], cwd=folder, env=self.environment, check=True, capture_output=True)
        self.seeds = {name: (folder / name).read_bytes() for name in ("v.json", "t.jsonl", "e.jsonl", "e.csv")}
        self.seeds["journal"] = (folder / ".cylon/journal.jsonl").read_bytes()
        self.scenes = [path.read_bytes() for path in sorted((ROOT / "scenarios").glob("*.toml"))
                       if b"certified" not in path.read_bytes() and path.name != "expected.toml"]
        self.meshes = [(ROOT / "tests/data/meshes/cube.obj").read_bytes()]

    def command(self, kind, mutant, here):
        if kind == "scene":
            (here / "m.toml").write_bytes(mutant)
            return ["validate", "m.toml"]
        if kind == "mesh":
            (here / "m.obj").write_bytes(mutant)
            (here / "m.toml").write_text('duration = 1\nstep = 0.1\n[[body]]\nname = "a"\nmass = 1\n'
                                         'shape = { type = "mesh", file = "m.obj" }\ncollide = false\n')
            return ["validate", "m.toml"]
        if kind == "journal":
            (here / ".cylon").mkdir(exist_ok=True)
            (here / ".cylon/journal.jsonl").write_bytes(mutant)
            return ["run", "--rerun-failed"]
        (here / kind).write_bytes(mutant)
        return ["track", "import", kind, "--store", "m.db"] if kind.startswith("e.") else ["report", kind, "--html", "m.html"]

    def seed(self, kind, number):
        several = {"scene": self.scenes, "mesh": self.meshes}.get(kind)
        return several[number % len(several)] if several else self.seeds[kind]

    def fault(self, kind, number, keep):
        mutant = mutated(self.seed(kind, number), number)
        with tempfile.TemporaryDirectory(dir=self.folder) as name:
            words = self.command(kind, mutant, pathlib.Path(name))
            ran = subprocess.run([self.cylon, *words], cwd=name, env=self.environment, capture_output=True,
                                 stdin=subprocess.DEVNULL, preexec_fn=limits, check=False)
        said = ran.stderr.decode("utf8", "replace")
        bad = ""
        if ran.returncode not in (0, 1, 2, 4):
            bad = f"exit code {ran.returncode}: {said[:200]!r}"
        elif kind in ("scene", "mesh") and ran.returncode == 2 and not PLACE.match(said):
            bad = f"no place: {said[:200]!r}"
        if bad and keep:
            pathlib.Path(keep).mkdir(parents=True, exist_ok=True)
            (pathlib.Path(keep) / f"{kind}-{number}").write_bytes(mutant)
        return bad


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("cylon")
    parser.add_argument("--from", dest="first", type=int, default=0)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--keep")
    options = parser.parse_args()
    failed = 0
    with tempfile.TemporaryDirectory(prefix="cylon-mutants-") as folder, \
            concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        corpus = Corpus(os.path.abspath(options.cylon), pathlib.Path(folder))
        # Half of them scenes.
        kinds = ["scene", "mesh", "scene", "journal", "scene", "v.json", "scene", "t.jsonl", "scene", "e.jsonl", "scene", "e.csv"]
        cases = [(kinds[n % len(kinds)], n) for n in range(options.first, options.first + options.count)]
        for (kind, number), bad in zip(cases, pool.map(lambda case: corpus.fault(*case, options.keep), cases)):
            if bad:
                failed += 1
                print(f"{kind} {number}: {bad}", flush=True)
    print(json.dumps({"tried": len(cases), "failed": failed}))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
