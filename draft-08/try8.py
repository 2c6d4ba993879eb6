"""Builds every patch with the harness and compares its answers: variants must equal the solution, mistakes must not, and
all first other spellings should answer as their patch. try8.py ROOT"""
import json, math, os, subprocess, sys, shutil, hashlib
from concurrent.futures import ThreadPoolExecutor
ROOT = sys.argv[1]
STEP = "08-post-processing"
SOL = f"{ROOT}/solutions/{STEP}"
FLAGS = ("-std=c++20 -O1 -fPIC -ffp-contract=off -Wall -Wextra -Wno-unused-parameter -DGLM_FORCE_SILENT_WARNINGS "
         "-I/work/s08/common -I/work/s08/steps -include /work/main/build/release/student/prelude.hpp").split()
T = "/work/s08x/t"
os.makedirs(T, exist_ok=True)
def obj(cpp):
    text = open(cpp).read()
    key = hashlib.sha1((text + open("/work/s08/steps/08-post-processing/post_processing.hpp").read()).encode()).hexdigest()[:16]
    exe = f"{T}/{key}"
    if not os.path.exists(exe):
        done = subprocess.run(["g++", *FLAGS, "-c", cpp, "-o", exe + ".o"], capture_output=True, text=True)
        if done.returncode: raise SystemExit(cpp + "\n" + done.stderr)
        noise = "missing-field"
        w = [l for l in done.stderr.splitlines() if "warning" in l and "missing initializer for member ‘atelier::post_processing::ColourTable" not in l]
        if w: print(cpp, "\n".join(w))
        subprocess.run(["g++", "/work/s08x/h8.o", exe + ".o", "-o", exe, "-L/work/s08x/lib", "-latelier", "-lfmt", "-Wl,-rpath,/work/s08x/lib"], check=True)
    return exe
def folder(name, patch):
    f = f"{T}/w-{name}"
    shutil.rmtree(f, ignore_errors=True); os.makedirs(f)
    for n in os.listdir(SOL): shutil.copy(f"{SOL}/{n}", f)
    if patch: subprocess.run(["patch", "-p1", "--fuzz=0", "--batch", "--forward", "-s", "-i", patch], cwd=f, check=True)
    return f
def ask(name, patch, requests):
    f = folder(name, patch)
    exe = obj(f + "/post_processing.cpp")
    done = subprocess.run([exe, f + "/post_processing.glsl"], input="\n".join(requests) + "\n", capture_output=True, text=True)
    if done.returncode: return name, ["crash " + done.stderr] * len(requests)
    out = []
    for line in done.stdout.splitlines():
        out.append(line if line.startswith("!") else [float(x) for x in line.split()])
    return name, out
def arg(n, v): return n + ":" + ",".join(repr(float(x)) for x in (v if isinstance(v, list) else [v]))
def req(probe, **a): return " ".join([probe] + [arg(k, v) for k, v in a.items()])
def codes(s): return [ord(c) for c in s]

