#!/usr/bin/env python3
"""An engine that speaks docs/protocol.md and does one misdeed: engine.py MISDEED, as the table below names it.
Bodies move uniformly.  tests/hostile/misdeeds.py runs every one beside a healthy engine."""
import json
import mmap
import os
import signal
import struct
import sys
import tempfile
import time

MIB = 1 << 20
HELLO = {"ok": "hello", "protocol": 1, "engine": "wild", "version": "1", "precision": "double",
         "schemes": [{"name": "s", "order": 1}]}
HOSTILE = "<script>alert(1)</script>|=cmd\x1b[2J\u202e\u0000\uffff`"
bodies, dt = [], 0.0


def write(data):
    view = memoryview(data)
    while view:
        view = view[os.write(1, view):]


def say(message):
    write(json.dumps(message).encode() + b"\n")


def frame(first, payload, states=1, stride=1, size=None):
    write(struct.pack("<4sIQQQ", b"CYLF", states, first, stride, len(payload) if size is None else size) + payload)


def states(t, dx=0.0):
    return b"".join(
        struct.pack("<13d", *[p + v * t + dx for p, v in zip(b["position"], b["velocity"])], *b["orientation"],
                    *b["velocity"], *b["angular_velocity"]) for b in bodies)


def spin():
    while True:
        pass


def sleeper():
    os.execvp("sleep", ["sleep", "311.5"])


def hidden_sleeper():
    os.execve("/bin/sleep", ["sleep", "311.5"], {})


def children(count, work):
    for _ in range(count):
        if os.fork() == 0:
            work()
            os._exit(0)


def restless():
    """Becomes a program of 1000 segments that starts itself again and again.  While the kernel lays out its memory, which
    is nearly always, it has no environment that anybody could read."""
    base, segments = 0x400000, 1000
    code = bytes.fromhex("488b0c24 488d742408 488d54ce08 488d3d0e000000 b83b000000 0f05 b83c000000 0f05") + b"/proc/self/exe\0"
    start = 64 + 56 * segments
    head = struct.pack("<16sHHIQQQIHHHHHH", b"\x7fELF\2\1\1", 2, 62, 1, base + start, 64, 0, 0, 64, 56, segments, 64, 0, 0)
    whole = start + len(code)
    table = struct.pack("<IIQQQQQQ", 1, 5, 0, base, base, whole, whole, 4096)
    for i in range(1, segments):
        place = 0x10000000 + i * 8192
        table += struct.pack("<IIQQQQQQ", 1, 4, 0, place, place, 4096, 4096, 4096)
    program = f"restless{os.getpid()}"
    with open(program, "wb") as out:
        out.write(head + table + code)
    os.chmod(program, 0o700)
    os.execv(program, [program])


def regroup():
    child = os.fork()
    if child == 0:
        os.setpgid(0, 0)
        spin()
    while os.getpgid(child) != child:
        pass
    os.setpgid(0, child)
    spin()


def leave(work):
    def away():
        os.setsid()
        work()
    return away


def hold_stdout(work):
    if os.fork() == 0:
        work()
        os._exit(0)
    os._exit(0)


def ignore_signals():
    for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)
    spin()


def flood(piece, stream=1):
    while True:
        os.write(stream, piece)


def eat():
    held = []
    while True:
        held.append(bytearray(os.urandom(1)) * MIB)


def eat_fast():
    held = []
    while True:
        held.append(mmap.mmap(-1, 1 << 30))
        held[-1].write(b"\1" * (1 << 30))


def eat_in_files(make):
    held = []  # descriptors of 2 GiB, whose pages are resident in no process
    for _ in range(32):
        held.append(make())
        os.write(held[-1], b"\1" * (64 * MIB))
    spin()


def nameless_file():
    fd, name = tempfile.mkstemp(dir="/dev/shm")
    os.unlink(name)
    return fd


def eat_in_family():
    def share():
        hog = bytearray(b"x") * (180 * MIB)
        time.sleep(30 if hog else 0)
    children(5, share)
    time.sleep(30)


def close_all():
    for fd in (0, 1, 2):
        os.close(fd)
    spin()


def append_garbage():
    for name in (".cylon/journal.jsonl",):
        try:
            with open(name, "a", encoding="utf8") as out:
                out.write('{"request":{"workers":["x=/usr/bin/touch forged"]}}\n')
        except OSError:
            pass


def slow_bytes():
    for c in json.dumps(HELLO).encode() * 100:
        os.write(1, bytes([c]))
        time.sleep(1)


def overflowing_frame():
    payload = states(0) or b"\0" * 104
    write(struct.pack("<4sIQQQ", b"CYLF", 1, 2**64 - 1, 2**64 - 1, len(payload)) + payload)
    spin()


def line(text):
    def tell():
        write(text + b"\n")
        spin()
    return tell


def once(data):
    return lambda: write(data)


def event(**change):
    return {"event": {"kind": "bounce", "body": 0, "other": -1, "plane": 0, "index": 1, "time": 0.1, "speed": 1,
                      "height": 0, **change}}


