#!/usr/bin/env python3
"""Compares two JSON reports of `cylon run`: equal bit for bit but for texts and times.

    tests/same_verdicts.py OLD.json NEW.json

Prints what differs and exits with 1 where anything but a text does. Differences of truth_error, the bound of a truth's own
error, are listed apart and count as well.
"""
import collections
import json
import sys

# What a row is of; the n-th row of an identity is compared with the n-th.
IDENTITY = ("scenario", "engine", "path", "integrator", "dt", "claim", "observable")
# Sentences for a reader, and what a run costs.
TEXTS = {"unforceable", "expected_reason", "reason", "detail", "stderr", "reproduce"}
TIMES = {"cpu_seconds", "cpu_verified"}


def rows(path):
    # Numbers stay as they are written: two spellings of a double are two doubles, or another writer.
    with open(path, encoding="utf-8") as file:
        document = json.load(file, parse_float=str, parse_int=str, parse_constant=str)
    found, count = {}, collections.Counter()
    for row in document["verdicts"]:
        key = tuple(json.dumps(row.get(k)) for k in IDENTITY)
        count[key] += 1
        found[(*key, count[key])] = row
    if not found:
        sys.exit(f"{path} has no verdicts")
    return found


def named(key):
    return " ".join(json.loads(k) or "-" for k in key[:-1]) + (f" #{key[-1]}" if key[-1] > 1 else "")


def differences(old, new, at=""):
    """(key, old value, new value) of every leaf that differs; a key that one side lacks has None."""
    if isinstance(old, dict) and isinstance(new, dict):
        for key in [*old, *(k for k in new if k not in old)]:
            yield from differences(old.get(key), new.get(key), f"{at}.{key}" if at else key)
    elif isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
        for i, (a, b) in enumerate(zip(old, new)):
            yield from differences(a, b, f"{at}[{i}]")
    elif old != new:
        yield at, old, new


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    old, new = rows(sys.argv[1]), rows(sys.argv[2])
    values, truths, texts = [], [], collections.Counter()
    if old.keys() == new.keys() and list(old) != list(new):
        values.append("the same rows in another order")
    for key in old.keys() | new.keys():
        if key not in old or key not in new:
            values.append(f"{named(key)}: only in {sys.argv[1] if key in old else sys.argv[2]}")
            continue
        for at, before, now in differences(old[key], new[key]):
            name = at.split(".")[0].split("[")[0]
            if name in TEXTS | TIMES:
                texts[name] += 1
            else:
                line = f"{named(key)}: {at}: {before} -> {now}"
                (truths if name == "truth_error" else values).append(line)
    for title, lines in (("Values that differ", values), ("Errors of truths that differ", truths)):
        if lines:
            print(f"{title}:", *sorted(lines), sep="\n  ")
    print(f"{len(old.keys() & new.keys())} rows compared, {len(values)} values and {len(truths)} errors of truths differ;"
          f" texts and times: {dict(texts) or 'none'}")
    return 1 if values or truths else 0


if __name__ == "__main__":
    sys.exit(main())
