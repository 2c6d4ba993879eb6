"""Judges every patch by the probe cases of cases.json, with the harness. cases_try8.py ROOT"""
import json, math, sys
from concurrent.futures import ThreadPoolExecutor
import os, subprocess
import try8
def exe_of(folder):
    base = try8.obj(folder + "/post_processing.cpp")
    exe = base + "-b"
    if not os.path.exists(exe) or os.path.getmtime(exe) < max(os.path.getmtime("/work/s08x/" + f) for f in ("h8b.o", "probes.o")):
        subprocess.run(["g++", "/work/s08x/h8b.o", "/work/s08x/probes.o", base + ".o", "-o", exe, "-L/work/s08x/lib", "-latelier", "-lfmt", "-Wl,-rpath,/work/s08x/lib"], check=True)
    return exe
def ask(name, patch, requests):
    f = try8.folder("b-" + name + "/08-post-processing", patch)
    done = subprocess.run([exe_of(f), os.path.dirname(f)], input="\n".join(requests) + "\n", capture_output=True, text=True)
    if done.returncode: raise SystemExit(name + done.stderr)
    return name, [l if l.startswith("!") else [float(x) for x in l.split()] for l in done.stdout.splitlines()]
ROOT, STEP = sys.argv[1], try8.STEP
cases = [c for c in json.load(open(f"/work/s08/tests/cases/{STEP}/cases.json"))["cases"] if "probe" in c]
R, at = [], []
for c in cases:
    for k, i in enumerate(c["inputs"]):
        i = {n: ("" if isinstance(v, list) and not v else v) for n, v in i.items()}
        R.append(" ".join([c["probe"]] + [f"{n}:" if v == "" else try8.arg(n, v) for n, v in i.items()])); at.append((c, k))
def passes(c, got, want):
    t = c.get("tolerance") or {}
    if isinstance(got, str) or len(got) != len(want): return False
    for g, w in zip(got, want):
        if math.isnan(g) or abs(g - w) > t.get("absolute", 0) + t.get("relative", 0) * abs(w): return False
    return True
def judged(name, patch):
    _, got = ask(name, patch, R)
    bad = {}
    for (c, k), g in zip(at, got):
        if not passes(c, g, c["expected"][k]): bad.setdefault(c["name"], []).append((k, g))
    return bad
print("tolerances:", {json.dumps(c.get("tolerance")) for c in cases if set(c.get("tolerance") or {}) - {"absolute", "relative", "reason"}})
V = json.load(open(f"{ROOT}/tests/variants/{STEP}/variants.json")); M = json.load(open(f"{ROOT}/tests/mistakes/{STEP}/mistakes.json"))
jobs = [("solution", None)] + [(v["name"], f"{ROOT}/tests/variants/{STEP}/{v['patch']}") for v in V]
jobs += [(p[:-6], f"{ROOT}/tests/mistakes/{STEP}/{p}") for m in M for p in [m["patch"], *m["spellings"]]]
with ThreadPoolExecutor(2) as pool: out = list(pool.map(lambda j: judged(*j), jobs))
claims = {m["name"]: [c["name"] for c in cases if m["name"] in (c.get("rejects") or [])] for m in M}
for (name, _), bad in zip(jobs, out):
    base = name.split(".")[0]
    if base in claims:
        missing = [c for c in claims[base] if c not in bad]
        print(name.ljust(38), {n: len(b) for n, b in bad.items()}, f"NOT CAUGHT BY {missing}" if missing else "")
    else:
        print("==", name, {n: len(b) for n, b in bad.items()} or "all")
        for n, b in bad.items():
            c = next(c for c in cases if c["name"] == n)
            for k, g in b[:4]: print("     ", n, json.dumps(c["inputs"][k])[:150], "got", g if isinstance(g, str) else g[:8], "want", c["expected"][k][:8])
# ---- Would the verdict name each first other spelling? (judge/explain/agreement.cpp, for probes)
def answers(name, patch):
    _, got = ask(name, patch, R)
    by = {}
    for (c, k), g in zip(at, got): by.setdefault(c["name"], []).append(g)
    return by
by_name = {c["name"]: c for c in cases}
def ok(c, got): return all(passes(c, g, w) for g, w in zip(got, c["expected"]))
def like(c, a, b): return all((isinstance(x, str) and isinstance(y, str)) or (not isinstance(x, str) and not isinstance(y, str) and passes({"tolerance": c.get("tolerance")}, x, y)) for x, y in zip(a, b))
with ThreadPoolExecutor(2) as pool: all_answers = dict(zip([n for n, _ in jobs], pool.map(lambda j: answers(*j), jobs)))
forms = {m["name"]: [all_answers[p[:-6]] for p in [m["patch"], *m["spellings"]]] for m in M}
def named(S):
    names = set()
    could = {n: ({m for m in forms if any(not ok(c, f[n]) and like(c, S[n], f[n]) for f in forms[m])} if not ok(c, S[n]) else set()) for n, c in by_name.items()}
    for i, c in by_name.items():
        if ok(c, S[i]): continue
        left = set()
        for m in could[i]:
            bad = False
            for j, d in by_name.items():
                known = any(not ok(d, f[j]) for f in forms[m]); unseen = any(ok(d, f[j]) for f in forms[m])
                if ok(d, S[j]):
                    bad |= known and not unseen
                elif not known: bad |= (d.get("functions") or [""])[0] == (c.get("functions") or [""])[0]
                else: bad |= m not in could[j]
            if not bad: left.add(m)
        if len(left) == 1: names |= left
        elif left: names.add("several: " + ", ".join(sorted(left)))
    return names
wrong = 0
for m in M:
    for p in [m["patch"], *m["spellings"]]:
        n = named(all_answers[p[:-6]])
        if n != {m["name"]}: print("NAMED", p, n); wrong += 1
print("not named rightly by probes:", wrong)
