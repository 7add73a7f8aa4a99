#!/usr/bin/env python3
"""Hostile files, scenarios through `cylon validate` and others through what reads them: tests/hostile/corpus.py CYLON [WORD…].

Of each: exit code 0 or 2, a place in the file where it is refused, an error of at most 4000 bytes, at most 1 GB
resident, and an end within 5 s of CPU time.  A slow machine may take longer: up to four times what it takes for a million
bodies in a lattice, which are read in one pass.  The last line is JSON: tried, failed, the most CPU seconds, how
many times that lattice's they are, and the most MB."""
import json
import math
import os
import pathlib
import re
import resource
import socket
import subprocess
import sys
import tempfile

HEAD = 'duration = 1\nstep = 0.01\n'
BODY = '[[body]]\nname="A"\nmass=1\n'
CLAIM = '[[claim]]\nconserves="energy"\ntolerance={absolute=1,reason="x"}\n'
SCENES, FILES = {}, {}


def t(name, text):
    SCENES[name] = text if isinstance(text, bytes) else text.encode()


for n in (300, 10000, 100000, 1000000, 5000000):
    t(f"dotted_key_{n}", ".".join(["a"] * n) + " = 1\n" + HEAD + BODY)
    t(f"dotted_table_{n}", HEAD + BODY + "[" + ".".join(["a"] * n) + "]\n")
    t(f"dotted_arrtable_{n}", HEAD + BODY + "[[" + ".".join(["a"] * n) + "]]\n")
    t(f"inline_dotted_{n}", HEAD + "x = {" + ".".join(["a"] * n) + "=1}\n" + BODY)
t("nest_arr", HEAD + "x=" + "[" * 5000000 + "\n")
t("nest_inline", HEAD + "x=" + "{a=" * 3000000 + "\n")
t("many_keys", HEAD + "".join(f"k{i}=1\n" for i in range(800000)) + BODY)
t("unknown_long_key", HEAD + "k" * 15000000 + "=1\n" + BODY)
t("unknown_long_word", HEAD + 'impacts="' + "k" * 15000000 + '"\n' + BODY)
t("long_string", HEAD + 'title="' + "k" * 15000000 + '"\n' + BODY + CLAIM)
t("long_step", 'duration=1\nstep="' + "1" * 15000000 + '"\n' + BODY)
t("long_line_err", HEAD + BODY + "# " + "x" * 10000000 + "\n" + "y" * 100)
t("body_1e5", HEAD + "".join(f'[[body]]\nname="b{i}"\nmass=1\nposition=[{i},0,0]\n' for i in range(100000)) + CLAIM)
t("body_2e5_dupname", HEAD + "".join(f'[[body]]\nname="b{i%199999}"\nmass=1\n' for i in range(200000)))
t("claims_2e4", HEAD + BODY + "".join(f'[[claim]]\nconserves="energy"\nuntil={0.01+i*1e-5}\ntolerance={{absolute=1,reason="x"}}\n' for i in range(20000)))
t("typo_among_1e6", HEAD + '[[lattice]]\nname="g"\nmass=1\ncount=[1000,1000,1]\nspacing=[1,1,1]\n' + '[[drag]]\nbody="%s"\nlinear=1\n' % ("z" * 3000))
t("mat_among_1e6", HEAD + '[[lattice]]\nname="g"\nmass=1\ncount=[1000,1000,1]\nspacing=[3,3,3]\nshape={type="sphere",radius=1}\n' + '[[material]]\nbetween=["%s","*"]\nrestitution=0\nfriction=0\n' % ("z" * 300))
MAT = '[[material]]\nbetween=["*","*"]\nrestitution=0\nfriction=0\n'
t("lattice_1e6", HEAD + '[[lattice]]\nname="g"\nmass=1\ncount=[1000,1000,1]\nspacing=[3,3,3]\nshape={type="sphere",radius=1}\n' + MAT + CLAIM)
t("lattice_1e6_zero_spacing_nocollide", HEAD + '[[lattice]]\nname="g"\nmass=1\ncount=[1000,1000,1]\nspacing=[0,0,0]\ncollide=false\nshape={type="sphere",radius=1}\n' + CLAIM)
t("lattice_x0", HEAD + '[[lattice]]\nname="g"\nmass=1\ncount=[1,1000,1000]\nspacing=[0,3,3]\nshape={type="sphere",radius=1}\n' + MAT + CLAIM)
t("lattice_1e6_locked_stack", HEAD + '[[lattice]]\nname="g"\nlocked=true\ncount=[1000,100,1]\nspacing=[0,0,0]\nshape={type="sphere",radius=1}\n' + BODY + MAT + CLAIM)
pts = ",".join(f"[{(i*7919%1000)/1000},{(i*104729%997)/997},{(i*1299709%991)/991}]" for i in range(1000))
t("lattice_hull", HEAD + f'[[lattice]]\nname="g"\nmass=1\ncount=[1000,1000,1]\nspacing=[9,9,9]\nshape={{type="hull",vertices=[{pts}]}}\n' + MAT + CLAIM)
t("lattice_long_name", HEAD + '[[lattice]]\nname="%s"\nmass=1\ncount=[1000,1000,1]\nspacing=[3,3,3]\n' % ("n" * 100000) + CLAIM)
def sph(n):
    o = []
    for i in range(n):
        z = 1 - 2 * (i + .5) / n; r = math.sqrt(1 - z * z); p = i * 2.399963229728653
        o.append(f"[{r*math.cos(p):.9f},{r*math.sin(p):.9f},{z:.9f}]")
    return ",".join(o)
