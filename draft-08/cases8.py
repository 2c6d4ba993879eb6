#!/usr/bin/env python3
"""Writes tests/cases/08-post-processing/cases.json. The expected numbers come from computations of their own, in exact
fractions or doubles, by other formulas than the solution's where there are others.

usage: cases8.py [OUTPUT]       default: /work/s08/tests/cases/08-post-processing/cases.json
"""
import json
import math
import struct
import sys
from fractions import Fraction as F


def f32(x):
    """The nearest 32-bit float, as a double."""
    return struct.unpack("f", struct.pack("f", float(x)))[0]


def exact(x):
    return F(f32(x))


# ---- Colours, in fractions of the 32-bit inputs


def luma(c):
    return (2126 * c[0] + 7152 * c[1] + 722 * c[2]) / F(10000)


def hue_chroma_luma(c):
    """By the order of the components: the middle one says where in the sector."""
    names = sorted("rgb", key=lambda n: -c["rgb".index(n)])
    least, middle, most = sorted(c)
    chroma = most - least
    if chroma == 0:
        return [F(0), F(0), luma(c)]
    part = (middle - least) / chroma
    start, sign = {"rgb": (0, 1), "grb": (2, -1), "gbr": (2, 1), "bgr": (4, -1), "brg": (4, 1), "rbg": (6, -1)}[
        "".join(names)]
    return [(start + sign * part) / 6 % 1, chroma, luma(c)]


CORNERS = [(1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 1, 1), (0, 0, 1), (1, 0, 1)]


def colour_of(hue, chroma, y):
    """Between two of the six corners of the hexagon; the greatest chroma that fits by bisection."""
    if y >= 1 or y <= 0:
        return [y] * 3
    sixths = hue % 1 * 6
    i, part = int(sixths), sixths - int(sixths)
    pure = [a + (b - a) * part for a, b in zip(CORNERS[i], CORNERS[(i + 1) % 6])]

    def with_chroma(x):
        at_zero = luma([x * p for p in pure])
        return [x * p - at_zero + y for p in pure]

    def fits(x):
        return all(0 <= v <= 1 for v in with_chroma(x))

    if fits(chroma):
        return with_chroma(chroma)
    low, high = F(0), min(chroma, F(1))
    for _ in range(70):
        middle = (low + high) / 2
        low, high = (middle, high) if fits(middle) else (low, middle)
    return with_chroma(low)


def adjusted(c, turns, saturation, brightness):
    h, x, y = hue_chroma_luma(c)
    return colour_of(h + turns, x * saturation, y * brightness)


# ---- Tone


def reinhard(c, white):
    y = luma(c)
    if y == 0:
        return [F(0)] * 3
    wanted = (y + (y / white) ** 2) / (1 + y)
    return [v * wanted / y for v in c]


def hable(x):
    """The two quotients over one denominator: the constants D E and E/F D F cancel."""
    a, b, c, d, e, f = F(15, 100), F(1, 2), F(1, 10), F(1, 5), F(1, 50), F(3, 10)
    return (a * (1 - e / f) * x * x + b * (c - e / f) * x) / (a * x * x + b * x + d * f)


def filmic(c):
    return [hable(2 * v) / hable(F(112, 10)) for v in c]


def tone_mapped(c, stops, curve, white):
    lit = [v * F(math.pow(2.0, float(stops))) for v in c]
    return [lit, reinhard(lit, white), filmic(lit)][curve] if curve else lit


def overlaid(below, above, amount):
    seen = above[3] * amount
    return [a + seen * (b - a) for a, b in zip(below[:3], above[:3])] + [below[3]]


def bright_part(c, threshold):
    y = luma(c)
    return [v - v * threshold / y for v in c] if y > threshold else [F(0)] * 3


# ---- Bloom


def gaussian_weights(sigma):
    last = math.ceil(3 * sigma)
    bell = [math.exp(-((k / sigma) ** 2) / 2) for k in range(-last, last + 1)]
    total = math.fsum(bell)
    return [b / total for b in bell[last:]]


def test_picture(x, y):
    x, y = min(max(x, 0), 8), min(max(y, 0), 4)
    return ((7 * x + 3 * y) % 11 / 10, x / 8, y / 4)


def blurred(place, across, last):
    """The probe's weights are no Gaussian; they have nine decimals."""
    weight = [float("%.9f" % (1 / (1 + k) - 0.05 * k)) for k in range(last + 1)]
    (x, y), across = place, int(across)
    return [math.fsum(weight[abs(k)] * f32(test_picture(x + k * across, y + k * (1 - across))[i])
                      for k in range(-last, last + 1)) for i in range(3)]


# ---- Tables


def grid(size, i):
    r, g, b = (v / (size - 1) for v in i)
    return (r * r, g * b, b - 0.3 * r * g + 0.1 * math.sin(7 * r))


def cell(colour, size):
    place = [float(v) * (size - 1) for v in colour]
    corner = [min(int(p), size - 2) for p in place]
    return corner, [p - c for p, c in zip(place, corner)]


def trilinear(colour, size):
    """The eight corners by their weights."""
    corner, part = cell(colour, size)
    out = [0.0] * 3
    for n in range(8):
        bits = [n & 1, n >> 1 & 1, n >> 2]
        weight = math.prod(p if b else 1 - p for p, b in zip(part, bits))
        out = [o + weight * v for o, v in zip(out, grid(size, [c + b for c, b in zip(corner, bits)]))]
    return out


def tetrahedral(colour, size):
    """The mean, over all thresholds from 0 to 1, of the corner whose coordinates are 1 where the fraction is above."""
    corner, part = cell(colour, size)
    borders = sorted({0.0, 1.0, *part})
    out = [0.0] * 3
    for low, high in zip(borders, borders[1:]):
        middle = (low + high) / 2
        at = grid(size, [c + (p > middle) for c, p in zip(corner, part)])
        out = [o + (high - low) * v for o, v in zip(out, at)]
    return out


# ---- The file

CASES = []


def case(name, title, asked, hint, points, tier="core", **rest):
    c = {"name": name, "title": title, "asked": asked}
    if hint:
        c["hint"] = hint
    c["points"] = points
    if tier != "core":
        c["tier"] = tier
    c.update(rest)
    CASES.append(c)


def shown(x):
    """A number as JSON: ten digits, or all that a float needs."""
    if isinstance(x, str):
        return x
    x = float(x)
    if x == int(x) and abs(x) < 1e15:
        return int(x)
    short = float("%.10g" % x)
    return short


def probe(name, title, asked, hint, points, function, inputs, expected, numbers, tolerance, rejects, functions=None,
          tier="core"):
    """`expected`: a function of an input, or the lists."""
    rest = {"probe": function, "inputs": inputs}
    if expected == "reference":
        rest["expected_from"] = "reference"
    else:
        lists = [expected(i) for i in inputs] if callable(expected) else expected
        rest["expected"] = [[shown(x) for x in numbers_of] for numbers_of in lists]
        for numbers_of in rest["expected"]:
            assert len(numbers_of) == len(numbers), (name, numbers_of)
    rest["numbers"] = numbers
    if tolerance:
        rest["tolerance"] = tolerance
    if rejects:
        rest["rejects"] = rejects
    rest["functions"] = functions or [function]
    case(name, title, asked, hint, points, tier, **rest)


