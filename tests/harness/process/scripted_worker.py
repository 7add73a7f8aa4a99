#!/usr/bin/env python3
"""An engine that misbehaves in the one way named by its first argument; bodies move uniformly.
Every other part of the conversation is as docs/protocol.md says."""
import json
import os
import signal
import struct
import sys
import time

MODE = sys.argv[1]
out = sys.stdout.buffer


def say(message):
    out.write(json.dumps(message).encode() + b"\n")
    out.flush()


def send(step, states, stride=1, magic=b"CYLF", count=None, cut=None):
    payload = b"".join(states)
    frame = struct.pack("<4sIQQQ", magic, count or len(states), step, stride, len(payload)) + payload
    out.write(frame[:cut])
    out.flush()


def state(bodies, t, junk=""):
    rows = []
    for b in bodies:
        x = [p + v * t for p, v in zip(b["position"], b["velocity"])]
        if junk == "nan":
            x = [float("nan"), float("inf"), x[2]]
        if junk == "nonsense":  # finite, and nowhere
            x = [1e30, -1e30, 1e30]
        q = [1.5 * u for u in b["orientation"]] if junk == "long_quaternion" else b["orientation"]
        rows.append(struct.pack("<13d", *x, *q, *b["velocity"], *b["angular_velocity"]))
    return b"".join(rows)


def forever():
    while True:
        pass


def misbehave(at):
    """What happens at one point of the conversation: hello, load, run."""
    if MODE == f"abort_in_{at}":
        print("Assertion 'mass > 0' failed", file=sys.stderr, flush=True)
        os.abort()
    if MODE == f"exit_0_in_{at}":
        os._exit(0)
    if MODE == f"exit_7_in_{at}":
        os._exit(7)
    if MODE == f"loop_in_{at}":
        forever()
    if MODE == f"says_and_loops_in_{at}":  # to whoever looks into the folder
        open("at_work", "w").close()
        forever()
    if MODE == f"ignore_terminate_in_{at}":
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
        forever()
    if MODE == f"garbage_in_{at}":
        print("Warning: friction too high", flush=True)
        forever()
    if MODE == f"not_json_in_{at}":
        print("{'ok': 'hello'}", flush=True)
        forever()
    if MODE == f"close_stdout_in_{at}":
        os.close(1)
        forever()
    if MODE == f"huge_line_in_{at}":
        out.write(b"{" + b" " * (40 << 20))
        out.flush()
        forever()
    if MODE == f"deep_line_in_{at}":
        out.write(b'{"ok":' + b"[" * 4000000 + b"]" * 4000000 + b"}\n")
        out.flush()
        forever()
    if MODE == f"memory_in_{at}":
        hog = []
        while True:
            hog.append(bytearray(os.urandom(1)) * (1 << 20))
    if MODE == f"chatter_in_{at}":
        sys.stderr.write("solver complains\n" * 60000 + "last complaint\n")
        sys.stderr.flush()
    if MODE == f"orphan_in_{at}":
        if os.fork() == 0:
            forever()
        os._exit(3)
    if MODE == f"stray_in_{at}":  # out of the group, and of the parent's reach
        if os.fork() == 0:
            os.setsid()
            if os.fork() == 0:
                forever()
            os._exit(0)
        os.wait()
        os._exit(3)
    if MODE == f"regroups_in_{at}":  # into its child's group
        child = os.fork()
        if child == 0:
            os.setpgid(0, 0)
            forever()
        while os.getpgid(child) != child:
            pass
        os.setpgid(0, child)
        forever()
    if MODE == f"family_memory_in_{at}":  # 5 * 80 MiB, each by itself within the limit
        for _ in range(5):
            if os.fork() == 0:
                hog = bytearray(b"x") * (80 << 20)
                forever()
        forever()
    if MODE == f"file_memory_in_{at}":  # resident in no process
        hog = os.memfd_create("hog")
        for _ in range(400):
            os.write(hog, b"x" * (1 << 20))
        forever()
    if MODE == f"spies_in_{at}":  # says what it can see and do
        import socket
        found = []
        for path in os.environ["SPY_FILES"].split(":"):
            try:
                open(path, "rb").read(1)
                found.append(f"reads {path}")
            except OSError:
                pass
        if "SPY_SECRET" in os.environ:
            found.append("knows")
        for path in ("written_by_worker", "/usr/written_by_worker"):
            try:
                open(path, "w").close()
                found.append(f"writes {path}")
            except OSError:
                pass
        if len([p for p in os.listdir("/proc") if p.isdigit()]) > 5:
            found.append("sees processes")
        try:
            socket.create_connection(("127.0.0.1", int(os.environ["SPY_PORT"])), 2)
            found.append("connects")
        except OSError:
            pass
        import ctypes
        if ctypes.CDLL(None).ptrace(16, 1, 0, 0) == 0 or ctypes.get_errno() not in (0, 1):
            found.append("traces")
        print("found: " + ", ".join(found), file=sys.stderr, flush=True)
    if MODE == "event_flood" and at == "run":
        out.write(b'{"event":{"kind":"bounce","body":0,"other":1,"plane":-1,"index":1,"time":0.1,"speed":1,"height":0}}\n' * 1100000)
    if MODE == f"slow_{at}":
        time.sleep(30)


