#!/usr/bin/env python3
"""clang-tidy over sources; a source that passed is not looked at again until it, a header of ours that it reads, its
command line or .clang-tidy changes.  What passed is remembered in .cache/lint.

    tests/lint.py BUILD_FOLDER SOURCE…

Exit codes: 0 no finding, 1 findings (on stdout), 2 clang-tidy is missing or cannot run.
"""
import concurrent.futures
import hashlib
import json
import os
import pathlib
import shlex
import shutil
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parent.parent
passed = root / ".cache" / "lint"


def digest(command, folder, common):
    """Of all that a finding depends on: the sources and headers of ours that the compiler reads, and how."""
    words = shlex.split(command)
    words = words[1:] if words[0].endswith("ccache") else words
    at = words.index("-o")
    words = words[:at] + words[at + 2:]
    made = subprocess.run([*words, "-MM"], cwd=folder, capture_output=True, text=True, check=True).stdout
    files = made.replace("\\\n", " ").split(":", 1)[1].split()
    whole = hashlib.sha256(common + shlex.join(words).encode())
    for file in sorted(files):
        whole.update(file.encode() + (pathlib.Path(folder) / file).read_bytes())
    return whole.hexdigest()


def lint(source, row, build, common):
    """What clang-tidy says of one source, and whether it passed."""
    try:
        stamp = passed / digest(row["command"], row["directory"], common)
    except (subprocess.CalledProcessError, OSError) as error:
        return f"{source}: {error}\n", False
    if stamp.exists():
        return "", True
    done = subprocess.run(["clang-tidy", "-p", build, "--quiet", source], cwd=root, capture_output=True, text=True)
    if done.returncode == 0:
        stamp.touch()
        return "", True
    return done.stdout or done.stderr, False


def main(build, sources):
    if not shutil.which("clang-tidy"):
        print("clang-tidy is not installed: apt-get install clang-tidy", file=sys.stderr)
        return 2
    rows = {row["file"]: row for row in json.loads((pathlib.Path(build) / "compile_commands.json").read_text())}
    version = subprocess.run(["clang-tidy", "--version"], capture_output=True, check=True).stdout
    common = version + (root / ".clang-tidy").read_bytes()
    passed.mkdir(parents=True, exist_ok=True)
    known = [(s, rows[str(root / s)]) for s in sources if str(root / s) in rows]
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        for said, good in pool.map(lambda job: lint(*job, build, common), known):
            failed += not good
            print(said, end="", flush=True)
    print(f"clang-tidy: {len(known)} sources, {failed} with findings", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