def picture(name, title, asked, hint, points, scene, rejects, functions, settings=None, tier="core", **rest):
    more = {"scene": scene, **rest}
    if settings:
        more["settings"] = settings
    if rejects:
        more["rejects"] = rejects
    if functions:
        more["functions"] = functions
    case(name, title, asked, hint, points, tier, **more)


def exacts(values):
    return [exact(v) for v in values]


RGB = ["red", "green", "blue"]
COLOUR_REASON = "Some sums, products and one or two quotients of floats."

# ---- Core 1: the chain

probe("next-target", "Two targets in turn",
      "The target that the pass does not read.",
      "A chain has two targets. A pass reads one of them: which is left for it to write?",
      2, "next_target", [{"source": 0}, {"source": 1}], [[1], [0]], ["target"], None, ["target-same"])

probe("next-target-first", "The target of the first pass",
      "0 or 1: the scene's picture is in neither of them.",
      None, 0, "next_target", [{"source": -1}], [[0.5]], ["target"],
      {"absolute": 0.5, "reason": "Either of the two is right."}, None)

probe("full-screen", "A triangle over the whole picture",
      "Every pixel is drawn once, by three vertices, and no vertex array stays bound.",
      "A core profile draws nothing without a bound vertex array. Which of your calls binds one, and which unbinds it?",
      0, "draw_full_screen",
      [{"size": [1, 1]}, {"size": [2, 3]}, {"size": [64, 48]}, {"size": [317, 211]}, {"size": [1, 300]},
       {"size": [512, 1]}],
      lambda i: [i["size"][0] * i["size"][1], 0, 3],
      ["pixels drawn once", "a vertex array stays bound", "vertices"], None, None)

probe("corners", "The corners of that triangle",
      "Corner 0 in the picture's lower left corner, corner 1 to the right of it and corner 2 above it, at twice the "
      "picture's width and height.",
      "Where must the second and the third corner be, so that the line between them meets the picture's upper right "
      "corner?",
      2, "full_screen_corner", [{"corner": 0}, {"corner": 1}, {"corner": 2}], [[-1, -1], [3, -1], [-1, 3]], ["x", "y"],
      None, ["corner-short"])

# ---- Core 2: which passes


def look(**given):
    return {"bloom": 0, "exposure": 0, "curve": 0, "hue": 0, "saturation": 1, "brightness": 1, "table": 0, "overlay": 0,
            **given}


NO = [-1] * 5
LOOKS = [
    (look(), []),
    (look(bloom=0.3), [0]),
    (look(bloom=4), [0]),
    (look(exposure=1), [1]),
    (look(exposure=-2.5), [1]),
    (look(curve=1), [1]),
    (look(curve=2), [1]),
    (look(exposure=0.5, curve=2), [1]),
    (look(hue=0.25), [2]),
    (look(hue=-0.25), [2]),
    (look(hue=1.5), [2]),
    (look(hue=1), []),
    (look(hue=-1), []),
    (look(hue=2), []),
    (look(hue=-2), []),
    (look(saturation=0), [2]),
    (look(saturation=1.5), [2]),
    (look(brightness=0), [2]),
    (look(brightness=1.25), [2]),
    (look(hue=0.5, saturation=0.5, brightness=2), [2]),
    (look(hue=1, saturation=2), [2]),
    (look(hue=2, brightness=0.5), [2]),
    (look(table=1), [3]),
    (look(overlay=1), [4]),
    (look(overlay=0.0625), [4]),
    (look(bloom=1, curve=2), [0, 1]),
    (look(bloom=1, hue=0.5), [0, 2]),
    (look(bloom=1, table=1), [0, 3]),
    (look(bloom=1, overlay=1), [0, 4]),
    (look(exposure=1, saturation=0.5), [1, 2]),
    (look(exposure=1, table=1), [1, 3]),
    (look(curve=1, overlay=0.5), [1, 4]),
    (look(brightness=0.5, table=1), [2, 3]),
    (look(brightness=0.5, overlay=1), [2, 4]),
    (look(table=1, overlay=1), [3, 4]),
    (look(bloom=1, exposure=1, hue=1, table=1), [0, 1, 3]),
    (look(curve=1, hue=0.125, table=1), [1, 2, 3]),
    (look(exposure=-1, saturation=2, table=1, overlay=0.5), [1, 2, 3, 4]),
    (look(bloom=0.5, exposure=2, curve=2, hue=-0.125, saturation=0.75, brightness=1.5, table=1, overlay=1),
     [0, 1, 2, 3, 4]),
]
probe("passes", "Which passes, and in which order",
      "The passes that the look needs, each once: 0 bloom, 1 tone, 2 adjust, 3 table, 4 overlay; -1 after the last.",
      "For each pass: when does it leave every picture as it is? And does it work on light, or on the colours of a "
      "display?",
      6, "passes_for", [i for i, _ in LOOKS], [([len(p)] + p + NO)[:6] for _, p in LOOKS],
      ["count", "pass 1", "pass 2", "pass 3", "pass 4", "pass 5"], None,
      ["passes-identity-kept", "passes-tone-last", "passes-bloom-after-tone", "passes-table-before-adjust",
       "passes-whole-turn-kept"])

# ---- Core 2: hue, chroma, luma

probe("luma", "How bright a colour is",
      "0.2126 of red, 0.7152 of green, 0.0722 of blue.",
      "The colours are linear light with the primaries of Rec. 709. Which weights belong to these?",
      2, "luma",
      [{"colour": c} for c in ([0, 0, 0], [1, 1, 1], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0.5, 0.25, 0],
                               [0.1, 0.7, 0.35], [30, 12.5, 3], [1e-6, 2e-6, 3e-6], [65504, 65504, 65504])],
      lambda i: [luma(exacts(i["colour"]))], ["luma"],
      {"absolute": 1e-9, "relative": 1e-6, "reason": "Three products and two sums of floats."},
      ["luma-601", "luma-mean"])

