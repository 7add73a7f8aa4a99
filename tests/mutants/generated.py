#!/usr/bin/env python3
"""Changes single tokens of the in-house engine, one at a time, and asks the shipped claims which changes they see.

    tests/mutants/generated.py [--build build/release] [--seed 1] [--count 200] [--scenes 8] [--out FILE] [--known FILE]

All changes are compiled into one worker (target cylon-worker-mutated); CYLON_MUTANT=n chooses one when it runs, 0 none.
A change is tried in scenes whose run reaches its line, the shortest first.  It is
  killed    where some claim's status is worse than without it,
  unseen    where the motion differs by more than a thousandth of its range, and no claim is worse: the judge is blind,
  small     where the motion differs by less,
  neutral   where no bit of the motion differs,
  unreached where no shipped scene comes to its line.
Lists all but the killed ones.  Changes that are known to be unseen stand in unseen.txt beside this script, and are tried
whatever the seed draws.  Ends with 1 if another one is unseen, and if one of the list is not: it is seen now, or its statement
is no longer there.  Same seed and same engine, same changes.
"""
import argparse
import concurrent.futures
import csv
import io
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(root / "tests/hostile"))
from counted import program_of  # noqa: E402

# What a token becomes.  Each keeps the type of its expression, or the compiler says that it does not.
SWAPS = [(r"(?<=[\w)\]] )\+(?= )", "-"), (r"(?<=[\w)\]] )-(?= )", "+"), (r"(?<=[\w)\]] )\*(?= )", "/"),
         (r"(?<=[\w)\]] )/(?= )", "*"), (r"(?<= )<(?= )", ">="), (r"(?<= )>(?= )", "<="), (r"(?<= )<=(?= )", "<"),
         (r"(?<= )>=(?= )", ">"), (r"(?<= )==(?= )", "!="), (r"(?<= )!=(?= )", "=="), (r"&&", "||"), (r"\|\|", "&&"),
         (r"\bstd::max\b", "std::min"), (r"\bstd::min\b", "std::max"), (r"\bstd::sin\b", "std::cos"),
         (r"\bstd::cos\b", "std::sin"), (r"\btrue\b", "false"), (r"\bfalse\b", "true"), (r"\+=", "-="), (r"-=", "+="),
         (r"\bx\(\)", "y()"), (r"\by\(\)", "z()"), (r"\bz\(\)", "x()"), (r"(?<![\w.])2(?![\w.])", "3"),
         (r"(?<![\w.])1(?![\w.])", "2"), (r"(?<![\w.])0\.5(?![\w.])", "0.6"), (r"(?<=[(= ])-(?=\w)", "")]
# Statements on a line of their own: a return, or an assignment that declares nothing.
STATEMENT = re.compile(r"^(\s*)(return .+;|[\w.\[\]>()-]+(?:\([^()]*\))? [-+*/]?= .+;)$")
BEGINS = re.compile(r"[;{}):]\s*(//.*)?$")  # the end of the line before one that begins a statement


def candidates():
    """(file, line number, changed statement), in the order of files."""
    for path in sorted((root / "engine").rglob("*.cc")):
        lines = path.read_text().splitlines()
        before = ""
        for number, line in enumerate(lines):
            found = STATEMENT.match(line)
            if found and BEGINS.search(before) and "constexpr" not in line and "[" not in found[2].split("=")[-1]:
                for pattern, new in SWAPS:
                    for token in re.finditer(pattern, found[2]):
                        changed = found[2][:token.start()] + new + found[2][token.end():]
                        yield path.relative_to(root), number, found[2], changed
            if line.strip() and not line.strip().startswith("//"):
                before = line


def write_sources(folder, changes):
    """The engine's sources with a switch at each changed statement."""
    by_file = {}
    for index, change in enumerate(changes, 1):
        if change[2] == change[3]:  # dropped; a switch would not do in a constant expression
            continue
        by_file.setdefault(change[0], {}).setdefault(change[1], []).append((index, change))
    for path in sorted((root / "engine").rglob("*.cc")):
        lines = path.read_text().splitlines()
        for number, there in by_file.get(path.relative_to(root), {}).items():
            text = "".join(f"if (cylon_mutant({index})) {{ {change[3]} }} else " for index, change in there)
            lines[number] = f"{{ {text}{{ {there[0][1][2]} }} }}"
        new = '#include "mutant.h"\n#line 1\n' + "\n".join(lines) + "\n"
        target = folder / path.relative_to(root)
        target.parent.mkdir(parents=True, exist_ok=True)
        if not target.exists() or target.read_text() != new:
            target.write_text(new)
    (folder / "mutant.h").write_text("""#pragma once
/// Whether change `n` is the one that CYLON_MUTANT names; notes in CYLON_REACHED that its line was reached.
bool cylon_mutant(int n);
""")
    (folder / "mutant.cc").write_text("""#include "mutant.h"

#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {
int chosen() {
  const char* text = std::getenv("CYLON_MUTANT");
  return text ? std::atoi(text) : 0;
}
struct Reached {
  std::vector<bool> lines = std::vector<bool>(100000);
  ~Reached() {
    const char* name = std::getenv("CYLON_REACHED");
    std::FILE* file = name ? std::fopen(name, "a") : nullptr;
    if (!file) return;
    for (std::size_t n = 0; n < lines.size(); ++n)
      if (lines[n]) std::fprintf(file, "%zu\\n", n);
    std::fclose(file);
  }
};
}  // namespace

bool cylon_mutant(int n) {
  static const int one = chosen();
  static Reached reached;
  reached.lines[static_cast<std::size_t>(n)] = true;
  return n == one;
}
""")


