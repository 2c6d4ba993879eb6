"""The known mistakes of step 08: (name, title, sentence, hint, edits). The first edit is the patch, the others are other
spellings of it. An edit changes a copy of the solution (make8.Change)."""
from make8 import CPP, GLSL

MISTAKES = []


def mistake(name, title, sentence, hint, *edits):
    MISTAKES.append((name, title, sentence, hint, edits))


def swap(file, *pairs):
    """Replaces old by new, one pair after another."""
    def edit(c):
        for old, new in pairs:
            c.swap(file, old, new)
    return edit


def body(file, signature, lines):
    return lambda c: c.body(file, signature, lines)


def both(*edits):
    def edit(c):
        for one in edits:
            one(c)
    return edit


# ================================================================ the chain

mistake(
    "target-same", "Reads what it writes",
    "It looks as if a pass wrote the target that it reads: which of its values a pixel gets to see is undefined.",
    "A pass reads target 0. Which of the two is free to be written?",
    swap(CPP, ("return source == 0 ? 1 : 0;", "return source == 1 ? 1 : 0;")),
    body(CPP, "int next_target", """
  return std::max(source, 0);
"""))

mistake(
    "corner-short", "A triangle that is too small",
    "It looks as if the triangle were too small for the picture: its upper right, beyond a diagonal, is not drawn.",
    "On which side of the line from corner 1 to corner 2 is the picture's corner (1, 1)?",
    swap(GLSL, ("corner == 1 ? 3.0 : -1.0, corner == 2 ? 3.0 : -1.0", "corner == 1 ? 1.0 : -1.0, corner == 2 ? 1.0 : -1.0")),
    body(GLSL, "vec2 full_screen_corner", """
  return vec2(2 * (corner & 1) - 1, (corner & 2) - 1);
"""),
    swap(GLSL, ("corner == 1 ? 3.0 : -1.0, corner == 2 ? 3.0 : -1.0", "corner == 1 ? 2.0 : -1.0, corner == 2 ? 2.0 : -1.0")))

# ================================================================ which passes

BLOOM = "  if (look.bloom != 0) passes.push_back(Pass::bloom);\n"
TONE = "  if (look.exposure != 0 || look.curve != 0) passes.push_back(Pass::tone);\n"
ADJUST = ("  if (look.hue != std::floor(look.hue) || look.saturation != 1 || look.brightness != 1) "
          "passes.push_back(Pass::adjust);\n")
TABLE = "  if (look.table) passes.push_back(Pass::table);\n"
OVERLAY = "  if (look.overlay != 0) passes.push_back(Pass::overlay);\n"


def passes(*lines):
    """The solution's conditions in this order."""
    def edit(c):
        for line in (BLOOM, TONE, ADJUST, TABLE, OVERLAY):
            assert line in c.text[CPP], line
        c.swap(CPP, BLOOM + TONE + ADJUST + TABLE + OVERLAY, "".join(lines))
    return edit


def listed(*rows):
    """The same by a list of what each pass needs."""
    need = {"bloom": "look.bloom > 0", "tone": "look.exposure != 0 || look.curve > 0",
            "adjust": "look.hue != std::round(look.hue) || look.saturation != 1 || look.brightness != 1",
            "table": "look.table", "overlay": "look.overlay > 0"}
    text = "  struct Step {\n    bool needed;\n    Pass pass;\n  };\n  const std::array<Step, 5> order{{\n"
    text += "".join(f"      {{{need[row]}, Pass::{row}}},\n" for row in rows)
    text += "  }};\n  std::vector<Pass> passes;\n  for (const Step& step : order)\n"
    text += "    if (step.needed) passes.push_back(step.pass);\n  return passes;\n"
    return body(CPP, "std::vector<Pass> passes_for", text)


mistake(
    "passes-identity-kept", "Passes that change nothing",
    "It looks as if passes ran of which nothing is asked, such as a correction of colours with saturation 1 and brightness 1: each of them reads and writes the whole picture for nothing.",
    "What does a pass do with saturation 1 and brightness 1, with no curve and no exposure, or with an amount of 0?",
    passes("  passes = {Pass::bloom, Pass::tone, Pass::adjust};\n", TABLE, "  passes.push_back(Pass::overlay);\n"),
    body(CPP, "std::vector<Pass> passes_for", """
  std::vector<Pass> passes;
  for (const Pass pass : {Pass::bloom, Pass::tone, Pass::adjust, Pass::table, Pass::overlay})
    if (pass != Pass::table || look.table) passes.push_back(pass);
  return passes;
"""),
    passes(BLOOM, "  passes.push_back(Pass::tone);\n  passes.push_back(Pass::adjust);\n", TABLE, OVERLAY))

mistake(
    "passes-tone-last", "Tone mapping after the colours",
    "It looks as if tone mapping came after the correction of colours: hue, saturation and the table are applied to light that a display cannot show yet.",
    "A lamp has the luma 20. For which range of colours are hue, saturation, brightness and tables made?",
    passes(BLOOM, ADJUST, TABLE, OVERLAY, TONE),
    listed("bloom", "adjust", "table", "overlay", "tone"),
    passes(BLOOM, ADJUST, TABLE, TONE, OVERLAY))

