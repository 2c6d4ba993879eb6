#include "08-post-processing/given/cheat_sheet.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string_view>
#include <utility>

namespace atelier {

namespace {

// ---- What is written

struct SheetLine {
  std::array<std::string_view, 4> keys;  ///< "" where there are fewer
  std::string_view does;
};

/// '<', '>', '^' and '_' are arrows to the left, right, up and down.
constexpr std::array<SheetLine, 5> sheet_lines = {
    {{{"<", "^", "_", ">"}, "TURN"}, {{"SPACE"}, "SPIN"}, {{"TAB"}, "MENU"}, {{"S"}, "SAVE"}, {{"ESC"}, "QUIT"}}};

/// 7 rows of 5 dots, from the top; bit 4 of a row is its leftmost dot.
struct Glyph {
  char name;
  std::array<std::uint8_t, 7> rows;
};

constexpr std::array<Glyph, 18> sheet_font = {{
    {'A', {0x0E, 0x11, 0x11, 0x1F, 0x11, 0x11, 0x11}},
    {'B', {0x1E, 0x11, 0x11, 0x1E, 0x11, 0x11, 0x1E}},
    {'C', {0x0E, 0x11, 0x10, 0x10, 0x10, 0x11, 0x0E}},
    {'E', {0x1F, 0x10, 0x10, 0x1E, 0x10, 0x10, 0x1F}},
    {'I', {0x0E, 0x04, 0x04, 0x04, 0x04, 0x04, 0x0E}},
    {'M', {0x11, 0x1B, 0x15, 0x15, 0x11, 0x11, 0x11}},
    {'N', {0x11, 0x19, 0x15, 0x15, 0x13, 0x11, 0x11}},
    {'P', {0x1E, 0x11, 0x11, 0x1E, 0x10, 0x10, 0x10}},
    {'Q', {0x0E, 0x11, 0x11, 0x11, 0x15, 0x12, 0x0D}},
    {'R', {0x1E, 0x11, 0x11, 0x1E, 0x14, 0x12, 0x11}},
    {'S', {0x0F, 0x10, 0x10, 0x0E, 0x01, 0x01, 0x1E}},
    {'T', {0x1F, 0x04, 0x04, 0x04, 0x04, 0x04, 0x04}},
    {'U', {0x11, 0x11, 0x11, 0x11, 0x11, 0x11, 0x0E}},
    {'V', {0x11, 0x11, 0x11, 0x11, 0x11, 0x0A, 0x04}},
    {'<', {0x00, 0x04, 0x08, 0x1F, 0x08, 0x04, 0x00}},
    {'>', {0x00, 0x04, 0x02, 0x1F, 0x02, 0x04, 0x00}},
    {'^', {0x00, 0x04, 0x0E, 0x15, 0x04, 0x04, 0x00}},
    {'_', {0x00, 0x04, 0x04, 0x15, 0x0E, 0x04, 0x00}},
}};

// ---- Where, in dots, from the upper left corner; a dot is a square of `scale` x `scale` pixels

constexpr int letter_pitch = 6;                  ///< from one letter to the next: 5 dots and a gap
constexpr int cap_height = 11, line_pitch = 14;  ///< of a key; from one line to the next
constexpr int sheet_margin = 6;                  ///< around the panel, and between it and what is on it
constexpr int keys_width = 50, does_width = 23;  ///< of the column of four keys, and of four letters
constexpr glm::ivec2 panel_size{keys_width + does_width + 3 * sheet_margin,
                                (int(sheet_lines.size()) - 1) * line_pitch + cap_height + 2 * sheet_margin};

constexpr Rgba panel_colour{0.012f, 0.014f, 0.02f, 0.7f}, cap_side{0.05f, 0.055f, 0.07f, 1},
    cap_top{0.2f, 0.21f, 0.24f, 1}, cap_letters{0.9f, 0.9f, 0.9f, 1}, words_on_panel{0.6f, 0.68f, 0.8f, 1};

constexpr int cap_width(std::string_view key) {
  return int(key.size()) * letter_pitch + 5;
}

struct Sheet {
  Image image;
  int scale;
  glm::ivec2 origin;  ///< the panel's upper left corner, pixels

  /// Lays a colour over a pixel, both with their opacities, so much of it.
  void blend(const glm::ivec2& pixel, const Rgba& colour, float coverage) {
    Rgba& p = image.at(pixel.x, pixel.y);
    const float above = colour.a * coverage, below = p.a * (1 - above), opacity = above + below;
    if (above == 0) return;
    const auto mix = [&](float low, float high) { return (high * above + low * below) / opacity; };
    p = below == 0 ? Rgba{colour.r, colour.g, colour.b, above}
                   : Rgba{mix(p.r, colour.r), mix(p.g, colour.g), mix(p.b, colour.b), opacity};
  }

  /// A box with rounded corners; `radius` in dots. A pixel is covered by its distance from the outline, which is 1
  /// pixel wide.
  void box(const glm::ivec2& at, const glm::ivec2& size, int radius, const Rgba& colour) {
    const glm::ivec2 low = origin + at * scale, pixels = size * scale;
    const glm::vec2 half = 0.5f * glm::vec2(pixels);
    const float r = float(radius * scale);
    for (int y = 0; y < pixels.y; ++y)
      for (int x = 0; x < pixels.x; ++x) {
        const glm::vec2 q = glm::abs(glm::vec2(x, y) + 0.5f - half) - (half - r);
        const float distance = glm::length(glm::max(q, 0.0f)) + std::min(std::max(q.x, q.y), 0.0f) - r;
        blend(low + glm::ivec2(x, y), colour, std::clamp(0.5f - distance, 0.0f, 1.0f));
      }
  }

  void write(glm::ivec2 at, std::string_view text, const Rgba& colour) {
    for (const char letter : text) {
      const auto glyph = std::ranges::find(sheet_font, letter, &Glyph::name);
      for (int y = 0; glyph != sheet_font.end() && y < 7; ++y)
        for (int x = 0; x < 5; ++x)
          if (glyph->rows[std::size_t(y)] >> (4 - x) & 1) box(at + glm::ivec2(x, y), {1, 1}, 0, colour);
      at.x += letter_pitch;
    }
  }

  /// A key, as seen a little from the front.
  void cap(const glm::ivec2& at, std::string_view key) {
    box(at, {cap_width(key), cap_height}, 2, cap_side);
    box(at, {cap_width(key), cap_height - 1}, 2, cap_top);
    write(at + glm::ivec2(3, 2), key, cap_letters);
  }
};

}  // namespace

Image make_cheat_sheet(int width, int height) {
  const int scale = height / 240;
  Sheet sheet{.image = Image(width, height, {panel_colour.r, panel_colour.g, panel_colour.b, 0}),
              .scale = scale,
              .origin = {sheet_margin * scale, height - (sheet_margin + panel_size.y) * scale}};
  if (scale < 1 || width < (panel_size.x + 2 * sheet_margin) * scale) return std::move(sheet.image);
  sheet.box({0, 0}, panel_size, 4, panel_colour);
  glm::ivec2 at(sheet_margin);
  for (const SheetLine& line : sheet_lines) {
    for (const std::string_view key : line.keys) {
      if (key.empty()) continue;
      sheet.cap(at, key);
      at.x += cap_width(key) + 2;
    }
    sheet.write({2 * sheet_margin + keys_width, at.y + 2}, line.does, words_on_panel);
    at = {sheet_margin, at.y + line_pitch};
  }
  return std::move(sheet.image);
}

}  // namespace atelier
