#!/usr/bin/env python3
"""Builds targets of a preset and says how far it is: one line that is written over on a terminal, one every ten seconds
elsewhere.  What compilers say goes to build/PRESET.log, and to stderr when the build fails.

    cmake/build.py PRESET TARGET…

Exit codes: 0 built, 1 failed.
"""
import os
import pathlib
import re
import subprocess
import sys
import time

every = 10  # [s] between lines where no terminal is

root = pathlib.Path(__file__).resolve().parent.parent
terminal = sys.stderr.isatty()


def minutes(seconds):
    return f"{seconds:.0f} s" if seconds < 90 else f"{seconds / 60:.0f} min"


class Progress:
    """Targets done of all, and the time left at the pace so far."""

    def __init__(self, folder):
        self.folder, self.start, self.shown, self.width = folder, time.monotonic(), 0.0, 0

    def show(self, done, total):
        now = time.monotonic()
        if now - self.shown < (0.2 if terminal else every):
            return
        self.shown = now
        passed = now - self.start
        left = f", {minutes(passed * (total - done) / done)} left" if done >= 10 or done and passed > 10 else ""
        line = f"Building {self.folder}: {done} of {total}{left}"
        print(f"\r{line:<{self.width}}" if terminal else line, end="" if terminal else "\n", file=sys.stderr, flush=True)
        self.width = len(line)

    def end(self):
        if terminal and self.width:
            print(f"\r{'':<{self.width}}\r", end="", file=sys.stderr, flush=True)


def build(preset, targets, log):
    def say(line):
        log.write(line)
        log.flush()

    def stream(command, see=lambda line: None):
        environment = {**os.environ, "NINJA_STATUS": "[%f/%t] "}
        with subprocess.Popen(command, cwd=root, env=environment, text=True, errors="replace", stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT) as process:
            for line in process.stdout:
                say(line)
                see(line)
        return process.returncode == 0

    progress = Progress(f"build/{preset}")

    def see(line):
        if step := re.match(r"\[(\d+)/(\d+)\] ", line):
            progress.show(int(step[1]), int(step[2]))

    try:
        return stream(["cmake", "--preset", preset]) and \
            stream(["cmake", "--build", "--preset", preset, "--target", *targets], see)
    finally:
        progress.end()


def main():
    preset, targets = sys.argv[1], sys.argv[2:]
    folder = root / "build"
    folder.mkdir(exist_ok=True)
    path = folder / f"{preset}.log"
    with open(path, "w") as log:
        built = build(preset, targets, log)
    if not built:
        sys.stderr.write(path.read_text(errors="replace"))
        print(f"The build failed; its output is above and in build/{preset}.log.", file=sys.stderr)
    return 0 if built else 1


try:
    sys.exit(main())
except KeyboardInterrupt:
    sys.exit(130)
