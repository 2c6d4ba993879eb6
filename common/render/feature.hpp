// A technique, plugged into the renderer: the lit surface, a shadow map, a normal map. A feature says what it needs for
// a scene, and brings its GLSL and its uniforms; what no feature wants does not exist in the shader that is drawn.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "case/settings.hpp"
#include "gl/objects.hpp"
#include "gl/shader.hpp"
#include "gl/target.hpp"
#include "render/counts.hpp"
#include "scene/scene.hpp"

namespace atelier {

/// One traversal of a scene.
struct View {
  Camera camera;
  std::string output = "colour";  ///< "colour", or one intermediate that the renderer or a feature offers
  bool wireframe = false;         ///< edges only
  bool camera_relative = false;   ///< the world is moved so that the eye is its origin, in double precision
  bool cull = false;              ///< leave out nodes whose boxes are outside the view
  bool reversed_depth = false;    ///< depth 1 at the near plane; needs clip control and a float depth buffer
};

/// A view with everything that the features need to know about it worked out, in the space that shaders call world
/// (moved to the eye where the view is camera-relative).
struct Viewpoint {
  const View& view;
  glm::mat4 world_to_view, projection;
  glm::vec3 eye;         ///< 0 when camera-relative
  glm::dvec3 origin{0};  ///< what was subtracted from the world: the eye when camera-relative, else 0
};

/// What a feature wants of the shader for one material: nothing, or a variant told by #defines. Numbers that change
/// from frame to frame are uniforms and stay out of it: they must not cost a compilation.
struct Need {
  bool wanted = false;
  Defines structure;
};

/// Places in the surface shader that a feature can fill. The last feature that fills one wins.
///
/// What fills `shade` may call the other three under the names visible_from_point, visible_from_spot and
/// visible_from_sun: the share, 0..1, of the light with this number (among those of its type) that reaches the surface,
/// 1 where no feature knows better. `to_light` is of unit length; for a sun it is the way against its light.
enum class Slot {
  shade,               ///< vec3 f(Surface): the light that leaves the surface
  visible_from_point,  ///< float f(int light, vec3 position, vec3 normal, vec3 to_light); world space
  visible_from_spot,   ///< the same
  visible_from_sun,    ///< the same
};

/// A piece of GLSL: the file that defines a function, and the function's name.
struct SlotCode {
  std::string include;   ///< "02-blinn-phong/surface_lighting.glsl"
  std::string function;  ///< "shade_surface"
};

/// Sets the uniforms and textures of the program that is about to draw. Owns the texture units.
class Binder {
 public:
  Binder(Gl& gl, Uniforms& uniforms) : gl_(gl), uniforms_(uniforms) {}
  /// A float, int, vector or matrix. A name that this program does not use is ignored.
  template <class Value>
  void set(std::string_view name, const Value& value) {
    uniforms_.set(name, value);
  }
  /// Binds a texture to the next free unit and points the sampler at it.
  void texture(const std::string& sampler, GLuint texture, GLenum target = GL_TEXTURE_2D);

 private:
  Gl& gl_;
  Uniforms& uniforms_;
  int units_ = 0;
};

/// The stages of a program that a feature draws nodes with for itself: GLSL texts of #include lines and code. The
/// vertex stage begins with the attributes and the uniforms u_model, u_view and u_projection declared and step 01's
/// functions included.
struct PassSources {
  std::string name;  ///< for messages
  std::string vertex, fragment;
  std::string geometry;  ///< empty: none
  Defines structure;     ///< #defines of all stages
  bool operator<(const PassSources& other) const;
};

/// Draws nodes of the prepared scene for a feature, into the framebuffer that it has bound: shadow maps.
class NodePainter {
 public:
  /// A node with a mesh, where step 01's functions have placed it in the space that shaders call world.
  struct Item {
    int node = 0;  ///< index into Scene::nodes
    glm::mat4 model{1.0f};
    glm::mat3 normal_matrix{1.0f};
    Box3 box;  ///< of the mesh: object space
  };
  virtual ~NodePainter() = default;

  virtual std::span<const Item> items() const = 0;

  /// Draws items (by their numbers in `items()`) with the pass's program; `bind` sets its uniforms, once. Sets which
  /// faces are front faces, a mirrored node's being turned round; culling, depth test and viewport are the caller's.
  virtual void paint(const PassSources& pass, std::span<const int> items, const std::function<void(Binder&)>& bind) = 0;
};

class Feature {
 public:
  virtual ~Feature() = default;

  /// Takes the settings of the frames to come. Called before `prepare`.
  virtual void configure(const Settings&) {}

  /// Makes what the scene needs of it in OpenGL's memory. Called once for a scene.
  virtual void prepare(Gl&, const Scene&) {}

  /// Called where the scene's nodes or lights have moved since `prepare`.
  virtual void moved(const Scene&) {}

  /// Draws what the view needs beforehand, into targets of the feature's own. Called once before each frame, with
  /// OpenGL's usual state; may leave it as it likes.
  virtual void draw_before(Gl&, const Scene&, const Viewpoint&, NodePainter&) {}

  /// Asked for each node with a mesh in each view.
  virtual Need need(const Scene&, const View&, const Node&) const = 0;

  /// Which slots it fills where it is wanted.
  virtual std::map<Slot, SlotCode> slots() const { return {}; }

  /// Intermediates that it can show: output name to a GLSL expression of type vec3 over `Surface surface`.
  virtual std::map<std::string, std::string> outputs() const { return {}; }

  /// Fills the whole target with an output that is no picture of the scene's surfaces, and says so by returning true: a
  /// shadow map as it is stored. Called after `draw_before`, with the target bound.
  virtual bool draw_instead(Gl&, const View&, const Target&) { return false; }

  /// Sets what is the same for all draws of a view with one program: called once for draws that follow each other. May
  /// make no textures: one that is made takes the place of one that is bound.
  virtual void bind_view(Binder&, const Scene&, const Viewpoint&) {}
  /// Sets what belongs to one material.
  virtual void bind_material(Binder&, const Scene&, const Material&) {}

  /// Adds what its part of a frame has cost. Asked after each frame.
  virtual void count(SceneCounts&) const {}
};

}  // namespace atelier