mistake(
    "passes-bloom-after-tone", "Bloom after tone mapping",
    "It looks as if bloom came after tone mapping: what is much brighter than the display has been cut down before its glow is computed.",
    "A lamp is 20 times as bright as white paper. How much brighter is it after tone mapping?",
    passes(TONE, BLOOM, ADJUST, TABLE, OVERLAY),
    listed("tone", "bloom", "adjust", "table", "overlay"))

mistake(
    "passes-table-before-adjust", "The table first",
    "It looks as if the table came before hue, saturation and brightness: they change what the table has made.",
    "A table that makes all colours blue is used, and the hue is turned. Which of the two has the last word?",
    passes(BLOOM, TONE, TABLE, ADJUST, OVERLAY),
    listed("bloom", "tone", "table", "adjust", "overlay"))

mistake(
    "passes-whole-turn-kept", "A whole turn counts as a change",
    "It looks as if every hue but 0 needed a pass: a pass runs for one or two whole turns, which change no colour.",
    "Where on the circle of hues do you arrive after exactly one turn, and after two turns back?",
    swap(CPP, ("look.hue != std::floor(look.hue)", "look.hue != 0")),
    body(CPP, "std::vector<Pass> passes_for", """
  std::vector<Pass> passes;
  const bool same_colours = std::abs(look.hue) + std::abs(look.saturation - 1) + std::abs(look.brightness - 1) == 0;
  const bool same_light = look.exposure == 0 && look.curve == 0;
  if (look.bloom > 0) passes.emplace_back(Pass::bloom);
  if (!same_light) passes.emplace_back(Pass::tone);
  if (!same_colours) passes.emplace_back(Pass::adjust);
  if (look.table) passes.emplace_back(Pass::table);
  if (look.overlay > 0) passes.emplace_back(Pass::overlay);
  return passes;
"""))

# ================================================================ hue, chroma, luma

mistake(
    "luma-601", "The weights of Rec. 601",
    "It looks as if the weights were 0.299, 0.587 and 0.114: those of Rec. 601, which belong to other primaries and to encoded values.",
    "The colours are linear light with the primaries of Rec. 709. Which weights have these?",
    swap(GLSL, ("vec3(0.2126, 0.7152, 0.0722)", "vec3(0.299, 0.587, 0.114)")),
    body(GLSL, "float luma", """
  return 0.299 * colour.r + 0.587 * colour.g + 0.114 * colour.b;
"""))

mistake(
    "luma-mean", "The mean of the components",
    "It looks as if luma were the mean of the components: blue counts as much as green, although it looks far darker.",
    "Pure green and pure blue have the same mean. Do they look equally bright?",
    swap(GLSL, ("dot(colour, vec3(0.2126, 0.7152, 0.0722))", "(colour.r + colour.g + colour.b) / 3.0")),
    body(GLSL, "float luma", """
  return dot(colour, vec3(1.0 / 3.0));
"""))

HUE_KEPT = ("vec3(fract(sixths / 6.0), chroma, luma(colour))", "vec3(sixths / 6.0, chroma, luma(colour))")
TURN_KEPT = ("float sixths = 6.0 * (hue - floor(hue));", "float sixths = 6.0 * hue;")

mistake(
    "hue-unwrapped", "Hues beyond a turn",
    "It looks as if a hue were not brought into 0 to 1 everywhere: reds towards magenta get a hue below 0, or a hue beyond the circle gives red.",
    "Which hue lies 0.1 turns before red, and which 0.1 turns after 0.95?",
    swap(GLSL, HUE_KEPT, TURN_KEPT),
    both(body(GLSL, "vec3 hue_chroma_luma", """
  float r = colour.r, g = colour.g, b = colour.b;
  float most = max(max(r, g), b), chroma = most - min(min(r, g), b), hue = 0.0;
  if (chroma == 0.0) return vec3(0.0, 0.0, luma(colour));
  if (most == r) hue = (g - b) / (6.0 * chroma);
  else if (most == g) hue = 1.0 / 3.0 + (b - r) / (6.0 * chroma);
  else hue = 2.0 / 3.0 + (r - g) / (6.0 * chroma);
  return vec3(hue, chroma, luma(colour));
"""),
         body(GLSL, "vec3 colour_of", """
  float s = 6.0 * hue, y = luma_wanted;
  vec3 pure = clamp(vec3(s < 3.0 ? 2.0 - s : s - 4.0, s < 2.0 ? s : 4.0 - s, s < 4.0 ? s - 2.0 : 6.0 - s), 0.0, 1.0);
  float peak = luma(pure);
  float room = min(y / peak, max(1.0 - y, 0.0) / (1.0 - peak));
  return max(y + min(max(chroma, 0.0), room) * (pure - peak), 0.0);
""")),
    swap(GLSL, HUE_KEPT),
    swap(GLSL, TURN_KEPT))

