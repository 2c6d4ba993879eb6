#!/usr/bin/env python3
"""Makes tests/mistakes/08-post-processing and tests/variants/08-post-processing from the solution: mistakes8.py and
variants8.py say what is replaced. Run it again whenever the solution changes.

make8.py [ROOT]    ROOT is the clone, /work/s08 by default"""
import difflib, json, os, re, subprocess, sys, tempfile

ROOT = sys.argv[1] if len(sys.argv) > 1 else "/work/s08"
STEP = "08-post-processing"
CPP, GLSL = "post_processing.cpp", "post_processing.glsl"
FILES = [CPP, GLSL]
SOLUTION = f"{ROOT}/solutions/{STEP}"


class Change:
    """Changes to copies of the solution's files."""

    def __init__(self):
        self.old = {f: open(f"{SOLUTION}/{f}").read() for f in FILES}
        self.text = dict(self.old)

    def swap(self, file, old, new):
        """Replaces a text that occurs exactly once."""
        count = self.text[file].count(old)
        if count != 1:
            raise SystemExit(f"{file}: {count} times instead of once: {old!r}")
        self.text[file] = self.text[file].replace(old, new)

    def body(self, file, signature, lines):
        """Replaces what stands between a function's student mark and its skeleton. `signature` begins its line."""
        pattern = re.compile(r"(^" + re.escape(signature) + r"[^{]*\{\n *// >>> student: [^\n]*\n)(.*?)(^ *// --- skeleton)",
                             re.M | re.S)
        found = pattern.findall(self.text[file])
        if len(found) != 1:
            raise SystemExit(f"{file}: {len(found)} functions begin with {signature!r}")
        lines = lines.strip("\n") + "\n"
        self.text[file] = pattern.sub(lambda m: m[1] + lines + m[3], self.text[file])

    def shared(self, lines):
        """Replaces the block before the functions of the .cpp."""
        pattern = re.compile(r"(^// >>> student: what your functions below share[^\n]*\n)(.*?)(^// --- skeleton)", re.M | re.S)
        assert len(pattern.findall(self.text[CPP])) == 1
        self.text[CPP] = pattern.sub(lambda m: m[1] + lines.strip("\n") + "\n" + m[3], self.text[CPP])

    def add_shared(self, lines):
        """Adds to the end of that block, inside its namespace."""
        self.swap(CPP, "}  // namespace\n// --- skeleton", lines.strip("\n") + "\n\n}  // namespace\n// --- skeleton")

    def before(self, file, anchor, lines):
        """Inserts lines before a text that occurs exactly once."""
        self.swap(file, anchor, lines.strip("\n") + "\n\n" + anchor)

    def patch(self):
        out = ""
        for f in FILES:
            a, b = self.old[f].splitlines(True), self.text[f].splitlines(True)
            for line in difflib.unified_diff(a, b, f"a/{f}", f"b/{f}"):
                out += line if line.endswith("\n") else line + "\n\\ No newline at end of file\n"
        return out


def patch_of(edit):
    change = Change()
    edit(change)
    text = change.patch()
    if not text:
        raise SystemExit("a patch changes nothing")
    for f in FILES:
        for i, line in enumerate(change.text[f].splitlines(), 1):
            if len(line) > 120 and line not in change.old[f]:
                print(f"long line, {len(line)}: {line}")
    return text, change


def checked(name, text, change):
    """Applies the patch as the project does, and compares the result."""
    with tempfile.TemporaryDirectory() as folder:
        for f in FILES:
            open(f"{folder}/{f}", "w").write(change.old[f])
        done = subprocess.run(["patch", "-p1", "--fuzz=0", "--batch", "--forward", "--no-backup-if-mismatch"],
                              input=text.encode(), cwd=folder, capture_output=True)
        if done.returncode or b"fuzz" in done.stdout or b"offset" in done.stdout:
            raise SystemExit(f"{name}: {done.stdout.decode()}")
        for f in FILES:
            if open(f"{folder}/{f}").read() != change.text[f]:
                raise SystemExit(f"{name}: applied, {f} is not what was meant")


def entry(members):
    lines = [f"    {json.dumps(key)}: {json.dumps(value, ensure_ascii=False)}" for key, value in members.items()]
    return "  {\n" + ",\n".join(lines) + "\n  }"


def write(folder, list_name, entries, patches):
    os.makedirs(folder, exist_ok=True)
    for old in os.listdir(folder):
        if old.endswith(".patch") and old not in patches:
            os.remove(f"{folder}/{old}")
    for name, text in patches.items():
        open(f"{folder}/{name}", "w").write(text)
    open(f"{folder}/{list_name}", "w").write("[\n" + ",\n".join(entries) + "\n]\n")


def main():
    from mistakes8 import MISTAKES
    from variants8 import VARIANTS
    entries, patches = [], {}
    for name, title, sentence, hint, edits in MISTAKES:
        names = [f"{name}.patch"] + [f"{name}.other.patch" if k == 0 else f"{name}.other-{k + 1}.patch"
                                     for k in range(len(edits) - 1)]
        for file, edit in zip(names, edits):
            text, change = patch_of(edit)
            checked(file, text, change)
            patches[file] = text
        for words in (title, sentence, hint):
            assert 0 < len(words.encode()) <= 1000 and "\n" not in words
        entries.append(entry({"name": name, "title": title, "sentence": sentence, "hint": hint, "patch": names[0],
                              "spellings": names[1:]}))
    assert len({m[0] for m in MISTAKES}) == len(MISTAKES)
    write(f"{ROOT}/tests/mistakes/{STEP}", "mistakes.json", entries, patches)
    variant_entries, variant_patches = [], {}
    for name, title, edit in VARIANTS:
        text, change = patch_of(edit)
        checked(name, text, change)
        variant_patches[f"{name}.patch"] = text
        variant_entries.append(entry({"name": name, "title": title, "patch": f"{name}.patch"}))
    write(f"{ROOT}/tests/variants/{STEP}", "variants.json", variant_entries, variant_patches)
    print(f"{len(entries)} mistakes in {len(patches)} patches, {len(variant_entries)} variants")


if __name__ == "__main__":
    sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
    sys.modules["make8"] = sys.modules["__main__"]
    main()
