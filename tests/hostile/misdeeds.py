#!/usr/bin/env python3
"""Runs every misdeed of engine.py in a matrix with a healthy engine: tests/hostile/misdeeds.py CYLON [MISDEED…].

Of each: the run ends in time with a documented exit code, the healthy engine passes, the wild one has its row, all
reports are there and well formed, and no process of it is left.  Where only time ran out, the misdeed is tried again with
four times the limit, because a limit holds for the healthy engine too and the machine may be busy.
The last line is JSON: tried, failed."""
import concurrent.futures
import ctypes
import functools
import json
import math
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import xml.dom.minidom

import engine

HERE = pathlib.Path(__file__).resolve().parent
SCENE = """duration = 0.1
step = 0.01
gravity = [0, -9.81, 0]
[[body]]
name = "ball"
mass = 1
position = [0, 1, 0]
shape = { type = "sphere", radius = 0.2 }
[[plane]]
name = "floor"
offset = -5
[[material]]
between = ["*", "*"]
restitution = 1
friction = 0
[[claim]]
conserves = "energy"
tolerance = { absolute = 1e-3, reason = "rounding" }
"""
EVENT = """[[claim]]
follows = "bouncing_sphere"
observable = "event"
event = "bounce"
index = 1
quantity = "time"
tolerance = { absolute = 1e-3, reason = "rounding" }
"""
LIMITS = (3, 12, 48)  # the harness's limit on a run [s], one after the other as long as only time runs out
SIGKILL_BIT = 1 << (signal.SIGKILL - 1)
SET_CHILD_SUBREAPER = 36  # of prctl


class TimeIsUp(Exception):
    """The limit was too short for the run, or the run does not keep it."""


def adopt_orphans():
    """In each process of the pool: what loses its parent below it becomes its child, whatever it did to itself."""
    if ctypes.CDLL(None, use_errno=True).prctl(SET_CHILD_SUBREAPER, 1, 0, 0, 0):
        raise OSError(ctypes.get_errno(), "prctl")


def children():
    """Process ids of all children of this process that have not ended; those that have are reaped."""
    try:
        while os.waitpid(-1, os.WNOHANG)[0]:
            pass
    except ChildProcessError:
        return set()
    return {int(pid) for thread in pathlib.Path("/proc/self/task").iterdir()
            for pid in (thread / "children").read_text().split()}


def user_ticks_if_alive(pid):
    """User time [ticks] of a process, infinite where it sleeps or is stopped; None where it was killed."""
    status = pathlib.Path(f"/proc/{pid}/status").read_text()
    pending = [int(mask, 16) for mask in re.findall(r"^(?:Sig|Shd)Pnd:\s+(\w+)", status, re.M)]
    if any(mask & SIGKILL_BIT for mask in pending):
        return None
    state, *fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    if state in "ZX":
        return None
    return math.inf if state in "STt" else int(fields[10])


def end_children():
    """Kills what a run left; its command lines.  What was killed before may wait for a processor and is not counted:
    it neither sleeps nor gets user time again."""
    left, first, killed = [], {}, set()
    while ids := children():
        for pid in ids - killed:
            try:
                ticks = user_ticks_if_alive(pid)
                if ticks is None or ticks <= first.setdefault(pid, ticks if ticks < math.inf else 0):
                    continue
                line = pathlib.Path(f"/proc/{pid}/cmdline").read_bytes()
                os.kill(pid, signal.SIGKILL)
            except OSError:
                continue
            left.append(line.replace(b"\0", b" ").decode("utf8", "replace"))
            killed.add(pid)
        time.sleep(0.01)
    return left