EVENTS = json.dumps(event()).encode() + b"\n"

# What is done at a point of the conversation: name -> (points, deed).
ANYWHERE = ("hello", "load", "run")
AT = {
    "children_of_the_dead": (ANYWHERE, lambda: (children(5, sleeper), os._exit(1))),
    "children_stay": (ANYWHERE + ("quit",), lambda: children(5, sleeper)),
    "children_leave": (ANYWHERE + ("quit",), lambda: children(5, leave(sleeper))),
    "children_leave_and_restart": (ANYWHERE + ("quit",), lambda: (children(20, leave(restless)), os._exit(1))),
    "children_hide": (("run", "quit"), lambda: children(2, leave(hidden_sleeper))),
    "leaves_its_group": (("load", "run"), regroup),
    "child_holds_stdout": (ANYWHERE, lambda: hold_stdout(sleeper)),
    "stranger_holds_stdout": (ANYWHERE, lambda: hold_stdout(leave(sleeper))),
    "ignores_signals": (("run",), ignore_signals),
    "endless_line": (("hello", "run"), lambda: (write(b"{"), flood(b"x" * MIB))),
    "endless_lines": (("hello", "run"), lambda: flood(b'{"a":1}\n' * 100000)),
    "endless_frames": (("run",), lambda: flood((struct.pack("<4sIQQQ", b"CYLF", 1, 1, 1, len(states(0))) + states(0)) * 5000)),
    "endless_stderr": (("run",), lambda: flood(b"\x1b[31m\x07<script>\n" * 50000, 2)),
    "endless_events": (("run",), lambda: flood(EVENTS * 2000)),
    "a_byte_a_second": (("hello",), slow_bytes),
    "huge_number": (("hello",), line(b'{"ok":"hello","protocol":1' + b"0" * 4000000 + b"}")),
    "huge_exponent": (("hello",), line(b'{"ok":"hello","protocol":1e99999}')),
    "big_integer": (("hello",), line(b'{"ok":"hello","protocol":18446744073709551617,"engine":"w","version":"1","precision":"double"}')),
    "integer_that_wraps": (("hello",), line(b'{"ok":"hello","protocol":18446744073709551615,"engine":"w","version":"1","precision":"double"}')),
    "deep_arrays": (ANYWHERE, line(b'{"ok":' + b"[" * 4000000 + b"]" * 4000000 + b"}")),
    "deep_objects": (ANYWHERE, line(b'{"a":' * 2000000 + b"1" + b"}" * 2000000)),
    "deep_and_open": (ANYWHERE, line(b'{"a":' + b"[" * 15000000)),
    "many_values": (("hello", "run"), line(b'{"ok":[' + b"[]," * 5000000 + b"0]}")),
    "zeros": (ANYWHERE, lambda: (write(b"\0" * MIB), spin())),
    "no_utf8": (("hello",), line(b'{"ok":"hello\xff\xfe"}')),
    "memory": (("load", "run"), eat),
    "memory_at_once": (("load",), eat_fast),
    "memory_of_a_family": (("load",), eat_in_family),
    "memory_in_memfd": (("load", "run"), lambda: eat_in_files(lambda: os.memfd_create("hog"))),
    "memory_in_nameless_files": (("run",), lambda: eat_in_files(nameless_file)),
    "stops": (("run",), lambda: os.kill(os.getpid(), signal.SIGSTOP)),
    "stops_its_group": (("run",), lambda: os.kill(0, signal.SIGSTOP)),
    "closes_stdin": (("load",), lambda: os.close(0)),
    "closes_everything": (ANYWHERE, close_all),
    "forges_the_journal": (("run",), append_garbage),
    "becomes_cat": (ANYWHERE, lambda: os.execvp("cat", ["cat"])),
    "segmentation_fault": (ANYWHERE + ("quit",), lambda: os.kill(os.getpid(), signal.SIGSEGV)),
    "real_time_signal": (("run",), lambda: os.kill(os.getpid(), 40)),
    "two_objects": (("hello",), line(b'{"ok":"hello"}{"ok":"hello"}')),
    "an_array": (("hello",), line(b"[1]")),
    "byte_order_mark": (("hello",), line(b"\xef\xbb\xbf" + json.dumps(HELLO).encode())),
    "unknown_key": (("hello",), lambda: say({**HELLO, "surprise": 1})),
    "version_of_megabytes": (("hello",), lambda: say({**HELLO, "version": "v" * (15 * MIB)})),
    "many_schemes": (("hello",), lambda: say({**HELLO, "schemes": [{"name": f"s{i}", "order": 1} for i in range(200000)]})),
    "error": (ANYWHERE, lambda: say({"error": "I refuse " + HOSTILE})),
    "error_of_megabytes": (("load",), lambda: say({"error": "E" * (15 * MIB)})),
    "error_that_is_no_text": (ANYWHERE, lambda: say({"error": {"a": [1]}})),
    "unsupported_of_megabytes": (("load",), lambda: say({"unsupported": "U" * (15 * MIB)})),
    "all_answers_at_once": (("load",), lambda: say({"ok": "load", "error": "x", "unsupported": "y"})),
    "early_frame": (("hello", "load"), lambda: frame(0, b"\0" * 104)),
    "huge_frame": (("load", "run"), lambda: (write(struct.pack("<4sIQQQ", b"CYLF", 2**32 - 1, 0, 0, 2**64 - 1)), spin())),
    "overflowing_frame": (("run",), overflowing_frame),
    "empty_frame": (("run",), lambda: (write(struct.pack("<4sIQQQ", b"CYLF", 0, 0, 0, 0)), spin())),
    "strange_event": (("run",), lambda: say(event(index=-2**31, time=1e308, speed=-1, height=None))),
}
# What it does with its states, and what it says at the end.
STATES = {
    "denormal": struct.pack("<13d", 5e-324, -5e-324, 0.0, 1, 0, 0, 0, 5e-324, -0.0, 0, 0, 0, 0),
    "nan_with_payload": struct.pack("<Q", 0x7ff4dead00000001) * 13,
    "largest_doubles": struct.pack("<13d", *[sys.float_info.max] * 13),
    "zero_quaternion": struct.pack("<13d", *[0.0] * 13),
}
DONE = {
    "negative_time": {"step_ns": -1},
    "huge_time": {"step_ns": 1e308},
    "wrong_steps": {"steps": 7},
    "steps_that_wrap": {"steps": 2**64 - 1},
    "remarks_of_megabytes": {"remarks": ["R" * 1000] * 15000},
    "hostile_remarks": {"remarks": [HOSTILE]},
    "hostile_diagnostics": {"diagnostics": [{"kind": HOSTILE, "method": HOSTILE, "unit": HOSTILE, "text": HOSTILE}]},
    "diagnostic_of_nobody": {"diagnostics": [{"kind": "k", "text": "t", "bodies": [HOSTILE]}]},
}
OTHERS = ["out_of_order", "twice_each", "none_but_the_last", "beyond_the_end", "done_twice", "garbage_behind",
          "protocol_0", "protocol_as_text", "hostile_names", "huge_order", "starts_elsewhere", "stays"]
