#!/usr/bin/env python3
"""Writes the tables of docs/fairness.md: every setting of Bullet and ODE, and what it changes over all scenarios.

    docs/fairness.py [--cylon build/release/cylon] [--kept FOLDER]

Runs every scenario once for each setting below, which takes minutes, and reads defaults and forced values from the program.
Fails where the program has an option that no line here tries.
"""
import argparse
import json
import math
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parent.parent
page = root / "docs" / "fairness.md"

ROWS = {"bullet": ["bullet", "bullet/path=as-shipped", "bullet/path=as-expert", "bullet-multibody"],
        "ode": ["ode", "ode-quick", "ode/path=as-shipped", "ode/path=as-expert"]}

INFO = "src/BulletDynamics/ConstraintSolver/btContactSolverInfo.h"
DYNAMICS, COLLISION = "src/BulletDynamics/", "src/BulletCollision/"
# Of an engine: option, the variant that tries it (the engine's default where a path of ours forces another), its name among
# the settings of a run, and where the engine's source has it.
SETTINGS = {
    "bullet": [
        ("sleeping", "bullet/sleeping=on", "activation state", COLLISION + "CollisionDispatch/btCollisionObject.cpp:34"),
        ("margin", "bullet/margin=0.04", "margin of all but spheres and capsules", COLLISION + "CollisionShapes/btCollisionMargin.h:22"),
        ("restitution-threshold", "bullet/restitution-threshold=0.2", "m_restitutionVelocityThreshold", INFO + ":108"),
        ("contact-threshold", "bullet/contact-threshold=1e18", "contactProcessingThreshold", COLLISION + "CollisionDispatch/btCollisionObject.h:188"),
        ("erp2", "bullet/erp2=0.2", "m_erp2", INFO + ":87"),
        ("split-threshold", "bullet/split-threshold=-0.04", "m_splitImpulsePenetrationThreshold", INFO + ":96"),
        ("damping", "bullet-multibody/damping=0.04", "linear and angular damping", DYNAMICS + "Featherstone/btMultiBody.cpp:120"),
        ("max-coordinate-velocity", "bullet-multibody/max-coordinate-velocity=100", "maxCoordinateVelocity", DYNAMICS + "Featherstone/btMultiBody.cpp:124"),
        ("rk4", "bullet-multibody/rk4=on", "useRK4Integration", DYNAMICS + "Featherstone/btMultiBody.h:642"),
        ("ccd", "bullet/ccd=0.9", "setCcdSweptSphereRadius, setCcdMotionThreshold", COLLISION + "CollisionDispatch/btCollisionObject.h:506"),
        ("speculative-restitution", "bullet/ccd=0.9,speculative-restitution=on", "setApplySpeculativeContactRestitution", DYNAMICS + "Dynamics/btDiscreteDynamicsWorld.h:209"),
        ("plane-queries", "bullet/plane-queries=3", "setPlaneConvexMultipointIterations", COLLISION + "CollisionDispatch/btDefaultCollisionConfiguration.h:108"),
        ("convex-queries", "bullet/convex-queries=3", "setConvexConvexMultipointIterations", COLLISION + "CollisionDispatch/btDefaultCollisionConfiguration.h:106"),
        ("breaking-threshold", "bullet/breaking-threshold=0.1", "gContactBreakingThreshold", COLLISION + "NarrowPhaseCollision/btPersistentManifold.h:30"),
        ("iterations", "bullet/iterations=200", "m_numIterations", INFO + ":85"),
        ("solver", "bullet/solver=dantzig", "solver", DYNAMICS + "MLCPSolvers/btDantzigSolver.h"),
        ("solver", "bullet/solver=nncg,iterations=50", "solver", DYNAMICS + "ConstraintSolver/btNNCGConstraintSolver.h"),
        ("gyro", "bullet/gyro=explicit", "gyro", DYNAMICS + "Dynamics/btRigidBody.cpp:91"),
        ("gyro", "bullet/gyro=none", "gyro", DYNAMICS + "Dynamics/btRigidBody.cpp:91"),
        ("max-gyroscopic-force", "bullet/gyro=explicit,max-gyroscopic-force=1e9", "m_maxGyroscopicForce", INFO + ":105"),
        ("erp", "bullet/erp=0.8", "m_erp", INFO + ":86"),
        ("cfm", "bullet/cfm=1e-8", "m_globalCfm", INFO + ":91"),
        ("warm-starting", "bullet/warm-starting=0", "m_warmstartingFactor", INFO + ":99"),
        ("relaxation", "bullet/relaxation=1.3", "m_sor", INFO + ":94"),
        ("slop", "bullet/slop=0.001", "m_linearSlop", INFO + ":98"),
        ("split-impulse", "bullet/split-impulse=off", "m_splitImpulse", INFO + ":95"),
        ("two-friction-directions", "bullet/two-friction-directions=on", "SOLVER_USE_2_FRICTION_DIRECTIONS", INFO + ":26"),
        ("random-order", "bullet/random-order=on", "SOLVER_RANDMIZE_ORDER", INFO + ":23"),
        ("interleave", "bullet/interleave=on", "SOLVER_INTERLEAVE_CONTACT_AND_FRICTION_CONSTRAINTS", INFO + ":31"),
    ],
    "ode": [
        ("rotation", "ode/rotation=infinitesimal", "rotation", "ode/src/util.cpp:600"),
        ("friction", "ode/friction=force", "contact_mode", "include/ode/contact.h:51"),
        ("friction-direction", "ode/friction-direction=slip", "contact_mode", "include/ode/contact.h:36"),
        ("bounce-velocity", "ode/bounce-velocity=0.1", "bounce_vel", "ode/src/joints/contact.cpp:199"),
        ("contact-cfm", "ode/contact-cfm=0.01", "soft_cfm", "include/ode/contact.h:39"),
        ("contact-erp", "ode/contact-erp=0", "soft_erp", "include/ode/contact.h:38"),
        ("surface-layer", "ode/surface-layer=0.0001", "contact_surface_layer", "ode/src/objects.cpp:79"),
        ("contacts", "ode/contacts=4", "contacts", "ode/src/collision_kernel.cpp:292"),
        ("stepper", "ode/stepper=quick", "solver", "include/ode/objects.h:427"),
        ("iterations", "ode-quick/iterations=100", "iterations", "include/ode/objects.h:460"),
        ("over-relaxation", "ode-quick/over-relaxation=1", "over_relaxation", "include/ode/objects.h:476"),
        ("springs", "ode/springs=stiff", "springs", "ode/src/joints/dball.cpp:269"),
        ("springs", "ode/springs=joint", "springs", "ode/src/joints/ball.cpp:123"),
        ("gyro", "ode/gyro=off", "gyro", "ode/src/ode.cpp:281"),
        ("erp", "ode/erp=0.8", "erp", "include/ode/objects.h:110"),
        ("cfm", "ode/cfm=0", "cfm", "include/ode/objects.h:127"),
    ],
}
RANK = {"pass": 2, "low-quality": 1, "fail": 0}
MARK = {"pass": "✓", "low-quality": "~", "fail": "✗", "unsupported": "–", "non-finite": "∞"}


