#!/usr/bin/env python3
"""The tables of all engines in README.md and docs/speed-against-accuracy.md: measures them, or writes them from what was measured.

    docs/engine_table.py [--cylon build/release/cylon] [--row TITLE]

measures, which takes a quarter of an hour on two quiet processors: `cylon matrix` on each scene of the suite conformance, in build/engine-table, where a
call goes on that was interrupted.  The numbers of each scene go to docs/engine_table.json as soon as they are there.
--row measures the engine of one row alone, with a date and a load of its own, and leaves the other rows as they are.
docs/update.py writes the tables from these, names the scenes that were not measured, and checks that no engine is missing.
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import tomllib

root = pathlib.Path(__file__).resolve().parent.parent
numbers = root / "docs" / "engine_table.json"

# Title, engines as measured, and the engines of engines.txt for which the row stands.  Settings and integrator as an expert
# sets them, where there is such a path, else the engine's default integrator.  MuJoCo 3 has no such path: the second of its engines is for scenes in
# which nothing can touch and gravity alone acts, as path=as-expert of MuJoCo 2.2 has it, whose forces are those of each stage.  A stand-in runs what the engine has no concept of, in a labelled way.
families = [
    ("in-house", ["in-house"], ["in-house", "in-house-float"]),
    ("Bullet", ["bullet/path=as-expert"], ["bullet", "bullet-float", "bullet-multibody", "bullet-multibody-float"]),
    ("ODE", ["ode/path=as-expert"], ["ode", "ode-quick"]),
    ("MuJoCo 2.2", ["mujoco/path=as-expert"], ["mujoco"]),
    ("Simbody", ["simbody/path=as-expert"], ["simbody"]),
    ("DART", ["dart/path=as-expert"], ["dart"]),
    ("Siconos", ["siconos/path=as-expert"], ["siconos"]),
    ("Jolt", ["jolt"], ["jolt"]),
    ("Rapier", ["rapier"], ["rapier", "rapier-deterministic", "rapier-simd"]),
    ("MuJoCo 3", ["mujoco3", "mujoco3/integrator=rk4"], ["mujoco3"]),
    ("Havok", ["havok/path=stand-in"], ["havok"]),
    ("PhysX", ["physx"], ["physx"]),
    ("crashcat", ["crashcat"], ["crashcat"]),
    ("cannon-es", ["cannon-es/path=stand-in"], ["cannon-es"]),
]
errors = [1e-2, 1e-3, 1e-4]
in_readme = 2  # of these
# What the scenes of the suite are of.
kinds = {
    "flight": ["projectile"],
    "impacts": ["bouncing_sphere", "two_sphere_oblique"],
    "springs": ["spring_zero_length", "spring_orbit"],
    "free rotation": ["free_symmetric_top", "dzhanibekov"],
    "a top on a joint": ["heavy_top"],
}
nothing_ran = 4  # exit code where the engine of a row refuses the scene
how = ["--rounds", "1", "--timeout", "600"]


def words_of(families):
    return [*(word for _, engines, _ in families for engine in engines for word in ("--engine", engine)), *how]


options = words_of(families)


# ---- Measuring ------------------------------------------------------------------------------------------

def reached(table, cell, times):
    """Of one engine on one scene: the step, or tolerance, that meets each error, with its cost; or why there is none."""
    if cell["refusal"]:
        return {"refused": cell["refusal"]}
    series = table["series"][cell["series"]]
    result = {"closed_form": series["closed_form"], "substeps": series["substeps"], "order": series["observed_order"], "reach": [],
              "lost": sum(p["status"] == "timeout" for p in series["points"])}
    for reach in cell["reach"]:
        if reach["point"] is None:
            result["reach"].append({"why": reach["why"]})
            continue
        point = series["points"][reach["point"]]
        time = times.get((table["scenario"], series["engine"], series["integrator"], point["dt_text"], point["tolerance"]), {})
        # An integrator that controls its error chooses its steps: what it was asked for is the tolerance.
        asked = {"tolerance": point["tolerance"]} if point["tolerance"] else {"step": point["dt"]}
        result["reach"].append({**asked, "cost": time.get("cpu_seconds_per_second")})
    return result


def reduced(document, families):
    """One scene: engines by title, with the versions that ran."""
    times = {(t["scenario"], t["engine"], t["integrator"], t["dt_text"], t["tolerance"]): t for t in document["times"]}
    table = document["tables"][0]
    result = {}
    for title, names, _ in families:
        engine = names[-1] if flies_freely(table["scenario"]) else names[0]
        cell = next((c for c in table["cells"] if table["series"][c["series"]]["engine"] == engine), None)
        if cell is None:
            sys.exit(f"docs/engine_table.py: no cell of {engine} on {table['scenario']}")
        result[title] = {"engine": engine, "version": table["series"][cell["series"]]["version"], **reached(table, cell, times)}
    return result


def flies_freely(scenario):
    """Whether nothing in a scene can touch and gravity alone acts."""
    scene = tomllib.loads((root / "scenarios" / f"{scenario}.toml").read_text())
    return not {"material", "spring", "drag", "thrust", "drive", "attraction", "water", "plugin_force"} & scene.keys()


def keep(scene, document, load):
    """Adds the numbers of a scene to those that are there."""
    data = json.loads(numbers.read_text()) if numbers.exists() else {"scenes": {}}
    provenance = document["provenance"]
    data["scenes"][scene] = {"machine": provenance["machine"], "date": provenance["date"][:10], "load": round(load),
                             "options": " ".join(options), "engines": reduced(document, families)}
    data["scenes"] = {name: data["scenes"][name] for name in suite() if name in data["scenes"]}
    numbers.write_text(json.dumps(data, indent=1) + "\n")


def is_row_alone(stored, family):
    """Whether all other rows of a scene were measured as they are asked for here."""
    asked = words_of([other for other in families if other is not family])
    return list(stored["engines"]) == [title for title, _, _ in families] and set(asked) <= set(stored["options"].split())


def keep_row(scene, document, load, family):
    """Puts one row in the place of that which is there, of a scene whose other rows were measured as they are asked for."""
    data = json.loads(numbers.read_text())
    stored = data["scenes"].get(scene)
    if stored is None or not is_row_alone(stored, family):
        sys.exit(f"docs/engine_table.py: {scene} was measured by another command, in more than this row: measure all rows")
    provenance = document["provenance"]
    [(title, row)] = reduced(document, [family]).items()
    stored["engines"][title] = {**row, "machine": provenance["machine"], "date": provenance["date"][:10], "load": round(load)}
    stored["options"] = " ".join(options)
    numbers.write_text(json.dumps(data, indent=1) + "\n")


def suite():
    return tomllib.loads((root / "scenarios/suites/conformance.toml").read_text())["scenarios"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cylon", default="build/release/cylon")
    parser.add_argument("--row", choices=[title for title, _, _ in families], help="measure the engine of this row alone")
    asked = parser.parse_args()
    cylon = str((root / asked.cylon).resolve())
    family = next((family for family in families if family[0] == asked.row), None)
    words = words_of([family]) if family else options
    folder = root / "build" / ("engine-table-row" if family else "engine-table")
    folder.mkdir(parents=True, exist_ok=True)
    for scene in suite():
        load = os.getloadavg()[0]
        code = subprocess.run([cylon, "matrix", scene, *words, "--resume", "--json", "matrix.json"], cwd=folder).returncode
        if code not in (0, nothing_ran):
            sys.exit("docs/engine_table.py: not finished; call it again to go on")
        document, load = json.loads((folder / "matrix.json").read_text()), max(load, os.getloadavg()[0])
        keep_row(scene, document, load, family) if family else keep(scene, document, load)
    print("now run docs/update.py")


# ---- The table --------------------------------------------------------------------------------------------

def milliseconds(seconds):
    text = f"{1e3 * seconds:.2g}"
    return text if "e+" not in text else f"{1e3 * seconds:.0f}"


def one_error(reach):
    if "why" in reach:
        return "–"
    cost = "" if reach["cost"] is None else f" ({milliseconds(reach['cost'])})"
    return (f"tol {scientific(reach['tolerance'])}" if "tolerance" in reach else f"{milliseconds(reach['step'])} ms") + cost


def cell(scene):
    """Of one engine on one scene, in README."""
    if "refused" in scene:
        return "refused"
    shown = scene["reach"][:in_readme]
    if all("why" in reach for reach in shown):
        return "–"
    if scene["closed_form"]:
        return f"= ({milliseconds(shown[0]['cost'])})"
    return "<br>".join(one_error(reach) for reach in shown)


def in_full(title, scene):
    """The same, as a row: each error, the order, and why the first error that is not met is not."""
    if "refused" in scene:
        return [title, *["refused"] * len(errors), "", scene["refused"]]
    if scene["closed_form"]:
        return [title, *[f"= ({milliseconds(scene['reach'][0]['cost'])})"] * len(errors), "", ""]
    why = next((f"{scientific(error)}: {reach['why']}" for error, reach in zip(errors, scene["reach"]) if "why" in reach), "")
    return [title, *map(one_error, scene["reach"]), "" if scene["order"] is None else f"{scene['order']:.2f}", why]


def scientific(error):
    return f"{error:.0e}".replace("e-0", "e-")


def met(scene, error):
    """Whether the engine meets the error of that index on a scene; a closed form meets both."""
    return "refused" not in scene and "why" not in scene["reach"][error]


def best_at(engine):
    """The kinds of motion on all of whose scenes the engine meets 1e-3, or else 1e-2: its own results, compared with nobody's."""
    for error in reversed(range(in_readme)):
        good = [kind for kind, names in kinds.items()
                if all(name in engine["scenes"] and met(engine["scenes"][name], error) for name in names)]
        if good:
            return f"{scientific(errors[error])}: " + ("all kinds" if len(good) == len(kinds) else ", ".join(good))
    return "–"