for n in (2000, 10000, 50000):
    t(f"hull_{n}", HEAD + f'[[body]]\nname="A"\nmass=1\nshape={{type="hull",vertices=[{sph(n)}]}}\n' + MAT + CLAIM)
t("cloud_dense", HEAD + '[[cloud]]\nname="c"\nmass=1\ncount=400000\nlow=[0,0,0]\nhigh=[100,100,100]\nshape={type="sphere",radius=0.45}\n' + MAT + CLAIM)
t("cloud_full", HEAD + '[[cloud]]\nname="c"\nmass=1\ncount=1000000\nlow=[0,0,0]\nhigh=[200,200,200]\nshape={type="sphere",radius=0.45}\n' + MAT + CLAIM)
t("clouds", HEAD + "".join(f'[[cloud]]\nname="c{i}"\nmass=1\ncount=9000\nseed={i}\nlow=[0,0,{30*i}]\nhigh=[30,30,{30*i+29}]\nshape={{type="sphere",radius=0.45}}\n' for i in range(60)) + MAT + CLAIM)
t("cloud_x_lattice", HEAD + '[[lattice]]\nname="g"\nmass=1\ncount=[300,300,1]\nspacing=[3,3,3]\nshape={type="sphere",radius=1}\n[[cloud]]\nname="c"\nmass=1\ncount=20000\nlow=[0,0,100]\nhigh=[1000,1000,1000]\nshape={type="sphere",radius=0.1}\n' + MAT + CLAIM)
# Spheres 60 m in radius, none of which finds a place among spheres of 0.45 m, one in each block of the grid.
t("cloud_of_giants", HEAD + '[[lattice]]\nname="g"\nmass=1\ncount=[100,77,77]\nspacing=[4,2,2]\nshape={type="sphere",radius=0.45}\n[[cloud]]\nname="c"\nmass=1\ncount=10\nlow=[200,77,77]\nhigh=[201,78,78]\nshape={type="sphere",radius=60}\n' + MAT + CLAIM)
t("cloud_inf_box", HEAD + '[[cloud]]\nname="c"\nmass=1\ncount=3\nlow=[-1e308,-1e308,-1e308]\nhigh=[1e308,1e308,1e308]\n' + CLAIM)
t("cloud_speed_inf", HEAD + '[[cloud]]\nname="c"\nmass=1\ncount=3\nvelocity=[1.7e308,0,0]\nspeed=1.7e308\nlow=[0,0,0]\nhigh=[1,1,1]\n' + CLAIM)
t("lattice_spacing_inf", HEAD + '[[lattice]]\nname="g"\nmass=1\ncount=[10,1,1]\nspacing=[1e308,0,0]\n' + CLAIM)
t("plane_far_gap", HEAD + '[[body]]\nname="A"\nmass=1\nposition=[1e308,1e308,1e308]\nshape={type="box",half_extents=[1e308,1e308,1e308]}\n[[plane]]\nname="p"\noffset=-1e308\n' + MAT + CLAIM)
t("box_1e308", HEAD + '[[body]]\nname="A"\nmass=1e308\nshape={type="box",half_extents=[1e308,1,1]}\n' + CLAIM)
t("step_denormal", 'duration=1e-320\nstep=5e-324\n' + BODY + CLAIM)
t("steps_9e15", 'duration=9e15\nstep=1\n' + BODY + CLAIM)
t("steps_9e15_sample", 'duration=9e15\nstep=1\n' + BODY + '[[claim]]\nconserves="energy"\nsample="step"\ntolerance={absolute=1,reason="x"}\n')
t("steps_1e12_truth", 'duration=1e12\nstep=1\ngravity=[0,-9,0]\n' + BODY + '[[claim]]\nfollows="projectile"\nobservable="position"\nsample="step"\ntolerance={absolute=1e30,reason="x"}\n')
t("event_truth_many", 'duration=1e9\nstep=1\ngravity=[0,-9.81,0]\n[[body]]\nname="A"\nmass=1\nposition=[0,1,0]\nshape={type="sphere",radius=0.5}\n[[plane]]\nname="p"\n[[material]]\nbetween=["A","p"]\nrestitution=1\nfriction=0\n[[claim]]\nfollows="bouncing_sphere"\nobservable="event"\nevent="bounce"\nindex=1\nquantity="time"\ntolerance={absolute=1,reason="x"}\n')
t("event_index_max", 'duration=1e3\nstep=1\ngravity=[0,-9.81,0]\n[[body]]\nname="A"\nmass=1\nposition=[0,1,0]\nshape={type="sphere",radius=0.5}\n[[plane]]\nname="p"\n[[material]]\nbetween=["A","p"]\nrestitution=1\nfriction=0\n[[claim]]\nfollows="bouncing_sphere"\nobservable="event"\nevent="bounce"\nindex=9223372036854775807\nquantity="time"\ntolerance={absolute=1,reason="x"}\n')
t("certified_chain", HEAD.replace("duration = 1", "duration = 100") + 'gravity=[0,-9.81,0]\n' + "".join(f'[[body]]\nname="b{i}"\nmass=1\nposition=[{i+1},0,0]\n[[joint]]\ntype="distance"\nbody="b{i}"\n' + (f'to="b{i-1}"\n' if i else 'point=[0,0,0]\n') for i in range(12)) + '[[claim]]\nfollows="certified"\nobservable="position"\nuntil="horizon"\ntolerance={absolute=1e-3,reason="x"}\n')
t("certified_nbody", 'duration=1000\nstep=0.001\n' + "".join(f'[[body]]\nname="b{i}"\nmass=1\nposition=[{i*1.1},{i*i*.3},{i%3}]\n' for i in range(30)) + "".join(f'[[attraction]]\nbody="b{i}"\nto="b{j}"\nstrength=1\n' for i in range(30) for j in range(i)) + '[[claim]]\nfollows="certified"\nobservable="position"\nuntil="horizon"\ntolerance={absolute=1e-3,reason="x"}\n')
t("certified_stiff", 'duration=1000\nstep=0.001\n[[body]]\nname="A"\nmass=1e-9\nposition=[1,0,0]\n[[spring]]\nbody="A"\npin=[0,0,0]\nstiffness=1e9\nrest_length=0.5\n[[claim]]\nfollows="certified"\nobservable="position"\nuntil="horizon"\ntolerance={absolute=1e-3,reason="x"}\n')
t("truth_kepler_extreme", 'duration=1e6\nstep=0.001\n[[body]]\nname="A"\nmass=1\nposition=[1,0,0]\nvelocity=[0,1e-12,0]\n[[body]]\nname="B"\nmass=1e20\nlocked=true\n[[attraction]]\nbody="A"\nto="B"\nstrength=1e-20\n[[claim]]\nfollows="kepler"\nobservable="position"\ntolerance={absolute=1e-3,reason="x"}\n')
# files
def mesh(n, f, extra=""): t(n, HEAD + f'[[body]]\nname="A"\nmass=1\n{extra}shape={{type="mesh",file="{f}"}}\n' + MAT + CLAIM)
for n, f in dict(passwd="../../../../../../../etc/passwd", shadow="/etc/shadow", zero="/dev/zero", stdin="/dev/stdin", tty="/dev/tty", loop="loop1", dir=".", fifo="fifo", sock="sock", pagemap="/proc/self/pagemap", kmsg="/proc/kmsg", selfmem="/proc/self/mem", kcore="/proc/kcore", kallsyms="/proc/kallsyms", smaps="/proc/self/smaps", tracepipe="/sys/kernel/debug/tracing/trace_pipe", big="big16.obj", toolong="a/" * 3000, nulname="a\\u0000b.obj", devfd="/dev/fd/0", self="mesh_self.toml", sparse="sparse.obj").items(): mesh("mesh_" + n, f)
INER = "inertia=[1,1,1]\n"
OBJ = {
 "oor": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 2147483647\n", "neg": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -99999\n", "zero": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 0 0\n",
 "quad_oor": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 900000000\n", "poly_oor": "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3 4 900000000\n", "poly_neg": "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf -1 -2 -3 -4 -5000\n",
 "poly_big": "".join(f"v {math.cos(i)} {math.sin(i)} 0\n" for i in range(30000)) + "f " + " ".join(str(i + 1) for i in range(30000)) + "\n",
 "overflow": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 99999999999999999999 2 3\n", "nanv": "v nan inf -inf\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "vn": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//9999999 2/8888/7 3/ /\n", "mtllib": "mtllib /etc/passwd\nusemtl x\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
 "longtok": "v " + "1" * 5000000 + " 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "lines": "l " + "1 " * 1000000 + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "t_tag": "t x 99999999/99999999/99999999 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "t_tag_neg": "t x -5/-5/-5\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "vw": "vw 99999999 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "nul": "v 0 0 0\0v 1 0 0\nv 0 1 0\nf 1 2 3\n", "g": "g " + "a " * 100000 + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "s": "s 99999999999\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}
for n, o in OBJ.items():
    FILES[f"o_{n}.obj"] = o.encode()
    mesh("obj_" + n, f"o_{n}.obj"); mesh("obj_inertia_" + n, f"o_{n}.obj", INER)
# recorded data
def rec(n, j):
    j = j if isinstance(j, bytes) else (j if isinstance(j, str) else json.dumps(j)).encode()
    FILES[f"data/{n}.json"] = j
    t("rec_" + n, HEAD + BODY + f'[[claim]]\nfollows={{file="data/{n}.json"}}\nobservable="position"\ntolerance={{absolute=1,reason="x"}}\n')
G = {"schema": "truth/1", "t": [0.0, 0.5], "bodies": [{"id": "A"}], "trajectory": {"A": {"position": [[0, 0, 0], [0, 0, 0]]}}}
rec("good", G)
deep = "[" * 5000000 + "]" * 5000000
rec("deep_schema", '{"schema":' + deep + '}')
rec("deep_t", '{"schema":"truth/1","t":[' + deep + ']}')
rec("deep_num", '{"schema":"truth/1","t":[0],"bodies":[{"id":"A"}],"trajectory":{"A":{"position":[[0,0,' + deep + ']]}}}')
rec("deep_kind", '{"schema":"truth/1","t":[0],"bodies":[{"id":"A"}],"trajectory":{"A":{"position":[[0,0,0]]}},"events":[{"kind":' + deep + '}]}')
rec("deep_unused", '{"schema":"truth/1","zz":' + deep + ',"t":[0],"bodies":[{"id":"A"}],"trajectory":{"A":{"position":[[0,0,0]]}}}')
rec("deep_obj", '{"schema":' + '{"a":' * 2000000 + '1' + '}' * 2000000 + '}')
rec("many_objects", '{"schema":"truth/1","zz":[' + "{}," * 5000000 + "0]}")
rec("many_numbers", '{"schema":"truth/1","t":[' + "0," * 8000000 + "0]}")
rec("badutf8", b'{"schema":"\xff\xfe"}')
rec("surrogate", '{"schema":"\\ud800"}')
rec("events_1e5", json.dumps(dict(G, events=[{"kind": "bounce", "body": "A", "time": i * 1e-6} for i in range(60000)])))
rec("times_1e6", json.dumps(dict(G, t=[i * 1e-7 for i in range(300000)], trajectory={"A": {"position": [[0, 0, 0]] * 300000}})))
rec("num_str", json.dumps(dict(G, t=["0", "5e-999999"])))
rec("num_1e999", '{"schema":"truth/1","t":[1e999]}')
rec("null", b"\0" * 100); rec("empty", b"")
rec("id_num", json.dumps(dict(G, bodies=[{"id": 5}]))); rec("traj_arr", json.dumps(dict(G, trajectory=[1])))
rec("body_scalar", json.dumps(dict(G, trajectory={"A": 5}))); rec("body_null", json.dumps(dict(G, trajectory={"A": None})))
rec("col_scalar", json.dumps(dict(G, trajectory={"A": {"position": 7}}))); rec("event_scalar", json.dumps(dict(G, events=[5]))); rec("event_str", json.dumps(dict(G, events=["x"])))
rec("event_noobj_to", json.dumps(dict(G, events=[{"kind": "bounce", "body": "A", "to": [], "time": 1}])))
rec("dup_bodies", json.dumps(dict(G, bodies=[{"id": "A"}] * 3)))
rec("agree_deep", json.dumps(dict(G, agreement={"max_abs_diff": [[[]]]}))); rec("agree_neg", json.dumps(dict(G, agreement={"max_abs_diff": -1e308})))
# Limits multiplied: what one claim, one body, one plane may ask, many times.
BALL = 'gravity=[0,-9.81,0]\n[[body]]\nname="A"\nmass=1\nposition=[0,1,0]\nshape={type="sphere",radius=0.5}\n[[plane]]\nname="p"\n[[material]]\nbetween=["A","p"]\nrestitution=1\nfriction=0\n'
def follows(truth, what, until): return f'[[claim]]\nfollows="{truth}"\n{what}\nuntil={until}\ntolerance={{absolute=1,reason="x"}}\n'
t("truths_many", 'duration=100000\nstep=0.001\n' + BALL + "".join(follows("bouncing_sphere", 'observable="position"', 99 * (i + 1)) for i in range(999)))
t("truths_many_events", 'duration=100000\nstep=0.001\n' + BALL + "".join(follows("bouncing_sphere", f'observable="event"\nevent="bounce"\nindex={i+1}\nquantity="time"', 100000) for i in range(999)))
t("truths_many_searches", 'duration=100000\nstep=0.001\n[[body]]\nname="S"\nlocked=true\n[[body]]\nname="A"\nmass=1\nposition=[1,0,0]\nvelocity=[0,1.1,0]\n[[attraction]]\nbody="A"\nto="S"\nstrength=1\n' + "".join(follows("kepler", f'observable="event"\nevent="apsis"\nto="S"\nindex={i+1}\nquantity="time"', 1000 + i) for i in range(999)))
t("planes_x_materials", HEAD + "".join(f'[[plane]]\nname="p{i}"\noffset=-{i+9}\n' for i in range(100000)) + "".join(f'[[body]]\nname="b{i}"\nmass=1\nposition=[{3*i},0,0]\nshape={{type="sphere",radius=1}}\n' for i in range(400)) + "".join(f'[[material]]\nbetween=["b{i}","p{99999-j}"]\nrestitution=0\nfriction=0\n' for i in range(400) for j in range(245)) + MAT + CLAIM)
t("lattice_compound", HEAD + '[[lattice]]\nname="g"\ncount=[100,100,100]\nspacing=[9,9,9]\nshape={type="compound",parts=[' + ",".join(f'{{type="sphere",radius=1,mass=1,position=[{3*i},0,0]}}' for i in range(2000)) + "]}\n" + MAT + CLAIM)
REC = '[[claim]]\nfollows={file="data/%s.json"}\nobservable="position"\nuntil=%g\ntolerance={absolute=1,reason="x"}\n'
LOCKED = '[[lattice]]\nname="g"\nlocked=true\ncount=[100,100,20]\nspacing=[3,3,3]\n'
MANY = dict(G, t=[i * 1e-5 for i in range(100000)], trajectory={"A": {"position": [[0, 0, 0]] * 100000}})
rec("many_times", json.dumps(MANY)); rec("many_ids", json.dumps(dict(MANY, bodies=[{"id": "A"}] * 100000)))
rec("many_names", json.dumps(dict(G, events=[{"kind": "bounce", "body": "A", "to": "g[199999]", "time": i * 1e-6} for i in range(20000)])))
t("rec_many_claims", HEAD + BODY + "".join(REC % ("many_times", 0.01 * (i + 1)) for i in range(99)))
t("rec_many_states", HEAD + BODY + LOCKED + REC % ("many_times", 1))
t("rec_many_ids_two", HEAD + BODY + '[[body]]\nname="B"\nlocked=true\n' + REC % ("many_ids", 1))
t("rec_many_names_bodies", HEAD + BODY + LOCKED + REC % ("many_names", 1))
for f, n in (("/proc/self/pagemap", "pagemap"), ("/etc/passwd", "passwd"), ("loop1", "loop"), ("/dev/zero", "zero"), ("/proc/kmsg", "kmsg")):
    t("recf_" + n, HEAD + BODY + f'[[claim]]\nfollows={{file="{f}"}}\nobservable="position"\ntolerance={{absolute=1,reason="x"}}\n')
t("nul_inside", HEAD.encode() + b"\0" + BODY.encode()); t("utf16", HEAD.encode("utf-16")); t("invalid_utf8", HEAD.encode() + b'title="\xff"\n'); t("bom", b"\xef\xbb\xbf" + (HEAD + BODY + CLAIM).encode()); t("crlf", (HEAD + BODY + CLAIM).replace("\n", "\r\n"))
t("neg_zero", HEAD + 'gravity=[-0.0,-0.0,-0.0]\n' + BODY + CLAIM); t("empty", ""); t("only_comment", "# x"); t("only_nul", b"\0"); t("one_bracket", "["); t("unicode_name", HEAD + '[[body]]\nname="名前😀"\nmass=1\n' + CLAIM); t("rtl_name", HEAD + '[[body]]\nname="\u202eA"\nmass=1\n' + CLAIM)
t("c1_name", HEAD + '[[body]]\nname="\\u009b31mA"\nmass=1\n' + CLAIM); t("uni_crlf_key", HEAD + '"a\\nb\\u001b[31m" = 1\n' + BODY)
# Documents for other commands: what they read before and behind 66 MB of empty objects, which are 2.5 GB of values.
EMPTY = ("{}," * 22000000)[:-1]
PART = '{"part":{"command":"run","count":1,"index":1},"units":[["a","b"]]}\n'
DOCUMENTS = {
    "report_list": ("report DOCUMENT --html o.html", "[", "]"),
    "report_of_verdicts": ("report DOCUMENT", '{"schema":1,"verdicts":[', "]}"),
    "report_of_fits": ("report DOCUMENT --html o.html", '{"format":"cylon-fit/1","fits":[', '],"a":1,"b":2}'),
    "report_of_scenarios": ("report DOCUMENT --html o.html", '{"format":"cylon-scenario/1","name":"a","x":[', "]}"),
    "report_baseline": ("report verdicts.json --html o.html --baseline DOCUMENT", '{"schema":1,"verdicts":[', "]}"),
    "merge_one_line": ("merge DOCUMENT", PART + '{"key":"a","verdicts":[],"x":[', "]}\n"),
    "import_benchmarks": ("track import DOCUMENT", '{"context":{},"benchmarks":[', "]}"),
    "import_history": ("track import DOCUMENT", '{"cylon_history":1}\n{"cell":[', "]}\n"),
}
FILES["verdicts.json"] = b'{"schema":1,"verdicts":[]}'

PLACE = re.compile(r"^error: [^\n]*?:\d+:\d+: ")
FILE = re.compile(r"^error: DOCUMENT:")
MOST_SECONDS, MOST_MB, MOST_BYTES = 5, 1000, 4000
YARDSTICK, MOST_YARDSTICKS, YARDSTICK_SECONDS = "lattice_1e6", 4, 100


def prepare(folder):
    (folder / "data").mkdir()
    for name, content in FILES.items():
        (folder / name).write_bytes(content)
    for here, there in (("loop1", "loop2"), ("loop2", "loop1"), ("data/loop1", "loop1")):
        (folder / here).symlink_to(there)
    os.mkfifo(folder / "fifo")
    (folder / "big16.obj").write_text("v 0 0 0\n" * 2000000 + "f 1 2 3\n")
    with open(folder / "sparse.obj", "wb") as sparse:
        sparse.truncate(1 << 40)
    with socket.socket(socket.AF_UNIX) as bound:
        here = os.getcwd()
        os.chdir(folder)  # the path of a socket is short
        bound.bind("sock")
        os.chdir(here)


def faults(cylon, folder, name, most_seconds):
    """What is wrong, and the CPU seconds and MB that it took."""
    def limits():
        resource.setrlimit(resource.RLIMIT_CPU, (most_seconds, most_seconds + 1))

    file, command, place = f"{name}.toml", f"validate {name}.toml", PLACE
    if name in SCENES:
        (folder / file).write_bytes(SCENES[name])
    else:
        command, before, behind = DOCUMENTS[name]
        file, place = "DOCUMENT", FILE
        (folder / file).write_text(before + EMPTY + behind)
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        child = subprocess.Popen([cylon, *command.split()], cwd=folder, stdin=subprocess.DEVNULL, stdout=out,
                                 stderr=err, preexec_fn=limits, env={**os.environ, "CYLON_CACHE": "off", "CYLON_KEY": f"{folder}/key"})
        _, status, used = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        err.seek(0)
        said = err.read().decode("utf8", "replace")
    (folder / file).unlink()
    seconds, megabytes = used.ru_utime + used.ru_stime, used.ru_maxrss / 1024
    bad = []
    if child.returncode not in (0, 2):
        bad.append(f"exit code {child.returncode}: {said[:200]!r}")
    if child.returncode == 2 and not place.match(said):
        bad.append(f"no place: {said[:200]!r}")
    if len(said) > MOST_BYTES:
        bad.append(f"{len(said)} bytes of error")
    if megabytes > MOST_MB:
        bad.append(f"{megabytes:.0f} MB")
    return bad, seconds, megabytes


def main():
    cylon, words = os.path.abspath(sys.argv[1]), sys.argv[2:]
    tried = failed = 0
    most = [0.0, 0.0]
    with tempfile.TemporaryDirectory(prefix="cylon-corpus-") as name:
        folder = pathlib.Path(name)
        prepare(folder)
        bad, yardstick, _ = faults(cylon, folder, YARDSTICK, YARDSTICK_SECONDS)
        if bad:
            sys.exit(f"{YARDSTICK}, by which the others are measured: {'; '.join(bad)}")
        most_seconds = max(MOST_SECONDS, math.ceil(MOST_YARDSTICKS * yardstick))
        for scene in [*SCENES, *DOCUMENTS]:
            if words and not any(word in scene for word in words):
                continue
            bad, *used = faults(cylon, folder, scene, most_seconds)
            tried += 1
            failed += bool(bad)
            most = [max(pair) for pair in zip(most, used)]
            if bad:
                print(f"{scene}: {'; '.join(bad)}", flush=True)
    print(json.dumps({"tried": tried, "failed": failed, "cpu_seconds": round(most[0], 1), "lattices": round(most[0] / yardstick, 1),
                      "megabytes": round(most[1])}))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