mistake(
    "hue-sectors-exchanged", "Green and blue exchanged",
    "It looks as if the hues around green and those around blue were exchanged; only those around red are right.",
    "Which hue has pure green, and which pure blue? Which number must be added where green is the largest component?",
    swap(GLSL, ("sixths = 2.0 + (colour.b - colour.r) / chroma;", "sixths = 4.0 + (colour.b - colour.r) / chroma;"),
         ("    else\n      sixths = 4.0 + (colour.r - colour.g) / chroma;", "    else\n      sixths = 2.0 + (colour.r - colour.g) / chroma;")),
    body(GLSL, "vec3 hue_chroma_luma", """
  float most = max(max(colour.r, colour.g), colour.b), chroma = most - min(min(colour.r, colour.g), colour.b);
  if (chroma <= 0.0) return vec3(0.0, 0.0, luma(colour));
  vec3 turned = vec3(0.0, 4.0, 2.0) + (colour.gbr - colour.brg) / chroma;
  float sixths = most <= colour.r ? turned.r : most <= colour.g ? turned.g : turned.b;
  return vec3(sixths < 0.0 ? sixths / 6.0 + 1.0 : sixths / 6.0, chroma, luma(colour));
"""))

mistake(
    "chroma-from-luma", "Chroma measured from the luma",
    "It looks as if chroma were the distance of the largest component from the luma instead of the smallest component: yellow has hardly any, blue nearly all.",
    "No colour is more colourful than (1, 1, 0). What is its chroma?",
    swap(GLSL, ("vec3(fract(sixths / 6.0), chroma, luma(colour))", "vec3(fract(sixths / 6.0), most - luma(colour), luma(colour))")),
    body(GLSL, "vec3 hue_chroma_luma", """
  float y = luma(colour);
  vec3 above = colour - y;
  float range = max(max(colour.r, colour.g), colour.b) - min(min(colour.r, colour.g), colour.b);
  if (range <= 0.0) return vec3(0.0, 0.0, y);
  float turns = 0.0;
  if (colour.r >= colour.g && colour.r >= colour.b) turns = (colour.g - colour.b) / range / 6.0;
  else if (colour.g >= colour.b) turns = (2.0 + (colour.b - colour.r) / range) / 6.0;
  else turns = (4.0 + (colour.r - colour.g) / range) / 6.0;
  return vec3(turns < 0.0 ? turns + 1.0 : turns, max(above.r, max(above.g, above.b)), y);
"""))

LOOP = """  float fits = max(chroma, 0.0);
  for (int i = 0; i < 3; ++i) {
    if (way[i] < 0.0) fits = min(fits, luma_wanted / -way[i]);
    if (way[i] > 0.0) fits = min(fits, max(1.0 - luma_wanted, 0.0) / way[i]);
  }
  return max(luma_wanted + fits * way, 0.0);
"""

# The colour with chroma 1 and this hue, in the other spellings.
PURE = """  float s = 6.0 * fract(hue);
  vec3 pure = clamp(vec3(abs(s - 3.0) - 1.0, 2.0 - abs(s - 2.0), 2.0 - abs(s - 4.0)), 0.0, 1.0);
"""

mistake(
    "gamut-ignored", "As much chroma as asked",
    "It looks as if the chroma were not limited: components fall below 0 or exceed 1.",
    "Pure blue has the luma 0.07. Turn it into a yellow of the same luma with chroma 1: what would its blue component be?",
    swap(GLSL, (LOOP, "  return luma_wanted + chroma * way;\n")),
    body(GLSL, "vec3 colour_of", PURE + """
  float least = luma_wanted - chroma * luma(pure);
  return vec3(least) + chroma * pure;
"""))

mistake(
    "gamut-clamped", "Components cut off",
    "It looks as if each component were cut off at 0 and 1, instead of reducing the chroma: luma and hue are not those that were asked for.",
    "Compute the luma of (1.2, 0.3, -0.1) before and after cutting its components off. Is it the same?",
    swap(GLSL, (LOOP, "  return clamp(luma_wanted + chroma * way, 0.0, 1.0);\n")),
    body(GLSL, "vec3 colour_of", PURE + """
  vec3 colour = vec3(luma_wanted - chroma * luma(pure)) + chroma * pure;
  for (int i = 0; i < 3; ++i) {
    if (colour[i] < 0.0) colour[i] = 0.0;
    if (colour[i] > 1.0) colour[i] = 1.0;
  }
  return colour;
"""))

mistake(
    "gamut-upper-only", "Only the upper limit",
    "It looks as if the chroma were reduced only until no component is above 1: in dark colours a component still falls below 0.",
    "Luma 0.05, the hue of yellow, chroma 0.5: which component leaves 0 to 1, and at which end?",
    swap(GLSL, ("    if (way[i] < 0.0) fits = min(fits, luma_wanted / -way[i]);\n", ""),
         ("return max(luma_wanted + fits * way, 0.0);", "return luma_wanted + fits * way;")),
    body(GLSL, "vec3 colour_of", PURE + """
  float peak = luma(pure);
  if (luma_wanted >= 1.0) return vec3(luma_wanted);
  float least = luma_wanted - peak * clamp(chroma, 0.0, (1.0 - luma_wanted) / (1.0 - peak));
  return least + pure * clamp(chroma, 0.0, (1.0 - luma_wanted) / (1.0 - peak));
"""))

