#!/usr/bin/env python3
"""Fails where a source includes, directly or through other headers, what its layer must not know.

    tests/layering_test.py build/release/layers.json

The layers, their arrows and the few finer rules are what CMake wrote into layers.json while it declared the targets
(cmake/layers.cmake); nothing of them is repeated here. The compiler alone stops no include: Debian keeps every library's
headers in one folder, and all of our sources are included from one root.
"""
import fnmatch
import functools
import json
import pathlib
import re
import sys
import tempfile

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)', re.MULTILINE)
SOURCES = {".h", ".hpp", ".cc", ".cpp", ".inc"}
# What is no library: the standard library's headers, and those of POSIX and Linux.
STANDARD = re.compile(r"[a-z_0-9]+$")
SYSTEM = re.compile(r"(arpa|linux|net|netinet|sys)/|(dirent|dlfcn|execinfo|fcntl|ifaddrs|immintrin|langinfo|malloc|poll|pthread|sched|signal|spawn|"
                    r"stddef|stdint|stdlib|time|unistd)\.h$")

# Nothing depends on these but each other: one suite may take another's helper, as far as it knows what the helper includes.
LEAVES = {"tests", "tool", "bench"}


class Layer:
    """All targets that are built from the same sources: the two precisions of an engine are one layer."""

    def __init__(self, place):
        self.place = place  # a folder with a slash behind it, or a file
        self.names, self.kinds, self.public, self.private = [], set(), set(), set()


class Tree:
    """The sources under a root, judged by what CMake declared of them."""

    def __init__(self, root, declared):
        self.root = pathlib.Path(root)
        self.layers, self.layer_of_target = {}, {}
        for row in declared["layers"]:
            for place in row["places"]:
                layer = self.layers.setdefault(place, Layer(place))
                layer.names.append(row["name"])
                layer.kinds.add(row["kind"])
                layer.public.update(row["public"])
                layer.private.update(row["private"])
                self.layer_of_target.setdefault(row["name"], []).append(layer)
        self.headers = {row["library"]: re.compile(row["headers"]) for row in declared["headers"]}
        self.folders = {row["library"]: [pathlib.Path(f) for f in row["folders"]] for row in declared["engines"]}
        self.forbidden = [(row["files"], row["header"]) for row in declared["forbidden"]]
        self.tops = {layer.place.split("/")[0] for layer in self.layers.values()}
        self.includes = functools.cache(self.includes)
        self.knows = functools.cache(self.knows)
        self.meaning = functools.cache(self.meaning)

    def sources(self):
        return sorted(str(p.relative_to(self.root)) for top in self.tops for p in (self.root / top).rglob("*")
                      if p.suffix in SOURCES and "node_modules" not in p.parts)

    def includes(self, file):
        path = self.root / file
        text = path.read_text(encoding="utf-8") if path.is_file() else ""
        return [header for _, header in INCLUDE.findall(text)]

    def layer(self, file):
        """The file itself where it was declared, else the longest folder that holds it."""
        while file:
            if file in self.layers:
                return self.layers[file]
            file = file[:file.rstrip("/").rfind("/") + 1]
        return None

    def knows(self, layer):
        """Layers and libraries that a layer may include: its own, what it uses, and what that shows in its headers."""
        known = {other for other in self.layers.values() if other is layer or set(other.names) & set(layer.names)}
        if layer.kinds & LEAVES:
            known.update(other for other in self.layers.values() if other.kinds & LEAVES)
        todo = list(layer.public | layer.private)
        while todo:
            name = todo.pop()
            for used in self.layer_of_target.get(name, [name]):
                if used not in known:
                    known.add(used)
                    todo += used.public if isinstance(used, Layer) else []
        return known

    def meaning(self, file, header):
        """('ours', path), ('library', name), ('system', header) or ('unknown', why)."""
        if header.split("/")[0] in self.tops:
            return "ours", header
        for library, pattern in self.headers.items():
            if pattern.match(header):
                return "library", library
        for library, folders in self.folders.items():
            if any(header.startswith(folder.name + "/") or (folder / header).exists() for folder in folders):
                return "library", library
        if STANDARD.match(header) or SYSTEM.match(header):
            return "system", header
        return "unknown", "it is neither ours, from the root of the sources, nor of a library that cmake/dependencies.cmake lists"

    def wrong(self, file, header, layer):
        """Why a layer must not see this include of `file`, or None."""
        kind, what = self.meaning(file, header)
        if kind == "unknown":
            return what
        if kind == "ours":
            other = self.layer(what)
            if other is None:
                return "it is in no layer"
            return None if other in self.knows(layer) else f"{layer.names[0]} does not use {other.names[0]}"
        if kind == "library":
            return None if what in self.knows(layer) else f"{layer.names[0]} does not use {what}"
        return None

    def judge(self, file, extra=()):
        """Everything that is wrong with a source; `extra`: includes that it is thought to have beside its own."""
        layer = self.layer(file)
        if layer is None:
            return [f"{file} is in no layer"]
        found, bad = [], set()
        for steps, at, header in self.reached(file, extra):
            why = None if bad & set(steps[:-1]) else self.wrong(at, header, layer)  # not again what stands behind it
            if why:
                bad.add(header)
                found.append(f"{' -> '.join(steps)}: {why}")
        for files, never in self.forbidden:
            if fnmatch.fnmatch(file, files):
                found += [f"{' -> '.join(steps)}: CMakeLists.txt forbids it"
                          for steps, _, header in self.reached(file, extra)
                          if fnmatch.fnmatch(header, never) and header != file]
        return found

    def reached(self, file, extra=()):
        """(way, includer, header) of every include that a source reaches; the shortest way."""
        seen, todo = {file}, [((file,), file, list(extra) + self.includes(file))]
        while todo:
            way, at, headers = todo.pop(0)
            for header in headers:
                yield (*way, header), at, header
                if header in seen or self.meaning(at, header)[0] != "ours":
                    continue
                seen.add(header)
                todo.append(((*way, header), header, self.includes(header)))


