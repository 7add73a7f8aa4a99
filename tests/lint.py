#!/usr/bin/env python3
"""clang-tidy over sources; a source that passed is not looked at again until it, a header of ours that it reads, its
command line or .clang-tidy changes.  What passed is remembered in .cache/lint.

    tests/lint.py [-j WORKERS] BUILD_FOLDER SOURCE…

A source that several targets compile is looked at as the first of them compiles it.
Exit codes: 0 no finding, 1 findings (on stdout), 2 clang-tidy is missing or cannot run.
"""
import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parent.parent
# gcc's precompiled headers are not clang's; so a source that needs one is found out.
without_precompiled = re.compile(r" -Winvalid-pch| -include \S+/cmake_pch\.hxx")
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


def scope(tidy):
    """The option that loads tests/lint_scope.cc, built against this clang-tidy; none where that cannot be."""
    source = root / "tests" / "lint_scope.cc"
    include = tidy.parent.parent / "include"
    if not (include / "clang" / "Frontend" / "FrontendPluginRegistry.h").exists():
        print("libclang-14-dev is not installed: the findings are the same, and take ten times as long", file=sys.stderr)
        return []
    made = passed / f"scope-{hashlib.sha256(source.read_bytes()).hexdigest()[:16]}.so"
    if not made.exists():
        part = made.with_suffix(f".{os.getpid()}")
        subprocess.run(["c++", "-std=c++17", "-O1", "-fPIC", "-shared", "-fno-rtti", "-isystem", include, source,
                        "-o", part], check=True)
        part.rename(made)
    return [f"--load={made}"]


def lint(source, row, tidy, common):
    """What clang-tidy says of one source, and whether it passed."""
    try:
        stamp = passed / digest(row["command"], row["directory"], common)
    except (subprocess.CalledProcessError, OSError) as error:
        return f"{source}: {error}\n", False
    if stamp.exists():
        return "", True
    done = subprocess.run([*tidy, source], cwd=root, capture_output=True, text=True)
    if done.returncode == 0:
        stamp.touch()
        return "", True
    return done.stdout or done.stderr, False


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("-j", type=int, default=len(os.sched_getaffinity(0)))
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("sources", nargs="+")
    options = parser.parse_args()
    found = shutil.which("clang-tidy")
    if not found:
        print("clang-tidy is not installed: apt-get install clang-tidy-14 libclang-14-dev", file=sys.stderr)
        return 2
    passed.mkdir(parents=True, exist_ok=True)
    rows = {}
    for row in json.loads((options.build / "compile_commands.json").read_text()):
        row["command"] = without_precompiled.sub("", row["command"])
        rows.setdefault(row["file"], row)
    (passed / "compile_commands.json").write_text(json.dumps(list(rows.values())))
    tidy = [found, *scope(pathlib.Path(found).resolve()), "-p", passed, "--quiet"]
    version = subprocess.run([found, "--version"], capture_output=True, check=True).stdout
    common = version + (root / ".clang-tidy").read_bytes()
    known = [(s, rows[str(root / s)]) for s in options.sources if str(root / s) in rows]
    failed = 0
    for source in set(options.sources) - {source for source, _ in known} - {"tests/lint_scope.cc"}:
        failed += 1
        print(f"{source}: no target of {options.build} compiles it")
    with concurrent.futures.ThreadPoolExecutor(options.j) as pool:
        for said, good in pool.map(lambda job: lint(*job, tidy, common), known):
            failed += not good
            print(said, end="", flush=True)
    print(f"clang-tidy: {len(known)} sources, {failed} with findings", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
