#!/usr/bin/env python3
"""Writes some sources into one, which takes the compiler a third of the time: what headers declare is read once, and
what templates they share is compiled once.

    cmake/batch.py OUTPUT NAME SOURCE…

An unnamed namespace of each file becomes one of its own, NAME_0, NAME_1, …, so that two files may name the same thing; so a
file keeps in it what it names.  As "as-they-are" they stay unnamed: for sources that use such names outside the namespace, and
then no two files may name the same thing.  A macro ends with its file.  Messages of the compiler show each file's lines.
"""
import os
import pathlib
import re
import sys

output, name, *sources = sys.argv[1:]
whole = ""
for i, source in enumerate(sources):
    text = pathlib.Path(source).read_text()
    for macro in re.findall(r"^#define (\w+)", text, re.M):
        if f"#undef {macro}" not in text:
            text += f"#undef {macro}\n"
    if name != "as-they-are":
        text = re.sub(r"^namespace \{$", f"namespace {name}_{i} {{", text, flags=re.M)
    # Not the path of this clone: the compiler cache shares what two clones compile.
    whole += f'#line 1 "{os.path.relpath(source, pathlib.Path(output).parent.parent)}"\n{text}'
pathlib.Path(output).write_text(whole)
