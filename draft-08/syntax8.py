"""Checks the C++ of every patch with the compiler's flags of students' files. syntax8.py ROOT"""
import json, os, subprocess, sys, tempfile, shutil
ROOT = sys.argv[1]; STEP = "08-post-processing"; SOL = f"{ROOT}/solutions/{STEP}"
flags = json.load(open("/work/main/build/release/step_flags.json"))
args = [a.replace("-I/work/main/", f"-I{ROOT}/") for a in flags["compile"]]
args = args[:args.index("-include")]  # without the precompiled header
plain = ["-include", "/work/main/build/release/student/prelude.hpp"]
seen, n = set(), 0
for kind in ("mistakes", "variants"):
    for p in sorted(os.listdir(f"{ROOT}/tests/{kind}/{STEP}")):
        if not p.endswith(".patch"): continue
        with tempfile.TemporaryDirectory() as f:
            for x in os.listdir(SOL): shutil.copy(f"{SOL}/{x}", f)
            done = subprocess.run(["patch", "-p1", "--fuzz=0", "--batch", "--forward", "-i", os.path.abspath(f"{ROOT}/tests/{kind}/{STEP}/{p}")], cwd=f, capture_output=True, text=True)
            assert done.returncode == 0 and "fuzz" not in done.stdout and "offset" not in done.stdout, done.stdout
            cpp = open(f"{f}/post_processing.cpp").read()
            if cpp in seen: continue
            seen.add(cpp); n += 1
            for compiler in ([flags["compiler"]] + (["clang++"] if kind == "variants" else [])):
                run = subprocess.run([compiler, *args, *(plain if compiler != "clang++" else []), "-fsyntax-only", f"{f}/post_processing.cpp"], capture_output=True, text=True)
                warn = [l for l in run.stderr.splitlines() if ("warning" in l or "error" in l) and "missing-field" not in l]
                if run.returncode or warn: print(p, compiler, run.returncode, warn[:5])
print(n, "different .cpp files")