HUES = [
    [0.5, 0.25, 0], [0.5, 0, 0], [0, 0.5, 0], [0, 0, 0.5], [0.5, 0.5, 0], [0, 0.5, 0.5], [0.5, 0, 0.5],  # corners
    [0.75, 0.5, 0.25], [0.5, 0.75, 0.25], [0.25, 0.75, 0.5], [0.25, 0.5, 0.75], [0.5, 0.25, 0.75], [0.75, 0.25, 0.5],
    [1, 0.125, 0], [0.125, 1, 0], [0, 1, 0.125], [0, 0.125, 1], [0.125, 0, 1], [1, 0, 0.125],
    [1, 0, 0.001953125], [1, 0.001953125, 0],  # on both sides of red
    [0, 0, 0], [1, 1, 1], [0.3, 0.3, 0.3], [30, 30, 30],  # greys
    [0.5, 0.500030517578125, 0.5], [0.5, 0.5, 0.500030517578125], [0.5, 0.499969482421875, 0.5],  # nearly
    [30, 20, 3], [2.5, 12, 9], [1e-4, 3e-4, 2e-4], [0.8, 0.55, 0.45],
]
probe("hue-chroma-luma", "Hue, chroma and luma of a colour",
      "Hue in turns from 0 to 1, the largest component minus the smallest, and the luma; the hue of a grey is 0.",
      "Draw the hexagon of red, yellow, green, cyan, blue and magenta. Between which two corners is the colour, and "
      "which component changes there?",
      6, "hue_chroma_luma", [{"colour": c} for c in HUES], lambda i: hue_chroma_luma(exacts(i["colour"])),
      ["hue", "chroma", "luma"],
      {"absolute": 2e-6, "relative": 1e-6, "reason": "One quotient of differences that are exact, and sums up to 6."},
      ["hue-unwrapped", "hue-sectors-exchanged", "chroma-from-luma"])

HCL = [
    (1 / 12, 0.5, 0.2851), (1 / 12, 0.8, 0.2851), (1 / 12, 0.25, 0.2851),
    (0, 0.5, 0.3), (1 / 6, 0.5, 0.6), (1 / 3, 0.5, 0.5), (0.5, 0.5, 0.5), (2 / 3, 0.5, 0.2), (5 / 6, 0.5, 0.4),
    (0.04, 0.3, 0.4), (0.25, 0.3, 0.4), (0.4, 0.3, 0.4), (0.6, 0.3, 0.4), (0.72, 0.3, 0.4), (0.95, 0.3, 0.4),
    (1, 0.25, 0.5), (-0.25, 0.25, 0.5), (1.75, 0.25, 0.5), (-1, 0.25, 0.5), (3.375, 0.25, 0.5), (-2.625, 0.25, 0.5),
    (0.9997, 0.25, 0.5), (1.0003, 0.25, 0.5),
    (0.3, 0, 0.4), (0.3, 0, 0), (0.3, 0.5, 0), (0.8, 1, 0.0001), (0.45, 1, 0.9999),
    (0.1, 0.5, 1), (0.6, 1, 1.3), (0.6, 0, 20),
    (1 / 6, 1, 0.1), (0.17, 1, 0.5), (2 / 3, 1, 0.9), (0.65, 1, 0.5), (0.7, 1, 0.03), (0, 1, 0.2), (0, 1, 0.25),
    (0.35, 1, 0.75), (0.52, 1, 0.05), (0.9, 1, 0.85), (0.28, 0.9, 0.6), (0.58, 1000, 0.5), (0.11, 1000, 0.5),
]
probe("colour-of", "The colour of a hue, a chroma and a luma",
      "This hue and this luma; the chroma as wanted, or the greatest with which every component is between 0 and 1.",
      "Start from the grey of this luma. In which direction does more chroma lead, and which component meets 0 or 1 "
      "first?",
      7, "colour_of", [{"hue": shown(h), "chroma": x, "luma_wanted": y} for h, x, y in HCL],
      lambda i: colour_of(exact(i["hue"]), exact(i["chroma"]), exact(i["luma_wanted"])), RGB,
      {"absolute": 5e-6, "relative": 1e-6,
       "reason": "A hue of 3 in floats is known to 1e-7 turns, so components to 2e-6; and some sums and a quotient."},
      ["gamut-ignored", "gamut-clamped", "gamut-upper-only", "colour-value-for-luma", "hue-unwrapped"])

ADJUSTED = [
    ([0.5, 0.25, 0.1], 0, 1, 1), ([0.8, 0.55, 0.45], 0, 1, 1),
    ([0.5, 0.25, 0.1], 1 / 3, 1, 1), ([0.5, 0.25, 0.1], 0.5, 1, 1), ([0.5, 0.25, 0.1], -0.25, 1, 1),
    ([0.5, 0.25, 0.1], 1, 1, 1), ([0.5, 0.25, 0.1], -2, 1, 1), ([0.5, 0.1, 0.2], 0.1, 1, 1),
    ([0.5, 0.2, 0.1], -0.1, 1, 1), ([0.5, 0, 0.002], 0.001, 1, 1),
    ([0.4, 0.4, 0.4], 0.3, 3, 1), ([0, 0, 0], 0.3, 2, 2), ([1, 1, 1], 0.3, 4, 1),
    ([0.5, 0.25, 0.1], 0, 0, 1), ([0.1, 0.2, 0.9], 0.2, 0, 1), ([0.5, 0.25, 0.1], 0, 0.5, 1),
    ([0.5, 0.45, 0.4], 0, 2, 1), ([0.5, 0.45, 0.4], 0, 1e6, 1), ([0.2, 0.3, 0.7], 0, 1.8, 1), ([0.9, 0.8, 0.3], 0, 2, 1),
    ([0.5, 0.25, 0.1], 0, 1, 0), ([0.5, 0.25, 0.1], 0, 1, 0.5), ([0.5, 0.25, 0.1], 0, 1, 1.5),
    ([0.5, 0.25, 0.1], 0, 1, 4), ([0.5, 0.25, 0.1], 0.2, 1, 1000), ([1, 0, 0], 0, 1, 0.5), ([0, 0, 1], 0, 1, 8),
    ([8, 2, 0.5], 0, 1, 0.0625), ([8, 2, 0.5], 0.4, 0.1, 0.125), ([30, 20, 10], 0.1, 1, 1),
    ([0.2, 0.6, 0.3], 0.15, 1.3, 0.8), ([0.02, 0.01, 0.05], -0.3, 0.7, 3),
]
probe("adjusted", "Hue, saturation and brightness",
      "The hue turned, the chroma times the saturation, the luma times the brightness.",
      "Turn the colour into hue, chroma and luma first. Which of the three does each setting change?",
      3, "adjusted", [{"colour": c, "turns": shown(t), "saturation": s, "brightness": b} for c, t, s, b in ADJUSTED],
      lambda i: adjusted(exacts(i["colour"]), exact(i["turns"]), exact(i["saturation"]), exact(i["brightness"])), RGB,
      {"absolute": 5e-6, "relative": 2e-6, "reason": "The errors of both conversions: a hue to 3e-7 turns, and quotients."},
      ["adjust-luma-added", "saturation-on-components"], ["adjusted", "hue_chroma_luma", "colour_of", "luma"])

# ---- Core 3: tone mapping