def attempt(cylon, misdeed, options, seconds):
    """What is wrong with one run under this limit.  Raises TimeIsUp."""
    with tempfile.TemporaryDirectory(prefix="cylon-misdeed-") as folder:
        scene = SCENE
        if "event" in misdeed:
            scene = SCENE.replace("duration = 0.1", "duration = 2").replace("offset = -5", "offset = 0") + EVENT
        (pathlib.Path(folder) / "s.toml").write_text(scene)
        command = [cylon, *options, "run", "s.toml", "--engine", "wild", "--engine", "in-house", "--jobs", "1", "--worker",
                   f"wild=python3 {HERE}/engine.py {misdeed}", "--timeout", str(seconds), "--memory", "0.2", "--json",
                   "o.json", "--junit", "o.xml", "--csv", "o.csv", "--html", "o.html"]
        environment = {**os.environ, "CYLON_KEY": folder + "/key"}
        try:
            ran = subprocess.run(command, cwd=folder, env=environment, capture_output=True, timeout=10 * seconds + 30,
                                 check=False)
        except subprocess.TimeoutExpired as late:
            end_children()
            raise TimeIsUp(f"the run does not end within {10 * seconds + 30} s") from late
        bad = [f"left behind: {line[:100]}" for line in end_children()]
        if ran.returncode not in (0, 1, 2, 5):
            bad.append(f"exit code {ran.returncode}: {ran.stderr[-200:]!r}")
        healthy, wild = [], []
        try:
            rows = json.loads((pathlib.Path(folder) / "o.json").read_text())["verdicts"]
            xml.dom.minidom.parse(folder + "/o.xml")
            healthy = [row for row in rows if row["engine"] == "in-house"]
            wild = [row for row in rows if row["engine"] == "wild"]
            if not wild:
                bad.append("the wild engine has no row")
            size = sum((pathlib.Path(folder) / file).stat().st_size for file in ("o.json", "o.xml", "o.csv"))
            if size > 1 << 20:
                bad.append(f"{size} bytes of reports")
            if not (pathlib.Path(folder) / "o.html").stat().st_size:
                bad.append("no page")
        except (OSError, ValueError, KeyError) as error:
            bad.append(f"reports: {error!r} {ran.stderr[-200:]!r}")
        if (pathlib.Path(folder) / "forged").exists():
            bad.append("a forged journal was obeyed")
        if misdeed.startswith("memory") and any(row["status"] == "timeout" for row in wild):
            raise TimeIsUp("its memory was not limited")
        if not any(row["status"] == "pass" for row in healthy):
            bad.append("the healthy engine did not pass: " + "; ".join(f"{r['status']} {r['reason']}"[:200] for r in healthy))
            if len(bad) == 1 and any(row["status"] == "timeout" for row in healthy):
                raise TimeIsUp(bad[0])
        return bad


def faults(cylon, misdeed, options=()):
    late = ""
    for seconds in LIMITS:
        try:
            return attempt(cylon, misdeed, options, seconds)
        except TimeIsUp as error:
            late = str(error)
    return [late]


def control():
    """What must be found: processes that a run leaves, with and without the environment that it gave them."""
    run = ["setsid sleep 311.5 &", "env -i setsid sleep 311.5 &", "setsid sh -c 'while :; do :; done' &"]
    subprocess.run(["sh", "-c", " ".join(run)], check=True)
    return len(end_children()) == len(run)


def main():
    cylon = os.path.abspath(sys.argv[1])
    options = [word for word in sys.argv[2:] if word.startswith("--")]
    wanted = [word for word in sys.argv[2:] if not word.startswith("--")] or engine.MISDEEDS
    failed = 0
    with concurrent.futures.ProcessPoolExecutor(max_workers=4, initializer=adopt_orphans) as pool:
        if not pool.submit(control).result():
            sys.exit("the control was not found: what is left would not be seen")
        for misdeed, bad in zip(wanted, pool.map(functools.partial(faults, cylon, options=options), wanted)):
            if bad:
                failed += 1
                print(f"{misdeed}: {'; '.join(bad)}", flush=True)
    print(json.dumps({"tried": len(wanted), "failed": failed}))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
