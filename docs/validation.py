#!/usr/bin/env python3
"""Writes the tables of docs/measured.md from what `cylon predict`, `cylon fit` and tests/levels find here and now.

    docs/validation.py [--cylon build/release/cylon] [--levels build/release/levels_study] [--only TABLE]

Takes hours.  An interrupted run goes on where it was: --state keeps what is done.  Each table is one run of the command above it.
"""
import argparse
import hashlib
import json
import pathlib
import re
import resource
import shlex
import subprocess
import sys

import measured

root = pathlib.Path(__file__).resolve().parent.parent
page = root / "docs" / "measured.md"
engines = ["in-house", "bullet", "ode", "mujoco"]
# Of tosses, which cost little where nothing is fitted, every family of engines, as in docs/engine_table.py; optional ones by ./run engines.
all_engines = [*engines, "simbody", "dart", "siconos", "jolt", "rapier", "mujoco3", "havok/path=stand-in", "physx", "crashcat", "cannon-es/path=stand-in"]
cases = ["ball", "ball, larger errors", "ball, in steps", "ball, inertia known", "ball, pyramid", "ball, no restitution", "ball, inertia +10 %"]


# How each pendulum is fitted, and on which engines.  Bullet has no dry friction of hinges, and the in-house engine takes a hundred times
# as long with it: Coulomb's loss is left out, for every engine alike.
pendulums = {
    "single": (["--parameters", "inertia 1,damping 1,quadratic damping 1"], ["in-house", "ode", "mujoco", "bullet"]),
    "double": (["--runs", "12"], ["ode", "mujoco", "bullet", "in-house"]),
    "triple": (["--runs", "8"], ["ode", "mujoco"]),
}
# Predictions with values of the fit above them, of the first of its engines.
fitted = {"single": ["inertia 1", "damping 1"]}
# Runs of which a band is made, 39 predictions of each, and runs of data that the engine itself made: few where predictions are dear.
bands = {"in-house/path=stepping": (275, 100)} | dict.fromkeys(["bullet", "ode", "ode/friction-direction=slip"], (275, 275)) | dict.fromkeys(
    ["bullet/two-friction-directions=on", "dart", "jolt", "havok/path=stand-in", "crashcat", "cannon-es/path=stand-in"], (275, 100)) | dict.fromkeys(["rapier", "physx"], (100, 100))
# Runs and folds of the cross-validation of the cube, and the engines.
crossed = (["--runs", "12", "--folds", "2"], ["in-house/path=stepping", "bullet"])
tables = ["levels", "tosses", "lengths", "bands", "cube fit", "cube folds", "validation", *pendulums, *(f"{arms} fit" for arms in pendulums),
          *(f"{arms} fitted" for arms in fitted)]


def words_of(command, experiment, options, of=engines):
    return [command, str(experiment.relative_to(root)), *options, *(word for engine in of for word in ("--engine", engine))]


def found_by(cylon, words, state, files=()):
    """What that command writes with --json; `files`: where files lie that it names."""
    folder = folder_of(words, state)
    file = folder / "found.json"
    if not file.exists():
        folder.mkdir(exist_ok=True)
        more = ["--resume"] if words[0] == "fit" else ["--curves", "0"]  # nothing here draws curves
        before = processor_time()
        done = subprocess.run([cylon, words[0], str(root / words[1]), *(dict(files).get(word, word) for word in words[2:]), *more, "--json", str(file)], cwd=folder)
        if done.returncode not in (0, 1):
            sys.exit(f"{' '.join(words)} ended with {done.returncode}")
        (folder / "cost.json").write_text(json.dumps({"processor_time": processor_time() - before}))
    return json.loads(file.read_text())


def folder_of(words, state):
    name = re.sub("[^a-z0-9]+", "-", " ".join(words))
    return state / (name if len(name) < 200 else name[:180] + hashlib.sha256(name.encode()).hexdigest()[:8])


