#!/usr/bin/env python3
"""A complete engine behind Cylon's worker protocol (docs/protocol.md): point bodies under uniform
gravity and undamped springs, by velocity Verlet.  For every other scene it answers why it cannot."""
import json
import math
import struct
import sys
import time

SCHEME = {"name": "verlet", "order": 2, "conserves": "phase-space volume"}
HELLO = {"ok": "hello", "protocol": 1, "engine": "example", "version": "1.0", "precision": "double",
         "schemes": [SCHEME]}


def unsupported(scene):
    for key in ("drag", "thrust", "drive", "attraction", "water", "joint", "frame"):
        if scene.get(key):
            return f"no {key}"
    for body in scene["body"]:
        if body["collide"]:
            return f"no contacts, but '{body['name']}' collides"
        if any(body["angular_velocity"]):
            return f"no rotation, but '{body['name']}' spins"
    for spring in scene["spring"]:
        if spring["damping"] or any(spring["anchor"]) or any(spring.get("to_anchor", [])):
            return "springs join centres, without damping"


class World:
    def __init__(self, scene, dt):
        self.dt, self.gravity, self.bodies = dt, scene["gravity"], scene["body"]
        self.index = {body["name"]: i for i, body in enumerate(self.bodies)}
        self.springs = scene["spring"]
        self.x = [list(body["position"]) for body in self.bodies]
        self.v = [list(body["velocity"]) for body in self.bodies]
        self.a = self.accelerations()

    def accelerations(self):
        a = [list(self.gravity) for _ in self.bodies]
        for s in self.springs:  # F = stiffness (|d| - rest_length) d/|d| on body, -F on to
            i, j = self.index[s["body"]], self.index.get(s.get("to"))
            end = s["pin"] if j is None else self.x[j]
            d = [e - x for e, x in zip(end, self.x[i])]
            length = math.hypot(*d)
            pull = s["stiffness"] * (1 - s["rest_length"] / length) if length else 0.0
            for k in range(3):
                a[i][k] += pull * d[k] / self.bodies[i]["mass"]
                if j is not None:
                    a[j][k] -= pull * d[k] / self.bodies[j]["mass"]
        return [[0.0] * 3 if body["locked"] else ai for body, ai in zip(self.bodies, a)]

    def step(self):  # x += v dt + a dt^2/2;  v += (a + a') dt/2
        for x, v, a in zip(self.x, self.v, self.a):
            x[:] = [x[k] + (v[k] + 0.5 * a[k] * self.dt) * self.dt for k in range(3)]
        before, self.a = self.a, self.accelerations()
        for v, a, b in zip(self.v, self.a, before):
            v[:] = [v[k] + 0.5 * (a[k] + b[k]) * self.dt for k in range(3)]

    def state(self):
        return b"".join(struct.pack("<13d", *x, *body["orientation"], *v, 0, 0, 0)
                        for x, v, body in zip(self.x, self.v, self.bodies))


def say(message):
    sys.stdout.buffer.write(json.dumps(message).encode() + b"\n")


def send(first_step, state):  # the simplest legal frame: one state
    sys.stdout.buffer.write(struct.pack("<4sIQQQ", b"CYLF", 1, first_step, 1, len(state)) + state)


def run(world, steps, every, at):
    frames, nanoseconds, extra = 0, 0, set(at)
    for step in range(1, steps + 1):
        start = time.thread_time_ns()
        world.step()
        nanoseconds += time.thread_time_ns() - start
        if step % every == 0 or step == steps or step in extra:
            send(step, world.state())
            frames += 1
    say({"ok": "run", "steps": steps, "frames": frames, "step_ns": nanoseconds})


for line in sys.stdin:
    request = json.loads(line)
    if request["cmd"] == "hello":
        say(HELLO)
    elif request["cmd"] == "load" and (request["path"] or request["options"]
                                       or request["integrator"] not in ("", SCHEME["name"])):
        say({"error": f"this engine has one path, the integrator {SCHEME['name']} and no options"})
    elif request["cmd"] == "load" and (reason := unsupported(request["scene"])):
        say({"unsupported": reason})
    elif request["cmd"] == "load":
        world = World(request["scene"], request["dt"])
        say({"ok": "load", "integrator": SCHEME["name"], "order": SCHEME["order"]})
        send(0, world.state())
    elif request["cmd"] == "run":
        run(world, request["steps"], request["every"], request["at"])
    elif request["cmd"] == "quit":
        break
    sys.stdout.flush()
