#!/usr/bin/env python3
"""Prints, as Markdown, what it takes to add a thing to Cylon, and how large and how repetitive the sources are.

    docs/growth.py REVISION [REVISION]     before and now; now is the working tree where it is left out

What a new thing would touch is read off an example that is there already: every production file that names it, outside
comments, is one that the next of its kind would touch too. Adapters are not counted: each engine maps a new force, joint
or shape in its own folder.
"""
import collections
import io
import pathlib
import re
import statistics
import subprocess
import sys
import tarfile

root = pathlib.Path(__file__).resolve().parent.parent

CODE = re.compile(r".*\.(h|hpp|cc)$")
OURS = re.compile(r"(engine|harness|reference|reports|scenarios)/(?!web/)")
ADAPTER = re.compile(r"reference/simulators/")
WEB = re.compile(r"reports/web/src/.*\.tsx?$")
BUILD = re.compile(r"(CMakeLists\.txt|run|test|cmake/.*|reference/simulators/engines\.txt)$")
DATA = re.compile(r"scenarios/.*\.toml$")
TRUTH = re.compile(r"reference/exact/(?!domain\.|nudges\.)")


def is_production(path):
    """C++ that ships: tests and benches are not it."""
    return bool(CODE.match(path) and OURS.match(path) and not path.startswith("reports/web/"))


def is_open(path):
    """Production that must know every kind of force, joint and shape.  An exact solution is about the kinds that it names and
    refuses all others, so that a new kind does not touch it; what all of them share is looked at."""
    return is_production(path) and not TRUTH.match(path)


# kind, example, what names it, which files are looked at (adapters are never).  A joint is a row of what it keeps; whoever
# writes its equations names what it keeps: of the hinge, turning about_axis only.
THINGS = [
    ("scenario", "`tunnel_two_spheres`", r"\btunnel_two_spheres\b", lambda p: is_production(p) or DATA.match(p)),
    ("truth", "`kepler`", r"\bkepler\b", is_production),
    ("engine", "ODE", r"\bode\b|\bODE\b|\bode[-_]|\bsim_ode\b", lambda p: is_production(p) or BUILD.match(p)),
    ("integrator", "`bm6`", r"\bbm6\b", is_production),
    ("observable", "`joint_gap`", r"\bjoint_gap\b", is_production),
    ("event", "`nutation`", r"\bnutation\b", is_production),
    ("force", "attraction", r"\b\w*[Aa]ttraction\w*\b", is_open),
    ("joint", "hinge", r"\b\w*[Hh]inge\w*\b|\b(joint_)?about_axis\b", is_open),
    ("shape", "capsule", r"\b\w*[Cc]apsule\w*\b", is_open),
    ("report section", "`trade`", r"\bTradeSection\b", WEB.match),
]


def files_at(revision):
    """Text of every file of interest at a revision; None: of the working tree."""
    if revision is None:
        paths = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=root, capture_output=True, text=True,
                               check=True).stdout.split("\n")
        raw = {p: (root / p).read_bytes() for p in paths if p and (root / p).is_file() and wanted(p)}
    else:
        archive = subprocess.run(["git", "archive", "--format=tar", revision], cwd=root, capture_output=True, check=True)
        with tarfile.open(fileobj=io.BytesIO(archive.stdout)) as tar:
            raw = {m.name: tar.extractfile(m).read() for m in tar if m.isfile() and wanted(m.name)}
    return {path: text.decode("utf-8", "replace") for path, text in raw.items()}


def wanted(path):
    return any(pattern.match(path) for pattern in (CODE, WEB, BUILD, DATA))


def without_comments(path, text):
    """Comments blanked, lines kept; a '//' inside a string is left alone where the string ends behind it."""
    if CODE.match(path) or WEB.match(path):
        text = re.sub(r"/\*.*?\*/", lambda m: "\n" * m[0].count("\n"), text, flags=re.DOTALL)
        return re.sub(r'^((?:[^"\n/]|"(?:[^"\\\n]|\\.)*"|/(?!/))*)//.*$', r"\1", text, flags=re.MULTILINE)
    return re.sub(r"(^|\s)#.*$", "", text, flags=re.MULTILINE)


