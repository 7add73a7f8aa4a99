"""What a campaign has tried so far: kept in tests/hostile/counts/NAME.json, which is committed, so that it goes on where it
was stopped, on any machine, and so that docs/security.py can tell.  Counts are of one program: those of another are put
aside, in the list "before" of their part, and are added to no others."""
import hashlib
import json
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
FOLDER = HERE / "counts"


def program_of(program):
    """Changes with the code of the program, and with it the places of calls."""
    code = subprocess.run(["objcopy", "-O", "binary", "--only-section=.text", program, "/dev/stdout"], capture_output=True,
                          check=True).stdout
    return hashlib.sha256(code).hexdigest()[:12]


def commit():
    """Of the working tree, marked where it differs from it; "unknown" outside a repository."""
    said = subprocess.run(["git", "describe", "--always", "--dirty", "--exclude", "*"], cwd=HERE, capture_output=True, text=True,
                          check=False)
    return said.stdout.strip() or "unknown"


class Counted:
    """Numbers and words by part and key, written whole after every change; without a name they are not kept."""

    def __init__(self, name=None):
        self.file = FOLDER / f"{name}.json" if name else None
        self.parts = json.loads(self.file.read_text()) if name and self.file.exists() else {}

    def get(self, part, key):
        return self.parts.get(part, {}).get(key, 0)

    def add(self, part, **numbers):
        self.set(part, **{key: self.get(part, key) + number for key, number in numbers.items()})

    def set(self, part, **values):
        self.parts.setdefault(part, {}).update(values)
        self.write()

    def write(self):
        if not self.file:
            return
        FOLDER.mkdir(exist_ok=True)
        draft = self.file.with_suffix(".draft")
        draft.write_text(written(self.parts))
        os.replace(draft, self.file)

    def total(self, key):
        return sum(row.get(key, 0) for row in self.parts.values())

    def may_go_on(self, part, program, anew):
        """Whether trials of this program may be added to the part: it has none, it has those of the same program, or those
        of another are put aside, as `anew` asks.  Says so where they stand in the way."""
        row = self.parts.get(part, {})
        if row.get("program") == program:
            return True
        if any(key not in ("program", "commit", "before") for key in row):
            if not anew:
                print(f"{part}: the counts are of another program, of commit {row.get('commit', 'unknown')}; --anew begins again",
                      file=sys.stderr)
                return False
            old = {key: value for key, value in row.items() if key not in ("before", "last", "open")}
            # What is open is asked of every program until it is none.
            row = {key: row[key] for key in ("open",) if key in row} | {"before": row.get("before", []) + [old]}
        self.parts[part] = {**row, "program": program, "commit": commit()}
        self.write()
        return True


def written(parts):
    """JSON, one part a line, in the order of their names."""
    lines = (f" {json.dumps(name)}: {json.dumps(row, sort_keys=True)}" for name, row in sorted(parts.items()))
    return "{\n" + ",\n".join(lines) + "\n}\n"
