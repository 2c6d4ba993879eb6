// A technique, plugged into the renderer: the lit surface, a shadow map, a normal map, a portal, a fog. A feature says
// what it needs for a scene, and brings its GLSL and its uniforms; what no feature wants does not exist in the shader
// that is drawn. Features stand beside each other: what one needs of another it is given as plain data.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "case/settings.hpp"
#include "gl/objects.hpp"
#include "gl/target.hpp"
#include "render/binder.hpp"
#include "render/chain.hpp"
#include "render/counts.hpp"
#include "render/draw_constants.hpp"
#include "render/scene_painter.hpp"
#include "render/slots.hpp"
#include "render/view.hpp"
#include "scene/scene.hpp"

namespace atelier {

/// The functions of a feature are called in the order in which they stand here.
class Feature {
 public:
  virtual ~Feature() = default;

  // ---- For a scene

  /// Takes the settings of the frames to come.
  virtual void configure(const Settings&) {}

  /// Tangents of a mesh, one a vertex (as Mesh::tangents), for surfaces whose `need` defines TANGENTS: uploaded once as
  /// attribute 3. Empty: none. The first feature that answers is taken.
  virtual std::vector<glm::vec4> tangents(const Scene&, int /*mesh*/) const { return {}; }

  /// Adds lights to those of the scene: images of lights in a mirror. Also where something has moved.
  virtual void add_lights(const Scene&, std::vector<Light>&) const {}

  /// Takes all lights: the scene's under their numbers, then those that features have added. They stay where they are
  /// until the next call.
  virtual void take_lights(std::span<const Light>) {}

  /// Makes what the scene needs of it in OpenGL's memory. Called once for a scene.
  virtual void prepare(Gl&, const Scene&) {}

  /// Whether views of this scene are drawn inside others: targets then have a stencil buffer.
  virtual bool needs_stencil(const Scene&) const { return false; }

  /// Called where the scene's nodes or lights have moved since `prepare`.
  virtual void moved(const Scene&) {}

  // ---- For a frame

  /// Draws whole views into targets of its own, once before each frame. Never called for these views themselves.
  virtual void draw_views(Gl&, const Scene&, const Viewpoint&, ScenePainter&) {}

  // ---- For each view, those inside others too

  /// Passes for the picture of a view that has a target for itself, in their order.
  virtual std::vector<ChainPass> passes(const Scene&, const View&) const { return {}; }

  /// Draws what the view needs beforehand, into targets of the feature's own: maps of shadows. What it has made is
  /// right until the next view. Called with OpenGL's usual state; may leave it as it likes.
  virtual void draw_before(Gl&, const Scene&, const Viewpoint&, ScenePainter&) {}

  /// What is seen where nothing is. The last feature that answers wins; otherwise it is the scene's own.
  virtual std::optional<glm::vec3> background(const Scene&, const View&) const { return {}; }

  /// Fills the whole target with an output that is no picture of the scene's surfaces, and says so by returning true: a
  /// shadow map as it is stored. Called with the target bound, the last feature first.
  virtual bool draw_instead(Gl&, const View&, const Target&) { return false; }

  /// Whether a node is left out of a view, its surface being the feature's to draw: the opening of a portal. Asked for
  /// as `need` is.
  virtual bool hides(const Scene&, const View&, const Node&) const { return false; }

  /// Asked for each node with a mesh. May depend on scene, settings, the view's output and what `draw_before` has
  /// found; where the last changes an answer, `structure_changed` must be called. The same holds for all that follows
  /// up to `outputs`.
  virtual Need need(const Scene&, const View&, const Node&) const = 0;

  /// Which slots it fills where it is wanted.
  virtual std::map<Slot, SlotCode> slots() const { return {}; }

  /// Intermediates that it can show: output name to a GLSL expression of type vec3 over `Surface surface`
  /// and `shaded`, the light that leaves it when all features have had their say.
  virtual std::map<std::string, std::string> outputs() const { return {}; }

  /// Uniforms of its GLSL for which it is worth while to be handed over as varyings where that is asked for
  /// (RenderOptions): those that every pixel reads, the most important first.
  virtual std::vector<DrawConstant> draw_constants() const { return {}; }

  /// Sets what is the same for all draws of a view with one program: called once for draws that follow each other. May
  /// make no textures: one that is made takes the place of one that is bound.
  virtual void bind_view(Binder&, const Scene&, const Viewpoint&) {}
  /// Sets what belongs to one material.
  virtual void bind_material(Binder&, const Scene&, const Material&) {}

  /// Draws views inside the one that has just been drawn, by ScenePainter::draw_view_inside. It is called for these
  /// views too: whoever recurses says when it ends.
  virtual void draw_inside(Gl&, const Scene&, const Viewpoint&, const Target&, ScenePainter&) {}

  /// Adds what its part of a frame has cost. Asked after each frame.
  virtual void count(SceneCounts&) const {}

  /// How often `structure_changed` was called.
  std::uint64_t structure_version() const { return structure_version_; }

 protected:
  /// To be called where `need`, `slots`, `outputs` or `hides` will answer otherwise than in the last frame.
  void structure_changed() { ++structure_version_; }

 private:
  std::uint64_t structure_version_ = 0;
};

}  // namespace atelier
