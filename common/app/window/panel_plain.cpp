// The panel without Dear ImGui: prints each message once to the terminal.
#include <fmt/core.h>

#include "app/window/panel.hpp"

namespace atelier {

const int panel_width = 0;

namespace {

class PlainPanel : public Panel {
 public:
  double width(const PanelState&) const override { return 0; }
  bool wants_mouse() const override { return false; }
  bool wants_keyboard() const override { return false; }

  bool update(Viewer& viewer, PanelState& state) override {
    if (state.help) fmt::print("{}", state.keys);
    state.help = false;
    say(notice_, state.notice);
    say(drawing_, viewer.trouble.drawing);
    say(shaders_, viewer.trouble.shaders);
    say(code_, viewer.trouble.code);
    return false;
  }
  void draw() override {}

 private:
  static void say(std::string& said, const std::string& words) {
    if (words == said) return;
    said = words;
    if (!words.empty()) fmt::print(stderr, "{}\n", words);
  }
  std::string notice_, drawing_, shaders_, code_;
};

}  // namespace

std::unique_ptr<Panel> make_panel(Display&) {
  return std::make_unique<PlainPanel>();
}

}  // namespace atelier
