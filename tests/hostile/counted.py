"""What a campaign has tried so far: kept in tests/hostile/counts/NAME.json, which is committed, so that it goes on where it
was stopped, on any machine, and so that docs/security.py can tell."""
import json
import os
import pathlib

FOLDER = pathlib.Path(__file__).resolve().parent / "counts"


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
        if not self.file:
            return
        FOLDER.mkdir(exist_ok=True)
        draft = self.file.with_suffix(".draft")
        draft.write_text(written(self.parts))
        os.replace(draft, self.file)

    def total(self, key):
        return sum(row.get(key, 0) for row in self.parts.values())


def written(parts):
    """JSON, one part a line, in the order of their names."""
    lines = (f" {json.dumps(name)}: {json.dumps(row, sort_keys=True)}" for name, row in sorted(parts.items()))
    return "{\n" + ",\n".join(lines) + "\n}\n"