mistake(
    "colour-value-for-luma", "The value of HSV instead of the luma",
    "It looks as if the luma that is asked for were the largest component, the value of HSV: colours come out too dark, blues most of all.",
    "(0, 0, 0.3) and (0.3, 0.3, 0) have the same largest component. Which of them is brighter?",
    swap(GLSL, (LOOP, """  float fits = clamp(chroma, 0.0, luma_wanted);
  return luma_wanted - fits * (1.0 - pure);
"""), ("  vec3 way = pure - luma(pure);\n", "")),
    body(GLSL, "vec3 colour_of", """
  vec3 ramps = abs(6.0 * fract(vec3(hue) + vec3(0.0, 2.0 / 3.0, 1.0 / 3.0)) - 3.0) - 1.0;
  float saturation = luma_wanted > 0.0 ? clamp(chroma / luma_wanted, 0.0, 1.0) : 0.0;
  return luma_wanted * mix(vec3(1.0), clamp(ramps, 0.0, 1.0), saturation);
"""))

mistake(
    "adjust-luma-added", "Brightness is added",
    "It looks as if brightness - 1 were added to the luma instead of multiplying the luma by brightness: black does not stay black.",
    "Which luma has black with brightness 2? By what does the luma of a bright and of a dark colour change?",
    swap(GLSL, ("parts.z * brightness)", "max(parts.z + brightness - 1.0, 0.0))")),
    body(GLSL, "vec3 adjusted", """
  vec3 hcl = hue_chroma_luma(colour) + vec3(turns, 0.0, brightness);
  float y = hcl.z - 1.0;
  return colour_of(hcl.x, saturation * hcl.y, y < 0.0 ? 0.0 : y);
"""))

mistake(
    "saturation-on-components", "Saturation as a factor of all components",
    "It looks as if all components were multiplied by the saturation: colours become brighter instead of more colourful, and saturation 0 gives black instead of greys.",
    "What should a photograph look like with saturation 0? Which of hue, chroma and luma is 0 then?",
    swap(GLSL, ("hue_chroma_luma(colour);\n  return colour_of(parts.x + turns, parts.y * saturation, parts.z * brightness)",
                "hue_chroma_luma(colour * saturation);\n  return colour_of(parts.x + turns, parts.y, parts.z * brightness)")),
    body(GLSL, "vec3 adjusted", """
  vec3 hcl = hue_chroma_luma(colour);
  hcl.yz *= saturation;
  hcl.z *= brightness;
  return colour_of(turns + hcl.x, hcl.y, hcl.z);
"""))

# ================================================================ tone mapping

mistake(
    "reinhard-per-component", "Reinhard's curve on each component",
    "It looks as if the curve were applied to each component by itself: bright colours fade to white, and their hue shifts.",
    "A lamp has (8, 2, 0). Which ratio do red and green have after the curve, if all components are scaled by the same factor?",
    swap(GLSL, ("return colour * ((1.0 + y / (white * white)) / (1.0 + y));",
                "return colour * (1.0 + colour / (white * white)) / (1.0 + colour);"),
         ("  // >>> student: one factor for all components\n  float y = luma(colour);\n",
          "  // >>> student: one factor for all components\n")),
    body(GLSL, "vec3 reinhard", """
  vec3 curved;
  for (int i = 0; i < 3; ++i) {
    float x = colour[i];
    curved[i] = (x + x * x / (white * white)) / (x + 1.0);
  }
  return curved;
"""))

mistake(
    "reinhard-white-not-squared", "white is not squared",
    "It looks as if the luma were divided by white instead of by its square: a luma of white does not become 1.",
    "Insert Y = white into your formula. What is left?",
    swap(GLSL, ("y / (white * white)", "y / white")),
    body(GLSL, "vec3 reinhard", """
  float y = dot(colour, vec3(0.2126, 0.7152, 0.0722));
  float factor = (white + y) / (white + white * y);
  return factor * colour;
"""))

mistake(
    "filmic-not-normalised", "Not divided by h(11.2)",
    "It looks as if the curve were not divided by its value at 11.2: nothing in the picture reaches white.",
    "What should the brightest light become, and what is h(11.2)?",
    swap(GLSL, ("return h.rgb / h.a;", "return h.rgb;")),
    body(GLSL, "vec3 filmic", """
  vec3 x = colour + colour;
  return x * (0.042 * x + 0.005) / (0.3 * (x * (0.15 * x + 0.5) + 0.06));
"""))