def processor_time():
    """Of all processes that this one started and that have ended, and of theirs [s]."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def cost(words, state):
    """Processor time of that command, when it last ran [s]."""
    return json.loads((folder_of(words, state) / "cost.json").read_text())["processor_time"]


def with_interval(value, low, high, digits="{:.4g}"):
    if value is None:
        return "not known"
    shown = digits.format(value)
    return shown if low is None else f"{shown} [{digits.format(low)}, {digits.format(high)}]"


def parameters(found):
    rows = ["| engine | parameter | value, if the uncertainties are right | between runs | remarks |", "|---" * 5 + "|"]
    for fit in found["fits"]:
        if fit["failure"]:
            rows.append(f"| {fit['engine']} | | | | {fit['failure']} |")
            continue
        for p in fit["parameters"]:
            remarks = [*(["at its bound"] if p["at_bound"] else []),
                       *(["cannot be told from others"] if p["error"] is None else [])]
            rows.append(f"| {fit['engine']} | {p['name']} | {with_interval(p['value'], p['low'], p['high'])} | "
                        f"{with_interval(p['value'], p['low_between_runs'], p['high_between_runs'])} | {', '.join(remarks)} |")
        rows.append(f"| {fit['engine']} | misfit of a number | {fit['misfit'] / fit['numbers']:.3g} | | "
                    f"{'settled' if fit['settled'] else 'not settled'} after {fit['rounds']} rounds |")
    return "\n".join(rows)


def scaled(estimate, scale, digits="{:.1f}"):
    return with_interval(*(None if estimate[k] is None else scale * estimate[k] for k in ("value", "low", "high")), digits)


def rests(found):
    rows = ["| engine | | distance [mm] | angle [deg] | same side [%] | first touch [ms] | -2 log L a run |", "|---" * 7 + "|"]
    for engine in found["judged"]:
        deviances = [d for d in engine["deviances"] if d is not None]
        for when in ("before", "after"):
            if when not in engine:
                continue
            s = engine[when]
            rows.append(f"| {engine['engine']} | {when} | {scaled(s['distance'], 1000)} | {scaled(s['angle'], 57.29577951)} | "
                        f"{scaled(s['same_side'], 100)} | {scaled(s['impact'], 1000, '{:.2f}')} | "
                        f"{f'{sum(deviances) / len(deviances):.1f}' if when == 'after' else ''} |")
    return "\n".join(rows)


def until(estimate):
    """A time that is null where a prediction holds to the end; of too few runs there is no interval."""
    if estimate["runs"] < 6:
        return "the end" if estimate["value"] is None else f"{estimate['value']:.3f}"
    value, low, high = ("the end" if estimate[k] is None else f"{estimate[k]:.3f}" for k in ("value", "low", "high"))
    return value if value == low == high else f"{value} [{low}, {high}]"


def horizons(summaries):
    """Rows of (engine, before or after a fit, summary)."""
    fitted = any(when for _, when, _ in summaries)
    rows = [f"| engine |{' |' if fitted else ''} within 0.1 rad for [s] | to the end | by the start alone [s] | exponent [1/s] |",
            "|---" * (6 if fitted else 5) + "|"]
    for engine, when, s in summaries:
        if s["failed"] == s["runs"]:
            rows.append(f"| {engine} |{f' {when} |' if fitted else ''} no prediction: {s['first_failure']} | | | |")
            continue
        held, expected = (until(s[k]) for k in ("held", "expected"))
        rows.append(f"| {engine} |{f' {when} |' if fitted else ''} {held} | {s['to_the_end']} of {s['runs'] - s['failed']} | {expected} | "
                    f"{scaled(s['exponent'], 1, '{:.2f}')} |")
    return "\n".join(rows)


def likelier(found):
    return "\n".join(f"- {pair['one']} is likelier in {pair['runs_of_one']} runs, {pair['other']} in {pair['runs_of_other']}: "
                     f"{pair['likelier']} (p = {pair['p']:.2g})" for pair in found["likelier"])


def nearer(found):
    return "\n".join(f"- {pair['one']} rests nearer in {pair['runs_of_one']} runs, {pair['other']} in {pair['runs_of_other']}: "
                     f"{pair['nearer']} (p = {pair['p']:.2g})" for pair in found["nearer"])


def predicted_rests(found):
    rows = ["| engine | runs | distance [mm] | angle [deg] | same side [%] | first touch [ms] | its place [mm] | energy lost [%] |", "|---" * 8 + "|"]
    for s in found["engines"]:
        if s["failed"] == s["runs"]:
            rows.append(f"| {s['engine']} | 0 | no prediction: {s['first_failure']} | | | | | |")
            continue
        rows.append(f"| {s['engine']} | {s['runs'] - s['failed']} | {scaled(s['distance'], 1000)} | {scaled(s['angle'], 57.29577951)} | "
                    f"{scaled(s['same_side'], 100)} | {scaled(s['impact'], 1000, '{:.2f}')} | {scaled(s['place'], 1000)} | "
                    f"{scaled(s['loss'], 100)} |")
    return "\n".join(rows)


def covered(cylon, experiment, state):
    """A row for each engine: the share inside its band, as the errors are stated, with the discrepancy, and of data of its own."""
    rows = ["| engine | runs | as stated [%] | 90 to 98 % | with `--discrepancy` [%] | 90 to 98 % | with `--synthetic ENGINE` [%] | 90 to 98 % "
            "| processor time [s] |", "|---" * 9 + "|"]
    for engine, (runs, own) in bands.items():
        cells, spent = [], 0
        for of, option in ((runs, []), (runs, ["--discrepancy"]), (own, ["--synthetic", engine])):
            words = words_of("predict", experiment, ["--runs", str(of), *option], [engine])
            found = found_by(cylon, words, state)["engines"][0]
            remarks = [*([f"{of} runs"] if of != runs else []), *([f"{found['failed']} failed"] if found["failed"] else [])]
            cells += [scaled(found["covered"], 100) + (f" ({', '.join(remarks)})" if remarks else ""), found["band"]]
            spent += cost(words, state)
        rows.append(f"| {engine} | {runs} | {' | '.join(cells)} | {spent:.0f} |")
    return "\n".join(rows)


def touches(found):
    rows = ["| touch | runs that fly after it | runs that tell its loss |", "|---" * 3 + "|"]
    rows += [f"| {k} | {one['flights']} | {one['known']} |" for k, one in enumerate(found["touches"], 1)]
    return "\n".join(rows)


def unseen(stated, discrepant):
    """Scores of runs by fits that did not see them, and shares inside the band, as the errors are stated and with the discrepancy."""
    rows = ["| engine | runs | distance [mm] | angle [deg] | same side [%] | inside the band, as stated [%] | with `--discrepancy` [%] |", "|---" * 7 + "|"]
    for s, other in zip(stated["engines"], discrepant["engines"], strict=True):
        rows.append(f"| {s['engine']} | {s['runs'] - s['failed']} | {scaled(s['distance'], 1000)} | {scaled(s['angle'], 57.29577951)} | "
                    f"{scaled(s['same_side'], 100)} | {scaled(s['covered'], 100)} | {scaled(other['covered'], 100)} |")
    return "\n".join(rows)


def lengths(found):
    of, g = found["lengths"], found["lengths"]["gravity"]
    rows = ["| sign | measured | true | measured over true | runs |", "|---" * 5 + "|",
            f"| fall in free flight [m/s²] | {scaled(of['flight'], g, '{:.3f}')} | {g:.4g} | {scaled(of['flight'], 1, '{:.4f}')} | {of['flight']['runs']} |",
            f"| height at rest [mm] | {scaled(of['height'], 1000, '{:.2f}')} | | {scaled(of['rest'], 1, '{:.4f}')} | {of['rest']['runs']} |"]
    for side in sorted({run["side"] for run in of["each"]} - {0}):
        runs = [run for run in of["each"] if run["side"] == side]
        height, half = (sum(run[k] for run in runs) / len(runs) for k in ("height", "half"))
        rows.append(f"| the same, side {'+' if side > 0 else '-'}{'xyz'[abs(side) - 1]} up [mm] | {1000 * height:.2f} | {1000 * half:.2f} | "
                    f"{height / half:.4f} | {len(runs)} |")
    if of["tilt"] is not None:
        rows.append(f"| tilt at rest, root mean square [mrad] | {1000 * of['tilt']:.1f} | 0 | | {of['rest']['runs']} |")
    return "\n".join(rows)


def predicted_horizons(found):
    return horizons([(s["engine"], "", s) for s in found["engines"]])


def judged_horizons(found):
    return horizons([(one["engine"], when, one[when]) for one in found["judged"] for when in ("before", "after") if when in one])


def claims(verdicts):
    """Claims against measured motions: what lies in which interval."""
    rows = ["| scenario | claim | engine | deviation | allowed | verdict |", "|---" * 6 + "|"]
    for v in verdicts:
        if v["evidence"] == "validated":
            low, high = v["interval"] or (None, None)
            deviation = "" if v["measured"] is None else f"{with_interval(v['measured'], low, high, '{:.3g}')} {v['unit']}"
            allowed = "" if v["allowed"] is None else f"{v['allowed']:.3g} {v['unit']}"
            rows.append(f"| {v['scenario']} | {v['claim']} | {v['engine']} | {deviation} | {allowed} | {v['status']} |")
    return "\n".join(rows)


def judged(words, found):
    return f"{shown(words)}, one half of {found['runs']} of {found['measured_runs']} runs fitted, the other judging it:"


def shown(words):
    return f"From `cylon {shlex.join(words)}`"


def levels(program, state, counts):
    rows = ["| case | experiments | truth inside, if the uncertainties are right [%] | between runs [%] | refused at 5 % [%] |",
            "|---" * 5 + "|"]
    made_by = hashlib.sha256(pathlib.Path(program).read_bytes()).hexdigest()[:12]  # what another program counted is not these levels
    for case in cases:
        file = state / f"levels {re.sub('[^a-z0-9]+', '-', case)} {made_by}.txt"
        out = subprocess.run([program, case, counts[case], str(file)], capture_output=True, text=True, check=True).stdout
        lines = out.splitlines()
        found = {}
        for line in lines[1:]:
            name, value = re.fullmatch(r"(.*?)\s+([0-9.]+) % (\[.*\])", line).group(1, 2)
            found[name] = float(value)
        stated = [v for k, v in found.items() if k.endswith(", stated")]
        between = [v for k, v in found.items() if k.endswith(", between runs")]
        interval = next(line for line in lines if line.startswith("refused")).split("%", 1)[1].strip()
        right = cases.index(case) < 4
        rows.append(f"| {case} | {lines[0].split(': ')[1].split()[0]} | {f'{min(stated):.1f} to {max(stated):.1f}' if right else ''} | "
                    f"{f'{min(between):.1f} to {max(between):.1f}' if right else ''} | {found['refused']:.1f} {interval} |")
    return "\n".join(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cylon", default="build/release/cylon")
    parser.add_argument("--levels", default="build/release/levels_study")
    parser.add_argument("--state", default="build/release/validation", help="folder that keeps what is done")
    parser.add_argument("--only", choices=tables)
    options = parser.parse_args()
    state = root / options.state
    state.mkdir(parents=True, exist_ok=True)
    cylon = str((root / options.cylon).resolve())
    folder = root / "scenarios" / "measured"

    def put(name, text):
        measured.put(page, f"<!-- {name} -->", f"<!-- /{name} -->", text)

    if options.only in (None, "levels"):
        # Of the first row seeds with which no setting of the method was chosen.
        counts = {cases[0]: "1000-1999", cases[1]: "1000", cases[2]: "300"} | dict.fromkeys(cases[3:], "100")
        put("levels", levels(str((root / options.levels).resolve()), state, counts))
    if options.only in (None, "validation"):
        done = subprocess.run([cylon, "run", "--suite", "validation", "--json", "-"], capture_output=True, text=True, cwd=state)
        put("validation", "From `cylon run --suite validation --json -`:\n\n" + claims(json.loads(done.stdout)["verdicts"]))
    cubes = folder / "cube_tosses" / "tosses.toml"
    if options.only in (None, "tosses"):
        words = words_of("predict", cubes, ["--members", "0"], all_engines)
        found = found_by(cylon, words, state)
        put("tosses", "\n\n".join([shown(words) + ":", predicted_rests(found), nearer(found)]))
    if options.only in (None, "lengths"):
        words = words_of("predict", cubes, ["--members", "0"], ["bullet"])
        found = found_by(cylon, words, state)
        put("lengths", f"{shown(words)}, on the lengths of the data:\n\n{lengths(found)}")
        put("touches", f"The same command on touches:\n\n{touches(found)}")
    if options.only in (None, "bands"):
        put("bands", "From `cylon predict scenarios/measured/cube_tosses/tosses.toml --runs RUNS --engine ENGINE` and the option of the column:\n\n"
            + covered(cylon, cubes, state))
    if options.only in (None, "cube fit"):
        # The in-house engine in steps, as the others: where impacts are located, each of the bounces in which a cube comes to
        # rest takes its time, and a fit thirty times as long.
        words = words_of("fit", cubes, ["--timeout", "600"], ["bullet", "ode", "in-house/path=stepping"])
        found = found_by(cylon, words, state)
        put("cube fit", "\n\n".join([judged(words, found), parameters(found), rests(found), likelier(found)]))
    if options.only in (None, "cube folds"):
        how, of = crossed
        fit = words_of("fit", cubes, ["--timeout", "600", *how], of)
        fits = found_by(cylon, fit, state)
        evaluations = sum(one["evaluations"] for one in fits["fits"])
        file = {"fit.json": str(folder_of(fit, state) / "found.json")}
        predict = words_of("predict", cubes, [*how[:2], "--fit", "fit.json"], [])
        found = [found_by(cylon, [*predict, *more], state, file) for more in ([], ["--discrepancy"])]
        put("cube folds", "\n\n".join([f"{shown([*fit, '--json', 'fit.json'])}, {evaluations} evaluations of the likelihood, and then "
                                       f"`cylon {shlex.join(predict)}`:", unseen(*found), likelier(fits), nearer(found[0])]))
    for arms, (how, of) in pendulums.items():
        swings = folder / f"pendulum_{arms}" / "swings.toml"
        if options.only in (None, arms):
            words = words_of("predict", swings, [])
            put(arms, shown(words) + ":\n\n" + predicted_horizons(found_by(cylon, words, state)))
        fit = words_of("fit", swings, how, of)
        if arms in fitted and options.only in (None, f"{arms} fitted"):
            values = {p["name"]: p["value"] for p in found_by(cylon, fit, state)["fits"][0]["parameters"]}
            words = words_of("predict", swings, [word for name in fitted[arms] for word in ("--set", f"{name}={values[name]:.4g}")])
            put(f"{arms} fitted", shown(words) + ":\n\n" + predicted_horizons(found_by(cylon, words, state)))
        if options.only in (None, f"{arms} fit"):
            words = fit
            found = found_by(cylon, words, state)
            texts = [judged(words, found), parameters(found), judged_horizons(found), likelier(found)]
            put(f"{arms} fit", "\n\n".join(text for text in texts if text))


main()
