// What a gallery does not show costs nothing: previews that are up to date or out of view, lamps of other places,
// styles of none, portals that nobody asked for. What changes while it runs leaves nothing behind.
#include "catch.hpp"
#include "drawn.hpp"

using namespace atelier;
using namespace atelier::test;

namespace {

constexpr const char* gallery_step = "12-gallery";
using Choices = std::map<std::string, SettingValue>;

/// The hall: paintings 0, 1 and 5 are in view.
Case hall(Choices settings = {}) {
  return picture("gallery", std::move(settings));
}

/// Its wall between paintings 0 and 1, from close by.
Case wall(Choices settings = {}) {
  Case c = hall(std::move(settings));
  c.camera.eye = {-2.4, 1.6, -4.2};
  c.camera.target = {-3, 1.6, -5.2};
  return c;
}

Case room(int number, Choices settings = {}) {
  settings["gallery.room"] = number;
  return picture("gallery", std::move(settings));
}

std::int64_t at_rest(const char* count, const Case& c) {
  return counts_at_rest(gallery_step, c).at(count);
}

}  // namespace

TEST_CASE("a preview is recorded once, and again when it must be", "[required][12-gallery]") {
  const auto views = [](Choices settings) { return at_rest("views", hall(std::move(settings))); };
  CHECK(views({}) == 1);
  const SettingValue always = text("always");
  CHECK(views({{"preview.update", always}}) == 1 + 3 * 3);  // colours, normals, heights
  CHECK(views({{"preview.update", always}, {"preview.relief", false}}) == 1 + 3);
  CHECK(views({{"preview.update", always}, {"preview.most", 2}}) == 1 + 2 * 3);
  CHECK(views({{"preview.update", always}, {"preview.most", 0}}) == 1);
  CHECK(at_rest("views", wall({{"preview.update", always}})) == 1);  // no painting is in view
  const auto first = drawn(gallery_step, {hall(), wall(), hall({{"preview.most", 1}})});
  CHECK(first[0].counts.at("views") == 1 + 3 * 3);
  CHECK(first[1].counts.at("views") == 1);
  CHECK(first[2].counts.at("views") == 1 + 3);
}

TEST_CASE("frames that follow each other allocate nothing", "[required][12-gallery]") {
  for (const char* update : {"when-moved", "always"})
    for (const int portals : {0, 1})
      CHECK(at_rest("allocated_bytes", hall({{"preview.update", text(update)}, {"gallery.portals", portals}})) == 0);
  for (int number = 0; number < 6; ++number) CHECK(at_rest("allocated_bytes", room(number)) == 0);
}

TEST_CASE("previews of another size leave nothing behind", "[required][12-gallery]") {
  const auto all = drawn(gallery_step, {hall({{"preview.size", 64}}), hall({{"preview.size", 256}}),
                                        hall({{"preview.size", 17}}), hall({{"preview.size", 64}})});
  CHECK(all[0].counts.at("texture_bytes") == all[3].counts.at("texture_bytes"));
  CHECK(pixels_apart(all[0].picture, all[3].picture) == 0);
  CHECK(pixels_apart(all[0].picture, all[1].picture) > 0);
}

TEST_CASE("each place has its own lamp", "[required][12-gallery]") {
  for (const Case& c : {hall({{"preview.most", 0}}), room(0)}) {
    Case every_lamp = c;
    every_lamp.settings["light.cull"] = false;
    const auto both = drawn(gallery_step, {every_lamp, c});
    CHECK(both[0].counts.at("lights") == 2);
    CHECK(both[1].counts.at("lights") == 1);
    CHECK(both[1].counts.at("lights_culled") == 0);  // each of them shines somewhere
    CHECK(both[1].counts.at("lookups") == both[0].counts.at("lookups") - 1);
    CHECK(both[1].counts.at("draws") < both[0].counts.at("draws"));  // no caster of another place is in a lamp's cube
    // A cube that stores smaller distances stores them more exactly: a shadow's edge may be a pixel farther.
    CHECK(pixels_a_code_apart(both[0].picture, both[1].picture) <= 160 * 120 / 1000);
  }
}

TEST_CASE("a style costs its passes in its own room, and none in the hall", "[required][12-gallery]") {
  const auto passes = [](const Case& c) { return at_rest("passes", c); };
  const std::int64_t plain = passes(hall());
  CHECK(passes(hall({{"gallery.styles", false}})) == plain);
  CHECK(passes(room(0)) == plain);
  for (int number = 1; number < 6; ++number) {
    INFO("room " << number);
    CHECK(passes(room(number)) > plain);
    CHECK(passes(room(number, {{"gallery.styles", false}})) == plain);
    const auto as_it_is = drawn(gallery_step, {room(0), room(number, {{"gallery.styles", false}})});
    CHECK(pixels_apart(as_it_is[0].picture, as_it_is[1].picture) == 0);
  }
}

TEST_CASE("portals cost nothing where there are none, or none in view", "[required][12-gallery]") {
  CHECK(at_rest("target_bytes", hall({{"gallery.portals", 1}})) >= at_rest("target_bytes", hall()));
  CHECK(at_rest("views", hall({{"gallery.portals", 1}})) == 2);
  CHECK(at_rest("views", hall({{"gallery.portals", 6}})) == 4);
  CHECK(at_rest("views", wall({{"gallery.portals", 6}})) == 1);
  // A portal is a view through its scissor, whose room is not recorded.
  const auto portal = counts_at_rest(gallery_step, hall({{"gallery.portals", 1}}));
  CHECK(portal.at("view_pixels") < 160 * 120 + 160 * 120 / 8);
  CHECK(drawn(gallery_step, {hall({{"gallery.portals", 6}})})[0].counts.at("views") == 4);
}
