#!/usr/bin/env python3
"""Writes the tables of docs/fairness.md: settings of Bullet and ODE, and what each changes over all scenarios but the measured ones.

    docs/fairness.py [--cylon build/release/cylon] [--kept FOLDER] [--check]

Runs every scenario once for each setting below, which takes half an hour, and reads defaults and forced values from the
program.  Runs are kept by the contents of the program, of the engine's worker and of the scenarios.  Fails where the program
has an option that no line here tries.

--check takes seconds: the blocks that need no run must be current; those of the rows must follow from the marks that the page
keeps in a comment; and a sample of the scenarios, run again, must give these marks.
"""
import argparse
import hashlib
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parent.parent
page = root / "docs" / "fairness.md"

ROWS = {"bullet": ["bullet", "bullet/path=as-shipped", "bullet/path=as-expert", "bullet-multibody"],
        "ode": ["ode", "ode-quick", "ode/path=as-shipped", "ode/path=as-expert"]}

INFO = "src/BulletDynamics/ConstraintSolver/btContactSolverInfo.h"
DYNAMICS, COLLISION = "src/BulletDynamics/", "src/BulletCollision/"
# Of an engine: the row that a setting is tried on, and of each setting its option, the value that is tried (the engine's default
# where a path of ours forces another), its name among the settings of a run, and where the engine's source has it.
SETTINGS = {
    "bullet": {
        "bullet": [
            ("sleeping", "sleeping=on", "activation state, canSleep", COLLISION + "CollisionDispatch/btCollisionObject.cpp:34"),
            ("margin", "margin=0.04", "setMargin", COLLISION + "CollisionShapes/btCollisionMargin.h:22"),
            ("restitution-threshold", "restitution-threshold=0.2", "m_restitutionVelocityThreshold", INFO + ":108"),
            ("contact-threshold", "contact-threshold=1e18", "contactProcessingThreshold", COLLISION + "CollisionDispatch/btCollisionObject.h:188"),
            ("stop-erp", "stop-erp=0.2", "m_stopERP", DYNAMICS + "ConstraintSolver/btGeneric6DofSpring2Constraint.h:76"),
            ("stops-ahead", "stops-ahead=off", "stops by btGeneric6DofSpring2Constraint", DYNAMICS + "ConstraintSolver/btGeneric6DofSpring2Constraint.h:312"),
            ("erp2", "erp2=0.2", "m_erp2", INFO + ":87"),
            ("split-threshold", "split-threshold=-0.04", "m_splitImpulsePenetrationThreshold", INFO + ":96"),
            ("ccd", "ccd=0.9", "setCcdSweptSphereRadius, setCcdMotionThreshold", COLLISION + "CollisionDispatch/btCollisionObject.h:506"),
            ("speculative-restitution", "ccd=0.9,speculative-restitution=on", "setApplySpeculativeContactRestitution", DYNAMICS + "Dynamics/btDiscreteDynamicsWorld.h:209"),
            ("plane-queries", "plane-queries=3", "setPlaneConvexMultipointIterations", COLLISION + "CollisionDispatch/btDefaultCollisionConfiguration.h:108"),
            ("convex-queries", "convex-queries=3", "setConvexConvexMultipointIterations", COLLISION + "CollisionDispatch/btDefaultCollisionConfiguration.h:106"),
            ("breaking-threshold", "breaking-threshold=0.1", "gContactBreakingThreshold", COLLISION + "NarrowPhaseCollision/btPersistentManifold.h:30"),
            ("iterations", "iterations=200", "m_numIterations", INFO + ":85"),
            ("solver", "solver=dantzig", "constraint solver", DYNAMICS + "MLCPSolvers/btDantzigSolver.h"),
            ("solver", "solver=nncg,iterations=50", "constraint solver", DYNAMICS + "ConstraintSolver/btNNCGConstraintSolver.h"),
            ("gyro", "gyro=explicit", "gyroscopic term", DYNAMICS + "Dynamics/btRigidBody.cpp:91"),
            ("gyro", "gyro=none", "gyroscopic term", DYNAMICS + "Dynamics/btRigidBody.cpp:91"),
            ("max-gyroscopic-force", "gyro=explicit,max-gyroscopic-force=1e9", "m_maxGyroscopicForce", INFO + ":105"),
            ("erp", "erp=0.8", "m_erp", INFO + ":86"),
            ("cfm", "cfm=1e-8", "m_globalCfm", INFO + ":91"),
            ("warm-starting", "warm-starting=0", "m_warmstartingFactor", INFO + ":99"),
            ("relaxation", "relaxation=1.3", "m_sor", INFO + ":94"),
            ("slop", "slop=0.001", "m_linearSlop", INFO + ":98"),
            ("split-impulse", "split-impulse=off", "m_splitImpulse", INFO + ":95"),
            ("two-friction-directions", "two-friction-directions=on", "SOLVER_USE_2_FRICTION_DIRECTIONS", INFO + ":26"),
            ("random-order", "random-order=on", "SOLVER_RANDMIZE_ORDER", INFO + ":23"),
            ("interleave", "interleave=on", "SOLVER_INTERLEAVE_CONTACT_AND_FRICTION_CONSTRAINTS", INFO + ":31"),
        ],
        "bullet-multibody": [
            ("damping", "damping=0.04", "setLinearDamping, setAngularDamping", DYNAMICS + "Featherstone/btMultiBody.cpp:120"),
            ("max-coordinate-velocity", "max-coordinate-velocity=100", "setMaxCoordinateVelocity", DYNAMICS + "Featherstone/btMultiBody.cpp:124"),
            ("integrator", "integrator=runge-kutta-4", "useRK4Integration", DYNAMICS + "Featherstone/btMultiBody.h:642"),
        ],
    },
    "ode": {
        "ode": [
            ("rotation", "rotation=infinitesimal", "rotation", "ode/src/util.cpp:600"),
            ("friction", "friction=force", "contact_mode", "include/ode/contact.h:51"),
            ("friction-direction", "friction-direction=slip", "contact_mode", "include/ode/contact.h:36"),
            ("bounce-velocity", "bounce-velocity=0.1", "bounce_vel", "ode/src/joints/contact.cpp:199"),
            ("contact-cfm", "contact-cfm=0.01", "soft_cfm", "include/ode/contact.h:39"),
            ("contact-erp", "contact-erp=0", "soft_erp", "include/ode/contact.h:38"),
            ("stop-erp", "stop-erp=0.2", "stop_erp", "ode/src/joints/joint.cpp:503"),
            ("surface-layer", "surface-layer=0.0001", "contact_surface_layer", "ode/src/objects.cpp:79"),
            ("contacts", "contacts=4", "contacts", "ode/src/collision_kernel.cpp:292"),
            ("stepper", "stepper=quick", "solver", "include/ode/objects.h:427"),
            ("springs", "springs=stiff", "springs", "ode/src/joints/dball.cpp:269"),
            ("springs", "springs=joint", "springs", "ode/src/joints/ball.cpp:123"),
            ("gyro", "gyro=off", "gyro", "ode/src/ode.cpp:281"),
            ("erp", "erp=0.8", "erp", "include/ode/objects.h:110"),
            ("cfm", "cfm=0", "cfm", "include/ode/objects.h:127"),
        ],
        "ode-quick": [
            ("iterations", "iterations=100", "iterations", "include/ode/objects.h:460"),
            ("over-relaxation", "over-relaxation=1", "over_relaxation", "include/ode/objects.h:476"),
        ],
    },
}
RANK = {"pass": 3, "undecided": 2, "low-quality": 1, "fail": 0}
MARK = {"pass": "✓", "undecided": "?", "low-quality": "~", "fail": "✗", "unsupported": "–", "non-finite": "∞"}