def run(bodies, dt, request):
    steps, every, at = request["steps"], request["every"], set(request["at"])
    frames = 0
    for step in range(1, steps + 1):
        if step == steps // 2:
            misbehave("run")
        if not (step % every == 0 or step == steps or step in at):
            continue
        now = [state(bodies, step * dt, MODE if step > steps // 2 else "")]
        frames += 1
        if step <= steps // 2:
            send(step, now)
        elif MODE == "bad_magic":
            send(step, now, magic=b"CYLG")
        elif MODE == "wrong_bodies":
            send(step, [now[0] + now[0][:104]])
        elif MODE == "wrong_count":
            send(step, now, count=1000)
        elif MODE == "torn_frame":
            send(step, now, cut=40)
            os._exit(0)
        elif MODE == "garbage_in_frame":
            send(step, now, cut=40)
            say({"event": {}})
            send(step, now)
        elif MODE == "backward":
            send(step - 2, now)
        elif MODE == "unwatched_event":
            send(step, now)
            say({"event": {"kind": "bounce", "body": 0, "other": -1, "plane": 5, "index": 1, "time": 0.5,
                           "speed": 1, "height": 0}})
        elif MODE == "error_in_run":
            say({"error": "Jacobian is singular"})
        else:
            send(step, now)
    done = {"ok": "run", "steps": steps, "frames": frames, "step_ns": 1000 * steps}
    if MODE == "miscounts":
        done["frames"] += 1
    if MODE == "adaptive":
        done["remarks"] = [f"tolerance {tolerance:g} was not reached: 0.5 was"]
    if MODE.startswith("diagnoses"):
        one = {"kind": "slow", "text": "it was slow", "bodies": [bodies[1]["name"]]}
        done["diagnostics"] = [{**one, **{"diagnoses_nobody": {"bodies": ["nobody"]},
                                          "diagnoses_too_many": {"body_count": len(bodies) + 1}}.get(MODE, {})}]
    if MODE == "boasts":
        done["step_ns"] = 5e9
    if MODE == "hides":  # what the steps cost
        until = time.process_time() + 0.2
        while time.process_time() < until:
            pass
    if MODE == "works":
        done["step_ns"] = 2e8
        until = time.process_time() + 0.2
        while time.process_time() < until:
            pass
    if MODE == "shaves":  # each step takes 20 us, of which one is told
        until = time.process_time() + 20e-6 * steps
        while time.process_time() < until:
            pass
    if MODE == "misspells":
        done["setp_ns"] = done.pop("step_ns")
    say(done)


bodies, dt, tolerance = [], 0, 0
for text in sys.stdin:
    request = json.loads(text)
    cmd = request["cmd"]
    if cmd == "hello":
        misbehave("hello")
        say({"ok": "hello", "protocol": 2 if MODE == "protocol_2" else 1, "engine": "scripted",
             "version": "v" * (15 << 20) if MODE == "long_version" else MODE,
             "precision": "double", "events": MODE == "event_flood",
             **({"schemes": [{"name": "stiff"}, {"name": "controlled", "order": 5, "adaptive": True}]}
                if MODE == "adaptive" else {})})
    elif cmd == "load":
        misbehave("load")
        bodies, dt, tolerance = request["scene"]["body"], request["dt"], request.get("tolerance", 0)
        if MODE == "unsupported":
            say({"unsupported": "no bodies at all"})
        elif MODE == "refuses_load":
            say({"error": "this worker takes no scene"})
        elif request["options"]:
            say({"error": f"unknown option '{list(request['options'])[0]}'"})
        else:
            say({"ok": "load", "integrator": "uniform", "order": 1,
                 **({"plan": [{"name": "flight", "in": True, "reason": "bodies move"},
                              {"name": "far too \x1b[31mred", "in": False, "reason": "nothing is"}]}
                    if MODE == "adaptive" else {})})
            send(0, [state(bodies, 1e-9 if MODE == "wrong_start" else 0)])
    elif cmd == "run":
        run(bodies, dt, request)
    elif cmd == "quit":
        if MODE == "crash_at_quit":
            os.kill(os.getpid(), signal.SIGSEGV)
        if MODE == "stay_at_quit":
            forever()
        break