REINHARD = [
    ([0, 0, 0], 4), ([4, 4, 4], 4), ([0.18, 0.18, 0.18], 4), ([1, 1, 1], 4), ([1, 1, 1], 1), ([0.5, 0.5, 0.5], 0.5),
    ([2, 1, 0.25], 4), ([30, 2, 0.5], 4), ([0.5, 30, 2], 16), ([0.5, 2, 30], 100), ([0.1, 0.02, 0.3], 0.1),
    ([1e-5, 2e-5, 0], 4), ([8, 0, 0], 2), ([0, 0, 8], 2), ([65504, 65504, 65504], 100), ([3, 2, 1], 1000),
]
probe("reinhard", "Reinhard's curve",
      "The luma becomes Y (1 + Y / white^2) / (1 + Y), all components by the same factor.",
      "Is the hue the same as before? Then compare the luma of the result with the formula, for a luma of `white`.",
      3, "reinhard", [{"colour": c, "white": w} for c, w in REINHARD],
      lambda i: reinhard(exacts(i["colour"]), exact(i["white"])), RGB,
      {"absolute": 1e-9, "relative": 5e-6, "reason": COLOUR_REASON},
      ["reinhard-per-component", "reinhard-white-not-squared"], ["reinhard", "luma"])

probe("filmic", "Hable's filmic curve",
      "h(2 x) / h(11.2) of each component: 5.6 becomes 1, black stays black.",
      "Which x must become exactly 1? Which two numbers does the contract divide?",
      3, "filmic",
      [{"colour": c} for c in ([0, 0, 0], [1, 1, 1], [5.6, 5.6, 5.6], [0.18, 0.18, 0.18], [0.1, 1, 20], [1, 20, 0.1],
                               [20, 0.1, 1], [0.001, 0.01, 0.05], [11.2, 2.8, 0.5], [1000, 100, 10],
                               [65504, 0, 65504])],
      lambda i: filmic(exacts(i["colour"])), RGB,
      {"absolute": 2e-6, "relative": 5e-6,
       "reason": "A difference of a quotient and 0.067 near black, and a second quotient."},
      ["filmic-not-normalised", "filmic-exposed-twice"])

TONE = [
    ([0.5, 0.25, 0.1], 0, 0, 4), ([0.5, 0.25, 0.1], 1, 0, 4), ([0.5, 0.25, 0.1], -1, 0, 4), ([0.5, 0.25, 0.1], 2.5, 0, 4),
    ([0.5, 0.25, 0.1], -3.25, 0, 1), ([1e-3, 2e-3, 3e-3], 10, 0, 4), ([65504, 100, 1], -10, 0, 4), ([0, 0, 0], 10, 0, 4),
    ([0.5, 0.25, 0.1], 0, 1, 4), ([0.5, 0.25, 0.1], 3, 1, 4), ([8, 2, 0.5], -1, 1, 4), ([2, 2, 2], 1, 1, 4),
    ([8, 2, 0.5], 0.5, 1, 1), ([8, 2, 0.5], -2, 1, 20), ([0, 0, 0], 10, 1, 0.1),
    ([0.5, 0.25, 0.1], 0, 2, 4), ([0.5, 0.25, 0.1], 2, 2, 4), ([8, 2, 0.5], -1.5, 2, 4), ([2.8, 2.8, 2.8], 1, 2, 4),
    ([2.8, 2.8, 2.8], 1, 2, 0.5), ([0, 0, 0], -10, 2, 4), ([30, 12, 3], -4, 2, 1),
]
probe("tone-mapped", "Exposure, then a curve",
      "The light times 2^stops, then no curve, Reinhard's, or the filmic one.",
      "Two stops more are four times the light. Is that done before the curve or after it?",
      3, "tone_mapped", [{"colour": c, "stops": s, "curve": k, "white": w} for c, s, k, w in TONE],
      lambda i: tone_mapped(exacts(i["colour"]), exact(i["stops"]), i["curve"], exact(i["white"])), RGB,
      {"absolute": 2e-6, "relative": 2e-5,
       "reason": "The driver's exponential is accurate to some ulp; processors differ in their approximations."},
      ["exposure-linear", "exposure-after-curve", "filmic-exposed-twice"], ["tone_mapped", "reinhard", "filmic", "luma"])

# ---- Core 4: overlay

OVERLAID = [
    ([0.2, 0.4, 0.6, 1], [0.9, 0.1, 0.5, 1], 0.5), ([0.2, 0.4, 0.6, 1], [0.9, 0.1, 0.5, 1], 0.25),
    ([0.2, 0.4, 0.6, 0.3], [0.9, 0.1, 0.5, 0.5], 1), ([0.2, 0.4, 0.6, 0], [0.9, 0.1, 0.5, 0.7], 0.6),
    ([8, 2, 0.5, 0.5], [0.05, 0.05, 0.05, 0.7], 1), ([0, 0, 0, 1], [1, 1, 1, 0.1], 0.1),
    ([0.5, 0.5, 0.5, 0.25], [4, 0, 0.5, 0.125], 0.875), ([0.2, 0.4, 0.6, 1], [0, 0, 0, 0.75], 1),
]
probe("overlaid", "A picture over the picture",
      "A share amount * above.a of the upper colour, the rest of the lower one; the opacity of the lower one.",
      "How much of the lower picture is seen where the upper one is half opaque and half of it is wanted?",
      3, "overlaid", [{"below": b, "above": a, "amount": m} for b, a, m in OVERLAID],
      lambda i: overlaid(exacts(i["below"]), exacts(i["above"]), exact(i["amount"])), ["red", "green", "blue", "alpha"],
      {"absolute": 2e-6, "relative": 1e-6, "reason": "Products and a sum of floats."},
      ["overlay-premultiplied", "overlay-inverted", "overlay-amount-ignored"])

# Floats that a + 1 (b - a) would not give back.
BELOW, ABOVE = [1000.123, 0.1, 3e-5, 0.3], [0.1, 700.7, 0.9, 1]
OVERLAID_EXACT = [
    (BELOW, ABOVE, 0), (BELOW, ABOVE, 1), (BELOW, ABOVE[:3] + [0], 1), (BELOW, ABOVE[:3] + [0], 0.3),
    (BELOW, ABOVE[:3] + [0.7], 0), ([0.7, 0.1, 0.3, 1], [0.1, 0.9, 0.6, 1], 1), ([0.7, 0.1, 0.3, 1], [0.1, 0.9, 0.6, 1], 0),
    ([30000.7, 0, 1e-6, 0], [1e-6, 0.3, 29.97, 1], 1), ([0, 0, 0, 0.6], [0.1, 0.2, 0.3, 1], 1),
    ([0.1, 0.2, 0.3, 0.6], [0, 0, 0, 1], 1),
]


def whole_floats(colour):
    return [f32(v) for v in colour]