mistake(
    "filmic-exposed-twice", "The factor 2 twice",
    "It looks as if the colour were multiplied by 2 twice before the filmic curve: everything is too bright, most of all what is dark.",
    "Insert 5.6 into your curve. The result should be exactly 1.",
    swap(GLSL, ("vec4(2.0 * colour, 11.2)", "vec4(2.0 * (2.0 * colour), 11.2)")),
    body(GLSL, "vec3 filmic", """
  vec3 once = 2.0 * colour, x = once + once;
  vec3 h = x * (0.042 * x + 0.005) / (0.3 * (x * (0.15 * x + 0.5) + 0.06));
  float white = 11.2 * (0.042 * 11.2 + 0.005) / (0.3 * (11.2 * (0.15 * 11.2 + 0.5) + 0.06));
  return h / white;
"""),
    swap(GLSL, ("filmic(exposed)", "filmic(2.0 * exposed)")))

mistake(
    "exposure-linear", "Stops as a linear factor",
    "It looks as if the light were multiplied by 1 + stops instead of by a power of 2: right for 0 and 1 stop only.",
    "Each stop doubles the light. What is left of it at -1 stop and at -2 stops?",
    swap(GLSL, ("colour * exp2(stops)", "colour * max(1.0 + stops, 0.0)")),
    body(GLSL, "vec3 tone_mapped", """
  colour += colour * max(stops, -1.0);
  if (curve == 1) return reinhard(colour, white);
  if (curve == 2) return filmic(colour);
  return colour;
"""))

mistake(
    "exposure-after-curve", "Exposure after the curve",
    "It looks as if the exposure were applied after the curve: a higher one makes bright places exceed 1 again, and a lower one greys what is burnt out.",
    "Exposure says how much light falls on the film. Does it come before or after what the film makes of it?",
    swap(GLSL, ("""  vec3 exposed = colour * exp2(stops);
  return curve == 1 ? reinhard(exposed, white) : curve == 2 ? filmic(exposed) : exposed;
""", """  vec3 curved = curve == 1 ? reinhard(colour, white) : curve == 2 ? filmic(colour) : colour;
  return curved * exp2(stops);
""")),
    body(GLSL, "vec3 tone_mapped", """
  float factor = pow(2.0, stops);
  if (curve == 2) return factor * filmic(colour);
  if (curve == 1) return factor * reinhard(colour, white);
  return factor * colour;
"""))

# ================================================================ a picture over the picture

mistake(
    "overlay-premultiplied", "Not multiplied by the opacity",
    "It looks as if the overlay's colour were already multiplied by its opacity: where it is half transparent the sum is too bright.",
    "White over white, seen by half: what is the sum of the two shares of the colour?",
    body(GLSL, "vec4 overlaid", """
  return vec4(above.rgb * amount + below.rgb * (1.0 - above.a * amount), below.a);
"""),
    body(GLSL, "vec4 overlaid", """
  below.rgb += amount * (above.rgb - above.a * below.rgb);
  return below;
"""))

mistake(
    "overlay-inverted", "The shares exchanged",
    "It looks as if the two shares were exchanged: the overlay is seen where it is transparent, and the picture where it is opaque.",
    "above.a is the opacity of the overlay. Which picture should be seen where it is 0?",
    body(GLSL, "vec4 overlaid", """
  return vec4(mix(above.rgb, below.rgb, above.a * amount), below.a);
"""),
    body(GLSL, "vec4 overlaid", """
  float share = amount * above.a;
  return vec4(share * below.rgb + (1.0 - share) * above.rgb, below.a);
"""))

mistake(
    "overlay-amount-ignored", "amount does not count",
    "It looks as if `amount` did not count: the overlay is always seen as much as its opacity says.",
    "What should be seen of an opaque overlay when `amount` is 1/2, and when it is 0?",
    body(GLSL, "vec4 overlaid", """
  return vec4(mix(below.rgb, above.rgb, above.a), below.a);
"""),
    body(GLSL, "vec4 overlaid", """
  return vec4(above.a * above.rgb + (1.0 - above.a) * below.rgb, below.a);
"""))

# ================================================================ bloom

mistake(
    "bright-hard-threshold", "All of the light instead of what exceeds the threshold",
    "It looks as if a colour bloomed with all of its light as soon as it exceeds the threshold: glow appears suddenly, with hard edges.",
    "How much light blooms where the luma is just above the threshold?",
    swap(GLSL, ("colour * ((y - threshold) / y)", "colour")),
    body(GLSL, "vec3 bright_part", """
  if (luma(colour) <= threshold) return vec3(0.0);
  return colour;
"""))

mistake(
    "bright-per-component", "The threshold on each component",
    "It looks as if the threshold were subtracted from each component: the glow has another hue than the light, and another luma.",
    "(3, 1, 0) exceeds a threshold. Which hue should its glow have?",
    body(GLSL, "vec3 bright_part", """
  return max(colour - threshold, 0.0);
"""),
    body(GLSL, "vec3 bright_part", """
  vec3 part = vec3(0.0);
  for (int i = 0; i < 3; ++i)
    if (colour[i] > threshold) part[i] = colour[i] - threshold;
  return part;
"""))

BLUR_SUM = """    sum += u_weights[k] *
           (texture(picture, texcoord + float(k) * pixel).rgb + texture(picture, texcoord - float(k) * pixel).rgb);
"""

