// A technique as a plug-in of the renderer: lit surface, shadow maps, normal maps, portals, fog. A feature declares
// what it needs for a scene, and provides GLSL and uniforms; the shader contains only what a feature needs. Features do
// not depend on each other's classes: they share plain data.
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

/// The functions are called in the order of their declarations; draw_before is called before the background is cleared
/// where no views are drawn inside.
class Feature {
 public:
  virtual ~Feature() = default;

  // ---- For a scene

  /// Sets the settings of the next frames.
  virtual void configure(const Settings&) {}

  /// Tangents of a mesh, one per vertex (as Mesh::tangents), for surfaces whose `need` defines TANGENTS: uploaded once
  /// as attribute 3. Empty: none. The first feature that returns some is used.
  virtual std::vector<glm::vec4> tangents(const Scene&, int /*mesh*/) const { return {}; }

  /// Adds lights to those of the scene, such as mirror images of lights. Called again when something has moved.
  virtual void add_lights(const Scene&, std::vector<Light>&) const {}

  /// Passes all lights: the scene's at their indices, then those that features have added. The span is valid until the
  /// next call.
  virtual void take_lights(std::span<const Light>) {}

  /// Creates the OpenGL objects for the scene. Called once for a scene.
  virtual void prepare(Gl&, const Scene&) {}

  /// Whether views of this scene are drawn inside others: targets then need a stencil buffer.
  virtual bool needs_stencil(const Scene&) const { return false; }

  /// Called when the scene's nodes or lights have moved since `prepare`.
  virtual void moved(const Scene&) {}

  // ---- For a frame

  /// Draws whole views into targets of its own, once before each frame. Never called for these views themselves.
  virtual void draw_views(Gl&, const Scene&, const Viewpoint&, ScenePainter&) {}

  // ---- For each view, including those inside others

  /// Post-processing passes, in order, for a view that has its own target.
  virtual std::vector<ChainPass> passes(const Scene&, const View&) const { return {}; }

  /// The background colour, which also replaces the sky. The last feature that returns one wins; otherwise it is the
  /// scene's.
  virtual std::optional<glm::vec3> background(const Scene&, const View&) const { return {}; }

  /// Whether the feature may draw the view's output instead of the scene's surfaces. If any does, no views are drawn
  /// inside this one.
  virtual bool may_draw_instead(const View&) const { return false; }

  /// Draws views inside this one, with ScenePainter::draw_view_inside, before its surfaces: what their openings hide is
  /// not shaded. Called if any feature needs a stencil buffer, for these views too: the feature must limit the
  /// recursion.
  virtual void draw_inside(Gl&, const Scene&, const Viewpoint&, const Target&, ScenePainter&) {}

  /// Draws what the view's surfaces need into targets of the feature's own, such as shadow maps. They are valid until
  /// the next view. Called with default OpenGL state, which it may change.
  virtual void draw_before(Gl&, const Scene&, const Viewpoint&, ScenePainter&) {}

  /// Draws an output that is not a view of the scene's surfaces, such as a stored shadow map, and returns true;
  /// otherwise returns false. Called with the target bound, the last feature first, if may_draw_instead is true for
  /// any.
  virtual bool draw_instead(Gl&, const View&, const Target&) { return false; }

  /// Whether a node is not drawn in a view because the feature draws it, such as the opening of a portal. Called like
  /// `need`.
  virtual bool hides(const Scene&, const View&, const Node&) const { return false; }

  /// Called for each node with a mesh. May depend on scene, settings, the view's output, whether it has an
  /// openings_clip_plane, and the result of `draw_before`; if the latter changes the return value, call
  /// `structure_changed`. The same holds for the functions below, up to `outputs`.
  virtual Need need(const Scene&, const View&, const Node&) const = 0;

  /// The slots that it fills in nodes that need it.
  virtual std::map<Slot, SlotCode> slots() const { return {}; }

  /// Intermediate results: output name to a GLSL expression of type vec3 in terms of `Surface surface` and `shaded`,
  /// the final reflected light.
  virtual std::map<std::string, std::string> outputs() const { return {}; }

  /// Uniforms of its GLSL that may be passed as varyings (RenderOptions): those that every pixel reads, the most
  /// important first.
  virtual std::vector<DrawConstant> draw_constants() const { return {}; }

  /// Sets the uniforms that are the same for all draws of a view with one program: called once for consecutive draws.
  /// Must not create textures: creating one changes the texture binding.
  virtual void bind_view(Binder&, const Scene&, const Viewpoint&) {}
  /// Sets the uniforms of one material.
  virtual void bind_material(Binder&, const Scene&, const Material&) {}

  /// Whether the feature has left something of the last frame for the next one.
  virtual bool wants_another_frame() const { return false; }

  /// Adds its own counts of a frame. Called after each frame.
  virtual void count(SceneCounts&) const {}

  /// How often `structure_changed` was called.
  std::uint64_t structure_version() const { return structure_version_; }

 protected:
  /// Call it if `need`, `slots`, `outputs` or `hides` will return other values than in the last frame.
  void structure_changed() { ++structure_version_; }

 private:
  std::uint64_t structure_version_ = 0;
};

}  // namespace atelier
