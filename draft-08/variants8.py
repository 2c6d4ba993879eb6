"""Other right solutions of step 08: (name, title, edit)."""
from make8 import CPP, GLSL

VARIANTS = []


def variant(name, title, includes, shared, cpp, helpers, glsl):
    """includes: more headers of the .cpp. shared: its block of helpers. cpp, glsl: bodies by the begin of a signature.
    helpers: GLSL functions before others, by the line before which they stand."""
    def edit(c):
        old = "#include <algorithm>\n#include <charconv>\n#include <cmath>\n#include <stdexcept>\n"
        new = "".join(f"#include <{i}>\n" for i in sorted({"stdexcept", "cmath", *includes}))
        c.swap(CPP, old, new)
        c.shared("namespace {\n\n" + shared.strip("\n") + "\n\n}  // namespace")
        for signature, lines in cpp.items():
            c.body(CPP, signature, lines)
        for signature, lines in glsl.items():
            c.body(GLSL, signature, lines)
        for anchor, lines in helpers.items():
            c.before(GLSL, anchor, lines)
    VARIANTS.append((name, title, edit))


# Whether every triangle that covers the picture is right, as the contract says. Set it to False if the contract names
# the corners.
ANY_TRIANGLE = True
OTHER_TRIANGLE = """
  // With the right angle at the upper right.
  vec2 corners[3] = vec2[3](vec2(1.0, 1.0), vec2(-3.0, 1.0), vec2(1.0, -3.0));
  return corners[corner];
"""
SAME_TRIANGLE = """
  vec2 corners[3] = vec2[3](vec2(-1.0, -1.0), vec2(3.0, -1.0), vec2(-1.0, 3.0));
  return corners[corner];
"""

NEXT, DRAW, PASSES = "int next_target", "void draw_full_screen", "std::vector<Pass> passes_for"
WEIGHTS, READ, WRITE = "std::vector<float> gaussian_weights", "ColourTable read_table", "std::string write_table"
CORNER, LUMA, HUE, COLOUR, ADJUSTED = ("vec2 full_screen_corner", "float luma", "vec3 hue_chroma_luma", "vec3 colour_of",
                                       "vec3 adjusted")
REINHARD, FILMIC, TONE, OVERLAID = "vec3 reinhard", "vec3 filmic", "vec3 tone_mapped", "vec4 overlaid"
BRIGHT, BLURRED, TRILINEAR, TETRAHEDRAL, DITHERED = ("vec3 bright_part", "vec3 blurred", "vec3 table_trilinear",
                                                     "vec3 table_tetrahedral", "vec3 dithered")

