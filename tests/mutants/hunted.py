#!/usr/bin/env python3
"""Looks for the faults of mutants as `cylon hunt` does, and for none in right simulators; counts, and goes on.

    tests/mutants/hunted.py [--build build/release] [--draw 40] [--seed 1] [--scenes 5000] [--seconds 120] [--jobs 2]
    tests/mutants/hunted.py --right 1000      scenes of each right simulator, beside those that were asked before

The seed draws the mutants, and makes the scenes.  A mutant is done when a scene has a fault, or when it was asked that many
scenes or that long, all calls together.  Counts are kept in tests/hostile/counts/hunted.json, by seed.  The last line is
JSON.  Exit codes: 0, 1 where a right simulator has a fault, 2 where the tool `hunted` is not built."""
import argparse
import json
import pathlib
import random
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/hostile"))
from counted import Counted  # noqa: E402


def names(tool):
    mutants, right = subprocess.run([tool, "--list"], capture_output=True, text=True, check=True).stdout.split("--\n")
    return mutants.splitlines(), right.splitlines()


def hunt(tool, name, options, counted, part, scenes, seconds):
    """Asks further scenes, and adds them to the counts."""
    asked = counted.get(part, "scenes")
    begun = time.monotonic()
    out = subprocess.run([tool, name, "--seed", str(options.seed), "--first", str(asked), "--scenes", str(scenes),
                          "--seconds", str(seconds), "--jobs", str(options.jobs)],
                         capture_output=True, text=True, check=True).stdout
    result = json.loads(out)
    counted.add(part, scenes=result["scenes"], refused=result["refused"], seconds=round(time.monotonic() - begun, 1))
    if "broken" in result:
        counted.set(part, found=result["number"], broken=", ".join(result["broken"]), family=result["family"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default="build/release")
    parser.add_argument("--draw", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--scenes", type=int, default=5000)
    parser.add_argument("--seconds", type=float, default=120)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--right", type=int, default=0)
    options = parser.parse_args()
    tool = ROOT / options.build / "hunted"
    if not tool.exists():
        print(f"{tool} is not built: cmake --build {options.build} --target hunted", file=sys.stderr)
        return 2
    mutants, right = names(tool)
    counted = Counted("hunted")
    part = "seed {} {}: {}".format
    if options.right:
        for name in right:
            key = part(options.seed, "right", name)
            hunt(tool, name, options, counted, key, options.right, 1e9)
            print(f"{name}: {counted.get(key, 'scenes')} scenes, {counted.get(key, 'broken') or 'no fault'}", flush=True)
        keys = [part(options.seed, "right", name) for name in right]
        faulty = [key for key in keys if counted.get(key, "broken")]
        print(json.dumps({"right": len(right), "scenes": sum(counted.get(key, "scenes") for key in keys), "faulty": len(faulty)}))
        return 1 if faulty else 0
    drawn = random.Random(options.seed).sample(mutants, min(options.draw, len(mutants)))
    print(f"{len(drawn)} of {len(mutants)} mutants, drawn by seed {options.seed}")
    for name in drawn:
        key = part(options.seed, "mutant", name)
        scenes, seconds = options.scenes - counted.get(key, "scenes"), options.seconds - counted.get(key, "seconds")
        if not counted.get(key, "broken") and scenes > 0 and seconds > 1:
            hunt(tool, name, options, counted, key, scenes, seconds)
        said = (f"scene {counted.get(key, 'found')} ({counted.get(key, 'family')}): {counted.get(key, 'broken')}"
                if counted.get(key, "broken") else f"not found in {counted.get(key, 'scenes')} scenes")
        print(f"{name}: {said}", flush=True)
    keys = [part(options.seed, "mutant", name) for name in drawn]
    print(json.dumps({"drawn": len(drawn), "found": sum(bool(counted.get(key, "broken")) for key in keys),
                      "scenes": sum(counted.get(key, "scenes") for key in keys)}))
    return 0


if __name__ == "__main__":
    sys.exit(main())