def base_of(variant):
    """The row that a variant is compared with."""
    return variant.split("/")[0]


def verdicts(cylon, variant, kept):
    """The rows of all scenarios on one variant; kept in a folder, so that a run that was stopped goes on."""
    file = kept / (re.sub(r"[^\w.=,-]", "_", variant) + ".json")
    if not file.exists():
        command = [cylon, "run", "*", "--engine", variant, "--json", str(file) + ".part"]
        done = subprocess.run(command, cwd=root, capture_output=True, text=True)
        if done.returncode not in (0, 1, 5):  # 5: an engine crashed, which is a verdict here
            sys.exit(f"{' '.join(command)} ended with {done.returncode}:\n{done.stderr}")
        pathlib.Path(str(file) + ".part").rename(file)
    return json.loads(file.read_text())["verdicts"]


def judged(cylon, variants, kept):
    """variant -> scenario -> its worst claim's status and log10(allowed/measured); and the runs' settings."""
    worst, settings = {v: {} for v in variants}, {v: {} for v in variants}
    for row in (row for v in variants for row in verdicts(cylon, v, kept)):
        if row["measured"] is None or row["status"] not in RANK:
            digits = -math.inf
        elif row["measured"] == 0:
            digits = math.inf
        else:
            digits = math.log10(row["allowed"] / row["measured"]) if row["allowed"] else -math.inf
        scenes = worst[row["engine"]]
        scenes[row["scenario"]] = min(scenes.get(row["scenario"], (math.inf, "pass")), (digits, row["status"]))
        for name, value in row["settings"].items():
            settings[row["engine"]].setdefault(name, {}).setdefault(value, set()).add(row["scenario"])
    return worst, settings