# ================================================================ scanner
variant(
    "scanner", "Tables by a hand-written scanner, weights by recurrence, six tetrahedra, hues by the order of components",
    ["cstdio", "cstdlib"],
    r"""
/// Deletes its vertex array at the end of its life.
struct Nothing {
  explicit Nothing(Gl& used) : gl(used) {
    gl.GenVertexArrays(1, &id);
    gl.BindVertexArray(id);
  }
  ~Nothing() {
    gl.BindVertexArray(0);
    gl.DeleteVertexArrays(1, &id);
  }
  Gl& gl;
  GLuint id = 0;
};

[[noreturn]] void refuse(const char* why) {
  throw std::invalid_argument(why);
}

/// A place in a text.
struct Cursor {
  std::string_view text;
  std::size_t at = 0;

  bool done() const { return at >= text.size(); }
  char here() const { return done() ? '\n' : text[at]; }
  bool ends_line() const {
    return here() == '\n' || (here() == '\r' && (at + 1 == text.size() || text[at + 1] == '\n'));
  }
  void skip_blanks() {
    while (!done() && (here() == ' ' || here() == '\t')) ++at;
  }
  void skip_line() {
    while (!done() && here() != '\n') ++at;
    ++at;
  }
  std::string word() {
    skip_blanks();
    std::string found;
    while (!ends_line() && here() != ' ' && here() != '\t') found += text[at++];
    return found;
  }
  void end_line() {
    skip_blanks();
    if (!ends_line()) refuse("too many words");
    skip_line();
  }
};

float number_of(const std::string& word) {
  std::size_t at = 0;
  const auto digits = [&] {
    const std::size_t begin = at;
    while (word[at] >= '0' && word[at] <= '9') ++at;
    return at - begin;
  };
  if (word[at] == '-') ++at;
  std::size_t count = digits();
  if (word[at] == '.') {
    ++at;
    count += digits();
  }
  if (count > 0 && (word[at] == 'e' || word[at] == 'E')) {
    ++at;
    if (word[at] == '-' || word[at] == '+') ++at;
    count = digits();
  }
  const float number = std::strtof(word.c_str(), nullptr);
  if (count == 0 || at != word.size() || !std::isfinite(number)) refuse("not a number");
  return number;
}

glm::vec3 three_of(Cursor& cursor) {
  glm::vec3 three;
  for (int i = 0; i < 3; ++i) three[i] = number_of(cursor.word());
  cursor.end_line();
  return three;
}
""",
    {NEXT: "  return 1 - (source == 1);\n",
     DRAW: """
  const Nothing nothing(gl);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
""",
     PASSES: """
  const bool tone = look.curve > 0 || look.exposure < 0 || look.exposure > 0;
  const bool adjust = std::fmod(look.hue, 1.0f) != 0 || look.saturation != 1 || look.brightness != 1;
  std::vector<Pass> passes;
  for (const auto& [needed, pass] : {std::pair(look.bloom > 0, Pass::bloom), std::pair(tone, Pass::tone),
                                     std::pair(adjust, Pass::adjust), std::pair(look.table, Pass::table),
                                     std::pair(look.overlay > 0, Pass::overlay)})
    if (needed) passes.push_back(pass);
  return passes;
""",
     WEIGHTS: """
  if (!(sigma > 0) || sigma > 20) refuse("sigma is above 0 and at most 20");
  // From one k^2 to the next: (k + 1)^2 = k^2 + (2 k + 1), and 2 k + 1 grows by 2.
  const double q = std::exp(-0.5 / (double(sigma) * double(sigma)));
  const int last = int(std::ceil(3.0 * double(sigma)));
  std::vector<double> bell{1};
  double sum = 1;
  for (double factor = q; int(bell.size()) <= last; factor *= q * q) {
    bell.push_back(bell.back() * factor);
    sum += 2 * bell.back();
  }
  std::vector<float> weights(bell.size());
  for (std::size_t k = 0; k < bell.size(); ++k) weights[k] = float(bell[k] / sum);
  return weights;
""",
     READ: r"""
  ColourTable table;
  bool sized = false, titled = false, has_low = false, has_high = false;
  const auto first_time = [&](bool& seen) {
    if (seen) refuse("a keyword twice");
    if (!table.colours.empty()) refuse("a keyword after the colours");
    seen = true;
  };
  Cursor cursor{text};
  while (!cursor.done()) {
    cursor.skip_blanks();
    if (cursor.ends_line() || cursor.here() == '#') {
      cursor.skip_line();
      continue;
    }
    const std::size_t begin = cursor.at;
    const std::string first = cursor.word();
    if (first == "TITLE") {
      first_time(titled);
      cursor.skip_blanks();
      if (cursor.here() != '"') refuse("no title");
      for (++cursor.at; cursor.here() != '"'; ++cursor.at) {
        if (cursor.ends_line()) refuse("a title without an end");
        table.title += cursor.here();
      }
      ++cursor.at;
      cursor.end_line();
    } else if (first == "LUT_3D_SIZE") {
      first_time(sized);
      const std::string word = cursor.word();
      table.size = 0;
      for (const char c : word) {
        if (c < '0' || c > '9' || table.size > 256) refuse("not a size");
        table.size = 10 * table.size + (c - '0');
      }
      if (table.size < 2 || table.size > 256) refuse("no such size");
      cursor.end_line();
    } else if (first == "DOMAIN_MIN") {
      first_time(has_low);
      table.low = three_of(cursor);
    } else if (first == "DOMAIN_MAX") {
      first_time(has_high);
      table.high = three_of(cursor);
    } else {
      cursor.at = begin;
      table.colours.push_back(three_of(cursor));
    }
  }
  const auto n = std::size_t(table.size);
  if (!sized || table.colours.size() != n * n * n) refuse("the number of colours");
  if (!(table.low.r < table.high.r && table.low.g < table.high.g && table.low.b < table.high.b)) refuse("the domain");
  return table;
""",
     WRITE: r"""
  std::string text;
  const auto write = [&](const char* keyword, const glm::vec3& c) {
    std::array<char, 128> line{};
    std::snprintf(line.data(), line.size(), "%s%.9g %.9g %.9g\n", keyword, double(c.r), double(c.g), double(c.b));
    text += line.data();
  };
  if (!table.title.empty()) text.append("TITLE \"").append(table.title).append("\"\n");
  text.append("LUT_3D_SIZE ").append(std::to_string(table.size)).append("\n");
  if (!(table.low == glm::vec3(0))) write("DOMAIN_MIN ", table.low);
  if (!(table.high == glm::vec3(1))) write("DOMAIN_MAX ", table.high);
  for (const auto& colour : table.colours) write("", colour);
  return text;
"""},
    {},
    {CORNER: "  return 4.0 * vec2(corner & 1, corner >> 1) - 1.0;\n",
     LUMA: "  return 0.2126 * colour.r + 0.7152 * colour.g + 0.0722 * colour.b;\n",
     HUE: """
  float r = colour.r, g = colour.g, b = colour.b, y = luma(colour);
  if (r == g && g == b) return vec3(0.0, 0.0, y);
  if (r >= g && g >= b) return vec3((g - b) / (r - b) / 6.0, r - b, y);
  if (g >= r && r >= b) return vec3((2.0 - (r - b) / (g - b)) / 6.0, g - b, y);
  if (g >= b && b >= r) return vec3((2.0 + (b - r) / (g - r)) / 6.0, g - r, y);
  if (b >= g && g >= r) return vec3((4.0 - (g - r) / (b - r)) / 6.0, b - r, y);
  if (b >= r && r >= g) return vec3((4.0 + (r - g) / (b - g)) / 6.0, b - g, y);
  return vec3((6.0 - (b - g) / (r - g)) / 6.0, r - g, y);
""",
     COLOUR: """
  float s = 6.0 * fract(hue), rise = fract(s);
  int sextant = int(s);
  vec3 pure = sextant == 0 ? vec3(1.0, rise, 0.0) : sextant == 1 ? vec3(1.0 - rise, 1.0, 0.0)
            : sextant == 2 ? vec3(0.0, 1.0, rise) : sextant == 3 ? vec3(0.0, 1.0 - rise, 1.0)
            : sextant == 4 ? vec3(rise, 0.0, 1.0) : vec3(1.0, 0.0, sextant == 5 ? 1.0 - rise : 0.0);
  // In the plane of this hue the colours form a triangle: black, white, and the pure colour with its own luma.
  float peak = luma(pure);
  float most = luma_wanted < peak ? luma_wanted / peak : luma_wanted < 1.0 ? (1.0 - luma_wanted) / (1.0 - peak) : 0.0;
  float fits = clamp(chroma, 0.0, most);
  return max(vec3(luma_wanted - fits * peak) + fits * pure, 0.0);
""",
     ADJUSTED: """
  vec3 hcl = hue_chroma_luma(colour) * vec3(1.0, saturation, brightness);
  return colour_of(hcl.x + turns, hcl.y, hcl.z);
""",
     REINHARD: """
  float before = luma(colour);
  if (before <= 0.0) return vec3(0.0);
  float after = before * (1.0 + before / (white * white)) / (1.0 + before);
  return after / before * colour;
""",
     FILMIC: """
  // h as one fraction: its difference with E / F has no constant.
  vec4 x = vec4(colour + colour, 11.2);
  vec4 h = x * (0.15 * (0.3 - 0.02) * x + 0.5 * (0.1 * 0.3 - 0.02)) / (0.3 * (x * (0.15 * x + 0.5) + 0.06));
  return h.xyz / h.w;
""",
     TONE: """
  colour *= pow(2.0, stops);
  if (curve == 1) return reinhard(colour, white);
  if (curve == 2) return filmic(colour);
  return colour;
""",
     OVERLAID: """
  float share = amount * above.a;
  return vec4((1.0 - share) * below.rgb + share * above.rgb, below.a);
""",
     BRIGHT: """
  float y = luma(colour);
  if (y <= threshold) return vec3(0.0);
  return colour - colour * (threshold / y);
""",
     BLURRED: """
  vec3 sum = vec3(0.0);
  for (int k = -LAST_WEIGHT; k <= LAST_WEIGHT; ++k)
    sum += texture(picture, texcoord + float(k) * pixel).rgb * u_weights[abs(k)];
  return sum;
""",
     TRILINEAR: "  return texture(table, mix(vec3(0.5), vec3(u_table_size - 0.5), colour) / u_table_size).rgb;\n",
     TETRAHEDRAL: """
  vec3 place = clamp(colour, 0.0, 1.0) * (u_table_size - 1.0);
  vec3 cell = min(floor(place), u_table_size - 2.0), p = place - cell;
  ivec3 at = ivec3(cell);
  vec3 c000 = texelFetch(table, at, 0).rgb, c111 = texelFetch(table, at + 1, 0).rgb;
  vec3 c100 = texelFetch(table, at + ivec3(1, 0, 0), 0).rgb, c110 = texelFetch(table, at + ivec3(1, 1, 0), 0).rgb;
  vec3 c010 = texelFetch(table, at + ivec3(0, 1, 0), 0).rgb, c011 = texelFetch(table, at + ivec3(0, 1, 1), 0).rgb;
  vec3 c001 = texelFetch(table, at + ivec3(0, 0, 1), 0).rgb, c101 = texelFetch(table, at + ivec3(1, 0, 1), 0).rgb;
  if (p.r > p.g) {
    if (p.g > p.b) return c000 + p.r * (c100 - c000) + p.g * (c110 - c100) + p.b * (c111 - c110);
    if (p.r > p.b) return c000 + p.r * (c100 - c000) + p.b * (c101 - c100) + p.g * (c111 - c101);
    return c000 + p.b * (c001 - c000) + p.r * (c101 - c001) + p.g * (c111 - c101);
  }
  if (p.b > p.g) return c000 + p.b * (c001 - c000) + p.g * (c011 - c001) + p.r * (c111 - c011);
  if (p.b > p.r) return c000 + p.g * (c010 - c000) + p.b * (c011 - c010) + p.r * (c111 - c011);
  return c000 + p.g * (c010 - c000) + p.r * (c110 - c010) + p.b * (c111 - c110);
""",
     DITHERED: "  return mix(stored - 0.5 / 255.0, stored + 0.5 / 255.0, noise);\n"})