mistake(
    "blur-not-mirrored", "One side only",
    "It looks as if the filter had only one side: what is blurred shifts to one side, and becomes darker unless this side counts twice.",
    "u_weights is half of the filter. Which pixels have the weight u_weights[2]?",
    swap(GLSL, (BLUR_SUM, "    sum += u_weights[k] * texture(picture, texcoord + float(k) * pixel).rgb;\n")),
    body(GLSL, "vec3 blurred", """
  vec3 sum = vec3(0.0);
  vec2 place = texcoord;
  for (int k = 0; k <= LAST_WEIGHT; ++k, place += pixel) sum += texture(picture, place).rgb * u_weights[k];
  return sum;
"""),
    swap(GLSL, (BLUR_SUM, "    sum += u_weights[k] * texture(picture, texcoord - float(k) * pixel).rgb;\n")),
    swap(GLSL, (BLUR_SUM, "    sum += 2.0 * u_weights[k] * texture(picture, texcoord + float(k) * pixel).rgb;\n")))

mistake(
    "blur-centre-twice", "The centre counts twice",
    "It looks as if the pixel itself were added twice: the blurred picture is too bright, and still sharp within the blur.",
    "How many pixels have the distance 0, and how many the distance 1?",
    swap(GLSL, ("vec3 sum = u_weights[0] * texture(picture, texcoord).rgb;", "vec3 sum = vec3(0.0);"),
         ("for (int k = 1; k <= LAST_WEIGHT; ++k)", "for (int k = 0; k <= LAST_WEIGHT; ++k)")),
    body(GLSL, "vec3 blurred", """
  vec3 sum = u_weights[0] * texture(picture, texcoord).rgb;
  for (int k = -LAST_WEIGHT; k <= LAST_WEIGHT; ++k)
    sum += texture(picture, texcoord + pixel * float(k)).rgb * u_weights[abs(k)];
  return sum;
"""))

mistake(
    "blur-diagonal", "Along the diagonal",
    "It looks as if each step went in both directions at once: lights are blurred along a diagonal instead of all around.",
    "`pixel` has one component that is 0. What must become of the other coordinate of texcoord?",
    swap(GLSL, ("  vec3 sum = u_weights[0] * texture(picture, texcoord).rgb;\n",
                "  pixel = 1.0 / vec2(textureSize(picture, 0));\n  vec3 sum = u_weights[0] * texture(picture, texcoord).rgb;\n")),
    body(GLSL, "vec3 blurred", """
  ivec2 size = textureSize(picture, 0);
  vec3 sum = vec3(0.0);
  for (int k = -LAST_WEIGHT; k <= LAST_WEIGHT; ++k) {
    vec2 place = texcoord + vec2(float(k) / float(size.x), float(k) / float(size.y));
    sum += u_weights[abs(k)] * texture(picture, place).rgb;
  }
  return sum;
"""))

mistake(
    "weights-variance-for-sigma", "sigma as the variance",
    "It looks as if sigma were the variance, its own square: wide blurs are much too narrow.",
    "How large is the weight at a distance of sigma, compared with the one at 0? It should be exp(-1/2).",
    swap(CPP, ("(double(sigma) * double(sigma))", "double(sigma)")),
    body(CPP, "std::vector<float> gaussian_weights", """
  if (!(sigma > 0) || sigma > 20) throw std::invalid_argument("sigma is out of range");
  const int last = int(std::ceil(3.0 * sigma));
  const auto bell = [&](int k) { return std::exp(-(k * k) / (2.0 * sigma)); };
  double sum = bell(0);
  for (int k = 1; k <= last; ++k) sum += 2 * bell(k);
  std::vector<float> weights;
  for (int k = 0; k <= last; ++k) weights.push_back(float(bell(k) / sum));
  return weights;
"""))

mistake(
    "weights-half-sum", "Only half of the filter sums to 1",
    "It looks as if only the weights of one half summed to 1: each direction of the blur makes the picture nearly twice as bright.",
    "A white picture is blurred. How often is each of your weights used, and what is the sum?",
    swap(CPP, ("sum += k == 0 ? bell[k] : 2 * bell[k];", "sum += bell[k];")),
    body(CPP, "std::vector<float> gaussian_weights", """
  if (!(sigma > 0) || sigma > 20) throw std::invalid_argument("sigma is out of range");
  std::vector<double> bell;
  for (double k = 0; k <= std::ceil(3.0 * sigma); ++k) bell.push_back(std::exp(-0.5 * (k / sigma) * (k / sigma)));
  double sum = 0;
  for (const double value : bell) sum += value;
  std::vector<float> weights(bell.size());
  std::transform(bell.begin(), bell.end(), weights.begin(), [&](double value) { return float(value / sum); });
  return weights;
"""))

# ================================================================ tables

PLACE = "texture(table, (colour * (u_table_size - 1.0) + 0.5) / u_table_size).rgb"