probe("overlaid-exact", "All of it, or nothing",
      "Where nothing of the upper picture is seen, exactly the lower colour; where all of it is, exactly the upper one.",
      "a + (b - a) need not be b in floats. Which form gives both ends without rounding?",
      2, "overlaid",
      [{"below": whole_floats(b), "above": whole_floats(a), "amount": f32(m)} for b, a, m in OVERLAID_EXACT],
      lambda i: [str(v) for v in (i["above"] if i["above"][3] * i["amount"] == 1 else i["below"])[:3]] +
                [str(i["below"][3])],
      ["red", "green", "blue", "alpha"], None, ["overlay-inverted", "overlay-amount-ignored"])

# ---- Core: pictures

BASE = ["passes_for", "draw_full_screen", "full_screen_corner"]
ADJUST = ["adjusted", "hue_chroma_luma", "colour_of", "luma"]

picture("room", "A room without passes", "The scene as it is: with the settings' defaults no pass runs.", None, 0, "room",
        None, None, student=False)

picture("room-exposed", "A first pass: less light",
        "The room with 2^-1.5 of its light, over the whole picture.",
        "Is a part of the picture missing, or all of it? Draw the triangle with its corners on paper, and the picture "
        "in it.",
        4, "room", ["corner-short", "exposure-linear"], BASE + ["tone_mapped"], {"tone.exposure": -1.5})

picture("chart-turned", "All hues, turned by a third",
        "Red becomes green, green blue, blue red, each as bright as before; greys stay.",
        "Which patches are wrong: all of one hue, the most colourful ones, or those that were nearly red?",
        3, "chart", ["hue-sectors-exchanged", "hue-unwrapped", "colour-value-for-luma", "gamut-ignored", "gamut-clamped"], BASE + ADJUST,
        {"colour.hue": 0.3333})

picture("chart-grey", "No chroma",
        "Greys that are as bright as the colours were.",
        "Compare a yellow patch with a blue one: which of the two is brighter?",
        2, "chart", ["luma-601", "luma-mean"], BASE + ADJUST, {"colour.saturation": 0})

picture("chart-vivid", "More chroma than fits",
        "Every patch keeps its hue and its luma; those that cannot have more chroma stop at the border.",
        "Compare patches of one hue: if the brightest or the darkest change their hue, what limits their chroma?",
        3, "chart", ["gamut-ignored", "gamut-clamped", "gamut-upper-only", "saturation-on-components"], BASE + ADJUST,
        {"colour.saturation": 1.8})

picture("chart-bright", "Half as bright again",
        "Every patch with 1.5 times its luma; bright ones come near white, of the same hue.",
        "By which operation does the brightness change the luma? What is black then?",
        2, "chart", ["adjust-luma-added", "gamut-ignored", "gamut-clamped"], BASE + ADJUST, {"colour.brightness": 1.5})

picture("lanterns-reinhard", "Lamps, by Reinhard's curve",
        "The alley with lamps that keep their colour.",
        "Are the lamps white, though their light has a colour? To what is the curve applied?",
        2, "lanterns", ["reinhard-per-component", "reinhard-white-not-squared"],
        BASE + ["tone_mapped", "reinhard", "luma"], {"tone.curve": "reinhard", "tone.exposure": 1})

picture("lanterns-filmic", "Lamps, by the filmic curve",
        "The alley with half of its light, then the filmic curve.",
        "./atelier run 08 --scene lanterns, and move tone.exposure: does one stop double the light before the curve?",
        3, "lanterns", ["filmic-not-normalised", "filmic-exposed-twice", "exposure-linear", "exposure-after-curve"],
        BASE + ["tone_mapped", "filmic"], {"tone.curve": "filmic", "tone.exposure": -1})

picture("room-overlay", "A cheat sheet over the room",
        "The sheet in its corner, its panel seven tenths opaque; the rest of the picture as it was.",
        "Is the sheet right and the room gone, or the other way round?",
        2, "room", ["overlay-inverted"], BASE + ["overlaid"], {"overlay.amount": 1})

picture("room-overlay-half", "The sheet, half faded",
        "The same with half of each opacity.",
        "Right with overlay.amount = 1, but not here? What does the amount change?",
        2, "room", ["overlay-inverted", "overlay-amount-ignored"], BASE + ["overlaid"], {"overlay.amount": 0.5})

picture("lanterns-chain", "Three passes in a row",
        "Tone mapping first, then hue and saturation, then the sheet, which keeps its own colours.",
        "Look at --output tone and --output adjust: which is the first wrong picture? Is each what the next one reads?",
        3, "lanterns", ["passes-tone-last"], BASE + ["next_target", "tone_mapped", "filmic", "overlaid"] + ADJUST,
        {"tone.curve": "filmic", "tone.exposure": -1, "colour.hue": 0.0625, "colour.saturation": 1.5,
         "overlay.amount": 0.875})

picture("chart-fused", "The same passes as one",
        "Exposure, curve, hue, saturation and the sheet in one pass: the picture that separate passes give.",
        "Right as separate passes (chain.fused = off), but not here? Which function changes what another one needs?",
        2, "chart", ["filmic-not-normalised", "overlay-inverted"],
        BASE + ["tone_mapped", "filmic", "overlaid"] + ADJUST,
        {"chain.fused": True, "tone.curve": "filmic", "tone.exposure": 0.5, "colour.hue": -0.125,
         "colour.saturation": 1.25, "overlay.amount": 0.75})

# ---- Further: bloom


def weights_row(i):
    weights = gaussian_weights(f32(i["sigma"]))
    return ([len(weights)] + weights + [0] * 62)[:62]


probe("weights", "Half of a Gaussian filter",
      "The weights of the pixels at distances 0 to 3 sigma, rounded up; the whole filter sums to 1.",
      "Add up the whole filter: the weight of the centre counts once. What of the others?",
      2, "gaussian_weights",
      [{"sigma": s} for s in (1, 0.5, 0.1, 0.001, 0.7, 1.3, 2, 2.7, 6, 12.5, 20)], weights_row,
      ["count"] + ["weight %d" % k for k in range(61)],
      {"absolute": 1e-9, "relative": 5e-6, "reason": "Exponentials of floats up to 4.5, and a sum of up to 121 of them."},
      ["weights-variance-for-sigma", "weights-half-sum"], tier="further")

REFUSED = [(0, 1), (-1, 1), ("nan", 1), ("inf", 1), ("-inf", 1), (20.00001, 1), (21, 1), (20, 0), (0.001, 0), (6, 0)]
probe("weights-refused", "Widths that are none",
      "std::invalid_argument for 0, negative numbers, numbers above 20, infinities and NaN.",
      "A comparison with NaN is false: write the condition so that this refuses.",
      0, "gaussian_refuses", [{"sigma": s} for s, _ in REFUSED], [[r] for _, r in REFUSED], ["refused"], None, None,
      ["gaussian_weights"], tier="further")

