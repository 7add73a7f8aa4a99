#!/usr/bin/env python3
"""Follows docs/tutorial.md as a reader would, in an empty folder, and prints the time of each command.

    docs/walk_tutorial.py [--cylon build/release/cylon]

Takes the commands, the scene and the Python code from the page itself.  Fails if a command fails.  Exit code 1 of
`cylon` is allowed: a verdict differs, as the page says.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

docs = pathlib.Path(__file__).resolve().parent


def blocks(page):
    """(language, text) of each block that the reader types; output of the program is left out."""
    scene = (docs / "examples" / "swing.toml").read_text()
    page = re.sub(r"<!-- scene -->.*?<!-- /scene -->", lambda _: f"```toml\n{scene}```", page, flags=re.S)
    page = re.sub(r"<!-- (\w+) -->.*?<!-- /\1 -->", "", page, flags=re.S)
    return re.findall(r"^```(\w*)\n(.*?)^```", page, flags=re.S | re.M)


def commands(text):
    """Lines without comments, continued lines joined."""
    lines = [re.sub(r"\s{2,}#.*", "", line).strip() for line in text.replace("\\\n", " ").splitlines()]
    return [line for line in lines if line]


def edit(file, code):
    """Puts the code where the page tells the reader to."""
    text = file.read_text()
    if code.startswith("SCHEME"):
        text = re.sub(r"^SCHEME = .*\n", lambda _: code, text, flags=re.M)
    else:
        begin, end = text.index("    def step(self):"), text.index("    def state(self):")
        text = text[:begin] + code + "\n" + text[end:]
    file.write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cylon", default=docs.parent / "build/release/cylon", type=pathlib.Path)
    cylon = parser.parse_args().cylon.resolve()
    with tempfile.TemporaryDirectory() as home:
        home = pathlib.Path(home)
        (home / "cylon").symlink_to(docs.parent)
        folder = home / "first"
        folder.mkdir()
        environment = {**os.environ, "HOME": str(home), "PATH": f"{cylon.parent}:{os.environ['PATH']}"}
        total = 0.0
        for language, text in blocks((docs / "tutorial.md").read_text()):
            if language == "toml":
                (folder / "swing.toml").write_text(text)
                continue
            if language == "python":
                edit(folder / "my_engine4.py", text)
                continue
            for command in commands(text):
                if command.startswith(("export", "mkdir")):
                    continue  # done above
                start = time.monotonic()
                done = subprocess.run(command, shell=True, cwd=folder, env=environment, capture_output=True, text=True)
                seconds = time.monotonic() - start
                total += seconds
                print(f"{seconds:7.1f} s  {command}", flush=True)
                if done.returncode not in (0, 1):
                    sys.exit(f"ended with {done.returncode}:\n{done.stdout}{done.stderr}")
        if not (folder / "report.html").is_file():
            sys.exit("no report was written")
        print(f"{total:7.1f} s  in all")


main()