# Eight texels around `place`, which is in texels.
EIGHT = """  vec3 low = clamp(floor(place), vec3(0.0), vec3(u_table_size - 1.0)), part = clamp(place - low, 0.0, 1.0);
  ivec3 a = ivec3(low), b = min(a + 1, ivec3(u_table_size) - 1);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 8; ++i) {
    ivec3 far = ivec3(i & 1, (i >> 1) & 1, i >> 2);
    vec3 share = mix(1.0 - part, part, vec3(far));
    sum += share.x * share.y * share.z * texelFetch(table, a + far * (b - a), 0).rgb;
  }
  return sum;
"""

mistake(
    "table-half-texel", "Half a texel off",
    "It looks as if half a texel were missing: every colour is looked up half a grid step too low.",
    "The colour 0 is at the centre of the first texel. Which texture coordinate has that centre in a table of 4?",
    swap(GLSL, (PLACE, "texture(table, colour * (u_table_size - 1.0) / u_table_size).rgb")),
    body(GLSL, "vec3 table_trilinear", "  vec3 place = clamp(colour, 0.0, 1.0) * (u_table_size - 1.0) - 0.5;\n" + EIGHT))

mistake(
    "table-whole-range", "The whole texture for 0 to 1",
    "It looks as if the colour were used as the texture coordinate: 0 and 1 are at the edges of the texture instead of the centres of its first and last texels, so contrast grows.",
    "Texture coordinates 0 and 1 are the edges of the first and the last texel. Where are their centres?",
    swap(GLSL, (PLACE, "texture(table, colour).rgb")),
    body(GLSL, "vec3 table_trilinear", "  vec3 place = clamp(colour, 0.0, 1.0) * u_table_size - 0.5;\n" + EIGHT))

mistake(
    "tetrahedral-order-reversed", "The smallest fraction first",
    "It looks as if the edges were gone in the opposite order, the smallest fraction first: the interpolation is in the wrong tetrahedron.",
    "The colour is near the red edge of its cell: red has the largest fraction. Which edge should be the first?",
    swap(GLSL, ("""  ivec3 first = part.r == most ? ivec3(1, 0, 0) : part.g == most ? ivec3(0, 1, 0) : ivec3(0, 0, 1);
  ivec3 last = part.b == least ? ivec3(0, 0, 1) : part.g == least ? ivec3(0, 1, 0) : ivec3(1, 0, 0);
""", """  ivec3 last = part.r == most ? ivec3(1, 0, 0) : part.g == most ? ivec3(0, 1, 0) : ivec3(0, 0, 1);
  ivec3 first = part.b == least ? ivec3(0, 0, 1) : part.g == least ? ivec3(0, 1, 0) : ivec3(1, 0, 0);
""")),
    body(GLSL, "vec3 table_tetrahedral", """
  vec3 place = clamp(colour, 0.0, 1.0) * (u_table_size - 1.0);
  ivec3 c = min(ivec3(place), ivec3(u_table_size) - 2), axes = ivec3(2, 1, 0);
  vec3 f = (place - vec3(c)).zyx;
  // Sorts the three fractions.
  if (f.x > f.y) { f.xy = f.yx; axes.xy = axes.yx; }
  if (f.y > f.z) { f.yz = f.zy; axes.yz = axes.zy; }
  if (f.x > f.y) { f.xy = f.yx; axes.xy = axes.yx; }
  ivec3 one = c, two;
  one[axes.x] += 1;
  two = one;
  two[axes.y] += 1;
  vec3 sum = (1.0 - f.z) * texelFetch(table, c, 0).rgb + (f.z - f.y) * texelFetch(table, one, 0).rgb;
  return sum + (f.y - f.x) * texelFetch(table, two, 0).rgb + f.x * texelFetch(table, c + 1, 0).rgb;
"""),
    body(GLSL, "vec3 table_tetrahedral", """
  vec3 place = clamp(colour, 0.0, 1.0) * (u_table_size - 1.0);
  ivec3 corner = min(ivec3(place), ivec3(u_table_size) - 2);
  vec3 part = place - vec3(corner), found = texelFetch(table, corner, 0).rgb, before = found, left = part;
  for (int i = 0; i < 3; ++i) {
    int axis = left.x <= left.y && left.x <= left.z ? 0 : left.y <= left.z ? 1 : 2;
    corner[axis] += 1;
    vec3 next = texelFetch(table, corner, 0).rgb;
    found += part[axis] * (next - before);
    before = next;
    left[axis] = 2.0;
  }
  return found;
"""))

# ================================================================ .cube files

COLOURS_WRITTEN = "  for (const glm::vec3& colour : table.colours) text += text_of(colour) + \"\\n\";\n"
TABLE_READ = """    if (!(table.low[i] < table.high[i])) throw std::invalid_argument("DOMAIN_MAX must be above DOMAIN_MIN");
  return table;
"""
BLUE_READ = TABLE_READ.replace("  return table;\n", """  const std::vector<glm::vec3> lines = table.colours;
  for (std::size_t i = 0; i < lines.size(); ++i)
    table.colours[i / (size * size) + size * (i / size % size + size * (i % size))] = lines[i];
  return table;
""")
BLUE_WRITTEN = """  const auto n = std::size_t(table.size);
  for (std::size_t r = 0; r < n; ++r)
    for (std::size_t g = 0; g < n; ++g)
      for (std::size_t b = 0; b < n; ++b) text += text_of(table.colours[r + n * (g + n * b)]) + "\\n";
"""


