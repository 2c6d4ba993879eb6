// passes_for: all combinations of what changes a picture and what does not, and the least and largest amounts.
#include "stability/08-post-processing/rows.hpp"

namespace atelier::stability {

using namespace post_processing;

namespace {

Values numbers_of(const std::vector<Pass>& passes) {
  Values numbers;
  for (const Pass pass : passes) numbers.push_back(double(pass));
  return numbers;
}

/// The passes for a look that is plain but for what `change` does to it.
template <class Change>
Values passes_with(Change change) {
  Look look;
  change(look);
  return numbers_of(passes_for(look));
}

/// How many of 1152 looks get other passes than those that they need.
double wrong_passes() {
  double wrong = 0;
  for (const float bloom : {0.0f, 0.5f})
    for (const float exposure : {0.0f, -3.0f, 1.0f})
      for (const int curve : {0, 1, 2})
        for (const float hue : {0.0f, -2.0f, 0.25f, 1.5f})
          for (const float saturation : {1.0f, 0.0f})
            for (const float brightness : {1.0f, 2.0f})
              for (const bool has_table : {false, true})
                for (const float overlay : {0.0f, 1.0f}) {
                  const std::array<bool, 5> wanted = {bloom > 0, exposure != 0 || curve > 0,
                                                      hue == 0.25f || hue == 1.5f || saturation != 1 || brightness != 1,
                                                      has_table, overlay > 0};
                  Values expected;
                  for (std::size_t pass = 0; pass < wanted.size(); ++pass)
                    if (wanted[pass]) expected.push_back(double(pass));
                  wrong += numbers_of(passes_for(
                               {bloom, exposure, curve, hue, saturation, brightness, has_table, overlay})) != expected;
                }
  return wrong;
}

}  // namespace

void add_passes_rows(Table& table) {
  Group group = table.of("passes_for");
  group.equals("1152 looks: other passes than needed, or in another order", [] { return Values{wrong_passes()}; }, {0});
  for (const float turns : {-2.0f, 1e6f, -16777216.0f, 1e30f, -0.0f})
    group.equals(fmt::format("{:g} turns: whole ones", turns),
                 [=] { return passes_with([=](Look& look) { look.hue = turns; }); }, {});
  for (const float turns : {denormal, 1 - 0x1p-24f, -0x1p-24f, 4194304.5f})
    group.equals(fmt::format("{:.9g} turns", turns), [=] { return passes_with([=](Look& look) { look.hue = turns; }); },
                 {double(Pass::adjust)});
  for (const float factor : {0.0f, denormal, 1 - 0x1p-24f, 1 + 0x1p-23f, 1e30f}) {
    group.equals(fmt::format("a saturation of {:.9g}", factor),
                 [=] { return passes_with([=](Look& look) { look.saturation = factor; }); }, {double(Pass::adjust)});
    group.equals(fmt::format("a brightness of {:.9g}", factor),
                 [=] { return passes_with([=](Look& look) { look.brightness = factor; }); }, {double(Pass::adjust)});
  }
  group.equals("amounts of -0",
               [] { return passes_with([](Look& look) { look.bloom = look.exposure = look.overlay = -0.0f; }); }, {});
  for (const float amount : {1e-30f, 1e30f}) {
    group.equals(fmt::format("a bloom of {:g}", amount),
                 [=] { return passes_with([=](Look& look) { look.bloom = amount; }); }, {double(Pass::bloom)});
    group.equals(fmt::format("an overlay of {:g}", std::min(amount, 1.0f)),
                 [=] { return passes_with([=](Look& look) { look.overlay = std::min(amount, 1.0f); }); },
                 {double(Pass::overlay)});
  }
  group.equals("126 stops down, and up",
               [] {
                 return Values{passes_with([](Look& look) { look.exposure = -126; })[0],
                               passes_with([](Look& look) { look.exposure = 126; })[0]};
               },
               {double(Pass::tone), double(Pass::tone)});
}

}  // namespace atelier::stability
