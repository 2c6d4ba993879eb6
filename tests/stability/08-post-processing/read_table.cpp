// read_table: numbers at the ends of a float's range, sizes that are none, texts that are broken off.
#include "stability/08-post-processing/rows.hpp"

namespace atelier::stability {

using post_processing::ColourTable;
using post_processing::read_table;

namespace {

/// `count` times the line.
std::string repeated(const std::string& line, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += line;
  return text;
}

/// A table of 2 grid points a side whose colours all have this line, with other lines before them.
std::string cube_text(const std::string& head, const std::string& line = "0 0.5 1\n") {
  return head + "LUT_3D_SIZE 2\n" + repeated(line, 8);
}

Values first_colour(const std::string& text) {
  const ColourTable table = read_table(text);
  return values(table.colours.at(0));
}

}  // namespace

void add_read_rows(Table& table) {
  Group group = table.of("read_table");
  group.equals("numbers at the ends of a float's range",
               [] { return first_colour(cube_text("", "3.4028235e38 1.17549435e-38 -3.4028235e+38\n")); },
               {double(largest_float), 0x1p-126, -double(largest_float)});
  group.equals("denormal numbers and -0", [] { return first_colour(cube_text("", "1e-40 1.4e-45 -0\n")); },
               {double(denormal), 0x1p-149, 0});
  group.equals("100 digits, and numbers without a digit before or behind the point",
               [] { return first_colour(cube_text("", "0." + repeated("3", 98) + " .5 2.\n")); },
               {double(float(1.0 / 3)), 0.5, 2});
  group.equals("a range of 1e-30 to 1e30",
               [] {
                 const ColourTable read =
                     read_table(cube_text("DOMAIN_MIN 1e-30 -1e30 0\nDOMAIN_MAX 1e30 -1e-30 1e-30\n"));
                 return all_values(std::array{read.low, read.high});
               },
               {double(1e-30f), -double(1e30f), 0, double(1e30f), -double(1e-30f), double(1e-30f)});
  group.equals("a range of one float: its ends",
               [] {
                 const ColourTable read =
                     read_table(cube_text("DOMAIN_MIN 1 1 1\nDOMAIN_MAX 1.00000012 1.00000012 1.00000012\n"));
                 return Values{double(read.low.r), double(read.high.r)};
               },
               {1, 1 + 0x1p-23});
  group.equals("all keywords, blanks, tabs, comments, CR LF, no last line end: the size and the number of colours",
               [] {
                 const ColourTable read =
                     read_table("# a comment\r\n\r\n \tTITLE  \"a # \t b\" \r\nLUT_3D_SIZE\t2 \r\n" +
                                repeated("\t0  0.5\t1 \r\n# another\r\n", 7) + "0 0.5 1");
                 return Values{double(read.size), double(read.colours.size()), double(read.title == "a # \t b")};
               },
               {2, 8, 1});
  group.equals("a comment of a million characters",
               [] { return first_colour(cube_text("#" + std::string(1'000'000, 'x') + "\n")); }, {0, 0.5, 1});
  group.equals(
      "64 grid points a side: the colours",
      [] { return Values{double(read_table("LUT_3D_SIZE 64\n" + repeated("0 1 0\n", 64 * 64 * 64)).colours.size())}; },
      {64 * 64 * 64});

  for (const char* size : {"1", "0", "-1", "257", "2147483649", "99999999999999999999", "2.5", "2e0", "two", "", "2 2"})
    group.refuses(fmt::format("a size of '{}'", size),
                  [=] { read_table(fmt::format("LUT_3D_SIZE {}\n", size) + repeated("0 0 0\n", 8)); });
  group.refuses("256 grid points a side and one colour", [] { read_table("LUT_3D_SIZE 256\n0 0 0\n"); });
  for (const int lines : {0, 7, 9})
    group.refuses(fmt::format("2 grid points a side and {} colours", lines),
                  [=] { read_table("LUT_3D_SIZE 2\n" + repeated("0 0 0\n", lines)); });
  for (const char* number : {"nan", "inf", "-inf", "1e39", "-1e39", "1e999999999", "1,5", "0.5f", "1e", "--1", "one"})
    group.refuses(fmt::format("a number of '{}'", number),
                  [=] { read_table(cube_text("", fmt::format("0 {} 0\n", number))); });
  for (const char* line : {"0", "0 0", "0 0 0 0"})
    group.refuses(fmt::format("colours of '{}'", line), [=] { read_table(cube_text("", fmt::format("{}\n", line))); });
  for (const char* head :
       {"LUT_1D_SIZE 2\n", "LUT_3D_SIZE 2\n", "lut_3d_size 2\n", "SOMETHING 1\n", "TITLE none\n", "TITLE \"open\n",
        "TITLE \"a\" b\n", "TITLE \"a\"\nTITLE \"b\"\n", "DOMAIN_MIN 0 0\n", "DOMAIN_MAX 1 1 1 1\n",
        "DOMAIN_MIN 0 0 nan\n", "DOMAIN_MAX 1 inf 1\n", "DOMAIN_MIN 1 1 1\n", "DOMAIN_MAX 1 0 1\n",
        "DOMAIN_MIN 2 2 2\nDOMAIN_MAX 1 3 3\n", "DOMAIN_MIN 0 0 0\nDOMAIN_MIN 0 0 0\n"})
    group.refuses(
        fmt::format("before the size: {}", std::string_view(head).substr(0, std::string_view(head).find('\n'))),
        [=] { read_table(cube_text(head)); });
  group.refuses("a keyword behind the colours", [] { read_table(cube_text("") + "DOMAIN_MIN 0 0 0\n"); });
  group.refuses("colours without a size", [] { read_table(repeated("0 0 0\n", 8)); });
  group.refuses("no text", [] { read_table(""); });
  group.refuses("a text of zero bytes", [] { read_table(std::string(1000, '\0')); });
  group.refuses("a zero byte in a number", [] { read_table(cube_text("", std::string("0 0\0 0\n", 7))); });
}

}  // namespace atelier::stability
