"""What a campaign has tried so far: kept in build/campaigns/NAME.json, so that it goes on where it was stopped, and so
that docs/security.py can tell."""
import json
import os
import pathlib

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "build/campaigns"


class Counted:
    """Numbers by part and key, written whole after every change; without a name they are not kept."""

    def __init__(self, name=None):
        self.file = FOLDER / f"{name}.json" if name else None
        self.parts = json.loads(self.file.read_text()) if name and self.file.exists() else {}

    def get(self, part, key):
        return self.parts.get(part, {}).get(key, 0)

    def add(self, part, **numbers):
        row = self.parts.setdefault(part, {})
        for key, number in numbers.items():
            row[key] = round(row.get(key, 0) + number, 3)
        if not self.file:
            return
        FOLDER.mkdir(parents=True, exist_ok=True)
        draft = self.file.with_suffix(".draft")
        draft.write_text(json.dumps(self.parts, indent=1, sort_keys=True) + "\n")
        os.replace(draft, self.file)

    def total(self, key):
        return sum(row.get(key, 0) for row in self.parts.values())
