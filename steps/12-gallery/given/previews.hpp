// The paintings of a gallery: pictures of the rooms behind them, recorded when they must be. Given.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "12-gallery/gallery.hpp"
#include "12-gallery/given/plan.hpp"
#include "12-gallery/given/room_styles.hpp"
#include "gl/objects.hpp"
#include "render/feature.hpp"

namespace atelier {

/// "preview.size", "preview.most", "preview.update", "preview.relief".
std::vector<SettingSpec> preview_settings();

/// The settings of step 06, with the heights of the rooms.
std::vector<SettingSpec> gallery_relief_settings();

/// The distance before a painting for which its preview shows what a portal would show, metres.
constexpr double preview_distance = 2.5;

constexpr float preview_far = 20;  ///< metres, from the eye of a preview's camera

/// Draws the rooms behind the paintings in view into their previews, before the frame. Must be listed after the
/// features that bind textures of materials.
class Previews : public Feature {
 public:
  explicit Previews(RoomStyles& styles) : styles_(styles) {}
  void configure(const Settings& settings) override;
  void prepare(Gl& gl, const Scene& scene) override;
  void moved(const Scene& scene) override;
  void draw_views(Gl& gl, const Scene& scene, const Viewpoint& viewpoint, ScenePainter& painter) override;
  bool wants_another_frame() const override { return more_wanted_ && most_ > 0; }
  Need need(const Scene& scene, const View& view, const Node& node) const override;
  void bind_material(Binder& binder, const Scene& scene, const Material& material) override;

 private:
  /// A painting, or the bedroom's door.
  struct Painting {
    int material = -1;  ///< index into Scene::materials; -1: the scene has no such painting
    glm::dmat4 frame{1};
    bool portal = false;  ///< shows its room as step 07 does
    int leads_to = 0;     ///< a room, or gallery::hall
    glm::dmat4 exit{1};
    std::array<GlTexture, 3> textures;  ///< by gallery::Map; owners of the names in `preview`
    GlFramebuffer framebuffer;
    gallery::Preview preview;
    gallery::PreviewState state;
  };
  bool in_view(const Painting& painting, const Viewpoint& viewpoint) const;
  void allocate(Gl& gl, Painting& painting);
  void turn_door();
  void record(Gl& gl, Painting& painting, const Viewpoint& viewpoint, bool stencil, ScenePainter& painter);

  RoomStyles& styles_;
  std::array<Painting, paintings_in_hall + 1> paintings_;  ///< the door is the last
  int size_ = 256, most_ = paintings_in_hall;
  bool relief_ = true, always_ = false;
  std::uint64_t version_ = 0;
  bool more_wanted_ = false;  ///< than the last frame was allowed to record
};

}  // namespace atelier