def build(options, changes):
    """Compiles; a change that does not compile is replaced by none, in place, so that numbers stay."""
    folder = options.build / "mutated"
    dropped = set()
    while True:
        write_sources(folder, [c for c in changes])
        done = subprocess.run(["ninja", "-C", options.build, "-k", "0", "cylon-worker-mutated"], capture_output=True, text=True)
        if done.returncode == 0:
            return dropped
        wrong = {(m[1], int(m[2]) - 1) for m in re.finditer(r"(engine/[\w/]+\.cc):(\d+):\d+: error", done.stdout)}
        new = {i for i, c in enumerate(changes) if c and (str(c[0]), c[1]) in wrong}
        if not new - dropped:
            sys.exit(done.stdout[-4000:])
        for i in new:
            changes[i] = (changes[i][0], changes[i][1], changes[i][2], changes[i][2])
        dropped |= new


def set_programs_aside(options):
    """Copies of the programs, which no later build replaces; beside the build folder, where cylon finds its scenarios."""
    options.programs = (options.build.parent / "mutated").resolve()
    options.programs.mkdir(exist_ok=True)
    for name in ("cylon", "cylon-worker-mutated"):
        shutil.copy2(options.build / name, options.programs / name)


def worker(options, mutant, reached=None):
    words = ["env", f"CYLON_MUTANT={mutant}"] + ([f"CYLON_REACHED={reached}"] if reached else [])
    return "mutated=" + " ".join(words + [str((options.programs / "cylon-worker-mutated").resolve())])


def claims(options, scene, spec):
    """claim -> status of one run, as its file states it and by theory."""
    found = {}
    for way in ([], ["--theory"]):
        with tempfile.TemporaryDirectory() as folder:  # one run at a time may work in a folder
            done = subprocess.run([options.programs / "cylon", "run", scene, "--worker", spec, "--engine", "mutated",
                                   *way, "--timeout", "10", "--json", "-"], capture_output=True, text=True, cwd=folder)
        try:
            rows = json.loads(done.stdout)["verdicts"]
        except (ValueError, KeyError):
            continue  # no table [theory]
        found |= {" ".join(way + [row["claim"]]): row["status"] for row in rows}
    return found


def motion(options, scene, spec):
    """Rows of positions, or None where the run does not end."""
    done = subprocess.run([options.programs / "cylon", "simulate", scene, "--engine", "mutated", "--worker", spec,
                           "--timeout", "10"], capture_output=True, text=True)
    if done.returncode != 0:
        return None
    rows = list(csv.reader(io.StringIO(done.stdout)))[1:]
    return [[float(x) for x in row[2:9]] for row in rows], done.stdout


def difference(first, second):
    """Largest difference of places and turns, as a part of the range of the places (turns: of 1)."""
    if len(first) != len(second):
        return float("inf")
    spread = max(max(row[k] for row in first) - min(row[k] for row in first) for k in range(3)) or 1
    worst = 0
    for a, b in zip(first, second):
        places = max(abs(x - y) for x, y in zip(a[:3], b[:3])) / spread
        turns = min(max(abs(x - s * y) for x, y in zip(a[3:], b[3:])) for s in (1, -1))
        d = max(places, turns)
        if not d <= worst:
            worst = d
    return worst


def listed_as_unseen(file):
    """(file, statement, changed statement) -> scene, of the changes that are known to be unseen."""
    rows = [line.split("\t") for line in file.read_text().splitlines() if line and not line.startswith("#")]
    return {tuple(row[:3]): row[3] for row in rows}


def named(change):
    """A change without its line, which moves."""
    return str(change[0]), change[2], change[3]


def differences(known, judged):
    """What the list of unseen changes says otherwise than the verdicts, (named change, verdict, scene) each, in words."""
    unseen = {name for name, verdict, _ in judged if verdict == "unseen"}
    for name, verdict, scene in judged:
        if verdict == "unseen" and name not in known:
            yield f"new, unseen in {scene}: {' | '.join(name)}"
    for name in known:
        if name not in unseen:
            now = [f"{verdict} {scene}".strip() for one, verdict, scene in judged if one == name]
            yield f"listed as unseen, but {now[0] if now else 'there is no such statement'}: {' | '.join(name)}"