def change(before, after):
    """Scenes that a setting takes to another status: the better and the worse ones."""
    better, worse = [], []
    for scene in sorted(after):
        (_, old), (_, new) = before[scene], after[scene]
        if old != new:
            (better if RANK.get(new, -1) > RANK.get(old, -1) else worse).append(
                f"{scene} {MARK.get(old, '☠')}→{MARK.get(new, '☠')}")
    return better, worse


def count(scenes):
    statuses = [status for _, status in scenes.values()]
    return [sum(s == "pass" for s in statuses), sum(s == "low-quality" for s in statuses),
            sum(s == "fail" for s in statuses), sum(s == "unsupported" for s in statuses),
            sum(s not in ("pass", "low-quality", "fail", "unsupported") for s in statuses)]


def values(settings, name):
    """What a row's runs have a setting at: the values, the commonest first."""
    found = settings.get(name, {})
    return ", ".join(sorted(found, key=lambda v: -len(found[v]))) or "default"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
    return "\n".join(lines + ["| " + " | ".join(str(cell).replace("|", "\\|") for cell in row) + " |" for row in rows])


def listed(better, worse):
    return "<br>".join(filter(None, ["+ " + ", ".join(better) if better else "",
                                     "− " + ", ".join(worse) if worse else ""])) or "none"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cylon", default="build/release/cylon")
    parser.add_argument("--kept", default="build/fairness", help="folder of the runs that are done; remove it to run again")
    options = parser.parse_args()
    cylon, kept = str(pathlib.Path(options.cylon).resolve()), root / options.kept
    kept.mkdir(parents=True, exist_ok=True)
    blocks = {}
    for engine, lines in SETTINGS.items():
        described = json.loads(subprocess.run([cylon, "engines", engine, "--json"], capture_output=True, text=True,
                                              check=True).stdout)[0]
        untold = {o["name"] for o in described["options"]} - {line[0] for line in lines}
        if untold:
            sys.exit(f"{engine}: no line of SETTINGS tries {', '.join(sorted(untold))}")
        default = {o["name"]: o["engine_default"] for o in described["options"]}
        variants = list(dict.fromkeys(ROWS[engine] + [v for _, v, _, _ in lines]))
        worst, settings = judged(cylon, variants, kept)
        ours, expert = ROWS[engine][0], f"{engine}/path=as-expert"
        blocks[f"{engine}-rows"] = table(
            ["row", "pass", "within ten times", "fail", "unsupported", "crash, NaN or time-out"],
            [[f"`{row}`", *count(worst[row])] for row in ROWS[engine]])
        blocks[f"{engine}-settings"] = table(
            ["option", "name in the engine", "default", "ours", "expert's", "source", "scenes that it changes"],
            [[f"`{variant.partition('/')[2]}`" + (f" of {base_of(variant)}" if base_of(variant) != engine else ""),
              name, default[option], values(settings[base_of(variant)], name), values(settings[expert], name),
              place, listed(*change(worst[base_of(variant)], worst[variant]))]
             for option, variant, name, place in lines])
        for row in (f"{engine}/path=as-shipped", expert):
            better, worse = change(worst[ours], worst[row])
            blocks[row.replace("/path=", "-")] = "\n".join(
                [f"Better ({len(better)}): {', '.join(better) or 'none'}.", "",
                 f"Worse ({len(worse)}): {', '.join(worse) or 'none'}."])
        rule = next(p["summary"] for p in described["paths"] if p["name"] == "as-expert")
        blocks[f"{engine}-rule"] = rule[0].upper() + rule[1:] + "."
        limits = dict.fromkeys(s for p in described["paths"] for s in p["unforceable"])
        blocks[f"{engine}-limits"] = "\n".join(f"- {sentence}" for sentence in limits)
    text = page.read_text()
    for name, block in blocks.items():
        text, found = re.subn(rf"(<!-- {name} -->\n).*?(<!-- /{name} -->)", lambda m: m[1] + block + "\n" + m[2], text,
                              flags=re.S)
        if found != 1:
            sys.exit(f"{page}: needs one block '<!-- {name} --> … <!-- /{name} -->'")
    page.write_text(text)


main()