BRIGHT = [
    ([0, 0, 0], 0), ([0, 0, 0], 1), ([0.5, 0.25, 0.1], 1), ([2, 2, 2], 1), ([30, 12, 3], 1), ([30, 12, 3], 16),
    ([3, 0.1, 0.1], 1), ([8, 0, 0], 1), ([0, 0, 8], 1), ([0, 2, 0], 1), ([0.4, 1.5, 0.2], 1), ([1.2, 1.1, 1], 1),
    ([0.5, 0.25, 0.1], 0), ([0.5, 0.25, 0.1], 0.125), ([1, 1, 1], 1), ([1e-4, 1e-4, 1e-4], 0.001),
    ([65504, 65504, 65504], 16), ([0.03, 0.01, 0.02], 0.01),
]
probe("bright-part", "What blooms",
      "The colour with the luma that exceeds the threshold; black where none does, and where there is no light.",
      "Which share of the colour's luma is too much? All components keep this share.",
      2, "bright_part", [{"colour": c, "threshold": t} for c, t in BRIGHT],
      lambda i: bright_part(exacts(i["colour"]), exact(i["threshold"])), RGB,
      {"absolute": 1e-6, "relative": 1e-5, "reason": "A difference of a luma and a threshold of nearly its size, and a quotient."},
      ["bright-hard-threshold", "bright-per-component"], ["bright_part", "luma"], tier="further")

BLURRED = [([4, 2], 1, 1), ([4, 2], 0, 1), ([3, 1], 1, 2), ([3, 1], 0, 2), ([6, 3], 1, 0), ([0, 0], 1, 3), ([0, 0], 0, 3),
           ([8, 4], 1, 4), ([8, 4], 0, 4), ([1, 3], 1, 5), ([7, 1], 0, 5), ([2, 0], 1, 8), ([6, 4], 0, 8), ([5, 2], 1, 12),
           ([5, 3], 0, 12)]
probe("blurred", "A blur in one direction",
      "The weighted sum of the pixels on both sides, in the direction of `pixel`, and of the centre, once.",
      "Which weight has the pixel k steps to the left? And the centre: how often does your loop meet it?",
      3, "blurred", [{"place": p, "across": a, "last": n} for p, a, n in BLURRED],
      lambda i: blurred(i["place"], i["across"], i["last"]), RGB,
      {"absolute": 1e-5, "reason": "Sums of up to 25 products of floats, of a size of 1."},
      ["blur-not-mirrored", "blur-centre-twice", "blur-diagonal"], tier="further")

# ---- Further: tables

LOOKUPS = [
    ([0, 0, 0], 2), ([1, 1, 1], 2), ([0.3, 0.6, 0.9], 2), ([0.9, 0.3, 0.6], 3), ([0, 0, 0], 5), ([1, 1, 1], 5),
    ([0.05, 0.05, 0.05], 5), ([0.95, 0.95, 0.95], 5), ([0.4, 0.4, 0.4], 5), ([1, 0, 0], 5), ([0, 1, 0], 5), ([0, 0, 1], 5),
    ([0.8, 0.7, 0.55], 4), ([0.55, 0.7, 0.8], 4), ([0.7, 0.8, 0.55], 4), ([0.7, 0.55, 0.8], 4), ([0.8, 0.55, 0.7], 4),
    ([0.55, 0.8, 0.7], 4), ([0.6, 0.6, 0.1], 3), ([0.1, 0.6, 0.6], 3), ([0.6, 0.1, 0.6], 3), ([0.6, 0.1, 0.1], 3),
    ([0.5, 0.25, 0.75], 5), ([0.5, 0.3, 0.9], 5), ([1, 0.3, 0.6], 9), ([0.02, 0.99, 0.51], 9), ([0.37, 0.61, 0.22], 17),
    ([0.913, 0.077, 0.444], 33),
]
lookups = [{"colour": c, "size": n} for c, n in LOOKUPS]
probe("trilinear", "A table, trilinearly",
      "Between the eight grid points around the colour; at 0 the first one, at 1 the last one.",
      "Where in texture coordinates are the centres of the first and of the last texel, in a table of two points?",
      2, "table_trilinear", lookups, lambda i: trilinear(exacts(i["colour"]), i["size"]), RGB,
      {"absolute": 2e-5, "reason": "Filtered texels: a place among 33 texels is known to 4e-6 of one."},
      ["table-half-texel", "table-whole-range"], tier="further")

probe("tetrahedral", "A table, tetrahedrally",
      "Between the four corners of the tetrahedron that holds the colour; on greys along the diagonal alone.",
      "Which way leads from the cell's lowest corner to the highest: along which axis does it go first?",
      3, "table_tetrahedral", lookups, lambda i: tetrahedral(exacts(i["colour"]), i["size"]), RGB,
      {"absolute": 1e-5, "reason": "Fractions of a place among 33 grid points, known to 2e-6, times differences below 1."},
      ["tetrahedral-order-reversed"], tier="further")


def codes(text):
    return {"text": [ord(c) for c in text]}


ZEROS = "0 0 0\n" * 8
PLAIN = "LUT_3D_SIZE 2\n" + ZEROS
RAMP = "".join("%d %d %d\n" % (n & 1, n >> 1 & 1, n >> 2) for n in range(8))
FIRST, SECOND, LAST = [0.125, 0.25, 0.5], [1.5, 0, 0.25], [0.75, -0.5, 1.5]
UNLIKE = "0.125 0.25 0.5\n1.5 0 0.25\n" + "0 0 0\n" * 5 + "0.75 -0.5 1.5\n"

NONE, ONE, BLACK = [0, 0, 0], [1, 1, 1], [[0, 0, 0]] * 3
TABLES = [  # text, size, low, high, length of the title; first, second and last colour
    ("LUT_3D_SIZE 2\n" + RAMP, 2, NONE, ONE, 0, [[0, 0, 0], [1, 0, 0], [1, 1, 1]]),
    ("LUT_3D_SIZE 2\n" + UNLIKE, 2, NONE, ONE, 0, [FIRST, SECOND, LAST]),
    ('TITLE "warm"\nLUT_3D_SIZE 2\n' + UNLIKE[:-1], 2, NONE, ONE, 4, [FIRST, SECOND, LAST]),
    ('DOMAIN_MAX 2 4 8\nTITLE "a  late  look"\nDOMAIN_MIN -1 -0.5 0.25\nLUT_3D_SIZE 2\n' + UNLIKE, 2, [-1, -0.5, 0.25],
     [2, 4, 8], 13, [FIRST, SECOND, LAST]),
    ('TITLE "LUT_3D_SIZE 5"\nLUT_3D_SIZE 2\nDOMAIN_MIN 0.5 0 -2\n' + ZEROS, 2, [0.5, 0, -2], ONE, 13, BLACK),
    ('TITLE "no #3"\nLUT_3D_SIZE 2\nDOMAIN_MAX 1.5 0.25 1e3\n' + ZEROS, 2, NONE, [1.5, 0.25, 1000], 5, BLACK),
    ("LUT_3D_SIZE 2\n0.1 1e-3 -2.5E1\n0.7 0.01 1\n" + "0 0 0\n" * 5 + "0.33333334 123456.7 0\n", 2, NONE, ONE, 0,
     [[0.1, 1e-3, -25], [0.7, 0.01, 1], [0.33333334, 123456.7, 0]]),
    ("LUT_3D_SIZE 3\n1 2 3\n3 2 1\n" + "0 0 0\n" * 24 + "4 5 6\n", 3, NONE, ONE, 0, [[1, 2, 3], [3, 2, 1], [4, 5, 6]]),
    ('# a look\n\n TITLE\t"x y"  \n\n#LUT_3D_SIZE 9\n\tLUT_3D_SIZE \t 2\t\n# colours:\n  0.25  0.5\t0.75 \n\n \t \n9 8 7\n' +
     "0 0 0\n" * 2 + "#\n" + "0 0 0\n" * 3 + "\t4 5 6\t\n# the end\n\n", 2, NONE, ONE, 3,
     [[0.25, 0.5, 0.75], [9, 8, 7], [4, 5, 6]]),
]
TABLE_NUMBERS = (["size"] + ["low, " + c for c in RGB] + ["high, " + c for c in RGB] + ["length of the title", "colours"] +
                 [which + " colour, " + c for which in ("first", "second", "last") for c in RGB])