ORDER = ["pass", "undecided", "low-quality", "fail", "non-finite", "unsupported", "timeout", "crash", "protocol"]


def worse(status, plain):
    rank = lambda s: ORDER.index(s) if s in ORDER else len(ORDER)
    return rank(status) > rank(plain)


def judge(options, mutant, scenes, plain):
    """By the first scenes; and, while no claim sees a large change, by all."""
    verdict, most = "neutral", 0
    for tried, scene in enumerate(scenes):
        if tried >= options.scenes and verdict != "unseen":
            break
        spec = worker(options, mutant)
        now = claims(options, scene, spec)
        if any(worse(now.get(claim, "crash"), status) for claim, status in plain[scene]["claims"].items()):
            return "killed", scene, 0
        moved = motion(options, scene, spec)
        if moved is None or plain[scene]["motion"] is None:
            continue
        if moved[1] == plain[scene]["motion"][1]:
            continue
        d = difference(plain[scene]["motion"][0], moved[0])
        if verdict == "neutral" or d > most or d != d:
            large = not d <= 1e-3 and not plain[scene]["chaotic"]  # there any change becomes large
            verdict, most, where = ("unseen" if large else "small"), d, scene
    return verdict, where if verdict != "neutral" else "", most


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=root / "build" / "release")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--scenes", type=int, default=8, help="scenes for each change that moves little")
    parser.add_argument("--out", type=pathlib.Path, help="one JSON line for each change; goes on where it ended")
    parser.add_argument("--known", type=pathlib.Path, default=pathlib.Path(__file__).with_name("unseen.txt"))
    options = parser.parse_args()

    every = list(candidates())
    changes = random.Random(options.seed).sample(every, min(options.count, len(every)))
    print(f"{len(every)} changes are possible; {len(changes)} drawn with seed {options.seed}", flush=True)
    on_list = listed_as_unseen(options.known)
    changes += [change for change in every if named(change) in on_list and change not in changes]
    dropped = build(options, changes)
    set_programs_aside(options)
    programs = " ".join(program_of(options.programs / name) for name in ("cylon", "cylon-worker-mutated"))
    print(f"{len(dropped)} do not compile", flush=True)

    listed = json.loads(subprocess.run([options.programs / "cylon", "list", "--json"], capture_output=True,
                                       text=True, check=True).stdout)
    def run_plain(row):
        scene, log = row["name"], options.build / "mutated" / f"reached-{row['name']}.txt"
        log.unlink(missing_ok=True)
        found = claims(options, scene, worker(options, 0, log))
        lines = {int(line) for line in log.read_text().split()} if log.exists() else set()
        steps, chaotic = row.get("duration", 0) / row.get("step", 1), "chaos" in row["tags"]
        return scene, found, lines, {"claims": found, "motion": motion(options, scene, worker(options, 0)),
                                     "cost": steps, "chaotic": chaotic}

    plain, reached = {}, {}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for scene, found, lines, known in pool.map(run_plain, listed):
            if not found:
                continue
            plain[scene] = known
            for line in lines:
                reached.setdefault(line, set()).add(scene)
    print(f"{len(plain)} scenes", flush=True)

    done = {}
    if options.out and options.out.exists():
        done = {(r.get("programs"), r["number"]): r for r in map(json.loads, options.out.read_text().splitlines())}
    def judge_one(number):
        row = done.get((programs, number))
        if row:
            return row
        scenes = sorted(reached.get(number, ()), key=lambda s: (plain[s]["cost"], s))
        verdict, where, size = judge(options, number, scenes, plain) if scenes else ("unreached", "", 0)
        file, line, was, now = changes[number - 1]
        return {"programs": programs, "number": number, "file": str(file), "line": line + 1, "was": was, "is": now,
                "verdict": verdict, "scene": where, "moved": size}

    counts, judged = {}, []
    numbers = [n for n in range(1, len(changes) + 1) if n - 1 not in dropped]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for row in pool.map(judge_one, numbers):
            judged.append((named(changes[row["number"] - 1]), row["verdict"], row["scene"]))
            if options.out and (programs, row["number"]) not in done:
                with options.out.open("a") as kept:
                    kept.write(json.dumps(row) + "\n")
            counts[row["verdict"]] = counts.get(row["verdict"], 0) + 1
            if row["verdict"] != "killed":
                print(f"{row['verdict']:9} {row['file']}:{row['line']}: {row['was']}  ->  {row['is']}  "
                      f"[{row['scene']} {row['moved']:.1e}]", flush=True)
    print(", ".join(f"{counts[k]} {k}" for k in sorted(counts)))
    wrong = list(differences(on_list, judged))
    print("\n".join(wrong), end="\n" if wrong else "")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
