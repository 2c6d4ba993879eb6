"""Checks cases.json against the solution's formulas in emulated 32-bit floats: how much of each tolerance they need, and
how far the known mistakes are away."""
import json, math, struct
def r(x):
    try: return struct.unpack("f", struct.pack("f", x))[0]
    except OverflowError: return math.copysign(math.inf, x)
class N:
    def __init__(s, v): s.v = r(float(v.v if isinstance(v, N) else v))
    def _o(f):
        return lambda a, b: N(f(a.v, N(b).v))
    __add__ = __radd__ = _o(lambda a, b: a + b)
    __mul__ = __rmul__ = _o(lambda a, b: a * b)
    __sub__ = _o(lambda a, b: a - b); __rsub__ = _o(lambda a, b: b - a)
    __truediv__ = _o(lambda a, b: a / b if b else math.nan); __rtruediv__ = _o(lambda a, b: b / a if a else math.nan)
    __neg__ = lambda a: N(-a.v)
    __abs__ = lambda a: N(abs(a.v))
    __lt__ = lambda a, b: a.v < N(b).v
    __gt__ = lambda a, b: a.v > N(b).v
    __le__ = lambda a, b: a.v <= N(b).v
    __ge__ = lambda a, b: a.v >= N(b).v
    __eq__ = lambda a, b: a.v == N(b).v