MISDEEDS = [f"{name}@{point}" for name, (points, _) in AT.items() for point in points] + list(STATES) + list(DONE) + OTHERS


def at(point):
    name, _, here = MISDEED.partition("@")
    if name in AT and here == point:
        AT[name][1]()


def run(request):
    steps, every, extra = request["steps"], request["every"], set(request["at"])
    frames = 0
    for step in range(1, steps + 1):
        if step == steps // 2 + 1:
            at("run")
        if not (step % every == 0 or step == steps or step in extra):
            continue
        payload = states(step * dt)
        if step > steps // 2:
            payload = STATES[MISDEED] * len(bodies) if MISDEED in STATES else payload
            if MISDEED == "out_of_order":
                step += every
            if MISDEED == "none_but_the_last" and step != steps:
                continue
            if MISDEED in ("twice_each", "beyond_the_end"):
                frame(step if MISDEED == "twice_each" else steps + 1, payload)
                frames += 1
        frame(step, payload)
        frames += 1
    done = {"ok": "run", "steps": steps, "frames": frames, "step_ns": 1000.0, **DONE.get(MISDEED, {})}
    say(done)
    if MISDEED == "done_twice":
        say(done)
    if MISDEED == "garbage_behind":
        write(b"garbage after the end\n" * 10)


def answer(request):
    global bodies, dt
    if request["cmd"] == "hello":
        at("hello")
        hello = dict(HELLO)
        if MISDEED in ("endless_events@run", "strange_event@run"):
            hello["events"] = True
        if MISDEED.startswith("protocol_"):
            hello["protocol"] = 0 if MISDEED == "protocol_0" else "1"
        if MISDEED == "hostile_names":
            hello.update(engine=HOSTILE, version=HOSTILE, schemes=[{"name": HOSTILE, "order": 1}])
        say(hello)
    elif request["cmd"] == "load":
        bodies, dt = request["scene"]["body"], request["dt"]
        at("load")
        loaded = {"ok": "load", "integrator": "s", "order": 2**31 - 1 if MISDEED == "huge_order" else 1}
        if MISDEED == "hostile_names":
            loaded.update(path=HOSTILE, gyroscopic=HOSTILE, integrator=HOSTILE, unforceable=[HOSTILE],
                          settings=[{"name": HOSTILE, "value": HOSTILE}])
        say(loaded)
        frame(0, states(0, 1e-9 if MISDEED == "starts_elsewhere" else 0.0))
    elif request["cmd"] == "run":
        run(request)
    elif request["cmd"] == "quit":
        at("quit")
        if MISDEED == "stays":
            ignore_signals()
        sys.exit()


if __name__ == "__main__":
    MISDEED = sys.argv[1]
    for text in sys.stdin:
        answer(json.loads(text))