def controls():
    """A rule that catches nothing is no rule: what must be refused and allowed in a small tree, on every run."""
    declared = {
        "layers": [
            dict(name="engine", kind="layer", places=["engine/"], public=["Eigen"], private=["tbb"]),
            dict(name="core", kind="layer", places=["core/"], public=["Eigen"], private=[]),
            dict(name="store", kind="layer", places=["core/store/"], public=["core"], private=["sqlite"]),
            dict(name="app", kind="layer", places=["app/"], public=["store"], private=[]),
            dict(name="sim_ball", kind="simulator", places=["sims/ball/"], public=["core"], private=["pkg:ball"]),
            dict(name="sim_cube", kind="simulator", places=["sims/cube/"], public=["core"], private=["engine"]),
            dict(name="user", kind="layer", places=["user/"], public=["sim_ball", "sim_cube"], private=[]),
            dict(name="suite", kind="tests", places=["tests/"], public=[], private=["app", "gtest"]),
            dict(name="inner", kind="tests", places=["tests/inner/"], public=[], private=["core"]),
            dict(name="one", kind="program", places=["app/main.cc"], public=[], private=["core"]),
        ],
        "headers": [dict(library="Eigen", headers="Eigen/"), dict(library="tbb", headers="tbb/"),
                    dict(library="sqlite", headers="sqlite3"), dict(library="gtest", headers="gtest/")],
        "engines": [dict(library="pkg:ball", folders=["include/ball"])],
        "forbidden": [dict(files="core/measure*", header="core/simulator.h")],
    }
    tree = {
        "engine/world.h": "<Eigen/Core>", "engine/pile.h": "<tbb/parallel_for.h>",
        "core/scene.h": "<Eigen/Core> <vector>", "core/simulator.h": '"core/scene.h"', "core/lane.h": '"core/simulator.h"',
        "core/far.h": '"core/lane.h"',
        "core/store/rows.h": '"core/scene.h"', "core/store/statement.h": "<sqlite3.h>",
        "app/view.h": '"core/store/rows.h"', "app/table.h": '"core/store/statement.h"',
        "sims/ball/face.h": '"core/scene.h"', "sims/ball/inside.h": "<ball/world.h>",
        "sims/cube/inside.h": '"engine/world.h"', "tests/helper.h": '"app/view.h"', "tests/plain.h": "<string>",
    }
    must_refuse = [
        ("engine/world.cc", "core/scene.h"),           # the engine knows nothing of ours
        ("engine/world.cc", "../core/scene.h"),        # by a relative path
        ("engine/world.cc", "sqlite3.h"),              # a library that it does not use
        ("engine/world.cc", "surprise/surprise.h"),    # a library that nobody listed
        ("core/scene.cc", "core/store/rows.h"),        # against the arrow
        ("core/scene.cc", "new_top/thing.h"),          # not ours and no library
        ("app/list.cc", "sqlite3.h"),                  # what a layer uses inside, its user does not see
        ("app/list.cc", "core/store/statement.h"),     # nor through one header
        ("app/list.cc", "app/table.h"),                # nor through two
        ("core/measure.cc", "core/simulator.h"),       # forbidden
        ("core/measure.cc", "core/lane.h"),            # forbidden, through another header
        ("core/measure_all.h", "core/lane.h"),
        ("core/measure.cc", "core/far.h"),             # and through two
        ("sims/ball/ball.cc", "engine/world.h"),       # one adapter knows no other's engine
        ("sims/ball/ball.cc", "sims/cube/inside.h"),
        ("sims/cube/cube.cc", "ball/world.h"),
        ("user/user.cc", "ball/world.h"),              # an adapter keeps its engine to itself
        ("user/user.cc", "sims/ball/inside.h"),
        ("user/user.cc", "sims/cube/inside.h"),
        ("tests/thing_test.cc", "engine/world.h"),
        ("tests/inner/thing_test.cc", "tests/helper.h"),  # another suite's helper that reaches further than this suite
        ("app/main.cc", "core/store/rows.h"),          # a program is not the layer in whose folder it lies
        ("other/thing.cc", "vector"),                  # in no layer
    ]
    must_allow = [
        ("engine/world.cc", "Eigen/Core"), ("engine/world.cc", "vector"), ("engine/world.cc", "unistd.h"),
        ("engine/world.cc", "engine/pile.h"), ("core/store/rows.cc", "core/store/statement.h"),
        ("core/measure.cc", "core/scene.h"), ("core/lane.cc", "core/lane.h"), ("app/list.cc", "app/view.h"),
        ("app/list.cc", "core/scene.h"), ("sims/ball/ball.cc", "sims/ball/inside.h"), ("sims/cube/cube.cc", "engine/world.h"),
        ("user/user.cc", "sims/ball/face.h"), ("tests/thing_test.cc", "gtest/gtest.h"),
        ("tests/inner/thing_test.cc", "tests/plain.h"), ("app/main.cc", "core/scene.h"),
    ]
    with tempfile.TemporaryDirectory() as root:
        for file, headers in tree.items():
            path = pathlib.Path(root, file)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("".join(f"#include {header}\n" for header in headers.split()))
        small = Tree(root, declared)
        blind = [f"the test is blind: it lets {file} include {header}" for file, header in must_refuse
                 if not small.judge(file, [header])]
        strict = [f"the test is too strict: {wrong}" for file, header in must_allow for wrong in small.judge(file, [header])]
    return blind + strict