probe("read-table", "A .cube file, read",
      "Size, range, title and colours as the file says; lines without a meaning are skipped.",
      "Print what you find line by line: is each line what you take it for, a keyword, a colour, or nothing?",
      2, "read_table", [codes(t) for t, *_ in TABLES],
      [[n] + low + high + [title, n ** 3] + sum(colours, []) for _, n, low, high, title, colours in TABLES], TABLE_NUMBERS,
      {"relative": 1e-7, "reason": "Decimal numbers, read as floats."}, ["cube-blue-first"], tier="further")

crlf = lambda text: text.replace("\n", "\r\n")
REFUSALS = [  # text, whether it is refused
    (PLAIN, 0),
    (PLAIN[:-1], 0),
    (crlf(PLAIN), 0),
    (crlf('TITLE "a b"\nDOMAIN_MIN 0 0 0\nDOMAIN_MAX 1 1 1\n\n# colours\n' + PLAIN), 0),
    ("LUT_3D_SIZE 2\r\n" + ZEROS, 0),
    ("\n#\n \t\n" + PLAIN.replace(" ", "\t") + "\n# TITLE\n", 0),
    ("DOMAIN_MIN -1 -1 -1\nDOMAIN_MAX 0 0 0\n" + PLAIN, 0),
    ("\n", 1), (ZEROS, 1), ("LUT_3D_SIZE 2\n", 1),
    ("LUT_1D_SIZE 2\n0 0 0\n1 1 1\n", 1),
    ("LUT_1D_SIZE 2\n" + PLAIN, 1),
    ("LUT_3D_INPUT_RANGE 0 1\n" + PLAIN, 1),
    ("lut_3d_size 2\n" + ZEROS, 1),
    ("LUT_3D_SIZE 2\n" + PLAIN, 1),
    ('TITLE "a"\nTITLE "a"\n' + PLAIN, 1),
    ("DOMAIN_MIN 0 0 0\nDOMAIN_MIN 0 0 0\n" + PLAIN, 1),
    ("DOMAIN_MAX 1 1 1\nDOMAIN_MAX 1 1 1\n" + PLAIN, 1),
    (ZEROS + "LUT_3D_SIZE 2\n", 1),
    (PLAIN + 'TITLE "a"\n', 1),
    ("LUT_3D_SIZE 2\n0 0 0\nDOMAIN_MAX 2 2 2\n" + "0 0 0\n" * 7, 1),
    ("LUT_3D_SIZE 1\n0 0 0\n", 1),
    ("LUT_3D_SIZE 0\n", 1),
    ("LUT_3D_SIZE -2\n" + ZEROS, 1),
    ("LUT_3D_SIZE 257\n" + ZEROS, 1),
    ("LUT_3D_SIZE 2.5\n" + ZEROS, 1),
    ("LUT_3D_SIZE two\n" + ZEROS, 1),
    ("LUT_3D_SIZE\n" + ZEROS, 1),
    ("LUT_3D_SIZE 2 2\n" + ZEROS, 1),
    ("LUT_3D_SIZE 2\n" + "0 0 0\n" * 7, 1),
    ("LUT_3D_SIZE 2\n" + "0 0 0\n" * 9, 1),
    ("LUT_3D_SIZE 3\n" + ZEROS, 1),
    ("LUT_3D_SIZE 2\n" + "0 0 0\n" * 7 + "0 0\n", 1),
    ("LUT_3D_SIZE 2\n0 0 0 0\n" + "0 0 0\n" * 7, 1),
    ("LUT_3D_SIZE 2\n0 0 0 # first\n" + "0 0 0\n" * 7, 1),
    ("LUT_3D_SIZE 2\n" + "0 0 0\n" * 7 + "0 nan 0\n", 1),
    ("LUT_3D_SIZE 2\n" + "0 0 0\n" * 7 + "0 0 inf\n", 1),
    ("LUT_3D_SIZE 2\n-inf 0 0\n" + "0 0 0\n" * 7, 1),
    ("LUT_3D_SIZE 2\n0 0 red\n" + "0 0 0\n" * 7, 1),
    ("LUT_3D_SIZE 2\n0 0 0.5x\n" + "0 0 0\n" * 7, 1),
    ("LUT_3D_SIZE 2\n0,5 0 0\n" + "0 0 0\n" * 7, 1),
    ("LUT_3D_SIZE 2\n- 0 0\n" + "0 0 0\n" * 7, 1),
    ("DOMAIN_MIN 0 1 0\n" + PLAIN, 1),
    ("DOMAIN_MAX 1 1 -1\n" + PLAIN, 1),
    ("DOMAIN_MIN 2 0 0\nDOMAIN_MAX 1 1 1\n" + PLAIN, 1),
    ("DOMAIN_MIN 0 0\n" + PLAIN, 1),
    ("DOMAIN_MAX 1 1 1 1\n" + PLAIN, 1),
    ("DOMAIN_MAX 1 inf 1\n" + PLAIN, 1),
    ("DOMAIN_MIN nan 0 0\n" + PLAIN, 1),
    ("TITLE warm\n" + PLAIN, 1),
    ('TITLE "warm\n' + PLAIN, 1),
    ("TITLE\n" + PLAIN, 1),
]
probe("read-refuses", "Files that are none",
      "1 for every text that the contract refuses, 0 for those that it allows, whatever the ends of their lines.",
      "Which text is it? Its numbers are character codes: 10 ends a line, 13 before it is a part of that end.",
      3, "read_refuses", [codes(t) for t, _ in REFUSALS], [[r] for _, r in REFUSALS], ["refused"], None,
      ["cube-crlf-kept", "cube-short-accepted"], ["read_table"], tier="further")

