#!/usr/bin/env python3
"""The worker that its arguments name, which is killed where it is given a second scene."""
import subprocess
import sys

with subprocess.Popen(sys.argv[1:], stdin=subprocess.PIPE) as worker:
    loads = 0
    for line in sys.stdin.buffer:
        loads += b'"cmd":"load"' in line
        if loads == 2:
            worker.kill()
            sys.exit(3)
        worker.stdin.write(line)
        worker.stdin.flush()
    worker.stdin.close()
