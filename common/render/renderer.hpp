// Draws scenes with the features that they need. Owns the programs and buffers.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "case/implementations.hpp"
#include "render/chain_runner.hpp"
#include "render/feature.hpp"
#include "render/placed_nodes.hpp"
#include "render/programs.hpp"
#include "render/sky.hpp"
#include "render/target_pool.hpp"
#include "render/transforms.hpp"

namespace atelier {

/// Options of the renderer itself.
struct RenderOptions {
  std::optional<ColourFormat> chain_format = {};  ///< of pictures between two passes; none: the target's format
  bool constants_as_varyings = false;             ///< instead of uniforms: DrawConstant
};

class Renderer : private ScenePainter {
 public:
  /// Shaders are searched in `implementations`, then among the renderer's own. `chain` runs the passes of features.
  Renderer(Gl& gl, Implementations implementations, TransformFunctions transforms,
           std::vector<std::unique_ptr<Feature>> features, ChainFunctions chain = {});

  /// Passes the settings to every feature.
  void configure(const Settings& settings, const RenderOptions& options = {});

  /// Uploads the scene, and frees the previous one. The scene must outlive its drawing.
  void prepare(const Scene& scene);

  /// Call it when nodes of the prepared scene have moved: matrices are cached until then (or, in a camera-relative
  /// view, until the eye moves).
  void nodes_moved();
  /// Call it when lights of the prepared scene have moved or changed.
  void lights_moved();

  /// Whether targets for the prepared scene need a stencil buffer.
  bool needs_stencil() const;

  /// Whether any feature has left something of the last frame for the next one.
  bool wants_another_frame() const;

  /// Clears the target to the background, draws the prepared scene and its sky, and runs the passes of the features. In
  /// an 8-bit target a NaN or infinite colour becomes magenta, as in a window: the format cannot store it. Throws
  /// ShaderError with source file and line, and Error if the view needs something that the driver or the target does
  /// not have.
  void render(const View& view, const Target& target);

  const SceneCounts& counts() const { return counts_; }  ///< of the last frame

  /// Rebuilds every program with a changed file. If one cannot be built, keeps the old one and returns the driver's
  /// log; otherwise returns an empty string.
  std::string reload_changed_shaders();

 private:
  /// The program of an item in views of one kind; null: not drawn.
  struct Variant {
    const SurfaceKey* key = nullptr;
    Program* program = nullptr;
  };
  /// Views of the same kind use the same programs.
  struct ViewKind {
    std::string output;
    bool clipped = false;
    bool cuts_openings = false;     ///< View::openings_clip_plane
    bool marks_non_finite = false;  ///< the target's format cannot store NaN and infinity
    auto operator<=>(const ViewKind&) const = default;
  };
  struct Drawing;

  SurfaceKey key_for(const View& view, const Node& node, const ViewKind& kind) const;
  const std::vector<Variant>& variants(const View& view, const Target& target);
  Viewpoint look(const View& view, const TargetSpec& target) const;
  bool hidden(const Item& item, const Viewpoint& viewpoint) const;
  void take_lights();
  void notify_moved();
  glm::vec3 background(const View& view) const;
  std::optional<glm::vec3> background_of_features(const View& view) const;
  std::vector<ChainPass> passes(const View& view) const;

  void draw_with_chain(const View& view, const Target& target);
  void draw_scene(const View& view, const Target& target);
  void draw_before(const Viewpoint& viewpoint, const Target& target);
  void begin(const Viewpoint& viewpoint, const Target& target);
  void set_bounds(const Viewpoint& viewpoint, const Target& target);
  void draw_nodes(const Viewpoint& viewpoint, const Target& target);
  void draw_sky(const Viewpoint& viewpoint);
  void use(const Variant& variant, Drawing& drawing);
  void draw(const Item& item, const Variant& variant, Drawing& drawing);
  bool drawn_instead(const View& view, const Target& target);
  void paint_opening(const Viewpoint& around, int opening, const glm::vec3& colour);

  std::span<const Item> items() const override { return nodes_->items(); }
  void paint(const PassSources& pass, std::span<const int> items, const std::function<void(Binder&)>& bind) override;
  void draw_view(const View& view, const Target& target) override;
  TargetPool& targets() override { return pool_; }
  void draw_view_inside(View view, const Viewpoint& around, const Target& target, int opening,
                        const NestingFunctions& functions) override;
  void fill_opening(const Viewpoint& around, const Target& target, int opening, const glm::vec3& colour) override;

  Gl& gl_;
  TransformFunctions transforms_;
  ChainFunctions chain_functions_;
  std::vector<std::unique_ptr<Feature>> features_;
  Programs programs_;
  TargetPool pool_;
  ChainRunner chain_;
  RenderOptions options_;

  const Scene* scene_ = nullptr;
  std::vector<Light> lights_;         ///< of the scene, then of features
  std::optional<PlacedNodes> nodes_;  ///< of the prepared scene
  std::unique_ptr<Skybox> skybox_;    ///< of the prepared scene; null: it has no sky
  SceneCounts counts_;
  bool mirrored_ = false;  ///< of the view that is being drawn

  std::map<ViewKind, std::vector<Variant>> variants_;  ///< item by item
  std::uint64_t variants_version_ = 0;  ///< sum of the features' structure versions for which variants_ was computed
};

}  // namespace atelier