# ================================================================ streams
variant(
    "streams", "Tables by streams, weights as powers, each channel by its distance on the circle of hues, eight texels mixed",
    ["algorithm", "limits", "sstream"],
    r"""
float read_number(std::istream& words) {
  std::string word;
  words >> word;
  std::istringstream digits(word);
  float number = 0;
  if (!(digits >> number) || digits.get() != std::char_traits<char>::eof() || !std::isfinite(number))
    throw std::invalid_argument("a number is wanted, not " + word);
  return number;
}

void end_of_line(std::istream& words) {
  std::string more;
  if (words >> more) throw std::invalid_argument("too much in a line: " + more);
}

glm::vec3 read_colour(std::istream& words) {
  glm::vec3 colour;
  colour.r = read_number(words);
  colour.g = read_number(words);
  colour.b = read_number(words);
  end_of_line(words);
  return colour;
}

std::ostream& operator<<(std::ostream& out, const glm::vec3& colour) {
  return out << colour.r << ' ' << colour.g << ' ' << colour.b << '\n';
}
""",
    {NEXT: "  return int(source != 1);\n",
     DRAW: """
  std::array<GLuint, 1> arrays{};
  gl.GenVertexArrays(1, arrays.data());
  gl.BindVertexArray(arrays[0]);
  gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 3);
  gl.DeleteVertexArrays(1, arrays.data());  // binds 0 in place of one that is bound
""",
     PASSES: """
  std::vector<Pass> passes{Pass::bloom, Pass::tone, Pass::adjust, Pass::table, Pass::overlay};
  const auto changes_nothing = [&](Pass pass) {
    switch (pass) {
      case Pass::bloom:
        return look.bloom == 0;
      case Pass::tone:
        return look.curve == 0 && look.exposure == 0;
      case Pass::adjust:
        return look.saturation == 1 && look.brightness == 1 && look.hue == std::round(look.hue);
      case Pass::table:
        return !look.table;
      default:
        return look.overlay == 0;
    }
  };
  passes.erase(std::remove_if(passes.begin(), passes.end(), changes_nothing), passes.end());
  return passes;
""",
     WEIGHTS: """
  if (!(sigma > 0 && sigma <= 20)) throw std::invalid_argument("sigma");
  const double step = 1 / double(sigma), at_one = std::exp(-0.5 * step * step);
  std::vector<double> side;
  for (int k = 1; k < std::ceil(3 * double(sigma)) + 1; ++k) side.push_back(std::pow(at_one, double(k) * k));
  double sum = 0;
  for (auto weight = side.rbegin(); weight != side.rend(); ++weight) sum += *weight;
  const double scale = 1 / (1 + 2 * sum);
  std::vector<float> weights{float(scale)};
  for (const double weight : side) weights.push_back(float(scale * weight));
  return weights;
""",
     READ: r"""
  ColourTable table;
  std::vector<std::string> seen;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    std::istringstream words(line);
    std::string first;
    if (!(words >> first) || first[0] == '#') continue;
    if (first[0] < 'A' || first[0] > 'Z') {
      std::istringstream whole(line);
      table.colours.push_back(read_colour(whole));
      continue;
    }
    if (!table.colours.empty() || std::count(seen.begin(), seen.end(), first) > 0)
      throw std::invalid_argument(first + " is not wanted here");
    seen.push_back(first);
    if (first == "TITLE") {
      char quote = 0;
      words >> quote;
      if (quote != '"' || !std::getline(words, table.title, '"') || words.eof())
        throw std::invalid_argument("a title stands between quotes");
      end_of_line(words);
    } else if (first == "LUT_3D_SIZE") {
      std::string size;
      words >> size;
      end_of_line(words);
      if (size.empty() || size.size() > 6 || size.find_first_not_of("0123456789") != size.npos)
        throw std::invalid_argument("not a size: " + size);
      table.size = std::stoi(size);
      if (table.size < 2 || table.size > 256) throw std::invalid_argument("the size is 2 to 256");
    } else if (first == "DOMAIN_MIN") {
      table.low = read_colour(words);
    } else if (first == "DOMAIN_MAX") {
      table.high = read_colour(words);
    } else {
      throw std::invalid_argument("an unknown keyword: " + first);
    }
  }
  if (std::count(seen.begin(), seen.end(), "LUT_3D_SIZE") == 0) throw std::invalid_argument("no size");
  if (table.colours.size() != std::size_t(table.size * table.size * table.size))
    throw std::invalid_argument("too few or too many colours");
  if (glm::any(glm::lessThanEqual(table.high, table.low))) throw std::invalid_argument("an empty domain");
  return table;
""",
     WRITE: r"""
  std::ostringstream out;
  out.precision(std::numeric_limits<float>::max_digits10);
  if (!table.title.empty()) out << "TITLE \"" << table.title << "\"\n";
  out << "LUT_3D_SIZE " << table.size << '\n';
  if (table.low != glm::vec3(0)) out << "DOMAIN_MIN " << table.low;
  if (table.high != glm::vec3(1)) out << "DOMAIN_MAX " << table.high;
  for (std::size_t i = 0; i < table.colours.size(); ++i) out << table.colours[i];
  return out.str();
"""},
    {"// Hable's filmic curve": """
// Hable's h of one number.
float hable_curve(float x) {
  float above = x * (0.15 * x + 0.1 * 0.5) + 0.2 * 0.02, below = x * (0.15 * x + 0.5) + 0.2 * 0.3;
  return above / below - 0.02 / 0.3;
}
"""},
    {CORNER: """
  if (corner == 0) return vec2(-1.0);
  return corner == 1 ? vec2(3.0, -1.0) : vec2(-1.0, 3.0);
""",
     LUMA: """
  vec3 light = colour * vec3(0.2126, 0.7152, 0.0722);
  return light.g + light.r + light.b;
""",
     HUE: """
  // Sorted so that the first is the largest; the third is where the hue starts, the fourth the other of two.
  vec4 p = colour.g < colour.b ? vec4(colour.bg, -1.0, 2.0 / 3.0) : vec4(colour.gb, 0.0, -1.0 / 3.0);
  vec4 q = colour.r < p.x ? vec4(p.xyw, colour.r) : vec4(colour.r, p.yzx);
  float chroma = q.x - min(q.w, q.y);
  float hue = chroma > 0.0 ? abs(q.z + (q.w - q.y) / (6.0 * chroma)) : 0.0;
  return vec3(hue, chroma, luma(colour));
""",
     COLOUR: """
  if (luma_wanted >= 1.0) return vec3(luma_wanted);
  // How far is the hue from that of each channel, in turns on a circle?
  vec3 away = abs(fract(vec3(hue) - vec3(0.0, 1.0, 2.0) / 3.0 + 0.5) - 0.5);
  vec3 pure = clamp(2.0 - 6.0 * away, 0.0, 1.0);
  vec3 colour = luma_wanted + max(chroma, 0.0) * (pure - luma(pure));
  // Towards the grey, until the smallest and the largest component fit.
  float least = min(colour.r, min(colour.g, colour.b));
  if (least < 0.0) colour = luma_wanted + (colour - luma_wanted) * (luma_wanted / (luma_wanted - least));
  float most = max(colour.r, max(colour.g, colour.b));
  if (most > 1.0) colour = luma_wanted + (colour - luma_wanted) * ((1.0 - luma_wanted) / (most - luma_wanted));
  return max(colour, 0.0);
""",
     ADJUSTED: """
  float y = luma(colour), hue = hue_chroma_luma(colour).x;
  float chroma = max(colour.r, max(colour.g, colour.b)) - min(colour.r, min(colour.g, colour.b));
  return colour_of(hue + turns, saturation * chroma, brightness * y);
""",
     REINHARD: """
  float y = luma(colour);
  return (colour + colour * (y / (white * white))) / (1.0 + y);
""",
     FILMIC: """
  float white = hable_curve(11.2);
  return vec3(hable_curve(2.0 * colour.r), hable_curve(2.0 * colour.g), hable_curve(2.0 * colour.b)) / white;
""",
     TONE: """
  vec3 light = exp2(stops) * colour;
  switch (curve) {
    case 1:
      return reinhard(light, white);
    case 2:
      return filmic(light);
  }
  return light;
""",
     OVERLAID: """
  float opacity = amount * above.a;
  vec4 seen = below;
  if (opacity == 1.0)
    seen.rgb = above.rgb;
  else if (opacity > 0.0)
    seen.rgb += opacity * (above.rgb - below.rgb);
  return seen;
""",
     BRIGHT: """
  float y = luma(colour), extra = max(y - threshold, 0.0);
  return extra > 0.0 ? extra / y * colour : vec3(0.0);
""",
     BLURRED: """
  vec3 sum = texture(picture, texcoord).rgb * u_weights[0];
  vec2 left = texcoord, right = texcoord;
  for (int k = 1; k <= LAST_WEIGHT; ++k) {
    left -= pixel;
    right += pixel;
    sum += u_weights[k] * texture(picture, left).rgb;
    sum += u_weights[k] * texture(picture, right).rgb;
  }
  return sum;
""",
     TRILINEAR: """
  vec3 place = clamp(colour, 0.0, 1.0) * (u_table_size - 1.0);
  ivec3 a = ivec3(place), b = min(a + 1, ivec3(u_table_size) - 1);
  vec3 part = place - vec3(a);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 8; ++i) {
    ivec3 far = ivec3(i & 1, (i >> 1) & 1, i >> 2);
    vec3 share = mix(1.0 - part, part, vec3(far));
    sum += share.x * share.y * share.z * texelFetch(table, a + far * (b - a), 0).rgb;
  }
  return sum;
""",
     TETRAHEDRAL: """
  vec3 place = clamp(colour, 0.0, 1.0) * (u_table_size - 1.0);
  ivec3 corner = min(ivec3(place), ivec3(u_table_size) - 2);
  vec3 part = place - vec3(corner), left = part;
  vec3 before = texelFetch(table, corner, 0).rgb, found = before;
  for (int i = 0; i < 3; ++i) {
    int axis = left.x >= left.y && left.x >= left.z ? 0 : left.y >= left.z ? 1 : 2;
    corner[axis] += 1;
    vec3 next = texelFetch(table, corner, 0).rgb;
    found += part[axis] * (next - before);
    before = next;
    left[axis] = -1.0;
  }
  return found;
""",
     DITHERED: """
  float step = 1.0 / 255.0;
  return stored - 0.5 * step + noise * step;
"""})

