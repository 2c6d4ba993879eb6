// The panel with Dear ImGui: scene, output, settings, statistics on the right; messages and help over the picture.
#include <fmt/core.h>
#include <imgui.h>

#if __has_include(<backends/imgui_impl_glfw.h>)
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#else
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>
#endif

#include <algorithm>
#include <cmath>

#include "app/window/panel.hpp"
#include "app/window/settings_editor.hpp"
#include "base/error.hpp"

namespace atelier {

const int panel_width = 290;

namespace {

constexpr float font_units = 13;  ///< design size of the built-in bitmap font

constexpr ImGuiWindowFlags fixed_window = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                          ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoTitleBar |
                                          ImGuiWindowFlags_NoSavedSettings;

class ImGuiPanel : public Panel {
 public:
  explicit ImGuiPanel(Display& display) : scale_(float(display.text_scale())) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // do not write a file into the student's folder
    dress();
    // GLSL 150 (OpenGL 3.2) is the lowest version that a core context accepts on every system.
    if (!ImGui_ImplGlfw_InitForOpenGL(display.handle(), true) || !ImGui_ImplOpenGL3_Init("#version 150")) {
      ImGui::DestroyContext();
      throw Error("the settings panel cannot be drawn with this OpenGL driver: draw into a file with --out FILE.png");
    }
  }
  ~ImGuiPanel() override {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
  }

  double width(const PanelState& state) const override { return state.visible ? double(panel_width) * scale_ : 0; }
  bool wants_mouse() const override { return ImGui::GetIO().WantCaptureMouse; }
  bool wants_keyboard() const override { return ImGui::GetIO().WantTextInput; }

  bool update(Viewer& viewer, PanelState& state) override {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    if (state.visible) side_panel(viewer, state);
    messages(viewer, state);
    if (state.help) help(state);
    ImGui::Render();
    return ImGui::GetIO().WantTextInput;  // a blinking cursor
  }

  void draw() override { ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData()); }

 private:
  void dress() const;
  void side_panel(Viewer& viewer, PanelState& state) const;
  void statistics(Viewer& viewer) const;
  void messages(const Viewer& viewer, const PanelState& state) const;
  void help(PanelState& state) const;
  float picture_width(const PanelState& state) const { return ImGui::GetIO().DisplaySize.x - float(width(state)); }

  float scale_;
};

void ImGuiPanel::dress() const {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowBorderSize = 0;
  style.FrameRounding = 3;
  style.WindowPadding = ImVec2(10, 10);
  style.ItemSpacing = ImVec2(8, 5);
  style.Colors[ImGuiCol_WindowBg] = ImVec4(0.11f, 0.115f, 0.125f, 1);
  style.ScaleAllSizes(scale_);
  // Rasterise the font in its final size: a scaled bitmap would blur.
  ImFontConfig font;
  font.SizePixels = std::max(font_units, std::round(font_units * scale_));
  ImGui::GetIO().Fonts->AddFontDefault(&font);
}

void ImGuiPanel::side_panel(Viewer& viewer, PanelState& state) const {
  const ImVec2 all = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(picture_width(state), 0));
  ImGui::SetNextWindowSize(ImVec2(float(width(state)), all.y));
  ImGui::Begin("panel", nullptr, fixed_window);
  ImGui::PushItemWidth(150 * scale_);
  ImGui::TextWrapped("%s", viewer.description().title.c_str());
  ImGui::Separator();
  if (const auto scene = edit_choice("scene", viewer.scene(), viewer.description().scenes); !scene.empty())
    viewer.choose_scene(scene);
  std::vector<std::string> outputs;
  for (const OutputSpec& spec : viewer.description().outputs) outputs.push_back(spec.name);
  if (const auto output = edit_choice("output", viewer.output(), outputs); !output.empty())
    viewer.choose_output(output);
  edit_settings(viewer);
  if (bool playing = viewer.playing(); ImGui::Checkbox("run the animation", &playing)) viewer.play(playing);
  if (ImGui::Button("Help (H)", ImVec2(-1, 0))) state.help = !state.help;
  statistics(viewer);
  ImGui::PopItemWidth();
  ImGui::End();
}

void ImGuiPanel::statistics(Viewer& viewer) const {
  if (!ImGui::CollapsingHeader("statistics", ImGuiTreeNodeFlags_DefaultOpen)) return;
  const glm::dvec3 eye = viewer.camera().eye;
  const double milliseconds = viewer.frame_seconds() * 1e3;
  ImGui::TextUnformatted(fmt::format("{:<16} {:>11}\n{:<16} {:.3g} {:.3g} {:.3g}", "frame, ms",
                                     milliseconds > 0 ? fmt::format("{:.2f}", milliseconds) : "-", "eye, m", eye.x,
                                     eye.y, eye.z)
                             .c_str());
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8 * scale_, scale_));
  for (const CostRow& row : cost_rows(viewer.cost())) {
    ImGui::TextUnformatted(fmt::format("{:<16} {:>11}", row.name, row.value).c_str());
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", row.meaning);
  }
  ImGui::PopStyleVar();
}

void ImGuiPanel::messages(const Viewer& viewer, const PanelState& state) const {
  const Trouble& trouble = viewer.trouble;
  if (!trouble.any() && state.notice.empty()) return;
  ImGui::SetNextWindowPos(ImVec2(8 * scale_, 8 * scale_));
  ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0), ImVec2(std::max(picture_width(state) - 16 * scale_, 100.0f),
                                                           ImGui::GetIO().DisplaySize.y - 16 * scale_));
  ImGui::SetNextWindowBgAlpha(0.85f);
  ImGui::Begin("messages", nullptr, fixed_window | ImGuiWindowFlags_AlwaysAutoResize);
  ImGui::PushTextWrapPos(std::max(picture_width(state) - 36 * scale_, 80.0f));
  const auto say = [](const char* title, const std::string& words) {
    if (words.empty()) return;
    ImGui::TextColored(ImVec4(1, 0.45f, 0.35f, 1), "%s", title);
    ImGui::TextUnformatted(words.c_str());
  };
  say("The scene cannot be drawn; the picture is the last good one:", trouble.drawing);
  say("A shader does not compile; the picture uses the last good one:", trouble.shaders);
  say("The new code cannot be loaded; the old code is still running:", trouble.code);
  if (!state.notice.empty()) ImGui::TextUnformatted(state.notice.c_str());
  ImGui::PopTextWrapPos();
  ImGui::End();
}

void ImGuiPanel::help(PanelState& state) const {
  ImGui::SetNextWindowPos(ImVec2(picture_width(state) / 2, ImGui::GetIO().DisplaySize.y / 2), ImGuiCond_Always,
                          ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowBgAlpha(0.92f);
  ImGui::Begin("help", nullptr, fixed_window | ImGuiWindowFlags_AlwaysAutoResize);
  std::string line;
  for (const char* letter = state.keys; *letter; ++letter) {
    if (*letter == '\t') {
      ImGui::TextUnformatted(line.c_str());
      ImGui::SameLine(170 * scale_);
      line.clear();
    } else if (*letter == '\n') {
      ImGui::TextUnformatted(line.c_str());
      line.clear();
    } else {
      line += *letter;
    }
  }
  ImGui::End();
}

}  // namespace

std::unique_ptr<Panel> make_panel(Display& display) {
  return std::make_unique<ImGuiPanel>(display);
}

}  // namespace atelier
