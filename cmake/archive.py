#!/usr/bin/env python3
"""Makes a static library of one object that shows nothing but some functions.

    cmake/archive.py LIBRARY --keeps REGEX --whole ARCHIVE… --parts ARCHIVE…

Everything of the whole archives is in it, and what that needs of the parts.  Functions whose mangled names match stay
visible; all else that is defined, templates too, becomes local.  Functions of ours must all be defined.  The same archives
give the same bytes.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile


def output(*words):
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout


def main():
    asked = argparse.ArgumentParser()
    asked.add_argument("library", type=pathlib.Path)
    asked.add_argument("--keeps", required=True)
    asked.add_argument("--whole", nargs="+", required=True)
    asked.add_argument("--parts", nargs="+", required=True)
    asked = asked.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        joined = pathlib.Path(folder, asked.library.stem.removeprefix("lib") + ".o")
        shown, defined = pathlib.Path(folder, "shown"), pathlib.Path(folder, "defined")
        # Groups of templates are resolved now: a local symbol in a group would be dropped with another object's group.
        output("ld", "-r", "--force-group-allocation", "-o", joined, "--whole-archive", *asked.whole, "--no-whole-archive",
               "--start-group", *asked.parts, "--end-group")
        symbols = [line.split() for line in output("nm", "-P", joined).splitlines()]
        missing = [name for name, kind, *_ in symbols if kind == "U" and re.match("_ZNK?5cylon", name)]
        if missing:
            sys.exit(f"{asked.library.name}: defined in none of these archives: {' '.join(missing)}")
        kept = [name for name, kind, *_ in symbols if kind == "T" and re.match(asked.keeps, name)]
        if not kept:
            sys.exit(f"{asked.library.name}: no function matches {asked.keeps}")
        shown.write_text("".join(f"{name}\n" for name in kept))
        # Weak first: what the whole process shares (GNU_UNIQUE) cannot become local at once, and what two of the libraries
        # show may meet in one program.
        defined.write_text("".join(f"{name}\n" for name, kind, *_ in symbols if kind not in "Uw"))
        output("objcopy", f"--weaken-symbols={defined}", joined)
        output("objcopy", f"--keep-global-symbols={shown}", joined)
        output("objcopy", "--strip-unneeded", "--remove-section=.comment", joined)
        asked.library.parent.mkdir(exist_ok=True)
        asked.library.unlink(missing_ok=True)
        visible = {line.split()[0] for line in output("nm", "-gP", "--defined-only", joined).splitlines()}
        if visible != set(kept):
            sys.exit(f"{asked.library.name}: visible beside what should be: {' '.join(sorted(visible - set(kept)))}")
        output("ar", "rcsD", asked.library, joined)


main()