# ================================================================ lines-first
variant(
    "lines-first", "All lines split first, an index buffer, hues along the edges of a hexagon, shares of eight corners",
    ["algorithm", "charconv", "cstdint", "cstdlib"],
    r"""
using Words = std::vector<std::string>;

/// The words of every line that means something; of a title, the rest of its line is the second word.
std::vector<Words> split(std::string_view text) {
  std::vector<Words> lines;
  std::string line;
  const auto finish = [&] {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    Words words(1);
    bool title = false;
    for (const char c : line + " ") {
      title = title || (words.size() == 2 && words.front() == "TITLE");
      if (title || (c != ' ' && c != '\t'))
        words.back() += c;
      else if (!words.back().empty())
        words.emplace_back();
    }
    if (!title) words.pop_back();
    if (!words.empty() && words[0][0] != '#') lines.push_back(words);
    line.clear();
  };
  for (const char c : text) {
    if (c == '\n')
      finish();
    else
      line += c;
  }
  finish();
  return lines;
}

float float_from(const std::string& word) {
  char* end = nullptr;
  const auto number = float(std::strtod(word.c_str(), &end));
  if (word.find_first_not_of("0123456789+-.eE") != word.npos || *end != 0 || end == word.c_str() ||
      !std::isfinite(number))
    throw std::invalid_argument("no number: " + word);
  return number;
}

glm::vec3 vector_from(const Words& words, std::size_t first) {
  if (words.size() - first != 3) throw std::invalid_argument("a line of " + std::to_string(words.size()) + " words");
  return glm::vec3(float_from(words[first]), float_from(words[first + 1]), float_from(words[first + 2]));
}

/// The text between quotes, with blanks around them.
std::string unquoted(std::string text) {
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.pop_back();
  text.erase(0, text.find_first_not_of(" \t"));
  if (text.size() < 2 || text.front() != '"' || text.back() != '"') throw std::invalid_argument("no quotes");
  return text.substr(1, text.size() - 2);
}
""",
    {NEXT: "  return source < 1 ? 1 : 0;\n",
     DRAW: """
  const std::array<std::uint8_t, 3> order{0, 1, 2};
  GLuint array = 0, indices = 0;
  gl.GenVertexArrays(1, &array);
  gl.GenBuffers(1, &indices);
  gl.BindVertexArray(array);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof order, order.data(), GL_STATIC_DRAW);
  gl.DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, nullptr);
  gl.BindVertexArray(0);
  gl.DeleteBuffers(1, &indices);
  gl.DeleteVertexArrays(1, &array);
""",
     PASSES: """
  std::vector<Pass> passes;
  const auto add_if = [&](bool needed, Pass pass) {
    if (needed) passes.insert(passes.end(), pass);
  };
  const bool neutral = look.saturation == 1 && look.brightness == 1 && look.hue == std::trunc(look.hue);
  add_if(look.bloom > 0, Pass::bloom);
  add_if(!(look.exposure == 0 && look.curve == 0), Pass::tone);
  add_if(!neutral, Pass::adjust);
  add_if(look.table, Pass::table);
  add_if(look.overlay > 0, Pass::overlay);
  return passes;
""",
     WEIGHTS: """
  if (!(sigma > 0) || !(sigma <= 20)) throw std::invalid_argument("no such sigma");
  const double s = sigma;
  const auto last = std::size_t(std::ceil(3 * s));
  std::vector<double> bell(last + 1);
  for (std::size_t k = 0; k <= last; ++k) bell[k] = std::exp2(-0.72134752044448170 * (double(k) / s) * (double(k) / s));
  double sum = 0;
  for (std::size_t k = last; k > 0; --k) sum += bell[k];
  sum = sum + sum + bell[0];
  return std::vector<float>([&] {
    std::vector<float> weights;
    std::transform(bell.begin(), bell.end(), std::back_inserter(weights), [&](double b) { return float(b / sum); });
    return weights;
  }());
""",
     READ: r"""
  ColourTable table;
  table.size = -1;
  const std::vector<Words> lines = split(text);
  std::size_t at = 0;
  bool titled = false, low = false, high = false;
  for (; at < lines.size() && lines[at][0] >= "A"; ++at) {
    const Words& words = lines[at];
    if (words[0] == "TITLE" && !titled && words.size() == 2) {
      titled = true;
      table.title = unquoted(words[1]);
    } else if (words[0] == "LUT_3D_SIZE" && table.size < 0 && words.size() == 2) {
      const char* end = words[1].data() + words[1].size();
      if (std::from_chars(words[1].data(), end, table.size).ptr != end || table.size < 2 || table.size > 256)
        throw std::invalid_argument("no size: " + words[1]);
    } else if (words[0] == "DOMAIN_MIN" && !low) {
      low = true;
      table.low = vector_from(words, 1);
    } else if (words[0] == "DOMAIN_MAX" && !high) {
      high = true;
      table.high = vector_from(words, 1);
    } else {
      throw std::invalid_argument("not understood: " + words[0]);
    }
  }
  const std::size_t count = lines.size() - at;
  if (table.size < 0 || count != std::size_t(table.size) * std::size_t(table.size) * std::size_t(table.size))
    throw std::invalid_argument("a wrong number of lines");
  for (; at < lines.size(); ++at) table.colours.push_back(vector_from(lines[at], 0));
  if (!glm::all(glm::greaterThan(table.high, table.low))) throw std::invalid_argument("nothing between the ends");
  return table;
""",
     WRITE: r"""
  std::string text = table.title.empty() ? "" : "TITLE\t\"" + table.title + "\"\n";
  const auto line = [&](std::string words, const glm::vec3& numbers) {
    for (int i = 0; i < 3; ++i) {
      std::array<char, 40> buffer;
      const auto end = std::to_chars(&buffer.front(), &buffer.back(), numbers[i], std::chars_format::scientific).ptr;
      if (!words.empty()) words += ' ';
      words += std::string(buffer.data(), end);
    }
    text += words + '\n';
  };
  text += "LUT_3D_SIZE " + std::to_string(table.size) + '\n';
  if (table.low != glm::vec3(0, 0, 0)) line("DOMAIN_MIN", table.low);
  if (table.high != glm::vec3(1, 1, 1)) line("DOMAIN_MAX", table.high);
  for (const glm::vec3& colour : table.colours) line({}, colour);
  return text;
"""},
    {"// The colour that has this hue (in turns": """
// The corners of the hexagon of hues, in turns of 1/6.
vec3 hexagon_corner(int i) {
  vec3 corners[6] = vec3[6](vec3(1, 0, 0), vec3(1, 1, 0), vec3(0, 1, 0), vec3(0, 1, 1), vec3(0, 0, 1), vec3(1, 0, 1));
  return corners[i % 6];
}
"""},
    {CORNER: OTHER_TRIANGLE if ANY_TRIANGLE else SAME_TRIANGLE,
     LUMA: """
  const mat3 to_yyy = mat3(vec3(0.2126), vec3(0.7152), vec3(0.0722));
  return (to_yyy * colour).y;
""",
     HUE: """
  float least = min(min(colour.r, colour.g), colour.b), chroma = max(max(colour.r, colour.g), colour.b) - least;
  if (!(chroma > 0.0)) return vec3(0.0, 0.0, luma(colour));
  vec3 u = (colour - least) / chroma;  // on the hexagon: one component is 1, another is 0
  float sixths = u.r >= 1.0 ? mod(u.g - u.b + 6.0, 6.0) : u.g >= 1.0 ? 2.0 - u.r + u.b : 4.0 - u.g + u.r;
  return vec3(sixths / 6.0, chroma, luma(colour));
""",
     COLOUR: """
  float s = 6.0 * fract(hue);
  int side = min(int(s), 5);
  vec3 pure = mix(hexagon_corner(side), hexagon_corner(side + 1), s - float(side));
  vec3 way = pure - luma(pure);
  float y = luma_wanted;
  vec3 ends = mix(vec3(y), vec3(max(1.0 - y, 0.0)), greaterThan(way, vec3(0.0)));
  vec3 reach = ends / max(abs(way), 1e-20);
  float fits = min(min(max(chroma, 0.0), reach.r), min(reach.g, reach.b));
  return max(fits * way + y, vec3(0.0));
""",
     ADJUSTED: """
  vec3 was = hue_chroma_luma(colour);
  float hue = was.x + turns;
  hue -= floor(hue);
  return colour_of(hue, was.y * saturation, was.z * brightness);
""",
     REINHARD: """
  float y = luma(colour), w = white * white;
  return (w + y) / (w * (1.0 + y)) * colour;
""",
     FILMIC: """
  vec3 result;
  for (int i = 0; i < 3; ++i) {
    float x = 2.0 * colour[i], a = 0.15 * x * x;
    result[i] = (a + 0.05 * x + 0.004) / (a + 0.5 * x + 0.06) - 1.0 / 15.0;
  }
  float a = 0.15 * 11.2 * 11.2;
  return result / ((a + 0.05 * 11.2 + 0.004) / (a + 0.5 * 11.2 + 0.06) - 1.0 / 15.0);
""",
     TONE: """
  colour = colour * exp2(stops);
  if (curve == 0) return colour;
  if (curve == 1) return reinhard(colour, white);
  return filmic(colour);
""",
     OVERLAID: """
  float over = above.a * amount, under = 1.0 - over;
  below.rgb = under * below.rgb + over * above.rgb;
  return below;
""",
     BRIGHT: """
  float y = luma(colour);
  if (!(y > threshold)) return vec3(0.0);
  return colour * (1.0 - threshold / y);
""",
     BLURRED: """
  // From the outermost pixels inwards.
  vec3 sum = vec3(0.0);
  for (int k = LAST_WEIGHT; k > 0; --k) {
    vec2 way = float(k) * pixel;
    vec3 sides = texture(picture, texcoord - way).rgb + texture(picture, texcoord + way).rgb;
    sum += sides * u_weights[k];
  }
  return sum + u_weights[0] * texture(picture, texcoord).rgb;
""",
     TRILINEAR: """
  vec3 texel = 1.0 / vec3(textureSize(table, 0));
  return textureLod(table, 0.5 * texel + colour * (1.0 - texel), 0.0).rgb;
""",
     TETRAHEDRAL: """
  // Each corner's share of the volume; at most four of the eight are above 0.
  vec3 place = clamp(colour, 0.0, 1.0) * (u_table_size - 1.0);
  ivec3 at = min(ivec3(place), ivec3(u_table_size) - 2);
  vec3 p = place - vec3(at);
  vec3 sum = (1.0 - max(p.r, max(p.g, p.b))) * texelFetch(table, at, 0).rgb;
  sum += max(p.r - max(p.g, p.b), 0.0) * texelFetch(table, at + ivec3(1, 0, 0), 0).rgb;
  sum += max(p.g - max(p.b, p.r), 0.0) * texelFetch(table, at + ivec3(0, 1, 0), 0).rgb;
  sum += max(p.b - max(p.r, p.g), 0.0) * texelFetch(table, at + ivec3(0, 0, 1), 0).rgb;
  sum += max(min(p.g, p.b) - p.r, 0.0) * texelFetch(table, at + ivec3(0, 1, 1), 0).rgb;
  sum += max(min(p.b, p.r) - p.g, 0.0) * texelFetch(table, at + ivec3(1, 0, 1), 0).rgb;
  sum += max(min(p.r, p.g) - p.b, 0.0) * texelFetch(table, at + ivec3(1, 1, 0), 0).rgb;
  return sum + min(p.r, min(p.g, p.b)) * texelFetch(table, at + 1, 0).rgb;
""",
     DITHERED: """
  vec3 codes = 255.0 * stored + (noise - 0.5);
  return codes / 255.0;
"""})

