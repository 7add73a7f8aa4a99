#!/usr/bin/env python3
"""Hostile texts in every field of a scenario, through every output, each parsed back: tests/hostile/texts.py CYLON.

JSON by json, XML by expat, CSV by csv, HTML by html.parser; none of Cylon's own.  The last line is JSON: tried, failed."""
import concurrent.futures
import csv
import html.parser
import io
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.dom.minidom

HERE = pathlib.Path(__file__).resolve().parent
TEXTS = {
    "script": "<script>alert(1)</script>", "ansi": "\x1b[2J\x1b[31mred\x1b]0;pwn\x07", "c1": "\u009b31m\u0085x",
    "formula": "=cmd|'/C calc'!A0", "plus": "+1+1", "at": "@SUM(1)", "tab_formula": "\t=1+1", "wide_formula": "＝1",
    "pipe": "a|b|c\n|x|y|", "no_xml": "\x01\x02\x08\ufffe\uffff", "bidi": "\u202eevil\u2066", "long": "L" * 300000,
    "cdata": "]]><x>", "comment": "--><!--", "markdown": "[c](javascript:alert(1)) `x` # h\n## h2", "crlf": "a\r\nb",
    "json": '"},{"a":"', "zero_width": "z\u200b\ufeff", "quote": "'\"", "entity": "&lt;&#x3c;", "format": "{} {0} %s %n",
    "shell": "$(id) `id` ; id",
}
FIELDS = ("title", "story", "tag", "source", "reason")
CONTROLS = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff\ufffe\uffff]")
NUMBER = re.compile(r"[-+]?[0-9.]+(e[-+]?[0-9]+)?$")
csv.field_size_limit(1 << 30)


def quoted(text):
    return '"' + "".join(f"\\u{ord(c):04X}" if ord(c) < 32 or ord(c) == 127 else "\\" + c if c in '"\\' else c
                         for c in text) + '"'


def scene(fields, text):
    words = {"title": "t", "story": "s", "tag": "g", "source": "o/r#1", "reason": "x", "name": "ball",
             **{field: text for field in fields}}
    q = {key: quoted(word) for key, word in words.items()}
    return f"""title = {q['title']}
story = {q['story']}
tags = [{q['tag']}]
sources = [{q['source']}]
duration = 0.1
step = 0.01
gravity = [0, -9.81, 0]
[[body]]
name = {q['name']}
mass = 1
position = [0, 1, 0]
[[claim]]
follows = "projectile"
observable = "position"
body = {q['name']}
tolerance = {{ absolute = 1e-3, reason = {q['reason']} }}
"""


def in_text(text):
    found = CONTROLS.search(text)
    return [f"control {found[0]!r} after {text[max(0, found.start() - 20):found.start()]!r}"] if found else []


def in_json(text):
    json.loads(text)
    return in_text(text)


def in_xml(text):
    xml.dom.minidom.parseString(text)
    return in_text(text)


def in_csv(text):
    rows = list(csv.reader(io.StringIO(text, newline="")))
    bad = ["ragged"] if any(len(row) != len(rows[0]) for row in rows) else []
    for row in rows[1:]:
        bad += [f"formula {cell[:40]!r}" for cell in row
                if cell and cell[0] in "=+-@\t\r\n＝＋－＠" and not NUMBER.match(cell)]
    return bad + in_text(text)


class Page(html.parser.HTMLParser):
    """Scripts and handlers of a page."""

    def __init__(self):
        super().__init__()
        self.found, self.scripts = [], 0

    def handle_starttag(self, tag, attrs):
        self.scripts += tag == "script" and dict(attrs).get("type") in (None, "module")
        self.found += [f"{tag} {name}" for name, value in attrs
                       if name.startswith("on") or (value or "").strip().lower().startswith("javascript:")]


def in_html(text):
    page = Page()
    page.feed(text)
    return page.found + ([f"{page.scripts} scripts"] if page.scripts != 1 else []) + in_text(text)


OUTPUTS = [("json", in_json), ("xml", in_xml), ("csv", in_csv), ("html", in_html)]


def faults(cylon, fields, text):
    """What is wrong, and how many outputs were read."""
    with tempfile.TemporaryDirectory(prefix="cylon-texts-") as name:
        folder = pathlib.Path(name)
        (folder / "s.toml").write_text(scene(fields, text), encoding="utf8")
        environment = {**os.environ, "CYLON_KEY": name + "/key"}

        def run(*words):
            return subprocess.run([cylon, *words], cwd=folder, env=environment, capture_output=True, check=False)

        ran = run("run", "s.toml", "--engine", "in-house", "--engine", "w", "--jobs", "1", "-v", "--worker",
                  f"w=python3 {HERE}/engine.py hostile_names", "--json", "o.json", "--junit", "o.xml", "--csv", "o.csv",
                  "--html", "o.html")
        console = (ran.stdout + ran.stderr).decode("utf8")
        bad = in_text(console)
        if ran.returncode == 2 and not (folder / "o.json").exists():
            return bad, 1  # refused: a name may not hold it
        if ran.returncode not in (0, 1, 5):
            bad.append(f"exit code {ran.returncode}")
        for ending, check in OUTPUTS:
            try:
                with open(folder / f"o.{ending}", encoding="utf8", newline="") as file:
                    bad += [f"{ending}: {fault}" for fault in check(file.read())]
            except (OSError, ValueError, xml.parsers.expat.ExpatError) as error:
                bad.append(f"{ending}: {error!r}")
        bad += [f"simulate: {fault}" for fault in in_csv(run("simulate", "s.toml").stdout.decode("utf8"))]
        plan = run("plan", "s.toml")
        bad += [f"plan: {fault}" for fault in in_text((plan.stdout + plan.stderr).decode("utf8"))]
        return bad, 3 + len(OUTPUTS)


def main():
    cylon = os.path.abspath(sys.argv[1])
    cases = [(key, fields) for key in TEXTS for fields in (FIELDS, ("name",))]  # a name may be refused
    tried = failed = 0
    with concurrent.futures.ThreadPoolExecutor(max_workers=4) as pool:
        for (key, fields), (bad, count) in zip(cases, pool.map(lambda c: faults(cylon, c[1], TEXTS[c[0]]), cases)):
            tried += count
            failed += bool(bad)
            if bad:
                print(f"{key} as {', '.join(fields)}: {'; '.join(bad)[:500]}", flush=True)
    print(json.dumps({"tried": tried, "failed": failed}))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
