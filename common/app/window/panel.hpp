// What lies over and beside the picture: the settings panel, messages, help. Two implementations, chosen by the build:
// Dear ImGui (panel_imgui.cpp), or none where the library is missing (panel_plain.cpp: title bar and terminal).
#pragma once

#include <memory>
#include <string>

#include "app/window/display.hpp"
#include "app/window/viewer.hpp"

namespace atelier {

/// The panel's width in units of text design: about forty letters; 0 where there is none.
extern const int panel_width;

/// What the panel knows beyond the viewer.
struct PanelState {
  bool visible = true;  ///< the panel itself; messages show anyway
  bool help = false;
  std::string notice;  ///< one line that fades: "saved frame.png"
};

class Panel {
 public:
  virtual ~Panel() = default;

  /// The width that the panel takes from the right of the window, in window units; 0 where it is hidden or there is
  /// none.
  virtual double width(const PanelState& state) const = 0;

  /// Whether mouse or keyboard are at work in the panel and not in the picture.
  virtual bool wants_mouse() const = 0;
  virtual bool wants_keyboard() const = 0;

  /// Builds this round's panel; changes the viewer as the user's hands say. True while it moves by itself.
  virtual bool update(Viewer& viewer, PanelState& state) = 0;
  /// Draws what `update` has built into the window's framebuffer.
  virtual void draw() = 0;
};

/// After the display's own callbacks are set, which it leaves in place. The display must outlive it.
std::unique_ptr<Panel> make_panel(Display& display);

}  // namespace atelier
