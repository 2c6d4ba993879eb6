// Views through portals and mirrors with the student's functions: which are drawn, from where, and how they are
// clipped. Given.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "07-stencil-portals/given/openings.hpp"
#include "case/settings.hpp"
#include "render/feature.hpp"

namespace atelier {

std::vector<SettingSpec> portal_settings();

class PortalViews : public Feature {
 public:
  void configure(const Settings& settings) override;
  void prepare(Gl& gl, const Scene& scene) override;
  bool needs_stencil(const Scene& scene) const override { return !scene.portals.empty(); }
  void moved(const Scene& scene) override;
  bool hides(const Scene& scene, const View& view, const Node& node) const override;
  void draw_inside(Gl& gl, const Scene& scene, const Viewpoint& around, const Target& target,
                   ScenePainter& painter) override;
  Need need(const Scene& scene, const View& view, const Node& node) const override;
  std::map<Slot, SlotCode> slots() const override;
  void bind_view(Binder& binder, const Scene& scene, const Viewpoint& viewpoint) override;

 private:
  enum class Clip { none, discard, distance, oblique };
  /// What the view through an opening begins at.
  struct Exit {
    int node = 0;
    glm::dvec4 plane{0};  ///< of the world: what is before it, on its negative side, is clipped
  };
  std::optional<glm::ivec4> rectangle_of(const Opening& opening, const Viewpoint& around, const Target& target) const;
  /// `plane` is the exit's: what stands before it is clipped.
  View view_through(const Opening& opening, const Viewpoint& around, const glm::dvec4& plane) const;
  static bool seen_from(const Exit& exit, const Opening& opening);
  void draw_opening(const Opening& opening, const Viewpoint& around, const Target& target, int item,
                    ScenePainter& painter);

  int deepest_ = 4, smallest_ = 1;
  int views_ = 0;  ///< inside the frame that is being drawn
  bool scissor_ = true;
  Clip clip_ = Clip::distance;
  std::vector<Opening> openings_;
  std::vector<Exit> exits_;     ///< of the views that are being drawn, the innermost last
  glm::mat4 projection_{1.0f};  ///< of the frame, shared by all views inside but for their near planes
};

}  // namespace atelier
