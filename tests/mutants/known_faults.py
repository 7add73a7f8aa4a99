#!/usr/bin/env python3
"""Whether `cylon hunt` finds by itself what engines are known to do wrong; counts, and goes on.

    tests/mutants/known_faults.py [--build build/release] [--seed 1] [--scenes 300] [--engine ROW ...] [--seconds 900] [--jobs 1]
    tests/mutants/known_faults.py --table      the counts as the table of docs/hunt.md, without a hunt

Each row of engines is asked `cylon hunt --engine ROW --count SCENES --seed S`, in a folder of its own under the build, where a
row that took longer than --seconds is resumed by the next call.  A fault is found where a card has its oracle and its parts, and,
where the engine has a setting without the fault's cause, is gone with that setting (and there with one that leaves the cause).
Counts are kept in tests/hostile/counts/known_faults.json.  Exit codes: 0, 1 where a row did not end, 2 where cylon is not
built."""
import argparse
import json
import pathlib
import re
import subprocess
import sys
import time
from dataclasses import dataclass

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/hostile"))
from counted import Counted  # noqa: E402


@dataclass
class Fault:
    """What a card of it has: one of the oracles, all of the parts, none of those without, so many bodies."""
    engine: str
    name: str
    where: str  # source, or the measurement that told of it
    oracles: str  # separated by commas; "*" at the end: any that begins so
    parts: str = ""
    without: str = ""
    bodies: int = 1  # at least
    gone: str = ""   # engine with a setting in which the cause is not
    there: str = ""  # engine with a setting in which the cause of a fault that looks alike is not

    def looks_like(self, card):
        parts = re.sub(r"^.*?: \d+ bod(y|ies)(, )?", "", card["signature"]).split(", ")
        names = [one.strip() for one in self.oracles.split(",")]
        said = any(card["oracle"] == one or (one.endswith("*") and card["oracle"].startswith(one[:-1])) for one in names)
        return said and bodies(card) >= self.bodies and set(self.parts.split()) <= set(parts) and not set(self.without.split()) & set(parts)

    def is_shown_by(self, card, options, folder):
        return (self.looks_like(card) and (not self.gone or replayed(options, folder, card, self.gone) == "fixed")
                and (not self.there or replayed(options, folder, card, self.there) in ("still there", "changed")))

    def key(self, seed):
        return f"seed {seed} {self.engine}: {self.name}"


BLOW = "energy, energy from nowhere, speed"
FAULTS = [
    Fault("bullet", "turns are clamped to pi/4 a step", "LinearMath/btTransformUtil.h:53", "spin, turn", "sphere", "plane"),
    Fault("bullet", "a sliding box is not braked by mu m g", "S10: -0.095 m of 1.18 m at 1 ms", "slide", "friction"),
    Fault("bullet/path=as-shipped", "speculative contacts eat the bounce", "contact made before the touch, bounce less gap/dt",
          "rebound, energy", "sphere restitution", gone="bullet/path=as-shipped,contact-threshold=0,erp2=0"),
    Fault("bullet/path=as-shipped", "Baumgarte's correction gives energy", "S3: +25 % at 0.1 ms", "energy from nowhere, speed",
          "sphere restitution", "gravity plane", gone="bullet/path=as-shipped,erp2=0,split-threshold=0"),
    Fault("ode", "stacks are dropped", "lcp.cpp:1067, 'LCP internal error'", "rest, statics, penetration", "box plane gravity",
          gone="ode/stepper=quick"),
    Fault("ode", "the hitter of a row passes through", "S12, lcp.cpp:1067", "penetration", "sphere", "plane gravity",
          gone="ode/stepper=quick"),
    Fault("ode", "friction is a pyramid", "joints/contact.cpp:220", "slide", "friction", gone="ode/friction-direction=slip"),
    Fault("ode", "the gyroscopic term drains energy", "step.cpp:642", "energy, angular momentum", "box", "plane"),
    Fault("mujoco", "contacts yield", "engine_core_constraint.c:1023", "rest, penetration", "plane gravity",
          gone="mujoco/solref-time=1e-9"),
    Fault("mujoco", "friction is a pyramid", "docs/engines.md", "slide", "friction", gone="mujoco/cone=elliptic"),
    Fault("mujoco", "sliding friction hops", "doc/computation.rst:38", "slide", "friction", there="mujoco/cone=elliptic"),
    Fault("mujoco", "the explicit gyroscopic term gives energy", "engine_forward.c:487", "energy*, non-finite, speed, angular momentum",
          "box", "plane"),
    Fault("jolt", "an elastic row loses energy", "S12: -2.3 %", BLOW, "sphere restitution", "gravity plane",
          gone="jolt/velocity-steps=100"),
    Fault("jolt", "the gyroscopic term gives energy", "S6: +64 % at 1/240", "energy*, speed, angular momentum", "box", "plane"),
    Fault("jolt", "a stack under a heavy top falls", "S11", "rest", "box plane gravity"),
    Fault("jolt/path=as-shipped", "damping of 0.05 by default", "mLinearDamping", "linear momentum, place, energy", "", "plane box"),
    Fault("jolt/path=as-shipped", "spins are capped at 47 rad/s", "mMaxAngularVelocity", "angular momentum, spin, turn", "sphere", "plane"),
    Fault("jolt/path=as-shipped", "slow impacts do not bounce", "mMinVelocityForRestitution 1 m/s", "rebound, energy", "restitution"),
    Fault("jolt/path=as-shipped", "no gyroscopic term by default", "mApplyGyroscopicForce", "angular momentum", "box", "plane"),
    Fault("rapier", "an elastic row loses energy", "S12: -30 %", BLOW, "sphere restitution", "gravity plane"),
    Fault("rapier", "an oblique blow changes angular momentum", "S3: 5.7 % at 1/60", "angular momentum", "sphere", bodies=2),
    Fault("rapier", "spins are cut to pi/4 a step", "FoundFaults.OfAFastSpin", "angular momentum, spin, energy", "sphere", "restitution"),
    Fault("rapier", "a stack under a heavy top falls", "S11", "rest", "box plane gravity"),
    Fault("physx", "an elastic row loses energy", "S12: -16 %", BLOW, "sphere restitution", "gravity plane"),
    Fault("physx", "a stack under a heavy top falls", "S11", "rest", "box plane gravity"),
    Fault("physx/path=as-shipped", "angular damping of 0.05 by default", "setAngularDamping", "angular momentum, turn, energy", "", "plane box"),
    Fault("physx/path=as-shipped", "spins are capped at 100 rad/s", "setMaxAngularVelocity", "angular momentum, spin, turn", "sphere", "plane"),
    Fault("physx/path=as-shipped", "slow impacts do not bounce", "bounceThresholdVelocity 2 m/s", "rebound, energy", "restitution"),
    Fault("physx/path=as-shipped", "no gyroscopic term by default", "eENABLE_GYROSCOPIC_FORCES", "angular momentum", "box", "plane"),
    Fault("havok", "inverse masses have 8 bits", "S3: 1.1 % of the momentum with 1 : 3", "linear momentum", "sphere"),
    # The energy dips for the one step for which Havok holds balls between a blow and its rebound, whatever is lost by it.
    Fault("havok", "a blow loses energy", "S3: -6 %, S13", "rebound", "sphere restitution"),
    Fault("havok", "a sliding box is not braked by mu m g", "S10: 10 % too little way", "slide", "friction"),
    Fault("havok", "a stack under a heavy top falls", "S11", "rest", "box plane gravity"),
    Fault("havok/path=stand-in", "no gyroscopic term", "S6, S7: the spin stays", "angular momentum", "box", "plane"),
]


