// image/colour: the curve of the judge itself, codes, and L*a*b*.
#include "image/colour.hpp"
#include "image/compare.hpp"
#include "stability/common/rows.hpp"

namespace atelier::stability {

namespace {

long double exact_encode(long double x) {
  return x <= 0.0031308L ? 12.92L * x : 1.055L * std::exp(std::log(x) / 2.4L) - 0.055L;
}

void add_curve_rows(Table& table) {
  Group encode = table.of("srgb_encode (common)"), decode = table.of("srgb_decode (common)");
  encode.equals("0, 1, -1, infinity",
                [] {
                  return Values{srgb_encode(0.0), srgb_encode(1.0f), srgb_encode(-1.0), srgb_encode(double(infinite))};
                },
                {0, 1, -12.92, double(infinite)});
  encode.nan("NaN", [] { return Values{srgb_encode(double(not_a_number))}; });
  decode.nan("NaN", [] { return Values{srgb_decode(double(not_a_number))}; });
  const Bound rounded{1.01 * rounding_unit, "relative", "computed in double precision, rounded once"};
  encode.close("1000 values, 1e-30 to 1e30, in floats", rounded, [] {
    return worst_of(1000, 200, [](Trial& t) {
      const float x = float(t.size_between(1e-30, 1e30));
      return double(std::abs(((long double)srgb_encode(x) - exact_encode(x)) / exact_encode(x)));
    });
  });
  decode.close("1000 values, 1e-6 to 1e6, encoded first, in doubles",
               {4e-15, "relative", "a power of 2.4 counts a rounding of its double input so often, and a few more"},
               [] {
                 return worst_of(1000, 201, [](Trial& t) {
                   const double x = t.size_between(1e-6, 1e6);
                   return std::abs(srgb_decode(srgb_encode(x)) - x) / x;
                 });
               });
  Group codes = table.of("srgb_code");
  codes.equals("NaN, -1, 0, 1, 2, infinity",
               [] {
                 Values out;
                 for (const float x : {not_a_number, -1.0f, 0.0f, 1.0f, 2.0f, infinite}) out.push_back(srgb_code(x));
                 return out;
               },
               {0, 0, 0, 255, 255, 255});
  codes.equals("every code survives decoding and encoding",
               [] {
                 double wrong = 0;
                 for (int code = 0; code < 256; ++code) wrong += srgb_code(float(srgb_decode(code / 255.0))) != code;
                 return Values{wrong};
               },
               {0});
}

void add_encode_rows(Table& table) {
  Group group = table.of("encode_for_comparison");
  const Bound promised{1e-6, "absolute", "what the function promises"};
  group.close("a pixel of NaN, minus infinity, infinity: 0, 0, 1", promised, [] {
    const Rgba p = encode_for_comparison(Image(1, 1, {not_a_number, -infinite, infinite, not_a_number})).at(0, 0);
    return difference({double(p.r), double(p.g), double(p.b)}, {0, 0, 1});
  });
  for (const int width : {1, 3, 7, 8, 9, 33})
    group.close(fmt::format("{} pixels, which no vector divides: against the curve", width), promised, [=] {
      Image image(width, 1);
      for (int x = 0; x < width; ++x) image.at(x, 0).r = float(Trial(202, x).between(0, 1));
      const Image encoded = encode_for_comparison(image);
      double worst = 0;
      for (int x = 0; x < width; ++x)
        worst = std::max(worst, std::abs(double(encoded.at(x, 0).r) - double(exact_encode(image.at(x, 0).r))));
      return worst;
    });
  group.close("an exposure of 1e-30, and one of 1e30: black and white", promised, [] {
    const float dark = encode_for_comparison(Image(1, 1, {1, 1, 1, 1}), 1e-30f).at(0, 0).r;
    const float bright = encode_for_comparison(Image(1, 1, {1e-20f, 0, 0, 1}), 1e30f).at(0, 0).r;
    return difference({double(dark), double(bright)}, {0, 1});
  });
}

void add_lab_rows(Table& table) {
  Group group = table.of("xyz_to_lab");
  group.finite("black, negative, 1e30", [] {
    Values out;
    for (const float x : {0.0f, -1.0f, 1e30f, denormal}) {
      const Lab lab = xyz_to_lab(linear_to_xyz({x, x, x, 1}));
      out.insert(out.end(), {lab.l, lab.a, lab.b});
    }
    return out;
  });
  group.close("greys have no colour",
              {1e-12, "absolute", "the matrix is made so that white comes out white, in doubles; a counts 500 times"},
              [] {
                double worst = 0;
                for (const float grey : {1e-6f, 0.01f, 0.5f, 1.0f}) {
                  const Lab lab = xyz_to_lab(linear_to_xyz({grey, grey, grey, 1}));
                  worst = std::max({worst, std::abs(lab.a), std::abs(lab.b)});
                }
                return worst;
              });
}

}  // namespace

void add_colour_rows(Table& table) {
  add_curve_rows(table);
  add_encode_rows(table);
  add_lab_rows(table);
}

}  // namespace atelier::stability
