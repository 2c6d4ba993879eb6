#include "08-post-processing/post_processing.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace atelier::post_processing {

// >>> student: what your functions below share, if anything
namespace {

/// The words of a line, separated by blanks and tabs.
std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; (at = line.find_first_not_of(" \t", at)) != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

template <class Number>
Number number_in(std::string_view word) {
  Number number{};
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (problem != std::errc() || end != word.data() + word.size() || !std::isfinite(double(number)))
    throw std::invalid_argument("not a number: " + std::string(word));
  return number;
}

/// Three numbers, from the word `first` on.
[[maybe_unused]] glm::vec3 colour_in(const std::vector<std::string_view>& words, std::size_t first) {
  if (words.size() != first + 3) throw std::invalid_argument("three numbers are wanted");
  return {number_in<float>(words[first]), number_in<float>(words[first + 1]), number_in<float>(words[first + 2])};
}

/// What stands between the quotes, of which there are two.
[[maybe_unused]] std::string title_in(std::string_view line) {
  const std::size_t first = line.find('"'), last = line.rfind('"');
  if (first == last || line.find('"', first + 1) != last || words_of(line.substr(0, first)).size() != 1 ||
      !words_of(line.substr(last + 1)).empty())
    throw std::invalid_argument("TITLE wants one text in quotes");
  return std::string(line.substr(first + 1, last - first - 1));
}

[[maybe_unused]] std::string text_of(const glm::vec3& colour) {
  std::string text;
  for (int i = 0; i < 3; ++i) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), colour[i]).ptr;
    text.append(i == 0 ? "" : " ").append(digits.data(), end);
  }
  return text;
}

}  // namespace
// --- skeleton
// <<< student

int next_target(int source) {
  // >>> student: the other one
  return source == 0 ? 1 : 0;
  // --- skeleton
  // | return source;
  // <<< student
}

void draw_full_screen(Gl& gl) {
  // >>> student: an empty vertex array, three vertices
  GLuint nothing = 0;
  gl.GenVertexArrays(1, &nothing);
  gl.BindVertexArray(nothing);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.BindVertexArray(0);
  gl.DeleteVertexArrays(1, &nothing);
  // --- skeleton
  // | static_cast<void>(gl);
  // <<< student
}

std::vector<Pass> passes_for(const Look& look) {
  // >>> student: those that change something, from light to display
  std::vector<Pass> passes;
  if (look.bloom != 0) passes.push_back(Pass::bloom);
  if (look.exposure != 0 || look.curve != 0) passes.push_back(Pass::tone);
  if (look.hue != std::floor(look.hue) || look.saturation != 1 || look.brightness != 1) passes.push_back(Pass::adjust);
  if (look.table) passes.push_back(Pass::table);
  if (look.overlay != 0) passes.push_back(Pass::overlay);
  return passes;
  // --- skeleton
  // | static_cast<void>(look);
  // | return {};
  // <<< student
}

std::vector<float> gaussian_weights(float sigma) {
  // >>> student: the bell, and what it sums to
  if (!(sigma > 0 && sigma <= 20)) throw std::invalid_argument("sigma must be above 0 and at most 20 pixels");
  std::vector<double> bell(std::size_t(std::ceil(3 * double(sigma))) + 1);
  double sum = 0;
  for (std::size_t k = 0; k < bell.size(); ++k) {
    bell[k] = std::exp(-0.5 * double(k * k) / (double(sigma) * double(sigma)));
    sum += k == 0 ? bell[k] : 2 * bell[k];
  }
  std::vector<float> weights;
  for (const double weight : bell) weights.push_back(float(weight / sum));
  return weights;
  // --- skeleton
  // | static_cast<void>(sigma);
  // | return {1};
  // <<< student
}

ColourTable read_table(std::string_view text) {
  // >>> student: line by line
  ColourTable table{.size = 0};
  bool has_title = false, has_low = false, has_high = false;
  const auto once = [&](bool& had) {
    if (had || !table.colours.empty()) throw std::invalid_argument("a keyword twice, or after the colours");
    had = true;
  };
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    const std::vector<std::string_view> words = words_of(line);
    if (words.empty() || words[0].starts_with('#')) continue;
    if (words[0] == "TITLE") {
      once(has_title);
      table.title = title_in(line);
    } else if (words[0] == "LUT_3D_SIZE") {
      bool had = table.size != 0;
      once(had);
      if (words.size() != 2) throw std::invalid_argument("LUT_3D_SIZE wants one number");
      table.size = number_in<int>(words[1]);
      if (table.size < 2 || table.size > 256) throw std::invalid_argument("LUT_3D_SIZE must be 2 to 256");
    } else if (words[0] == "DOMAIN_MIN") {
      once(has_low);
      table.low = colour_in(words, 1);
    } else if (words[0] == "DOMAIN_MAX") {
      once(has_high);
      table.high = colour_in(words, 1);
    } else {
      table.colours.push_back(colour_in(words, 0));
    }
  }
  const auto size = std::size_t(table.size);
  if (size == 0 || table.colours.size() != size * size * size)
    throw std::invalid_argument("a table of size n has n^3 colours");
  for (int i = 0; i < 3; ++i)
    if (!(table.low[i] < table.high[i])) throw std::invalid_argument("DOMAIN_MAX must be above DOMAIN_MIN");
  return table;
  // --- skeleton
  // | static_cast<void>(text);
  // | return {.size = 2, .colours = std::vector<glm::vec3>(8, glm::vec3(0.5f))};
  // <<< student
}

std::string write_table(const ColourTable& table) {
  // >>> student: the keywords that say something, then the colours
  std::string text;
  if (!table.title.empty()) text += "TITLE \"" + table.title + "\"\n";
  text += "LUT_3D_SIZE " + std::to_string(table.size) + "\n";
  if (table.low != glm::vec3(0)) text += "DOMAIN_MIN " + text_of(table.low) + "\n";
  if (table.high != glm::vec3(1)) text += "DOMAIN_MAX " + text_of(table.high) + "\n";
  for (const glm::vec3& colour : table.colours) text += text_of(colour) + "\n";
  return text;
  // --- skeleton
  // | static_cast<void>(table);
  // | return {};
  // <<< student
}

}  // namespace atelier::post_processing