def replayed(options, folder, card, engine):
    """What `cylon hunt --replay` says of one card on an engine."""
    alone = folder / "alone"
    alone.mkdir(exist_ok=True)
    for file in alone.iterdir():
        file.unlink()
    (alone / f"{card['name']}.toml").write_text(card["scenario"])
    out = subprocess.run([options.build / "cylon", "hunt", "--replay", "alone", "--engine", engine], cwd=folder, capture_output=True, text=True)
    if out.returncode not in (0, 1):
        sys.exit(f"{engine}: {out.stderr}")
    return re.search(r"(fixed|still there|changed|refused)[^\n]*$", out.stdout.strip())[1]


def bodies(card):
    return card["scenario"].count("[[body]]")


def scene(card):
    return int(re.match(r"scene (\d+)", card["found_in"])[1])


def hunt(options, row, counted):
    """Asks a row its scenes, unless it was; whether it came to the end."""
    part = f"seed {options.seed} {row}"
    if counted.get(part, "scenes") >= options.scenes:
        return True
    folder = options.build / "known_faults" / re.sub(r"\W+", "-", row)
    folder.mkdir(parents=True, exist_ok=True)
    begun = time.monotonic()
    try:
        out = subprocess.run([options.build / "cylon", "hunt", "--engine", row, "--count", str(options.scenes), "--seed",
                              str(options.seed), "--jobs", str(options.jobs), "--cards", "cards", "--json", "cards.json", "--resume"],
                             cwd=folder, capture_output=True, text=True, timeout=options.seconds)
    except subprocess.TimeoutExpired:
        return False
    if out.returncode not in (0, 1):
        sys.exit(f"{row}: {out.stderr}")
    cards = json.loads((folder / "cards.json").read_text())["cards"]
    counted.set(part, scenes=options.scenes, seconds=round(time.monotonic() - begun, 1), cards=len(cards))
    for fault in FAULTS:
        shown = [card for card in cards if fault.engine == row and fault.is_shown_by(card, options, folder)]
        if shown:
            first, least = min(shown, key=scene), min(shown, key=bodies)
            counted.set(fault.key(options.seed), found=scene(first), bodies=bodies(least), card=least["signature"])
    return True


def table(options, counted):
    lines = ["| engine | known fault | where | found by scene | bodies | card |", "|---|---|---|---|---|---|"]
    for fault in FAULTS:
        asked = counted.get(f"seed {options.seed} {fault.engine}", "scenes")
        key = fault.key(options.seed)
        card = counted.get(key, "card")
        said = (f"{counted.get(key, 'found')} | {counted.get(key, 'bodies')} | {card}" if card
                else f"not in {asked} | | " if asked else "not asked | | ")
        lines.append(f"| {fault.engine} | {fault.name} | {fault.where} | {said} |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--scenes", type=int, default=300)
    parser.add_argument("--engine", action="append")
    parser.add_argument("--seconds", type=float, default=900)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--table", action="store_true")
    options = parser.parse_args()
    options.build = options.build.resolve()
    if not (options.build / "cylon").exists():
        print(f"{options.build / 'cylon'} is not built", file=sys.stderr)
        return 2
    counted = Counted("known_faults")
    rows = [] if options.table else options.engine or list(dict.fromkeys(fault.engine for fault in FAULTS))
    unfinished = []
    for row in rows:
        if not hunt(options, row, counted):
            unfinished.append(row)
            print(f"{row}: not finished in {options.seconds:.0f} s; the next call goes on", file=sys.stderr, flush=True)
    print(table(options, counted))
    return 1 if unfinished else 0


if __name__ == "__main__":
    sys.exit(main())
