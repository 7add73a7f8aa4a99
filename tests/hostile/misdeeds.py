#!/usr/bin/env python3
"""Runs every misdeed of engine.py in a matrix with a healthy engine: tests/hostile/misdeeds.py CYLON [MISDEED…].

Of each: the run ends in time with a documented exit code, the healthy engine passes, the wild one has its row, all
reports are there and well formed, and no process of it is left.  The last line is JSON: tried, failed."""
import concurrent.futures
import json
import os
import pathlib
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
SECONDS = 3  # the harness's limit on a run of the wild engine


def left(mark):
    """Command lines of processes that descend from the harness of this mark."""
    found = []
    for entry in pathlib.Path("/proc").iterdir():
        if not entry.name.isdigit() or int(entry.name) == os.getpid():
            continue
        try:
            if mark in (entry / "environ").read_bytes():
                found.append((entry / "cmdline").read_bytes().replace(b"\0", b" ").decode("utf8", "replace"))
        except OSError:
            pass
    return found


def faults(cylon, misdeed, options=()):
    with tempfile.TemporaryDirectory(prefix="cylon-misdeed-") as folder:
        scene = SCENE
        if "event" in misdeed:
            scene = SCENE.replace("duration = 0.1", "duration = 2").replace("offset = -5", "offset = 0") + EVENT
        (pathlib.Path(folder) / "s.toml").write_text(scene)
        mark = "MISDEED_TEST=" + folder
        command = [cylon, *options, "run", "s.toml", "--engine", "wild", "--engine", "in-house", "--jobs", "1", "--worker",
                   f"wild=python3 {HERE}/engine.py {misdeed}", "--timeout", str(SECONDS), "--memory", "0.2", "--json",
                   "o.json", "--junit", "o.xml", "--csv", "o.csv", "--html", "o.html"]
        environment = {**os.environ, "CYLON_KEY": folder + "/key", "MISDEED_TEST": folder}
        start = time.monotonic()
        try:
            ran = subprocess.run(command, cwd=folder, env=environment, capture_output=True, timeout=90, check=False)
        except subprocess.TimeoutExpired:
            return ["the run does not end"]
        bad = []
        if ran.returncode not in (0, 1, 2, 5):
            bad.append(f"exit code {ran.returncode}: {ran.stderr[-200:]!r}")
        try:
            rows = json.loads((pathlib.Path(folder) / "o.json").read_text())["verdicts"]
            xml.dom.minidom.parse(folder + "/o.xml")
            if not any(row["engine"] == "in-house" and row["status"] == "pass" for row in rows):
                bad.append("the healthy engine did not pass")
            if not any(row["engine"] == "wild" for row in rows):
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
        for _ in range(50):
            if not left(mark.encode()):
                break
            time.sleep(0.02)
        bad += [f"left behind: {line[:100]}" for line in left(mark.encode())]
        if time.monotonic() - start > 10 * SECONDS + 30:
            bad.append(f"{time.monotonic() - start:.0f} s")
        return bad


def main():
    cylon = os.path.abspath(sys.argv[1])
    options = [word for word in sys.argv[2:] if word.startswith("--")]
    wanted = [word for word in sys.argv[2:] if not word.startswith("--")] or engine.MISDEEDS
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(max_workers=4) as pool:
        for misdeed, bad in zip(wanted, pool.map(lambda m: faults(cylon, m, options), wanted)):
            if bad:
                failed += 1
                print(f"{misdeed}: {'; '.join(bad)}", flush=True)
    print(json.dumps({"tried": len(wanted), "failed": failed}))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
