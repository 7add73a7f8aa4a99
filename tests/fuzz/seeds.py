#!/usr/bin/env python3
"""Writes the seeds of fuzz targets that no shipped file serves, from what the program itself writes.

    tests/fuzz/seeds.py build/release/cylon

The files land in tests/fuzz/corpus/TARGET/ and are committed.  Files there with other names are regressions and stay."""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
CORPUS = ROOT / "tests/fuzz/corpus"
HEAD = """duration = 0.02
step = 0.01
gravity = [0, -9.81, 0]
[[body]]
name = "a"
mass = 1
"""
SCENE = HEAD + """position = [0, 0.6, 0]
velocity = [0.5, -1, 0]
shape = { type = "sphere", radius = 0.5 }
[[body]]
name = "b"
mass = 2
position = [3, 2, 0]
[[plane]]
name = "floor"
[[material]]
between = ["*", "*"]
restitution = 1
friction = 0
[[claim]]
conserves = "energy"
tolerance = { absolute = 1, reason = "seed" }
"""
CERTIFIED = HEAD + """[[claim]]
follows = "certified"
observable = "position"
tolerance = { absolute = 1, reason = "seed" }
"""
HERE = [(rb'"machine":"[^"]*"', b'"machine":"one"'), (rb'"os":"[^"]*"', b'"os":"Linux"'),
        (rb'"command_line":"[^" ]*/cylon ', b'"command_line":"cylon ')]
HOST = "Host: 127.0.0.1:8080\r\n"
TOKEN = "X-Cylon-Token: 0123456789abcdef0123456789abcdef\r\n"
COMMANDS = [{"do": "play"}, {"do": "speed", "value": 0.5}, {"do": "kick", "body": 0, "impulse": [1, 2.5, -3]},
            {"do": "pull", "body": 1, "anchor": [0, 0.1, 0], "pin": [1, 2, 3], "stiffness": 40},
            {"do": "lanes", "lanes": [{"engine": "ode/erp=0", "integrator": "", "dt_text": "1/240"},
                                      {"engine": "in-house", "integrator": "rk4", "dt_text": "0.001"}]},
            {"do": "set", "key": "gravity", "value": [0, -1.6, 0]}, {"do": "set", "key": "friction", "value": 0.3}]
BENCHMARK = {"context": {"date": "2026-01-02T03:04:05+00:00", "host_name": "here", "executable": "./bench", "num_cpus": 2},
             "benchmarks": [{"name": "BM_step/8", "run_name": "BM_step/8", "run_type": "iteration", "repetitions": 1,
                             "repetition_index": 0, "threads": 1, "iterations": 10, "real_time": 1.5, "cpu_time": 1.25,
                             "time_unit": "us", "bodies": 8.0}]}


def keep(target, name, content):
    folder = CORPUS / target
    folder.mkdir(parents=True, exist_ok=True)
    content = content if isinstance(content, bytes) else content.encode()
    (folder / name).write_bytes(without_this_machine(content))


def without_this_machine(content):
    """Where a seed was made, and on what, is nobody's business."""
    for pattern, word in HERE:
        content = re.sub(pattern, word, content)
    return content


def short(hello):
    """The introduction of a worker with the first of each list alone."""
    message = json.loads(hello)
    for key in ("paths", "schemes", "options"):
        message[key] = message.get(key, [])[:1]
    for path in message["paths"]:
        path["settings"] = path.get("settings", [])[:2]
    return json.dumps(message).encode()


def conversation(cylon, folder):
    """What the in-house worker writes while a run of two bodies."""
    worker = pathlib.Path(cylon).parent / "cylon-worker-in-house"
    (folder / "worker.sh").write_text(f"#!/bin/sh\n{worker} | tee {folder}/said\n")
    (folder / "worker.sh").chmod(0o755)
    subprocess.run([cylon, "run", "s.toml", "--worker", f"w={folder}/worker.sh", "--engine", "w"], cwd=folder, check=False,
                   capture_output=True)
    hello, rest = (folder / "said").read_bytes().split(b"\n", 1)
    keep("protocol", "run", short(hello) + b"\n" + rest)
    keep("protocol", "messages", "\n".join(map(json.dumps, [
        {"event": {"kind": "bounce", "body": 0, "other": -1, "plane": 0, "index": 1, "time": 0.5, "speed": 2,
                   "height": None}},
        {"contacts": [{"body": 0, "other": 1, "plane": -1, "point": [0, 1, 2], "normal": [0, 1, 0], "impulse": None}]},
        {"unsupported": "no water"}])) + "\n")


def certified(cylon, folder):
    (folder / "c.toml").write_text(CERTIFIED)
    subprocess.run([cylon, "validate", "c.toml"], cwd=folder, check=True, capture_output=True,
                   env={**os.environ, "CYLON_CACHE": str(folder / "cache")})
    (file,) = (folder / "cache/certified").glob("*.bin")
    keep("cache", "projectile", file.read_bytes().split(b"\n", 3)[3])


def stored(cylon, folder):
    def run(*words):
        subprocess.run([cylon, *words], cwd=folder, check=True, capture_output=True)

    run("run", "s.toml", "--engine", "in-house", "--json", "v.json", "--traces", "t.jsonl")
    lines = [json.loads(line) for line in (folder / ".cylon/journal.jsonl").read_text().splitlines()]
    keep("journal", "run", "\n".join(json.dumps({k: v for k, v in line.items() if k != "seal"}) for line in lines) + "\n")
    keep("report", "verdicts.json", (folder / "v.json").read_bytes())
    keep("report", "trace.jsonl", (folder / "t.jsonl").read_text().splitlines()[-1] + "\n")
    run("track", "record", "s.toml", "--engine", "in-house", "--repetitions", "2", "--store", "g.db")
    run("track", "export", "--store", "g.db", "e.jsonl")
    run("track", "export", "--store", "g.db", "--format", "csv", "e.csv")
    keep("history", "store.jsonl", (folder / "e.jsonl").read_bytes())
    keep("history", "samples.csv", b"\n".join((folder / "e.csv").read_bytes().split(b"\n")[:4]) + b"\n")
    keep("history", "benchmark.json", json.dumps(BENCHMARK))


def requests():
    for number, command in enumerate(map(json.dumps, COMMANDS)):
        keep("command", str(number), command)
    post = json.dumps(COMMANDS[2])
    keep("http", "page", f"GET / HTTP/1.1\r\n{HOST}\r\n")
    keep("http", "session", f"GET /api/session HTTP/1.1\r\n{HOST}{TOKEN}Origin: http://127.0.0.1:8080\r\n\r\n")
    keep("http", "command", f"POST /api/command HTTP/1.1\r\n{HOST}{TOKEN}Content-Length: {len(post)}\r\n\r\n{post}")
    keep("http", "frame", f"POST /api/frame?n=17 HTTP/1.1\r\n{HOST}{TOKEN}Content-Length: 8\r\n\r\n\x89PNG\r\n\x1a\n"
         .encode("latin-1"))
    keep("http", "chunked", f"POST /api/command HTTP/1.1\r\n{HOST}{TOKEN}Transfer-Encoding: chunked\r\n\r\n2\r\n{{}}\r\n0\r\n\r\n")


def main():
    cylon = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory(prefix="cylon-seeds-") as name:
        folder = pathlib.Path(name)
        (folder / "s.toml").write_text(SCENE)
        os.environ["CYLON_KEY"] = str(folder / "key")
        conversation(cylon, folder)
        certified(cylon, folder)
        stored(cylon, folder)
        requests()


if __name__ == "__main__":
    sys.exit(main())