SAMPLE = 12  # scenarios that --check runs again


def lines_of(engine):
    """(row, option, variant, name, source) of each setting that is tried."""
    return [(base, option, f"{base}/{tried}", name, place)
            for base, settings in SETTINGS[engine].items() for option, tried, name, place in settings]


def digest(cylon, engine):
    """Of all that a verdict follows from: the program, the engine's worker, the scenarios."""
    worker = pathlib.Path(cylon).parent / {"bullet": "cylon-worker-bullet-f64", "ode": "cylon-worker-ode"}[engine]
    sum_ = hashlib.sha256()
    for file in [pathlib.Path(cylon), worker, *sorted((root / "scenarios").rglob("*.toml"))]:
        sum_.update(file.read_bytes())
    return sum_.hexdigest()[:16]


def run(cylon, scenarios, variant, file):
    """Verdicts of some scenarios on one variant, as JSON in a file."""
    command = [cylon, "run", *scenarios, "--engine", variant, "--json", str(file)]
    with tempfile.TemporaryDirectory() as folder:  # one run at a time may work in a folder
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if done.returncode not in (0, 1, 5):  # 5: an engine crashed, which is a verdict here
        sys.exit(f"{' '.join(command)} ended with {done.returncode}:\n{done.stderr}")
    return json.loads(pathlib.Path(file).read_text())["verdicts"]


def verdicts(cylon, variant, kept):
    """The rows of all scenarios on one variant; kept in a folder, so that a run that was stopped goes on."""
    file = kept / (re.sub(r"[^\w.=,-]", "_", variant) + ".json")
    if not file.exists():
        part = pathlib.Path(str(file) + ".part")
        run(cylon, ["*"], variant, part)
        part.rename(file)
    # What follows a measured motion is a verdict on a model too.
    return [row for row in json.loads(file.read_text())["verdicts"] if row.get("evidence") != "validated"]