def battery():
    import random
    rnd = random.Random(8)
    R = []
    for s in (-1, 0, 1): R.append(req("next_target", source=s))
    for s in ([1, 1], [5, 3], [64, 48], [317, 211]): R.append(req("draw_full_screen", size=s))
    base = dict(bloom=0, exposure=0, curve=0, hue=0, saturation=1, brightness=1, table=0, overlay=0)
    for ch in ({}, {"bloom": .5}, {"exposure": 1}, {"exposure": -1}, {"curve": 1}, {"curve": 2}, {"hue": .25}, {"hue": 1}, {"hue": -2}, {"hue": 1.5}, {"hue": -.5}, {"saturation": 0}, {"saturation": 2},
               {"brightness": 0}, {"brightness": 2}, {"table": 1}, {"overlay": .5}, {"overlay": 1}, dict(bloom=1, exposure=1, curve=2, hue=.3, saturation=2, brightness=2, table=1, overlay=1), dict(curve=1, overlay=1), dict(bloom=1, curve=1), dict(hue=.2, table=1), dict(curve=1, hue=.2), dict(curve=1, table=1), dict(hue=1, table=1), dict(bloom=1, saturation=0, overlay=.1)):
        R.append(req("passes_for", **{**base, **ch}))
    for s in (1e-3, .3, .5, 1, 1.5, 2, 6, 10.1, 20): R.append(req("gaussian_weights", sigma=s))
    for s in (0, -1, 20.001, 20, 1e9, float("nan"), float("inf"), 1e-30): R.append(req("gaussian_refuses", sigma=s))
    cols = [[0, 0, 0], [1, 1, 1], [.5, .5, .5], [.5, .25, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 1, 1], [0, 0, 1], [1, 0, 1], [1, 0, .5], [.2, .9, .4], [.1, .2, .7], [.7, .1, .2], [.3, .2, .25], [30, 2, 5], [.01, .02, .005], [8, 2, 0]]
    cols += [[round(rnd.random(), 4) for _ in range(3)] for _ in range(25)]
    for c in cols:
        R += [req("luma", colour=c), req("hue_chroma_luma", colour=c), req("filmic", colour=c)]
        for w in (.5, 1, 4): R.append(req("reinhard", colour=c, white=w))
        for st, cu in ((0, 0), (1, 0), (-1, 0), (2, 1), (-2, 2), (.5, 2), (3, 0), (-1, 1)): R.append(req("tone_mapped", colour=c, stops=st, curve=cu, white=4))
        for t in (0, .5, 1, 5): R.append(req("bright_part", colour=c, threshold=t))
        for n in (0, .25, .5, 1): R.append(req("dithered", stored=c, noise=n))
        for tu, sa, br in ((0, 1, 1), (1 / 3, 1, 1), (-.4, 1, 1), (.7, 2, 1), (0, 0, 1), (0, 1.8, 1), (0, 1, 1.5), (0, 1, 0), (1, 1, 1), (-2, .5, .5), (.1, 1, 8)): R.append(req("adjusted", colour=c, turns=tu, saturation=sa, brightness=br))
    for h in (0, 1 / 12, .2, .35, .5, .61, .8, .95, 1.2, -.1, 2.4, -1.3):
        for ch in (0, .2, .5, .8, 1, 5):
            for y in (0, .05, .2851, .5, .7, .95, 1, 1.5): R.append(req("colour_of", hue=h, chroma=ch, luma=y))
    for be in ([.1, .2, .3, .4], [.9, .1, 5, 1]):
        for ab in ([.7, .6, .5, 1], [.33, .1, .9, .5], [.2, .3, .4, 0]):
            for am in (0, .25, .5, 1): R.append(req("overlaid", below=be, above=ab, amount=am))
    for s in (.5, 1, 2, 6):
        for a in (0, 1):
            for x, y in ((0, 0), (4, 2), (8, 4), (3, 1)): R.append(req("blurred", sigma=s, across=a, tx=x, ty=y))
    for n in (2, 3, 5, 9, 17):
        for c in cols[:12] + cols[18:]:
            R += [req("table_trilinear", colour=c, size=n), req("table_tetrahedral", colour=c, size=n)]
    eight = "".join(f"{r} {g} {b}\n" for b in (0, 1) for g in (0, .5) for r in (.25, .125))
    files = ["LUT_3D_SIZE 2\n" + eight, "# c\r\nTITLE \"a b  c\"\r\nLUT_3D_SIZE 2\r\n\r\nDOMAIN_MIN -1 0 .5\r\nDOMAIN_MAX 2 1e1 +1\r\n".replace("+", "") + eight.replace("\n", "\r\n"),
             "\t LUT_3D_SIZE\t2 \n#x\n \t\nTITLE \"\"\n" + eight[:-1], "DOMAIN_MAX 2 2 2\nLUT_3D_SIZE 3\n" + "".join(f" {i * .01} {i * .02}\t{1e-7 * i} \n" for i in range(27)),
             "LUT_3D_SIZE 2\r\n" + eight.replace("\n", "\r\n")[:-1], "LUT_3D_SIZE 2\n" + eight.replace("\n", "\n\n# in between\n"), "  TITLE   \"# 1 \" \nLUT_3D_SIZE 2\n" + eight,
             "LUT_3D_SIZE 2\n" + "0.1 -.5 5.\n1e-3 1E2 -1e+2\n" + "".join(eight.splitlines(True)[2:])]
    bad = ["", "LUT_3D_SIZE 2\n", eight, "LUT_3D_SIZE 1\n0 0 0\n", "LUT_3D_SIZE 257\n" + eight, "LUT_1D_SIZE 2\n0 0 0\n1 1 1\n", "LUT_3D_SIZE 2\nLUT_3D_SIZE 2\n" + eight, "LUT_3D_SIZE 2\n" + eight + "0 0 0\n", "LUT_3D_SIZE 2\n" + eight[:-2 - len("0.125 0.5 1")] , 
           "LUT_3D_SIZE 2\n" + "nan 0 0\n" + "".join(eight.splitlines(True)[1:]), "LUT_3D_SIZE 2\n" + "inf 0 0\n" + "".join(eight.splitlines(True)[1:]), "LUT_3D_SIZE 2\n" + "1e40 0 0\n" + "".join(eight.splitlines(True)[1:]),
           "LUT_3D_SIZE 2\n" + "0 0\n" + "".join(eight.splitlines(True)[1:]), "LUT_3D_SIZE 2\n" + "0 0 0 0\n" + "".join(eight.splitlines(True)[1:]), "LUT_3D_SIZE 2\n" + "0 0 0x\n" + "".join(eight.splitlines(True)[1:]), "LUT_3D_SIZE 2\n" + "0 0 1-2\n" + "".join(eight.splitlines(True)[1:]), "LUT_3D_SIZE 2\n" + "0 0 1,2\n" + "".join(eight.splitlines(True)[1:]), "LUT_3D_SIZE 2\n" + "0 0 .\n" + "".join(eight.splitlines(True)[1:]), "LUT_3D_SIZE 2\n" + "0 0 1e\n" + "".join(eight.splitlines(True)[1:]),
           "LUT_3D_SIZE 2\n" + eight + "TITLE \"x\"\n", "LUT_3D_SIZE 2\n" + "".join(eight.splitlines(True)[:4]) + "DOMAIN_MIN 0 0 0\n" + "".join(eight.splitlines(True)[4:]), "LUT_3D_SIZE 2 2\n" + eight, "LUT_3D_SIZE two\n" + eight, "LUT_3D_SIZE\n" + eight, "LUT_3D_SIZE 2.5\n" + eight, "LUT_3D_SIZE -2\n" + eight, "LUT_3D_SIZE 99999999999999\n" + eight,
           "TITLE x\nLUT_3D_SIZE 2\n" + eight, "TITLE \"x\nLUT_3D_SIZE 2\n" + eight, "TITLE\nLUT_3D_SIZE 2\n" + eight, "TITLE \"x\" y\nLUT_3D_SIZE 2\n" + eight, "TITLE \"x\"\nTITLE \"x\"\nLUT_3D_SIZE 2\n" + eight, "DOMAIN_MIN 0 0\nLUT_3D_SIZE 2\n" + eight, "DOMAIN_MIN 1 0 0\nLUT_3D_SIZE 2\n" + eight, "DOMAIN_MAX 1 0 1\nLUT_3D_SIZE 2\n" + eight, "DOMAIN_MIN 0 0 0\nDOMAIN_MIN 0 0 0\nLUT_3D_SIZE 2\n" + eight, "DOMAIN_MIN 0 0 2\nDOMAIN_MAX 1 1 2\nLUT_3D_SIZE 2\n" + eight, "LUT_3D_INPUT_RANGE 0 1\nLUT_3D_SIZE 2\n" + eight, "title \"x\"\nLUT_3D_SIZE 2\n" + eight, "hello\nLUT_3D_SIZE 2\n" + eight]
    for t in files: R += [req("read_all", text=codes(t)), req("read_table", text=codes(t))]
    for t in bad + files: R.append(req("read_refuses", text=codes(t)) if t else "read_refuses text:")
    for k in range(4): R += [req("write_table", kind=k), req("round_trip", kind=k)]
    return R

