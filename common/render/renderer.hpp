// Draws scenes with the features that they require. Sole owner of the programs and buffers that this takes.
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
#include "render/target_pool.hpp"
#include "render/transforms.hpp"

namespace atelier {

/// What is asked of the drawing itself, and not of a feature.
struct RenderOptions {
  std::optional<ColourFormat> chain_format = {};  ///< of pictures between two passes; none: the target's
  bool constants_as_varyings = false;             ///< not as uniforms: DrawConstant
};

class Renderer : private ScenePainter {
 public:
  /// Shaders are found along `implementations`, then among the renderer's own. `chain` is what runs the passes of
  /// features that have some.
  Renderer(Gl& gl, Implementations implementations, TransformFunctions transforms,
           std::vector<std::unique_ptr<Feature>> features, ChainFunctions chain = {});

  /// Hands the settings to every feature.
  void configure(const Settings& settings, const RenderOptions& options = {});

  /// Uploads what the scene needs, once; frees what the scene before it needed. The scene must outlive its drawing.
  void prepare(const Scene& scene);

  /// To be called where nodes of the prepared scene have moved: matrices are computed once and kept until then (or,
  /// where the view is camera-relative, until the eye moves).
  void nodes_moved();
  /// To be called where lights of the prepared scene have moved or changed.
  void lights_moved();

  /// Whether targets for the prepared scene need a stencil buffer.
  bool needs_stencil() const;

  /// Clears the target to the background, draws the prepared scene and runs the passes of the features. In a target of
  /// 8 bits a colour that is no number or infinite becomes magenta, as a window shows it: the format would hide it.
  /// Throws ShaderError with the author's file and line, Error where the view asks what the driver or the target lacks.
  void render(const View& view, const Target& target);

  const SceneCounts& counts() const { return counts_; }  ///< of the last frame

  /// Builds anew every program one of whose files has changed. Where one cannot be built, the old one stays and the
  /// driver's words are returned; otherwise an empty string.
  std::string reload_changed_shaders();

 private:
  /// What an item is drawn with in views of one kind; no program: it is left out.
  struct Variant {
    const SurfaceKey* key = nullptr;
    Program* program = nullptr;
  };
  /// Views of one kind ask for the same programs.
  struct ViewKind {
    std::string output;
    bool clipped = false;
    bool marks_non_finite = false;  ///< the target's format would hide NaN and infinity
    auto operator<=>(const ViewKind&) const = default;
  };
  struct Drawing;

  SurfaceKey key_for(const View& view, const Node& node, const ViewKind& kind) const;
  const std::vector<Variant>& variants(const View& view, const Target& target);
  Viewpoint look(const View& view, const TargetSpec& target) const;
  bool hidden(const Item& item, const Viewpoint& viewpoint) const;
  void take_lights();
  void tell_moved();
  glm::vec3 background(const View& view) const;
  std::vector<ChainPass> passes(const View& view) const;

  void draw_with_chain(const View& view, const Target& target);
  void draw_scene(const View& view, const Target& target);
  void begin(const Viewpoint& viewpoint, const Target& target);
  void set_bounds(const Viewpoint& viewpoint, const Target& target);
  void draw_nodes(const Viewpoint& viewpoint, const Target& target);
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

  Gl& gl_;
  TransformFunctions transforms_;
  ChainFunctions chain_functions_;
  std::vector<std::unique_ptr<Feature>> features_;
  Programs programs_;
  TargetPool pool_;
  ChainRunner chain_;
  RenderOptions options_;

  const Scene* scene_ = nullptr;
  std::vector<Light> lights_;         ///< of the scene, and of features
  std::optional<PlacedNodes> nodes_;  ///< of the prepared scene
  SceneCounts counts_;
  bool mirrored_ = false;  ///< of the view that is being drawn

  std::map<ViewKind, std::vector<Variant>> variants_;  ///< item by item
  std::uint64_t variants_version_ = 0;                 ///< the features' structure versions, when they were found
};

}  // namespace atelier
