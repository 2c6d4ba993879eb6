// A technique, plugged into the renderer: the lit surface, a shadow map, a normal map. A feature says what it needs for
// a scene, and brings its GLSL and its uniforms; what no feature wants does not exist in the shader that is drawn.
#pragma once

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

/// Places in the surface shader that a feature can fill.
enum class Slot {
  shade,  ///< vec3 f(Surface): the light that leaves the surface; the last feature that fills it wins
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

class Feature {
 public:
  virtual ~Feature() = default;

  /// Takes the settings of the frames to come. Called before `prepare`.
  virtual void configure(const Settings&) {}

  /// Makes what the scene needs of it in OpenGL's memory. Called once for a scene.
  virtual void prepare(Gl&, const Scene&) {}

  /// Asked for each material in each view.
  virtual Need need(const Scene&, const View&, const Material&) const = 0;

  /// Which slots it fills where it is wanted.
  virtual std::map<Slot, SlotCode> slots() const { return {}; }

  /// Intermediates that it can show: output name to a GLSL expression of type vec3 over `Surface surface`.
  virtual std::map<std::string, std::string> outputs() const { return {}; }

  /// Sets what is the same for all draws of a view with one program.
  virtual void bind_view(Binder&, const Scene&, const Viewpoint&) {}
  /// Sets what belongs to one material.
  virtual void bind_material(Binder&, const Scene&, const Material&) {}

  /// Adds what its part of a frame has cost. Asked after each frame.
  virtual void count(SceneCounts&) const {}
};

}  // namespace atelier