def fl(a): return N(math.floor(a.v))
def V(c): return [N(x) for x in c]
def clamp(x, a, b): return min(max(x, N(a)), N(b))
W = {"": (0.2126, 0.7152, 0.0722)}
def mk(m=""):
    parts = {"luma-601": (.299, .587, .114), "luma-mean": (1/3,)*3}.get(m, (0.2126, 0.7152, 0.0722))
    def luma(c): return c[0]*N(parts[0]) + c[1]*N(parts[1]) + c[2]*N(parts[2])
    def hcl(c):
        most, least = max(c), min(c); ch = most-least; s = N(0)
        a, b = (4., 2.) if m == "hue-sectors-exchanged" else (2., 4.)
        if ch > 0:
            if most == c[0]: s = (c[1]-c[2])/ch
            elif most == c[1]: s = a+(c[2]-c[0])/ch
            else: s = b+(c[0]-c[1])/ch
        h = s/6.
        if m != "hue-unwrapped": h = h-fl(h)
        return [h, most-luma(c) if m == "chroma-from-luma" else ch, luma(c)]
    def colour_of(h, ch, y):
        s = 6.*h if m == "hue-unwrapped" else 6.*(h-fl(h))
        pure = [clamp(abs(s-3.)-1., 0, 1), clamp(2.-abs(s-2.), 0, 1), clamp(2.-abs(s-4.), 0, 1)]
        if m == "colour-value-for-luma":
            f = clamp(ch, 0, y); return [y-f*(1.-p) for p in pure]
        way = [p-luma(pure) for p in pure]
        if m == "gamut-ignored": return [y+ch*w for w in way]
        if m == "gamut-clamped": return [clamp(y+ch*w, 0, 1) for w in way]
        f = max(ch, N(0))
        for w in way:
            if w < 0 and m != "gamut-upper-only": f = min(f, y/-w)
            if w > 0: f = min(f, max(1.-y, N(0))/w)
        o = [y+f*w for w in way]
        return o if m == "gamut-upper-only" else [max(x, N(0)) for x in o]
    def adjusted(c, t, s, b):
        if m == "saturation-on-components": c, s = [x*s for x in c], N(1)
        p = hcl(c)
        y = max(p[2]+b-1., N(0)) if m == "adjust-luma-added" else p[2]*b
        return colour_of(p[0]+t, p[1]*s, y)
    def reinhard(c, w):
        if m == "reinhard-per-component": return [x*(1.+x/(w*w))/(1.+x) for x in c]
        y = luma(c); return [x*(1.+y/(w if m == "reinhard-white-not-squared" else w*w))/(1.+y) for x in c]
    def h(x): return (x*(0.15*x+0.05)+0.004)/(x*(0.15*x+0.5)+0.06)-N(0.02/0.3)
    def filmic(c):
        k = 4. if m == "filmic-exposed-twice" else 2.
        d = N(1) if m == "filmic-not-normalised" else h(N(11.2))
        return [h(k*x)/d for x in c]
    def tone(c, st, k, w):
        e = N(2.0**st.v)
        if m == "exposure-linear": e = max(1.+st, N(0))
        cur = lambda c: reinhard(c, w) if k == 1 else filmic(c) if k == 2 else c
        if m == "exposure-after-curve": return [x*e for x in cur(c)]
        return cur([x*e for x in c])
    def overlaid(b, a, am):
        s = a[3]*am
        mix = lambda x, y, t: x*(1.-t)+y*t
        if m == "overlay-premultiplied": return [a[i]*am+b[i]*(1.-s) for i in range(3)]+[b[3]]
        if m == "overlay-inverted": return [mix(a[i], b[i], s) for i in range(3)]+[b[3]]
        if m == "overlay-amount-ignored": s = a[3]
        if m == "mix-fast": return [b[i]+s*(a[i]-b[i]) for i in range(3)]+[b[3]]
        return [mix(b[i], a[i], s) for i in range(3)]+[b[3]]
    def bright(c, t):
        if m == "bright-per-component": return [max(x-t, N(0)) for x in c]
        y = luma(c)
        if not y > t: return V((0, 0, 0))
        return c if m == "bright-hard-threshold" else [x*((y-t)/y) for x in c]
    def pic(x, y):
        x, y = min(max(x, 0), 8), min(max(y, 0), 4)
        return V((r((7*x+3*y) % 11)/10, x/8, y/4))
    def blurred(p, ac, last):
        w = [N("%.9f" % (1/(1+k)-.05*k)) for k in range(last+1)]
        dx, dy = (1, 1) if m == "blur-diagonal" else (ac, 1-ac)
        x, y = p
        s = [w[0]*v for v in pic(x, y)]
        if m == "blur-centre-twice": s = [2*v for v in s]
        for k in range(1, last+1):
            a, b = pic(x+k*dx, y+k*dy), pic(x-k*dx, y-k*dy)
            if m == "blur-not-mirrored": b = V((0, 0, 0))
            s = [s[i]+w[k]*(a[i]+b[i]) for i in range(3)]
        return s
    def grid(n, i):
        R, G, B = (v/(n-1) for v in i); return V((R*R, G*B, B-.3*R*G+.1*math.sin(7*R)))
    def tri(c, n):
        u = {"table-half-texel": lambda x: x*(n-1.)/n, "table-whole-range": lambda x: x}.get(m, lambda x: (x*(n-1.)+.5)/n)
        at = [u(x)*n-.5 for x in c]; lo = [fl(a) for a in at]; f = [a-l for a, l in zip(at, lo)]
        o = V((0, 0, 0))
        for k in range(8):
            bit = [k & 1, k >> 1 & 1, k >> 2]; w = N(1)
            for i in range(3): w = w*(f[i] if bit[i] else 1.-f[i])
            g = grid(n, [min(max(int(lo[i].v)+bit[i], 0), n-1) for i in range(3)])
            o = [o[i]+w*g[i] for i in range(3)]
        return o
    def tetra(c, n):
        pl = [clamp(x, 0, 1)*(n-1.) for x in c]; co = [min(int(p.v), n-2) for p in pl]; f = [p-c_ for p, c_ in zip(pl, co)]
        most, least = max(f), min(f); mid = f[0]+f[1]+f[2]-most-least
        E = [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
        first = E[0] if f[0] == most else E[1] if f[1] == most else E[2]
        last = E[2] if f[2] == least else E[1] if f[1] == least else E[0]
        if m == "tetrahedral-order-reversed": first, last = last, first
        g = lambda d: grid(n, [a+b for a, b in zip(co, d)])
        lo, hi, one, two = g((0,)*3), g((1,)*3), g(first), g([1-x for x in last])
        return [(1.-most)*lo[i]+(most-mid)*one[i]+(mid-least)*two[i]+least*hi[i] for i in range(3)]
    def dith(s, n):
        if m == "dither-upwards": return [x+n/255. for x in s]
        if m == "dither-full-255-missing": return [x+(n-.5) for x in s]
        return [x+(n-.5)/255. for x in s]
    def weights(sg):
        sg = r(sg); last = math.ceil(3*sg); d = sg if m == "weights-variance-for-sigma" else sg*sg
        b = [math.exp(-.5*k*k/d) if -.5*k*k/d > -700 else 0. for k in range(last+1)]
        t = sum(b) if m == "weights-half-sum" else 2*sum(b)-b[0]
        return ([len(b)]+[r(x/t) for x in b]+[0]*62)[:62]
    def passes(i):
        B = [0] if i["bloom"] else []; T = [1] if i["exposure"] or i["curve"] else []
        A = [2] if (i["hue"] != math.floor(i["hue"]) or (m == "passes-whole-turn-kept" and i["hue"])) or i["saturation"] != 1 or i["brightness"] != 1 else []
        L = [3] if i["table"] else []; O = [4] if i["overlay"] else []
        p = {"passes-tone-last": B+A+L+O+T, "passes-bloom-after-tone": T+B+A+L+O, "passes-table-before-adjust": B+T+L+A+O,
             "passes-identity-kept": [0, 1, 2]+L+[4]}.get(m, B+T+A+L+O)
        return [len(p)]+(p+[-1]*5)[:5]
    return {"luma": lambda i: [luma(V(i["colour"]))], "hue_chroma_luma": lambda i: hcl(V(i["colour"])),
            "colour_of": lambda i: colour_of(N(i["hue"]), N(i["chroma"]), N(i["luma_wanted"])),
            "adjusted": lambda i: adjusted(V(i["colour"]), N(i["turns"]), N(i["saturation"]), N(i["brightness"])),
            "reinhard": lambda i: reinhard(V(i["colour"]), N(i["white"])), "filmic": lambda i: filmic(V(i["colour"])),
            "tone_mapped": lambda i: tone(V(i["colour"]), N(i["stops"]), i["curve"], N(i["white"])),
            "overlaid": lambda i: overlaid(V(i["below"]), V(i["above"]), N(i["amount"])),
            "bright_part": lambda i: bright(V(i["colour"]), N(i["threshold"])),
            "blurred": lambda i: blurred(i["place"], i["across"], i["last"]),
            "table_trilinear": lambda i: tri(V(i["colour"]), i["size"]), "table_tetrahedral": lambda i: tetra(V(i["colour"]), i["size"]),
            "dithered": lambda i: dith(V(i["stored"]), N(i["noise"])), "gaussian_weights": lambda i: weights(i["sigma"]),
            "passes_for": passes, "read_table": lambda i: read_probe(i, m), "read_refuses": lambda i: [refused(i, m)]}
# --- read_table as the solution's
class Bad(Exception): pass
import re
NUM = re.compile(r"-?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\Z|-?(inf|infinity|nan)\Z", re.I)
def read(text, m):
    t = dict(size=0, low=[0]*3, high=[1]*3, title="", colours=[]); had = set()
    def once(k):
        if k in had or t["colours"]: raise Bad
        had.add(k)
    def num(w):
        if not NUM.match(w): raise Bad
        v = r(float(w))
        if not math.isfinite(v): raise Bad
        return v
    def three(w):
        if len(w) != 3: raise Bad
        return [num(x) for x in w]
    lines = text.split("\n")
    if lines[-1] == "": lines.pop()
    for line in lines:
        if line.endswith("\r") and m != "cube-crlf-kept": line = line[:-1]
        w = re.findall(r"[^ \t]+", line)
        if not w or w[0][0] == "#": continue
        if w[0] == "TITLE":
            once("t"); a, b = line.find('"'), line.rfind('"')
            if a == b or line[b+1:].strip(" \t"): raise Bad
            t["title"] = line[a+1:b]
        elif w[0] == "LUT_3D_SIZE":
            once("s")
            if len(w) != 2 or not re.match(r"-?\d+\Z", w[1]) or not 2 <= int(w[1]) <= 256: raise Bad
            t["size"] = int(w[1])
        elif w[0] == "DOMAIN_MIN": once("l"); t["low"] = three(w[1:])
        elif w[0] == "DOMAIN_MAX": once("h"); t["high"] = three(w[1:])
        else: t["colours"].append(three(w))
    n = t["size"]
    if n == 0 or (len(t["colours"]) > n**3 if m == "cube-short-accepted" else len(t["colours"]) != n**3): raise Bad
    if any(not a < b for a, b in zip(t["low"], t["high"])): raise Bad
    if m == "cube-blue-first":
        c = t["colours"]; o = list(c)
        for i in range(n**3): o[i//(n*n)+n*(i//n % n+n*(i % n))] = c[i]
        t["colours"] = o
    return t
def text(i): return "".join(map(chr, i["text"]))
def refused(i, m):
    try: read(text(i), m); return 0
    except Bad: return 1
def read_probe(i, m):
    t = read(text(i), m); c = t["colours"]
    return [t["size"], *t["low"], *t["high"], len(t["title"]), len(c), *c[0], *c[1], *c[-1]]

def times(a, b, t):
    if a == b: return 0
    if not math.isfinite(a): return math.inf
    tol = t.get("absolute", 0)+t.get("relative", 0)*abs(b)
    return abs(a-b)/tol if tol else math.inf
def worst(c, f):
    w = (0, None)
    for i, e in zip(c["inputs"], c["expected"]):
        got = [x.v if isinstance(x, N) else float(x) for x in f(i)]
        assert len(got) == len(e), (c["name"], got)
        for g, x in zip(got, e):
            k = times(g, x, c.get("tolerance", {}))
            if k > w[0]: w = (k, (i, got, e))
    return w
d = json.load(open("/work/s08/tests/cases/08-post-processing/cases.json"))
for c in d["cases"]:
    if "probe" not in c or c["probe"] not in mk(): continue
    k, where = worst(c, mk()[c["probe"]])
    print("%-18s solution %.3f" % (c["name"], k), "" if k <= 0.5 else where)
    for m in c.get("rejects", []):
        k, where = worst(c, mk(m)[c["probe"]])
        print("      %-28s %.4g%s" % (m, k, "" if k >= 2 else "   <<<<"))
k, where = worst(next(c for c in d["cases"] if c["name"] == "overlaid-exact"), mk("mix-fast")["overlaid"])
print("a + t (b - a), exact:", k)
