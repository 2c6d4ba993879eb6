// The settings panel, messages and help. Two implementations, chosen by the build: Dear ImGui (panel_imgui.cpp), or a
// fallback without the library (panel_plain.cpp: title bar and terminal).
#pragma once

#include <memory>
#include <string>

#include "app/window/controls.hpp"
#include "app/window/display.hpp"
#include "app/window/viewer.hpp"

namespace atelier {

/// The panel's width before scaling: about forty letters; 0 without panel.
extern const int panel_width;

/// The panel's state beside the viewer.
struct PanelState {
  bool visible = true;  ///< of the panel; messages are always visible
  bool help = false;
  const char* keys = keys_help;  ///< what the help says
  std::string notice;            ///< one line that fades: "saved frame.png"
};

class Panel {
 public:
  virtual ~Panel() = default;

  /// The width of the panel at the right of the window, in window units; 0 if it is hidden or there is none.
  virtual double width(const PanelState& state) const = 0;

  /// Whether the panel uses mouse or keyboard input.
  virtual bool wants_mouse() const = 0;
  virtual bool wants_keyboard() const = 0;

  /// Builds the panel for this frame; applies the user's changes to the viewer. True while it is animated.
  virtual bool update(Viewer& viewer, PanelState& state) = 0;
  /// Draws the panel of `update` into the window's framebuffer.
  virtual void draw() = 0;
};

/// Chains to the display's callbacks. The display must outlive the panel.
std::unique_ptr<Panel> make_panel(Display& display);

}  // namespace atelier
