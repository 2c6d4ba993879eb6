// write_table: every float, all ranges, tables of 2 to 64 grid points a side. The text of 256 would have half a
// gigabyte.
#include <cstring>

#include "stability/08-post-processing/rows.hpp"

namespace atelier::stability {

using post_processing::ColourTable;
using post_processing::read_table;
using post_processing::write_table;

namespace {

/// Any float that is finite, from random bits: sizes of 1e-45 to 3e38, both signs.
float any_float(Trial& t) {
  for (;;) {
    const auto bits = std::uint32_t(t.between(0, 0x1p32));
    float value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (std::isfinite(value)) return value;
  }
}

glm::vec3 any_colour(Trial& t) {
  const float r = any_float(t), g = any_float(t);
  return {r, g, any_float(t)};
}

ColourTable random_table(int size) {
  ColourTable table{.size = size};
  for (int i = 0; i < size * size * size; ++i) {
    Trial t(930, i);
    table.colours.push_back(any_colour(t));
  }
  return table;
}

/// How many of its members are not the very same after writing and reading.
double changed_by_writing(const ColourTable& table) {
  const ColourTable back = read_table(write_table(table));
  double changed = double(back.title != table.title) + double(back.size != table.size) + double(back.low != table.low) +
                   double(back.high != table.high) + double(back.colours.size() != table.colours.size());
  for (std::size_t i = 0; i < std::min(table.colours.size(), back.colours.size()); ++i)
    changed += std::memcmp(&table.colours[i], &back.colours[i], sizeof(glm::vec3)) != 0;
  return changed;
}

double count_words(const std::string& text, const std::string& word) {
  double count = 0;
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += word.size()) ++count;
  return count;
}

/// How often its text has DOMAIN_MIN, DOMAIN_MAX and TITLE.
Values keywords_of(const ColourTable& table) {
  const std::string text = write_table(table);
  return {count_words(text, "DOMAIN_MIN"), count_words(text, "DOMAIN_MAX"), count_words(text, "TITLE")};
}

}  // namespace

void add_write_rows(Table& table) {
  Group group = table.of("read_table(write_table)");
  for (const int size : {2, 3, 17, 64})
    group.equals(fmt::format("{} grid points a side, floats of random bits: what changes", size),
                 [=] { return Values{changed_by_writing(random_table(size))}; }, {0});
  group.equals("1000 random ranges of 1e-30 to 1e30 beside 0: what changes",
               [] {
                 return Values{worst_of(1000, 931, [](Trial& t) {
                   ColourTable some = random_table(2);
                   for (int i = 0; i < 3; ++i) {
                     some.low[i] = float(-t.size_between(1e-30, 1e30));
                     some.high[i] = float(t.size_between(1e-30, 1e30));
                   }
                   return changed_by_writing(some);
                 })};
               },
               {0});
  group.equals("ranges of a float, of denormals, and of all floats: what changes",
               [] {
                 Values changed;
                 for (const auto& [low, high] : {std::pair{1.0f, std::nextafter(1.0f, 2.0f)},
                                                 {-0.0f, 0x1p-149f},
                                                 {denormal, 2 * denormal},
                                                 {-largest_float, largest_float}}) {
                   ColourTable some = random_table(2);
                   some.low = glm::vec3(low), some.high = glm::vec3(high);
                   changed.push_back(changed_by_writing(some));
                 }
                 return changed;
               },
               {0, 0, 0, 0});
  group.equals("titles of blanks, tabs, signs, other alphabets and 10000 characters: what changes",
               [] {
                 Values changed;
                 for (const std::string& title : {std::string(), std::string(" "), std::string("\t a  b "),
                                                  std::string("# LUT_3D_SIZE 3"), std::string("1 2 3"),
                                                  std::string("Gr\xC3\xBC\xC3\x9F"
                                                              "e"),
                                                  std::string(10'000, 'x')}) {
                   ColourTable some = random_table(2);
                   some.title = title;
                   changed.push_back(changed_by_writing(some));
                 }
                 return changed;
               },
               {0, 0, 0, 0, 0, 0, 0});

  Group written = table.of("write_table");
  const auto ranged = [](const glm::vec3& low, const glm::vec3& high) {
    ColourTable some{.size = 2, .low = low, .high = high};
    some.colours.assign(8, glm::vec3(0.5f));
    return some;
  };
  const glm::vec3 zero(0), one(1);
  written.equals("the default range, no title: DOMAIN_MIN, DOMAIN_MAX, TITLE",
                 [=] { return keywords_of(ranged(zero, one)); }, {0, 0, 0});
  written.equals("one component of the lower end is a denormal",
                 [=] {
                   return keywords_of(ranged({0, 0, denormal}, one));
                 },
                 {1, 0, 0});
  written.equals("one component of the upper end is a float above 1",
                 [=] {
                   return keywords_of(ranged(zero, {1, std::nextafter(1.0f, 2.0f), 1}));
                 },
                 {0, 1, 0});
  written.equals("a title of one blank",
                 [=] {
                   ColourTable titled = ranged(zero, one);
                   titled.title = " ";
                   return keywords_of(titled);
                 },
                 {0, 0, 1});
  written.equals("64 grid points a side: lines that are neither empty nor comments",
                 [] {
                   const std::string text = "\n" + write_table(random_table(64));
                   double lines = 0;
                   for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; ++at)
                     lines += at + 1 < text.size() && text[at + 1] != '\n' && text[at + 1] != '#';
                   return Values{lines};
                 },
                 {64 * 64 * 64 + 1});
}

}  // namespace atelier::stability