probe("write-table", "A .cube file, written",
      "Reading it gives the same table to the last bit; keywords that say nothing new are left out.",
      "How many digits does a float need so that reading gives the same float?",
      2, "write_table", [{"kind": k} for k in range(4)],
      [[1, 9, 0, 0, 0], [1, 10, 0, 0, 1], [1, 11, 1, 1, 0], [1, 28, 0, 0, 0]],
      ["read back equal", "lines", "DOMAIN_MIN", "DOMAIN_MAX", "TITLE"], None, ["cube-digits-lost", "cube-blue-first"], tier="further")

# The noise puts every value on a multiple of 1/255, so that rounding or clamping in the function changes nothing.
DITHERED = [((10, 100, 200), 0.4, 0.1), ((0, 128, 253), 0.75, 0.75), ((3, 4, 250), 0.5, 0), ((3, 4, 250), 0.5, 1),
            ((0, 60, 255), 0, 0.5), ((12, 99, 254), 0.9, 0.6), ((1, 50, 254), 0.1, 0.4), ((20, 120, 220), 0.25, 0.25)]


def dithered_row(i):
    return [v + (i["noise"] - 0.5) / 255 for v in i["stored"]]


probe("dithered", "Noise before 8 bits",
      "The value plus noise between minus and plus half a step of 1/255: the more noise, the more.",
      "Let noise run over 0 to 1: between which two numbers must the change lie, so that its mean is 0?",
      2, "dithered",
      [{"stored": [shown((k + part) / 255) for k in whole], "noise": n} for whole, part, n in DITHERED], dithered_row, RGB,
      {"absolute": 2e-5, "reason": "A hundredth of a step and less."},
      ["dither-upwards", "dither-full-255-missing"], tier="further")

# ---- Further: pictures

BLOOM = ["next_target", "bright_part", "luma", "gaussian_weights", "blurred"]

picture("lanterns-bright", "The bright part of the alley",
        "Lamps and what they light strongly, less the threshold; all else is black.",
        "Does the picture begin with a jump at its edges? Which light is left where the luma is just above the threshold?",
        1, "lanterns", ["bright-hard-threshold", "bright-per-component"], BASE + ["bright_part", "luma"],
        {"bloom.strength": 1, "bloom.threshold": 0.5}, "further", output="bright")

picture("lanterns-blur", "The bright part, blurred",
        "Round spots around the lamps, in the middle of each.",
        "Are the spots too bright, too small, or beside their lamps? The weights sum to 1, on both sides together.",
        2, "lanterns", ["blur-not-mirrored", "blur-centre-twice", "blur-diagonal", "weights-variance-for-sigma",
                      "weights-half-sum"],
        BASE + BLOOM, {"bloom.strength": 1, "bloom.sigma": 6}, "further", output="blur")

picture("lanterns-bloom", "Lamps that glow",
        "Light around the lamps, then the filmic curve; 317 x 211 pixels.",
        "Do only a few places glow, or none? After tone mapping, what is still above the threshold?",
        2, "lanterns", ["passes-bloom-after-tone"], BASE + BLOOM + ["tone_mapped", "filmic"],
        {"bloom.strength": 0.5, "tone.curve": "filmic", "tone.exposure": 0.5}, "further", size=[317, 211])

picture("chart-warm", "A warm look",
        "The chart in the colours of the table, trilinearly.",
        "Try table.look = identity: it must change nothing. Which patches does it change?",
        1, "chart", ["table-half-texel", "table-whole-range", "cube-blue-first"],
        BASE + ["read_table", "table_trilinear"], {"table.look": "warm"}, "further")

picture("chart-warm-tetrahedral", "The warm look, tetrahedrally",
        "The same by tetrahedra: nearly the same picture.",
        "Right with table.lookup = trilinear, but not here? Look at the fractions of a single colour, by hand.",
        1, "chart", ["tetrahedral-order-reversed", "cube-blue-first"], BASE + ["read_table", "table_tetrahedral"],
        {"table.look": "warm", "table.lookup": "tetrahedral"}, "further")

picture("chart-turned-night", "Colours turned, then the night",
        "The hue is turned before the table is looked up: the night stays blue.",
        "Is the night blue in --output table? Which pass came before it?",
        1, "chart", ["passes-table-before-adjust"], BASE + ADJUST + ["read_table", "table_trilinear"],
        {"colour.hue": 0.25, "colour.saturation": 1.25, "table.look": "night"}, "further")

picture("ramp-dithered", "Gradients without bands",
        "Noise of half a step up or down before the picture is stored in 8 bits; its mean is as before.",
        "Is the picture brighter than without chain.dither? Or is the noise far more than one step of 8 bits?",
        1, "ramp", ["dither-upwards", "dither-full-255-missing"], ["dithered"],
        {"chain.dither": True, "frame.format": "8"}, "further", delta=0.4, budget=3000,
        reason="Codes are whole numbers, so that any other code counts. Processors differ by a little in the light, "
               "which changes the codes of a few pixels in a hundred; a mean that is too high changes every other one.",
        truth_differs="The truth has neither codes nor noise.")


# ---- Writing

LONG = 118


def one_line(value):
    if isinstance(value, dict):
        return "{" + ", ".join("%s: %s" % (json.dumps(k), one_line(v)) for k, v in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(one_line(v) for v in value) + "]"
    if isinstance(value, float) and value == int(value) and abs(value) < 1e15:
        return str(int(value))
    return json.dumps(value, ensure_ascii=False)


class Raw(str):
    pass


def rows(values, indent):
    return "[\n" + ",\n".join(" " * (indent + 2) + one_line(v) for v in values) + "\n" + " " * indent + "]"


def written(c):
    members = []
    for key, value in c.items():
        if key == "expected":
            value = [[float(x) if isinstance(x, str) else x for x in numbers] for numbers in value]
        line = one_line(value)
        if key in ("inputs", "expected") and len(line) > LONG:
            line = rows(value, 6)
        elif key == "numbers" and len(line) > LONG:
            lines, current = [], ""
            for name in value:
                text = one_line(name)
                if current and len(current) + len(text) + 10 > LONG:
                    lines.append(current)
                    current = ""
                current += (", " if current else "") + text
            line = "[\n        " + ",\n        ".join(lines + [current]) + "\n      ]"
        members.append("      %s: %s" % (json.dumps(key), line))
    return "    {\n" + ",\n".join(members) + "\n    }"


def document():
    return ('{\n  "schema": 1,\n  "step": "08-post-processing",\n  "defaults": {"size": [320, 240]},\n  "cases": [\n' +
            ",\n".join(written(c) for c in CASES) + "\n  ]\n}\n")


if __name__ == "__main__":
    out = sys.argv[1] if len(sys.argv) > 1 else "/work/s08/tests/cases/08-post-processing/cases.json"
    text = document()
    json.loads(text)
    with open(out, "w") as file:
        file.write(text)