def near(a, b, probe):
    if isinstance(a, str) or isinstance(b, str): return isinstance(a, str) and isinstance(b, str)
    if len(a) != len(b): return False
    for x, y in zip(a, b):
        if math.isnan(x) and math.isnan(y): continue
        if not abs(x - y) <= 2e-6 * max(1, abs(x)): return False
    return True

def main():
    R = battery()
    _, ref = ask("solution", None, R)
    print(len(R), "requests;", sum(isinstance(x, str) for x in ref), "errors in the solution")
    for r, a in zip(R, ref):
        if isinstance(a, str): print("  ", r[:100], a[:200])
    ok = True
    V = json.load(open(f"{ROOT}/tests/variants/{STEP}/variants.json"))
    M = json.load(open(f"{ROOT}/tests/mistakes/{STEP}/mistakes.json"))
    jobs = [("variants", v["name"], v["patch"]) for v in V] + [("mistakes", m["name"], p) for m in M for p in [m["patch"], *m["spellings"]]]
    with ThreadPoolExecutor(2) as pool:
        answers = list(pool.map(lambda j: ask(j[2][:-6], f"{ROOT}/tests/{j[0]}/{STEP}/{j[2]}", R)[1], jobs))
    main_of = {}
    for (kind, name, patch), got in zip(jobs, answers):
        differs = [i for i in range(len(R)) if not near(got[i], ref[i], R[i])]
        by = {}
        for i in differs: by[R[i].split()[0]] = by.get(R[i].split()[0], 0) + 1
        if kind == "variants":
            print("VARIANT", name, by or "equal")
            for i in differs[:12]: print("    ", R[i][:110], got[i] if isinstance(got[i], str) else got[i][:8], ref[i] if isinstance(ref[i], str) else ref[i][:8])
        else:
            if patch == name + ".patch": main_of[name] = got
            same = all(near(got[i], main_of[name][i], R[i]) for i in range(len(R)))
            print("mistake", patch[:-6].ljust(38), "SAME AS SOLUTION" if not by else by, "" if patch == name + ".patch" else "= patch" if same else "other answers")
            if any(isinstance(g, str) and not isinstance(x, str) for g, x in zip(got, ref)): print("     error:", [g for g, x in zip(got, ref) if isinstance(g, str) and not isinstance(x, str)][0][:300])
    # two mistakes with the same answers
    names = list(main_of)
    for i, a in enumerate(names):
        for b in names[i + 1:]:
            if all(near(x, y, "") for x, y in zip(main_of[a], main_of[b])): print("ALIKE", a, b)
if __name__ == "__main__": main()
