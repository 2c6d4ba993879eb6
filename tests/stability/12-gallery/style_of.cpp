// style_of: the hall, the six rooms, the numbers next to them and at both ends of their range.
#include "stability/12-gallery/rows.hpp"

namespace atelier::stability {

using namespace gallery;

void add_style_rows(Table& table) {
  Group group = table.of("style_of");
  group.equals("rooms 0 to 5: the styles in their order",
               [] {
                 Values styles;
                 for (int room = 0; room < 6; ++room) styles.push_back(double(style_of(room)));
                 return styles;
               },
               {0, 1, 2, 3, 4, 5});
  for (const int room : {least_int, least_int + 1, -256, -2, hall, 6, 7, 256, largest_int - 1, largest_int})
    group.equals(fmt::format("room {}: none", room), [=] { return Values{double(style_of(room))}; },
                 {double(Style::none)});
}

}  // namespace atelier::stability
