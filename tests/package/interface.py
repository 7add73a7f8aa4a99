#!/usr/bin/env python3
"""Fails where what engines outside the tree are built on changes while the version stands still (docs/library.md).

    tests/package/interface.py PREFIX    compares an installation with tests/package/release/VERSION
    tests/package/interface.py PREFIX --store    writes that folder, once for each release

VERSION is major.minor of the project.  Stored are the public headers without comments and layout, the keys of the worker
protocol as docs/protocol.md lists them, and the example worker in Python, which later versions must still run.
"""
import difflib
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parents[2]
releases = root / "tests" / "package" / "release"


def version():
    return re.search(r"project\(cylon VERSION (\d+\.\d+)", (root / "CMakeLists.txt").read_text())[1]


def interface(header):
    """The header without comments, one statement a line: a reformatted or better explained header is the same."""
    kept = re.sub(r'"(?:\\.|[^"\\])*"|//[^\n]*|/\*.*?\*/', lambda m: m[0] if m[0][0] == '"' else " ",
                  header.replace("\\\n", " "), flags=re.DOTALL)
    lines = []
    for line in re.split(r"\n(?=[ \t]*#)|(?<=\n)", kept):
        if line.lstrip().startswith("#"):
            lines.append(" ".join(line.split()) + "\n")
        else:
            lines += [part + "\n" for part in re.split(r"(?<=[;{}])", " ".join(line.split())) if part.strip()]
    # A statement may have been broken over lines, or joined: join until it ends.
    joined, open_ = [], ""
    for line in lines:
        if line.startswith("#"):
            joined.append(line)
            continue
        open_ = f"{open_} {line.strip()}".strip()
        if open_[-1] in ";{}":
            joined.append(re.sub(r"\s*([(){}\[\],;:<>=&*|+])\s*", r"\1", open_) + "\n")
            open_ = ""
    return "".join(joined + ([open_ + "\n"] if open_ else []))


def protocol(page):
    """Each key that the page lists, below its heading: from tables, and from the messages that it prints."""
    found, heading = [], ""
    for line in page.splitlines():
        if line.startswith("#"):
            heading = line.strip("# ")
        cells = re.split(r"(?<!\\)\|", line)
        if line.startswith("| `") and len(cells) > 2:
            first = ", ".join(re.findall(r"`([^`]+)`", cells[1]))
            elements = re.findall(r"(?:^|<br>)\s*`(\w+)`((?: \[[^\]]*\])?(?: \*opt\*)?)", cells[2])
            optional = " *opt*" if "*opt*" in cells[2] and not elements else ""
            found.append(f"{heading}: {first}{optional}\n")
            found += [f"{heading}: {first}.{key}{rest}\n" for key, rest in elements]
        if line.startswith("    ") or "`{" in line:
            found += [f"{heading}: says {key}\n" for key in re.findall(r'"(\w+)":', line)]
    return "".join(dict.fromkeys(found))


def today(prefix):
    """Name and content of each file of a release, as the installation has it."""
    include = prefix / "include" / "cylon"
    files = {f"include/{h.relative_to(include)}.txt": interface(h.read_text()) for h in sorted(include.rglob("*.h"))}
    files["protocol.txt"] = protocol((root / "docs" / "protocol.md").read_text())
    files["worker.py"] = (root / "docs" / "examples" / "foreign_engine.py").read_text()
    return files


def stored(folder):
    return {str(p.relative_to(folder)): p.read_text() for p in sorted(folder.rglob("*")) if p.is_file()}


def changes(old, new):
    """A diff of each file that is not the same; the stored worker is a program to run, and may differ."""
    for name in sorted(old.keys() | new.keys()):
        if name != "worker.py":
            yield from difflib.unified_diff(old.get(name, "").splitlines(True), new.get(name, "").splitlines(True),
                                            f"released/{name}", f"now/{name}", n=1)


def controls():
    """A comparison that sees nothing, or sees layout, is none."""
    before = "// A word.\nstruct A {\n  int x = 0;  ///< [m]\n  virtual void f(int) = 0;\n};\n#define N 1 /* one */\n"
    same = ["struct A {\n  int x = 0; virtual void f(\n      int) = 0;\n};\n#define N 1\n", before.replace("word", "better word")]
    other = [before.replace("int x", "long x"), before.replace("= 0;  ///", "= 1;  ///"), before.replace("f(int)", "f(int, int)"),
             before.replace("N 1", "N 2"), before.replace("  int x = 0;  ///< [m]\n", "")]
    page = "## load\n\n    {\"ok\": 1}\n| `step_ns` | *opt*: time |\n| `body` | `name`: Unique.<br>`mass` [kg]: Mass. |\n"
    pages = [page.replace("mass", "weight"), page.replace("*opt*: ", ""), page.replace("[kg]", "[g]"), page.replace('"ok"', '"yes"')]
    return [f"the same, and taken for another:\n{text}" for text in same if interface(text) != interface(before)] + \
           [f"another, and taken for the same:\n{text}" for text in other if interface(text) == interface(before)] + \
           [f"another page, and taken for the same:\n{text}" for text in pages if protocol(text) == protocol(page)]


def main():
    prefix, folder = pathlib.Path(sys.argv[1]), releases / version()
    if blind := controls():
        sys.exit("\n".join(blind))
    new = today(prefix)
    if len(new) < 5:
        sys.exit(f"no public headers in {prefix}")
    if sys.argv[2:] == ["--store"]:
        for name, text in new.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(text)
        return print(f"Stored {len(new)} files in {folder}")
    if not folder.is_dir():
        sys.exit(f"{version()} is a new version: store its interface (tests/package/interface.py PREFIX --store), and say in "
                 "CHANGELOG.md what an engine's author must change")
    if found := "".join(changes(stored(folder), new)):
        sys.exit(f"{found}The interface is not that of release {version()}, and the version is.  Undo the change, or move the "
                 "version in CMakeLists.txt and store the new interface; of the protocol and of cylon/engine.h the number there "
                 "moves too (docs/library.md).")
    # What was built on an earlier release of the same protocol still runs.
    for worker in sorted(releases.glob("*/worker.py")):
        ran = subprocess.run([prefix / "bin" / "cylon", "run", "projectile", "spring_orbit", "--worker",
                              f"old=python3 {worker}", "--engine", "old"], capture_output=True, text=True, cwd=prefix.parent)
        if ran.returncode or " 0 differ" not in ran.stdout:
            sys.exit(f"the worker of release {worker.parent.name} does not run any more:\n{ran.stdout}{ran.stderr}")
    print(f"The interface of release {version()}: {len(new)} files.")


main()