def step_cost(engine):
    """Median over the scenes of the CPU time of a step at 1e-2 [s]; none where the integrator chooses its steps."""
    costs = sorted(reach["cost"] * reach["step"] for scene in engine["scenes"].values() if not scene.get("closed_form", True)
                   for reach in scene["reach"][:1] if reach.get("cost") and "step" in reach)
    return costs[len(costs) // 2] if costs else None


def block(_):
    measured_scenes = json.loads(numbers.read_text())["scenes"]
    engines = {title: {"scenes": {name: scene["engines"][title] for name, scene in measured_scenes.items()}}
               for title, _, _ in families}
    lines = ["| engine | best at | µs a step | " + " | ".join(measured_scenes) + " |", "|---" * (len(measured_scenes) + 3) + "|"]
    for title, engine in engines.items():
        cost = step_cost(engine)
        label = " †" if any("Node" in scene["version"] for scene in engine["scenes"].values()) else ""
        substeps = max(scene.get("substeps", 1) for scene in engine["scenes"].values())
        label += f" ({substeps} substeps)" if substeps > 1 else ""
        lines.append(f"| {title}{label} | {best_at(engine)} | {'–' if cost is None else f'{1e6 * cost:.2g}'} | " +
                     " | ".join(cell(scene) for scene in engine["scenes"].values()) + " |")
    left = [name for name in suite() if name not in measured_scenes]
    if left:
        lines += ["", f"Not measured yet: {', '.join(left)}; a call of `docs/engine_table.py` goes on."]
    lost = sum(scene.get("lost", 0) for engine in engines.values() for scene in engine["scenes"].values())
    if lost:
        lines += ["", f"{lost} runs did not start or end in time; their steps count as not met."]
    alone = [title for title, engine in engines.items() if any("date" in row for row in engine["scenes"].values())]
    runs = [*measured_scenes.values(), *(row for engine in engines.values() for row in engine["scenes"].values() if "date" in row)]
    machines, dates = sorted({run["machine"] for run in runs}), sorted({run["date"] for run in runs})
    load = max(run["load"] for run in runs)
    lines += ["", f"Measured on {', '.join(machines)}, {', '.join(dates)}, while the machine had a load average of up to {load}.\nCPU times "
              "depend on that by caches and clocks, steps only where a run was lost. `docs/engine_table.py` calls, for each scene,", "",
              "```", *wrapped("cylon matrix SCENE " + " ".join(options)), "```"]
    if alone:
        lines += ["", f"Measured after the others, each row alone (`--row`): {', '.join(alone)}."]
    return "\n".join(lines)


def full_block(_):
    """A table for each scene: engines on which the README's have no room."""
    text = []
    for name, scene in json.loads(numbers.read_text())["scenes"].items():
        rows = [["engine", *map(scientific, errors), "order", "what is not met, and why"],
                *(in_full(title, scene["engines"][title]) for title, _, _ in families)]
        lines = ["| " + " | ".join(word.replace("|", r"\|") for word in row) + " |" for row in rows]
        text += [f"**{name}**", "", lines[0], "|---" * len(rows[0]) + "|", *lines[1:], ""]
    return "\n".join(text[:-1])


def wrapped(text, width=116):
    lines = [""]
    for word in text.split():
        if len(lines[-1]) + len(word) > width:
            lines[-1] += " \\"
            lines.append("   ")
        lines[-1] = f"{lines[-1]} {word}" if lines[-1] else word
    return lines


def wrong():
    """What the measured numbers lack: sentences."""
    rows = [line.split()[0] for line in (root / "reference/simulators/engines.txt").read_text().splitlines() if line[:1] not in "#"]
    known = [engine for _, _, ids in families for engine in ids]
    for engine in rows:
        if engine not in known:
            yield f"docs/engine_table.py: no row for {engine} of engines.txt"
    if sorted(suite()) != sorted(name for names in kinds.values() for name in names):
        yield "docs/engine_table.py: each scene of the suite conformance is of one kind of motion"
    for name, scene in json.loads(numbers.read_text())["scenes"].items():
        if name not in suite() or scene["options"] != " ".join(options) or list(scene["engines"]) != [title for title, _, _ in families]:
            yield f"docs/engine_table.json: {name} was measured by another command: run docs/engine_table.py"


if __name__ == "__main__":
    main()