def worst_of(rows):
    """scenario -> its worst claim's status; claims that a run cannot answer count where none can be."""
    worst = {}
    answered = {row["scenario"] for row in rows if row["status"] != "unsupported"}
    for row in rows:
        if row["status"] == "unsupported" and row["scenario"] in answered:
            continue
        if row["measured"] is None or row["status"] not in RANK:
            digits = -math.inf
        elif row["measured"] == 0:
            digits = math.inf
        else:
            digits = math.log10(row["allowed"] / row["measured"]) if row["allowed"] else -math.inf
        worst[row["scenario"]] = min(worst.get(row["scenario"], (math.inf, "pass")), (digits, row["status"]))
    return {scenario: status for scenario, (_, status) in worst.items()}


def settings_of(rows):
    """setting -> its values -> the scenarios that ran with them."""
    settings = {}
    for row in rows:
        for name, value in row["settings"].items():
            settings.setdefault(name, {}).setdefault(value, set()).add(row["scenario"])
    return settings


def marks(worst):
    """One mark a scenario, in alphabetical order."""
    return "".join(MARK.get(worst[scenario], "☠") for scenario in sorted(worst))


def statuses(line, scenarios):
    """The reverse of marks()."""
    named = {mark: status for status, mark in MARK.items()}
    return {scenario: named.get(mark, "crash") for scenario, mark in zip(sorted(scenarios), line)}


def change(before, after):
    """Scenes that a setting takes to another status: the better and the worse ones."""
    better, worse = [], []
    for scene in sorted(after):
        old, new = before[scene], after[scene]
        if old != new:
            (better if RANK.get(new, -1) > RANK.get(old, -1) else worse).append(
                f"{scene} {MARK.get(old, '☠')}→{MARK.get(new, '☠')}")
    return better, worse


def count(scenes):
    kinds = ["pass", "low-quality", "fail", "unsupported"]
    found = list(scenes.values())
    return [sum(s == kind for s in found) for kind in kinds] + [sum(s not in kinds for s in found)]


def values(settings, name):
    """What a row's runs have a setting at: the values, the commonest first; where a run sets none, the engine's default."""
    found = dict(settings.get(name, {}))
    untouched = {s for values_ in settings.values() for scenes in values_.values() for s in scenes} - set().union(*found.values())
    if untouched:
        found["default"] = untouched
    return ", ".join(sorted(found, key=lambda v: -len(found[v])))


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
    return "\n".join(lines + ["| " + " | ".join(str(cell).replace("|", "\\|") for cell in row) + " |" for row in rows])


def listed(better, worse):
    return "<br>".join(filter(None, ["+ " + ", ".join(better) if better else "",
                                     "− " + ", ".join(worse) if worse else ""])) or "none"


def row_blocks(engine, worst):
    """What follows from the verdicts of the four rows."""
    ours = ROWS[engine][0]
    blocks = {f"{engine}-rows": table(["row", "pass", "within ten times", "fail", "unsupported", "crash, NaN or time-out"],
                                      [[f"`{row}`", *count(worst[row])] for row in ROWS[engine]])}
    for row in (f"{engine}/path=as-shipped", f"{engine}/path=as-expert"):
        better, worse = change(worst[ours], worst[row])
        blocks[row.replace("/path=", "-")] = "\n".join(
            [f"Better ({len(better)}): {', '.join(better) or 'none'}.", "",
             f"Worse ({len(worse)}): {', '.join(worse) or 'none'}."])
    _, beaten = change(worst[f"{engine}/path=as-shipped"], worst[f"{engine}/path=as-expert"])
    blocks[f"{engine}-as-expert"] += (f"\n\nWorse than the engine as shipped ({len(beaten)}): "
                                      f"{', '.join(beaten) or 'none'}.")
    return blocks


def described_blocks(engine, described):
    """What the program says of itself."""
    expert = next(p for p in described["paths"] if p["name"] == "as-expert")
    rule = expert["summary"]
    limits = dict.fromkeys(s for p in described["paths"] for s in p["unforceable"])
    return {f"{engine}-rule": rule[0].upper() + rule[1:] + ".\n\n" + table(
                ["setting", "value", "engine's default", "where, and why"],
                [[s["name"], s["value"], s["engine_default"], s["reason"]] for s in expert["settings"]]),
            f"{engine}-limits": "\n".join(f"- {sentence}" for sentence in limits)}


