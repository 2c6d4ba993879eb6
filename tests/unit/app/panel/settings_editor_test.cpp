// The panel's controls, used by a mouse on a screen that is never shown.
#include "app/window/settings_editor.hpp"

#include <imgui.h>

#include "../fake_step.hpp"
#include "app/window/colour_codes.hpp"
#include "catch.hpp"
#include "gl/context.hpp"

namespace {

using namespace atelier;

constexpr float frame_seconds = 1 / 60.0f;

/// Dear ImGui without a display, over a viewer whose program has one setting of its own.
class Panel {
 public:
  explicit Panel(const SettingSpec& setting) : step_(test::bare_step({setting})) {
    viewer_.emplace(step_, context_->gl(), Implementations({{folder_.path(), ""}}), CommandLine{});
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = ImVec2(400, 200);
    io.DeltaTime = frame_seconds;
    unsigned char* pixels;
    int width, height;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);  // without it Dear ImGui draws nothing
    frame({-1, -1}, false);
  }
  ~Panel() { ImGui::DestroyContext(); }

  const SettingValue& value() const { return viewer_->settings().value("sky"); }

  /// Presses at `from`, moves on by `right` in steps of a hand, and lets go.
  void drag(ImVec2 from, float right) {
    frame(from, false);
    frame(from, true);
    for (float way = 0; way < right; way += 4) frame({from.x + way, from.y}, true);
    frame({from.x + right, from.y}, true);
    frame({from.x + right, from.y}, false);
  }

  /// Drags to the right in each line until one is found that changes the setting.
  void drag_its_first_field(float right) {
    const SettingValue before = value();
    for (float y = 2; y < 200 && value() == before; y += 6) drag({20, y}, right);
  }

 private:
  void frame(ImVec2 mouse, bool down) {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = mouse;
    io.MouseDown[0] = down;
    ImGui::NewFrame();
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(io.DisplaySize);
    ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize);
    edit_settings(*viewer_);
    ImGui::End();
    ImGui::Render();
  }

  TemporaryFolder folder_;
  std::unique_ptr<HeadlessContext> context_ = make_headless_context();
  SceneProgram step_;
  std::optional<Viewer> viewer_;
};

}  // namespace

TEST_CASE("a colour is edited by its codes, within its range, and only where it is touched", "[settings_editor]") {
  const struct {
    const char* name;
    double low, high;
    float right;  ///< how far the field of red is dragged: about a code for each pixel
    double red;   ///< then; 0: some other code than before
  } rows[] = {
      {"a little", 0, 1, 40, 0},
      {"to a screen's brightest", 0, 1, 360, 1},
      {"to the end of a range below that", 0, 0.3, 360, 0.3},
      {"to the end of a range beyond", 0, 1.5, 360, 1.5},
  };
  const Colour before(0.2, 1.0 / 4, 1e-9);
  for (const auto& row : rows) {
    INFO(row.name);
    Panel panel({.name = "sky", .fallback = before, .low = row.low, .high = row.high});
    panel.drag_its_first_field(row.right);
    const Colour after = std::get<Colour>(panel.value());
    INFO(setting_text(after));
    if (row.red > 0)
      CHECK(after.r == row.red);
    else
      CHECK((after.r > before.r && after.r == srgb_decode(codes_of(after).r / 255.0)));
    CHECK(after.g == before.g);
    CHECK(after.b == before.b);
  }
}

TEST_CASE("a colour that is not edited stays unchanged", "[settings_editor]") {
  Panel panel({.name = "sky", .fallback = Colour(0.2, 0.25, 1e-9), .low = 0, .high = 1});
  panel.drag_its_first_field(0);
  CHECK(panel.value() == SettingValue(Colour(0.2, 0.25, 1e-9)));
}