# ================================================================ keywords
variant(
    "keywords", "A function for each keyword, numbers in double precision, the reach of each channel, sorted fractions",
    ["algorithm", "charconv", "functional", "map", "utility"],
    r"""
[[noreturn]] void wrong(const std::string& what) {
  throw std::invalid_argument(what);
}

/// Takes the next word off a line; empty at its end.
std::string_view take_word(std::string_view& line) {
  while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
  std::size_t length = 0;
  while (length < line.size() && line[length] != ' ' && line[length] != '\t') ++length;
  const std::string_view word = line.substr(0, length);
  line.remove_prefix(length);
  return word;
}

double take_number(std::string_view& line) {
  const std::string_view word = take_word(line);
  double number = 0;
  const auto result = std::from_chars(word.begin(), word.end(), number, std::chars_format::general);
  if (result.ec != std::errc{} || result.ptr != word.end() || word.empty()) wrong("not a number");
  if (!std::isfinite(float(number))) wrong("not a finite number");
  return number;
}

void take_end(std::string_view line) {
  if (!take_word(line).empty()) wrong("too many words");
}

glm::vec3 take_three(std::string_view line) {
  const double r = take_number(line), g = take_number(line), b = take_number(line);
  take_end(line);
  return glm::vec3(float(r), float(g), float(b));
}
""",
    {NEXT: """
  switch (source) {
    case 0:
      return 1;
    default:
      return 0;
  }
""",
     DRAW: """
  std::vector<GLuint> ids(1);
  gl.GenVertexArrays(GLsizei(ids.size()), ids.data());
  gl.BindVertexArray(ids.front());
  gl.DrawArrays(GL_TRIANGLE_FAN, 0, 3);
  gl.BindVertexArray(GLuint{});
  gl.DeleteVertexArrays(GLsizei(ids.size()), ids.data());
""",
     PASSES: """
  std::map<int, Pass> order;
  if (look.overlay > 0) order.emplace(4, Pass::overlay);
  if (look.table) order.emplace(3, Pass::table);
  if (look.saturation != 1) order.emplace(2, Pass::adjust);
  if (look.brightness != 1) order.emplace(2, Pass::adjust);
  if (look.hue - std::floor(look.hue) > 0) order.emplace(2, Pass::adjust);
  if (look.curve != 0) order.emplace(1, Pass::tone);
  if (look.exposure != 0) order.emplace(1, Pass::tone);
  if (look.bloom > 0) order.emplace(0, Pass::bloom);
  std::vector<Pass> passes;
  for (const auto& entry : order) passes.push_back(entry.second);
  return passes;
""",
     WEIGHTS: """
  if (std::isnan(sigma) || sigma <= 0 || sigma > 20) wrong("sigma");
  const double variance = double(sigma) * double(sigma);
  std::vector<double> whole;  // the filter from one end to the other
  const int last = int(std::ceil(3 * double(sigma)));
  for (int k = -last; k <= last; ++k) whole.push_back(std::exp(-double(k) * double(k) / (2 * variance)));
  double sum = 0;
  for (const double weight : whole) sum += weight;
  std::vector<float> half;
  for (int k = 0; k <= last; ++k) half.push_back(float(whole[std::size_t(last + k)] / sum));
  return half;
""",
     READ: r"""
  ColourTable table;
  table.size = 0;
  std::map<std::string, std::function<void(std::string_view)>, std::less<>> keywords;
  keywords["TITLE"] = [&](std::string_view rest) {
    while (!rest.empty() && (rest.front() == ' ' || rest.front() == '\t')) rest.remove_prefix(1);
    if (!rest.starts_with('"')) wrong("a title needs quotes");
    rest.remove_prefix(1);
    const std::size_t end = rest.find('"');
    if (end == rest.npos) wrong("a title needs two quotes");
    table.title.assign(rest.substr(0, end));
    take_end(rest.substr(end + 1));
  };
  keywords["LUT_3D_SIZE"] = [&](std::string_view rest) {
    const std::string_view word = take_word(rest);
    take_end(rest);
    const auto result = std::from_chars(word.begin(), word.end(), table.size);
    if (result.ec != std::errc{} || result.ptr != word.end() || table.size < 2 || table.size > 256) wrong("the size");
  };
  keywords["DOMAIN_MIN"] = [&](std::string_view rest) { table.low = take_three(rest); };
  keywords["DOMAIN_MAX"] = [&](std::string_view rest) { table.high = take_three(rest); };
  for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end + 1) {
    end = std::min(text.find('\n', begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    std::string_view rest = line;
    const std::string_view first = take_word(rest);
    if (first.empty() || first.front() == '#') continue;
    const auto keyword = keywords.find(first);
    if (keyword == keywords.end()) {
      table.colours.push_back(take_three(line));
    } else {
      if (!table.colours.empty()) wrong("a keyword after colours");
      keyword->second(rest);
      keywords.erase(keyword);  // so that it is unknown the next time
    }
  }
  if (table.size == 0) wrong("no size");
  const auto n = std::size_t(table.size);
  if (table.colours.size() != n * n * n) wrong("the number of colours");
  for (int i = 0; i < 3; ++i)
    if (table.high[i] <= table.low[i]) wrong("the domain");
  return table;
""",
     WRITE: r"""
  std::vector<std::string> lines;
  const auto in_words = [](float number) {
    std::array<char, 64> buffer{};
    return std::string(buffer.data(), std::to_chars(buffer.data(), buffer.data() + 64, double(number)).ptr);
  };
  const auto colour_line = [&](const glm::vec3& c) {
    return in_words(c.x) + " " + in_words(c.y) + " " + in_words(c.z);
  };
  if (table.title != "") lines.push_back("TITLE \"" + table.title + "\"");
  if (table.low != glm::vec3(0)) lines.push_back("DOMAIN_MIN " + colour_line(table.low));
  if (table.high != glm::vec3(1)) lines.push_back("DOMAIN_MAX " + colour_line(table.high));
  lines.push_back("LUT_3D_SIZE " + std::to_string(table.size));
  for (const glm::vec3& colour : table.colours) lines.push_back(colour_line(colour));
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
"""},
    {},
    {CORNER: "  return vec2((corner << 2) & 4, (corner << 1) & 4) - 1.0;\n",
     LUMA: "  return dot(vec3(2126.0, 7152.0, 722.0), colour) / 10000.0;\n",
     HUE: """
  float most = max(colour.r, max(colour.g, colour.b)), least = min(colour.r, min(colour.g, colour.b));
  float middle = max(min(colour.r, colour.g), min(max(colour.r, colour.g), colour.b)), chroma = most - least;
  // The hexagon has a corner for each component and one between each two of them.
  float towards = chroma > 0.0 ? (middle - least) / chroma : 0.0;
  float nearest = colour.r == most ? 0.0 : colour.g == most ? 2.0 : 4.0;
  bool back = colour.r == most ? colour.b > colour.g : colour.g == most ? colour.r > colour.b : colour.g > colour.r;
  float sixths = back ? nearest - towards : nearest + towards;
  return vec3(sixths < 0.0 ? 1.0 + sixths / 6.0 : sixths / 6.0, chroma, luma(colour));
""",
     COLOUR: """
  vec3 ramps = abs(mod(6.0 * (hue - floor(hue)) + vec3(0.0, 4.0, 2.0), 6.0) - 3.0) - 1.0;
  vec3 pure = clamp(ramps, 0.0, 1.0);
  float peak = luma(pure), fits = chroma;
  fits = min(fits, luma_wanted / peak);
  fits = min(fits, (1.0 - luma_wanted) / (1.0 - peak));
  fits = max(fits, 0.0);
  return max(mix(vec3(luma_wanted - peak * fits), vec3(luma_wanted + (1.0 - peak) * fits), pure), 0.0);
""",
     ADJUSTED: """
  vec3 before = hue_chroma_luma(colour);
  vec3 after = before * vec3(1.0, saturation, brightness) + vec3(fract(turns), 0.0, 0.0);
  return colour_of(after.x, after.y, after.z);
""",
     REINHARD: """
  float y = luma(colour);
  return colour / (1.0 + y) + colour * (y / (1.0 + y) / (white * white));
""",
     FILMIC: """
  const float A = 0.15, B = 0.5, C = 0.1, D = 0.2, E = 0.02, F = 0.3, W = 11.2;
  vec3 x = 2.0 * colour;
  vec3 h = (x * (A * x + C * B) + D * E) / (x * (A * x + B) + D * F) - E / F;
  float white = (W * (A * W + C * B) + D * E) / (W * (A * W + B) + D * F) - E / F;
  return h * (1.0 / white);
""",
     TONE: """
  float factor = exp2(stops);
  vec3 light = colour * factor;
  vec3 results[3] = vec3[3](light, reinhard(light, white), filmic(light));
  return results[curve];
""",
     OVERLAID: """
  vec4 seen = above;
  seen.a *= amount;
  return vec4(seen.rgb * seen.a + below.rgb * (1.0 - seen.a), below.a);
""",
     BRIGHT: """
  float y = luma(colour);
  return colour * (max(y - threshold, 0.0) / max(y, 1e-30));
""",
     BLURRED: """
  vec3 left = vec3(0.0), right = vec3(0.0);
  for (int k = 1; k <= LAST_WEIGHT; ++k) {
    left += u_weights[k] * texture(picture, texcoord - float(k) * pixel).rgb;
    right += u_weights[k] * texture(picture, texcoord + float(k) * pixel).rgb;
  }
  return left + u_weights[0] * texture(picture, texcoord).rgb + right;
""",
     TRILINEAR: "  return texture(table, colour - (colour - 0.5) / u_table_size).rgb;\n",
     TETRAHEDRAL: """
  vec3 place = clamp(colour, 0.0, 1.0) * (u_table_size - 1.0);
  ivec3 c = min(ivec3(place), ivec3(u_table_size) - 2), axes = ivec3(0, 1, 2);
  vec3 f = place - vec3(c);
  // Sorts the three fractions, the largest first.
  if (f.x < f.y) { f.xy = f.yx; axes.xy = axes.yx; }
  if (f.y < f.z) { f.yz = f.zy; axes.yz = axes.zy; }
  if (f.x < f.y) { f.xy = f.yx; axes.xy = axes.yx; }
  ivec3 one = c, two;
  one[axes.x] += 1;
  two = one;
  two[axes.y] += 1;
  vec3 upper = mix(texelFetch(table, c, 0).rgb, texelFetch(table, one, 0).rgb, f.x);
  vec3 between = f.y * (texelFetch(table, two, 0).rgb - texelFetch(table, one, 0).rgb);
  return upper + between + f.z * (texelFetch(table, c + 1, 0).rgb - texelFetch(table, two, 0).rgb);
""",
     DITHERED: "  return (stored - 1.0 / 510.0) + noise / 255.0;\n"})