# The arrows that Cylon stands on, asked of the real declarations: whoever widens a USES by mistake hears of it here.
MUST_REFUSE = [
    ("engine/world.cc", "harness/core/scene.h"),                        # the subject does not know that it is examined
    ("engine/world.cc", "fmt/format.h"),
    ("reference/exact/heavy_top.cc", "engine/world.h"),                 # an oracle shares no code with its subject
    ("reference/certified/truth.cc", "engine/world.h"),
    ("reference/exact/heavy_top.cc", "reference/simulators/in_house/in_house_model.h"),
    ("reference/simulators/ode/ode.cc", "harness/scenario/reader.h"),   # an adapter gets a scene, never the exam
    ("reference/simulators/in_house/in_house.cc", "reference/exact/heavy_top_axis.h"),
    ("reference/workers/main.cc", "harness/scenario/reader.h"),
    ("harness/scenario/reader.cc", "engine/world.h"),                   # a scenario does not say who runs it
    ("harness/scenario/reader.cc", "reference/simulators/ode/ode_settings.h"),
    ("harness/core/observable.cc", "harness/core/simulator.h"),         # no engine is asked for its own energy
    ("harness/study/trade.cc", "harness/core/simulator.h"),             # a study talks to workers
    ("harness/results/verdict.cc", "harness/core/scene.h"),             # a verdict knows numbers alone
    ("reports/html.cc", "harness/process/worker_loop.h"),               # a report is built from stored rows
    ("reports/html.cc", "sqlite3.h"),
    ("reference/simulators/ode/ode.cc", "reference/simulators/bullet/bullet_settings.h"),  # adapters know no other
    ("reference/simulators/ode/ode.cc", "engine/world.h"),
    ("reference/simulators/bullet/bullet.cc", "ode/ode.h"),
    ("reference/simulators/ode/ode.cc", "btBulletDynamicsCommon.h"),
    ("tests/harness/cli/commands_test.cc", "reference/simulators/ode/ode_settings.h"),
    ("tests/harness/cli/commands_test.cc", "ode/ode.h"),
    ("bench/store_bench.cc", "btBulletDynamicsCommon.h"),
    ("harness/core/scene.cc", "harness/scenario/reader.h"),
    ("harness/study/trade.cc", "reports/html.h"),
    ("harness/study/trade.cc", "toml++/toml.h"),
    ("harness/tracking/statistics/holm.cc", "harness/results/verdict.h"),
    ("harness/cli/commands/main.cc", "engine/world.h"),
    ("harness/cli/selection.cc", "httplib.h"),
    ("harness/new_layer/thing.cc", "vector"),
]
MUST_ALLOW = [
    ("engine/world.cc", "Eigen/Core"),
    ("harness/core/observable.cc", "harness/core/recording.h"),
    ("reference/simulators/in_house/in_house.cc", "engine/world.h"),
    ("reference/simulators/ode/ode.cc", "ode/ode.h"),
    ("reference/simulators/bullet/bullet.cc", "btBulletDynamicsCommon.h"),
    ("harness/cli/commands/main.cc", "harness/cli/commands/app.h"),
    ("harness/cli/commands/run.cc", "reports/html.h"),
    ("tests/engine/world_test.cc", "engine/world.h"),
]


def main():
    declared = json.loads(pathlib.Path(sys.argv[1]).read_text())
    tree = Tree(pathlib.Path(__file__).resolve().parent.parent, declared)
    wrong = controls()
    wrong += [f"the layers are too wide: {file} may include {header}" for file, header in MUST_REFUSE
              if not any(line.startswith((f"{file} -> {header}", f"{file} is in no layer")) for line in tree.judge(file, [header]))]
    wrong += [f"the layers are too narrow: {line}" for file, header in MUST_ALLOW for line in tree.judge(file, [header])]
    wrong += [f"a control includes {header}, which is no file" for _, header in MUST_REFUSE + MUST_ALLOW
              if header.split("/")[0] in tree.tops and not (tree.root / header).is_file()]
    sources = tree.sources()
    wrong += [line for file in sources for line in tree.judge(file)]
    if len(sources) < 100:
        wrong.append(f"only {len(sources)} sources under {tree.root}")
    for line in wrong:
        print(line, file=sys.stderr)
    print(f"{len(sources)} sources in {len(tree.layers)} layers, {sum(len(tree.includes(s)) for s in sources)} includes")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
