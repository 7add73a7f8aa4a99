#!/usr/bin/env python3
"""Writes the table "The influence of the build" of docs/speed-against-accuracy.md from what the benches printed.

    ./run bench --huge >debian.txt; ./run bench rebuilt >rebuilt.txt; ./run bench native >native.txt
    docs/whose_build.py debian.txt rebuilt.txt native.txt
"""
import pathlib
import re
import sys

page = pathlib.Path(__file__).resolve().parent / "speed-against-accuracy.md"
HEADINGS = (  # what a line says of the lines below it
    (re.compile(r"^\d+ (S\d .*|chain .*), [\d.]+ s$"), lambda m: m[1]),
    (re.compile(r"^S2, "), lambda m: "bouncing ball"),
    (re.compile(r"^S13, "), lambda m: "gas of 1000"),
    (re.compile(r"^(\d+) (.+) bodies, (\w+)$"), lambda m: f"{m[1]} {m[2]}, {m[3]}"),
    (re.compile(r"^ *(\d+)  \d+ steps of 1/60 s, layers"), lambda m: f"pile of {m[1]}"),
)
ERROR = re.compile(r"^  error <= (\S+)")
RATIOS = (  # how, whom, ratio
    re.compile(r"^    (?P<how>)vs (?P<whom>\w+) +(?P<ratio>\d+)x(?:.*\(in steps: (?P<stepped>\d+)x)?"),
    re.compile(r"^  (?P<how>)vs (?P<whom>\w+): (?P<ratio>\d+)x(?P<stepped>)"),
    re.compile(r"^    (?P<how>\S.*\S) +vs (?P<whom>\w+) +(?P<ratio>\d+)x(?P<stepped>)"),
    re.compile(r"^ +(?P<how>)\S+ with overlap .* vs (?P<whom>\S+): (?P<ratio>[\d.]+)x(?P<stepped>)"),
)


def ratios(text):
    """(scene, error, whom) -> ratio, in the order of the text."""
    found, scene, error = {}, "", ""
    for line in text.splitlines():
        for pattern, name in HEADINGS:
            if m := pattern.match(line):
                scene, error = name(m), ""
        if m := ERROR.match(line):
            error = m[1]
        for pattern in RATIOS:
            if m := pattern.match(line):
                found[scene + (f", {m['how']}" if m["how"] else ""), error, m["whom"]] = m["ratio"]
                if m["stepped"]:
                    found[scene + ", in steps", error, m["whom"]] = m["stepped"]
                break
    return found


def main(files):
    columns = [ratios(pathlib.Path(file).read_text()) for file in files]
    rows = ["| scene | error [m, rad] | against | Debian's packages | rebuilt | all native |", "|---|---|---|---|---|---|"]
    for key in columns[0]:
        rows.append(f"| {' | '.join(key)} | {' | '.join(c.get(key, '–') for c in columns)} |")
    begin, end = "<!-- begin: builds -->\n", "<!-- end: builds -->\n"
    before, rest = page.read_text().split(begin)
    page.write_text(before + begin + "\n" + "\n".join(rows) + "\n\n" + end + rest.split(end)[1])


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(sys.argv[1:])