def touched(files, pattern, looked_at):
    """Files and lines outside comments that name an example; `#include`s of its own headers are not counted apart."""
    found = {}
    for path, text in files.items():
        if ADAPTER.match(path) and not BUILD.match(path) or not looked_at(path):
            continue
        lines = [line for line in without_comments(path, text).split("\n") if re.search(pattern, line)]
        if lines or re.search(pattern, pathlib.PurePath(path).name):
            found[path] = len(lines)
    return found


def functions(path, text):
    """(lines, name, path) of each function: a head at column 0 or one namespace deep, up to its closing brace there."""
    lines, start, head = text.split("\n"), None, ""
    for number, line in enumerate(lines):
        if start is None and re.match(r"[A-Za-z_].*[({,]$|[A-Za-z_].*\) *(const|noexcept|override)* *\{$", line):
            if not re.match(r"(namespace|class|struct|enum|union|using|typedef|template|extern)\b", line):
                start, head = number, line
        if start is not None and line.startswith("}"):
            name = re.search(r"([A-Za-z_][\w:~]*(?:operator[^\s(]*)?)\s*\(", head)
            if line == "}" and name:
                yield number - start + 1, name[1], path
            start = None
        elif start is not None and line.endswith(";") and not line.startswith(" "):
            start = None


def repeated(files, window=6):
    """Lines that stand in a run of at least `window` equal lines of code somewhere else; braces and includes are none."""
    seen, runs = collections.defaultdict(list), set()
    for path, text in files.items():
        code = [(n, re.sub(r"\s+", " ", line).strip()) for n, line in enumerate(without_comments(path, text).split("\n"))]
        code = [(n, line) for n, line in code if len(line) > 3 and not line.startswith(("#", "}", "namespace "))]
        for i in range(len(code) - window + 1):
            seen[tuple(line for _, line in code[i:i + window])].append([(path, n) for n, _ in code[i:i + window]])
    for places in seen.values():
        if len(places) > 1:
            runs.update(place for lines in places for place in lines)
    return len(runs)


def table(head, rows):
    print("| " + " | ".join(head) + " |")
    print("|" + "---|" * len(head))
    for row in rows:
        print("| " + " | ".join(str(cell) for cell in row) + " |")
    print()


def sizes(files):
    production = {path: text for path, text in files.items() if is_production(path)}
    lines = {path: text.count("\n") for path, text in production.items()}
    names = collections.Counter(pathlib.PurePath(path).name for path in production if path.endswith(".h"))
    longest = sorted((f for path, text in production.items() for f in functions(path, text)), reverse=True)[:5]
    return {
        "production files": len(lines),
        "production lines": sum(lines.values()),
        "lines of the median file": int(statistics.median(lines.values())),
        "files over 400 lines": sum(n > 400 for n in lines.values()),
        "files under 25 lines": sum(n < 25 for n in lines.values()),
        "header names that occur more than once": sum(n > 1 for n in names.values()),
        "lines in repeated runs of 6 or more": repeated(production),
        "longest files": "<br>".join(f"`{p}` {n}" for p, n in sorted(lines.items(), key=lambda item: -item[1])[:5]),
        "longest functions": "<br>".join(f"`{name}` in `{path}` {n}" for n, name, path in longest),
    }


def main():
    if not 2 <= len(sys.argv) <= 3:
        sys.exit(__doc__)
    revisions = [sys.argv[1], sys.argv[2] if len(sys.argv) == 3 else None]
    before, now = (files_at(revision) for revision in revisions)

    rows, lists = [], []
    for kind, example, pattern, looked_at in THINGS:
        old, new = touched(before, pattern, looked_at), touched(now, pattern, looked_at)
        rows.append((kind, example, len(old), sum(old.values()), len(new), sum(new.values())))
        lists.append((kind, ", ".join(f"`{path}` {n}" for path, n in sorted(new.items()))))
    table(("a new …", "as", "files before", "lines before", "files now", "lines now"), rows)
    table(("a new …", "files that name the example now, with lines"), lists)
    old, new = sizes(before), sizes(now)
    table(("sources", "before", "now"), [(key, old[key], new[key]) for key in old])


if __name__ == "__main__":
    main()