def blue_by_exchange(c):
    c.add_shared("""
/// The colours of a table with red and blue exchanged.
std::vector<glm::vec3> other_way(std::vector<glm::vec3> colours, int size) {
  const auto at = [&](int x, int y, int z) -> glm::vec3& { return colours[std::size_t(x + size * (y + size * z))]; };
  for (int y = 0; y < size; ++y)
    for (int z = 0; z < size; ++z)
      for (int x = 0; x < z; ++x) std::swap(at(x, y, z), at(z, y, x));
  return colours;
}
""")
    c.swap(CPP, TABLE_READ, TABLE_READ.replace("  return table;\n", "  table.colours = other_way(table.colours, table.size);\n  return table;\n"))
    c.swap(CPP, COLOURS_WRITTEN, COLOURS_WRITTEN.replace("table.colours", "other_way(table.colours, table.size)"))


mistake(
    "cube-blue-first", "Blue runs fastest",
    "It looks as if blue ran fastest in the list of colours, and red slowest: the table has red and blue exchanged.",
    "In a file of size 2, which grid point belongs to the second line of colours: the one for red or the one for blue?",
    both(swap(CPP, (TABLE_READ, BLUE_READ)), swap(CPP, (COLOURS_WRITTEN, BLUE_WRITTEN))),
    blue_by_exchange,
    swap(CPP, (TABLE_READ, BLUE_READ)))

LINES = """  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.ends_with('\\r')) line.remove_suffix(1);
"""
SPLIT = """  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = begin;
    while (end < text.size() && text[end] != '\\n') ++end;
    const std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
"""

mistake(
    "cube-crlf-kept", "The CR of CR LF is kept",
    "It looks as if only LF ended a line: in files from Windows a CR is left at the end of every line, so that the last word is no number, and empty lines are not empty.",
    "Print the last character of each line of such a file as a number. What is 13?",
    swap(CPP, ("    if (line.ends_with('\\r')) line.remove_suffix(1);\n", "")),
    swap(CPP, (LINES, SPLIT)))

COUNT = """  if (size == 0 || table.colours.size() != size * size * size)
    throw std::invalid_argument("a table of size n has n^3 colours");
"""

mistake(
    "cube-short-accepted", "Too few lines are accepted",
    "It looks as if a file with too few lines of colours were accepted: the rest of the table is missing or made up.",
    "A download stopped half-way. How do you notice it?",
    swap(CPP, (COUNT, COUNT.replace("!= size", "> size"))),
    swap(CPP, (COUNT, """  if (size == 0) throw std::invalid_argument("no LUT_3D_SIZE");
  if (size * size * size < table.colours.size()) throw std::invalid_argument("too many colours");
  table.colours.resize(size * size * size);
""")))


def printed(c):
    c.swap(CPP, """    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), colour[i]).ptr;
    text.append(i == 0 ? "" : " ").append(digits.data(), end);
""", """    std::array<char, 64> digits{};
    std::snprintf(digits.data(), digits.size(), "%s%.6g", i == 0 ? "" : " ", double(colour[i]));
    text += digits.data();
""")
    c.swap(CPP, "#include <cmath>\n", "#include <cmath>\n#include <cstdio>\n")


mistake(
    "cube-digits-lost", "Too few digits",
    "It looks as if numbers were written with six decimals, or with six significant digits: read again, floats differ in their last bits, and small ones may differ in all.",
    "How many significant digits are needed so that no two floats look alike? Six are not enough.",
    swap(CPP, ("""    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), colour[i]).ptr;
    text.append(i == 0 ? "" : " ").append(digits.data(), end);
""", """    text += i == 0 ? "" : " ";
    text += std::to_string(colour[i]);
""")),
    printed)

# ================================================================ dithering

mistake(
    "dither-upwards", "Noise that only adds",
    "It looks as if the noise were added without its mean being subtracted: the picture becomes brighter by half a step of 1/255.",
    "What is the mean of numbers that are even over 0 to 1, and what should the mean of the added noise be?",
    swap(GLSL, ("stored + (noise - 0.5) / 255.0", "stored + noise / 255.0")),
    body(GLSL, "vec3 dithered", """
  vec3 steps = 255.0 * stored + vec3(noise);
  return steps / 255.0;
"""))

mistake(
    "dither-full-255-missing", "Noise over the whole range",
    "It looks as if the noise were not scaled to one step of 1/255: it covers the whole range, and the picture vanishes in it.",
    "How far apart are two neighbouring values of 8 bits, if 1 is the largest of them?",
    swap(GLSL, ("stored + (noise - 0.5) / 255.0", "stored + (noise - 0.5)")),
    body(GLSL, "vec3 dithered", """
  return mix(stored - 0.5, stored + 0.5, noise);
"""))