# ================================================================ scanf
variant(
    "scanf", "Lines by sscanf and the size before the colours' count, hues as a share of a sextant, corners by comparisons",
    ["algorithm", "bit", "cstdio", "cstdlib", "cstring", "numeric"],
    r"""
enum Seen : unsigned { seen_title = 1, seen_size = 2, seen_low = 4, seen_high = 8 };

/// Throws unless `good`.
void want(bool good, const char* what) {
  if (!good) throw std::invalid_argument(what);
}

bool blank(char c) {
  return c == ' ' || c == '\t';
}

/// Three finite numbers and nothing else.
glm::vec3 three_numbers(const char* text) {
  glm::vec3 three(0);
  int length = 0;
  want(std::strspn(text, "0123456789+-.eE \t") == std::strlen(text), "other characters than those of numbers");
  std::array<char[256], 3> words{};
  const int count = std::sscanf(text, "%255s %255s %255s %n", words[0], words[1], words[2], &length);
  want(count == 3, "three numbers are wanted");
  want(std::size_t(length) == std::strlen(text), "more than three words");
  for (int i = 0; i < 3; ++i) {
    char* end = nullptr;
    three[i] = std::strtof(words[std::size_t(i)], &end);
    want(*end == 0, "not a number");
    want(std::abs(three[i]) < INFINITY, "not a finite number");
  }
  return three;
}
""",
    {NEXT: "  return (std::max(source, -1) + 2) % 2 == 0 ? 1 : 0;\n",
     DRAW: """
  const auto with_array = [&gl](auto&& draw) {
    GLuint array = 0;
    gl.GenVertexArrays(1, &array);
    gl.BindVertexArray(array);
    draw();
    gl.BindVertexArray(0);
    gl.DeleteVertexArrays(1, &array);
  };
  with_array([&gl] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
""",
     PASSES: """
  unsigned bits = 0;
  bits |= look.bloom != 0 ? 1u << unsigned(Pass::bloom) : 0u;
  bits |= std::abs(look.exposure) + float(look.curve) > 0 ? 1u << unsigned(Pass::tone) : 0u;
  bits |= std::remainder(look.hue, 1.0f) != 0 ? 1u << unsigned(Pass::adjust) : 0u;
  bits |= look.saturation != 1 || look.brightness != 1 ? 1u << unsigned(Pass::adjust) : 0u;
  bits |= look.table ? 1u << unsigned(Pass::table) : 0u;
  bits |= look.overlay != 0 ? 1u << unsigned(Pass::overlay) : 0u;
  std::vector<Pass> passes;
  for (; bits != 0; bits &= bits - 1) passes.push_back(Pass(std::countr_zero(bits)));
  return passes;
""",
     WEIGHTS: """
  want(sigma > 0 && sigma <= 20, "sigma is above 0 and at most 20 pixels");
  std::vector<double> bell(1 + std::size_t(std::ceil(double(sigma) * 3)));
  std::iota(bell.begin(), bell.end(), 0.0);
  for (double& k : bell) k = std::exp(-0.5 * std::pow(k / double(sigma), 2));
  const double total = 2 * std::accumulate(bell.begin(), bell.end(), 0.0) - bell.front();
  std::vector<float> weights(bell.begin(), bell.end());
  for (std::size_t k = 0; k < weights.size(); ++k) weights[k] = float(bell[k] / total);
  return weights;
""",
     READ: r"""
  ColourTable table;
  unsigned seen = 0;
  std::size_t left = 0;  // lines of colours that are still to come
  const auto see = [&](Seen keyword) {
    want((seen & keyword) == 0, "a keyword twice");
    want(table.colours.empty(), "a keyword after the colours");
    seen |= keyword;
  };
  std::string rest(text);
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    std::string line = rest.substr(0, end);
    rest.erase(0, end == rest.npos ? rest.size() : end + 1);
    if (!line.empty() && line.back() == '\r') line.erase(line.size() - 1);
    while (!line.empty() && blank(line.back())) line.erase(line.size() - 1);
    line.erase(0, line.find_first_not_of(" \t"));
    if (line.empty() || line[0] == '#') continue;
    std::size_t length = 0;
    while (length < line.size() && !blank(line[length])) ++length;
    const std::string first = line.substr(0, length);
    const char* more = line.c_str() + length;
    while (blank(*more)) ++more;
    if (first == "TITLE") {
      see(seen_title);
      const std::string quoted = more;
      want(quoted.size() >= 2 && quoted.front() == '"' && quoted.find('"', 1) == quoted.size() - 1, "not a title");
      table.title = quoted.substr(1, quoted.size() - 2);
    } else if (first == "LUT_3D_SIZE") {
      see(seen_size);
      want(std::strlen(more) >= 1 && std::strlen(more) < 8 && std::strspn(more, "0123456789") == std::strlen(more),
           "not a size");
      std::sscanf(more, "%d", &table.size);
      want(table.size >= 2 && table.size <= 256, "a size of 2 to 256 is wanted");
      left = std::size_t(table.size) * std::size_t(table.size) * std::size_t(table.size);
    } else if (first == "DOMAIN_MIN") {
      see(seen_low);
      table.low = three_numbers(more);
    } else if (first == "DOMAIN_MAX") {
      see(seen_high);
      table.high = three_numbers(more);
    } else {
      table.colours.push_back(three_numbers(line.c_str()));
    }
  }
  want((seen & seen_size) != 0 && table.colours.size() == left, "a wrong number of colours");
  want(table.low.x < table.high.x && table.low.y < table.high.y && table.low.z < table.high.z, "no domain");
  return table;
""",
     WRITE: r"""
  std::string text;
  std::array<char, 40> word{};
  const auto add = [&](float number, char after) {
    // As few digits as are enough.
    for (int digits = 1; digits <= 9; ++digits) {
      std::snprintf(word.data(), word.size(), "%.*g", digits, double(number));
      float again = 0;
      if (std::sscanf(word.data(), "%f", &again) == 1 && again == number) break;
    }
    text += word.data();
    text += after;
  };
  const auto add_three = [&](const glm::vec3& three) { add(three.x, ' '), add(three.y, ' '), add(three.z, '\n'); };
  if (!table.title.empty()) text += "TITLE \"" + table.title + "\"\n";
  text += "LUT_3D_SIZE " + std::to_string(table.size) + "\n";
  if (table.low != glm::vec3(0)) text += "DOMAIN_MIN ", add_three(table.low);
  if (table.high != glm::vec3(1)) text += "DOMAIN_MAX ", add_three(table.high);
  for (const glm::vec3& colour : table.colours) add_three(colour);
  return text;
"""},
    {"// The colour that has this hue (in turns": """
// One channel of the colour with chroma 1, by the hue in sixths of a turn from where this channel is the largest.
float hexagon_ramp(float sixths) {
  float far = abs(mod(sixths + 3.0, 6.0) - 3.0);
  return clamp(2.0 - far, 0.0, 1.0);
}
"""},
    {CORNER: """
  float x = corner == 1 ? 3.0 : -1.0;
  float y = corner > 1 ? 3.0 : -1.0;
  return vec2(x, y);
""",
     LUMA: """
  return mix(colour.g, colour.r, 0.2126) + 0.0722 * (colour.b - colour.g);
""",
     HUE: """
  bool red = colour.r >= colour.g && colour.r >= colour.b, green = !red && colour.g >= colour.b;
  // The components in the order of the circle, the largest first.
  vec3 turned = red ? colour.rgb : green ? colour.gbr : colour.brg;
  float chroma = turned.x - min(turned.y, turned.z);
  float share = (turned.y - turned.z) / (chroma > 0.0 ? chroma : 1.0);
  float third = red ? 0.0 : green ? 1.0 : 2.0;
  return vec3(chroma > 0.0 ? fract((share + 2.0 * third) / 6.0) : 0.0, chroma, luma(colour));
""",
     COLOUR: """
  float sixths = 6.0 * fract(hue);
  vec3 pure = vec3(hexagon_ramp(sixths), hexagon_ramp(sixths - 2.0), hexagon_ramp(sixths - 4.0));
  float peak = luma(pure), y = min(luma_wanted, 1.0);
  float fits = min(max(chroma, 0.0), y * (1.0 - peak) < peak * (1.0 - y) ? y / peak : (1.0 - y) / (1.0 - peak));
  return max(luma_wanted - fits * (peak - pure), 0.0);
""",
     ADJUSTED: """
  vec3 parts = hue_chroma_luma(colour);
  parts.x = fract(parts.x + turns);
  parts.y *= saturation;
  parts.z *= brightness;
  return colour_of(parts.x, parts.y, parts.z);
""",
     REINHARD: """
  float y = luma(colour), relative = y / white / white;
  return colour / ((1.0 + y) / (1.0 + relative));
""",
     FILMIC: """
  // h(x) F = x (0.042 x + 0.005) / (0.15 x^2 + 0.5 x + 0.06); the factor F cancels.
  vec4 x = vec4(2.0 * colour, 11.2);
  vec4 h = (0.042 * x + 0.005) * x / ((0.15 * x + 0.5) * x + 0.06);
  return h.rgb / h.aaa;
""",
     TONE: """
  vec3 light = colour * exp2(stops);
  if (curve == 2) light = filmic(light);
  if (curve == 1) light = reinhard(light, white);
  return light;
""",
     OVERLAID: """
  vec3 shares = vec3(above.a * amount);
  return vec4(above.rgb * shares + below.rgb * (vec3(1.0) - shares), below.a);
""",
     BRIGHT: """
  float y = luma(colour), share = y > threshold ? (y - threshold) / y : 0.0;
  return share * colour;
""",
     BLURRED: """
  vec3 sum = -u_weights[0] * texture(picture, texcoord).rgb;
  for (int side = -1; side <= 1; side += 2)
    for (int k = 0; k <= LAST_WEIGHT; ++k)
      sum += u_weights[k] * texture(picture, texcoord + float(side * k) * pixel).rgb;
  return sum;
""",
     TRILINEAR: """
  float last = u_table_size - 1.0;
  vec3 texels = last * colour;
  texels += 0.5;
  return texture(table, texels / u_table_size).rgb;
""",
     TETRAHEDRAL: """
  vec3 place = clamp(colour, 0.0, 1.0) * (u_table_size - 1.0);
  ivec3 a = min(ivec3(floor(place)), ivec3(u_table_size) - 2);
  vec3 f = place - vec3(a);
  // How many of the other two fractions each one exceeds: 2 for the largest, 0 for the smallest.
  bool rg = f.r >= f.g, gb = f.g >= f.b, rb = f.r >= f.b;
  ivec3 rank = ivec3(int(rg) + int(rb), int(!rg) + int(gb), int(!rb) + int(!gb));
  vec3 order = vec3(0.0);  // the fractions, the smallest first
  for (int i = 0; i < 3; ++i) order[rank[i]] = f[i];
  vec3 corners[4];
  for (int i = 0; i < 4; ++i) corners[i] = texelFetch(table, a + ivec3(greaterThan(rank, ivec3(2 - i))), 0).rgb;
  vec4 shares = vec4(1.0, order.zyx) - vec4(order.zyx, 0.0);
  return mat4x3(corners[0], corners[1], corners[2], corners[3]) * shares;
""",
     DITHERED: """
  vec3 up = vec3(noise / 255.0), down = vec3(0.5 / 255.0);
  return stored + (up - down);
"""})
