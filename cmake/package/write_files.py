#!/usr/bin/env python3
"""Writes what an installation has beside programs and scenarios, all of it from the program itself: man pages, completion
scripts and the schema of the scenario format.

    cmake/package/write_files.py CYLON FOLDER

The same program gives the same bytes.
"""
import gzip
import pathlib
import shutil
import subprocess
import sys

import man


def compressed(text):
    return gzip.compress(text.encode(), compresslevel=9, mtime=0)


def main():
    program, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])

    def said(*words):
        return subprocess.run([program, *words], check=True, stdout=subprocess.PIPE, text=True).stdout

    files = {f"man/man1/{name}.1.gz": compressed(page) for name, page in man.pages(said).items()}
    files |= {f"completion/{shell}": said("completion", shell).encode() for shell in ("bash", "zsh", "fish")}
    files["cylon/scenario.schema.json"] = said("validate", "--schema").encode()
    for part in ("man", "completion", "cylon"):  # what an earlier build wrote
        shutil.rmtree(folder / part, ignore_errors=True)
    for name, content in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(content)


main()