def setting_blocks(engine, described, worst, settings):
    """Each setting alone, and which did not help: no scene better, or fewer than worse."""
    default = {o["name"]: o["engine_default"] for o in described["options"]}
    default["integrator"] = described["schemes"][0]["name"]
    expert, rows, vain = f"{engine}/path=as-expert", [], []
    for base, option, variant, name, place in lines_of(engine):
        tried = variant.partition("/")[2]
        better, worse = change(worst[base], worst[variant])
        rows.append([f"`{tried}`" + (f" of {base}" if base != engine else ""), name, default[option],
                     values(settings[base], name), values(settings[expert], name), place, listed(better, worse)])
        if not better or len(better) < len(worse):
            vain.append(f"`{variant}`: {len(better)} better, {len(worse)} worse")
    return {f"{engine}-settings": table(["option", "name in the engine", "default", "ours", "expert's", "source",
                                         "scenes that it changes"], rows),
            f"{engine}-no-help": "\n".join(f"- {line}." for line in vain)}


def described_by(cylon, engine):
    described = json.loads(subprocess.run([cylon, "engines", engine, "--json"], capture_output=True, text=True,
                                          check=True).stdout)[0]
    untold = {o["name"] for o in described["options"]} - {line[1] for line in lines_of(engine)}
    if untold:
        sys.exit(f"{engine}: no line of SETTINGS tries {', '.join(sorted(untold))}")
    return described


def with_blocks(text, blocks):
    for name, block in blocks.items():
        text, found = re.subn(rf"(<!-- {name} -->\n).*?(<!-- /{name} -->)", lambda m: m[1] + block + "\n" + m[2], text,
                              flags=re.S)
        if found != 1:
            sys.exit(f"{page}: needs one block '<!-- {name} --> … <!-- /{name} -->'")
    return text


def scenarios(cylon):
    """Those with a truth in mathematics; what follows a measured motion is a verdict on a model too."""
    measured = {file.stem for file in (root / "scenarios" / "validation").glob("*.toml")}
    names = subprocess.run([cylon, "list", "--names"], cwd=root, capture_output=True, text=True, check=True).stdout.split()
    return sorted(set(names) - measured)


def check(cylon):
    """What is wrong with the page, as sentences."""
    text, wrong, names = page.read_text(), [], scenarios(cylon)
    for engine in SETTINGS:
        blocks = described_blocks(engine, described_by(cylon, engine))
        worst = {}
        for row in ROWS[engine]:
            kept = re.search(rf"^{re.escape(row)} (\S+)$", text, flags=re.M)
            if not kept or len(kept[1]) != len(names):
                wrong.append(f"{row}: the page has {len(kept[1]) if kept else 'no'} marks, and there are {len(names)} scenarios")
                continue
            worst[row] = statuses(kept[1], names)
            sample = names[::max(1, len(names) // SAMPLE)]
            with tempfile.TemporaryDirectory() as folder:
                again = worst_of(run(cylon, sample, row, pathlib.Path(folder) / "rows.json"))
            wrong += [f"{row}: {scenario} is {MARK.get(again[scenario], '☠')}, and the page says "
                      f"{MARK.get(worst[row][scenario], '☠')}" for scenario in sample
                      if MARK.get(again[scenario], "☠") != MARK.get(worst[row][scenario], "☠")]
        if len(worst) == len(ROWS[engine]):
            blocks.update(row_blocks(engine, worst))
        wrong += [f"the block {name} is not current" for name, block in blocks.items()
                  if with_blocks(text, {name: block}) != text]
    return wrong


def write(cylon, kept):
    blocks, kept_marks = {}, []
    for engine in SETTINGS:
        described = described_by(cylon, engine)
        folder = kept / f"{engine}-{digest(cylon, engine)}"
        folder.mkdir(parents=True, exist_ok=True)
        worst, settings = {}, {}
        for variant in dict.fromkeys(ROWS[engine] + [line[2] for line in lines_of(engine)]):
            rows = verdicts(cylon, variant, folder)
            worst[variant], settings[variant] = worst_of(rows), settings_of(rows)
        kept_marks += [f"{row} {marks(worst[row])}" for row in ROWS[engine]]
        blocks.update(row_blocks(engine, worst))
        blocks.update(described_blocks(engine, described))
        blocks.update(setting_blocks(engine, described, worst, settings))
    text = with_blocks(page.read_text(), blocks)
    text = re.sub(r"<!-- marks\n.*?-->", lambda m: "<!-- marks\n" + "\n".join(kept_marks) + "\n-->", text, flags=re.S)
    page.write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cylon", default="build/release/cylon")
    parser.add_argument("--kept", default="build/fairness", help="folder of the runs that are done")
    parser.add_argument("--check", action="store_true", help="write nothing; fail where the page is not current")
    options = parser.parse_args()
    cylon = str(pathlib.Path(options.cylon).resolve())
    if not options.check:
        write(cylon, root / options.kept)
        return
    wrong = check(cylon)
    for sentence in wrong:
        print(sentence, file=sys.stderr)
    sys.exit(f"{page}: run docs/fairness.py" if wrong else 0)


main()
