// Draws scenes with the features that they require. Sole owner of the programs and buffers that this takes.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "case/implementations.hpp"
#include "render/feature.hpp"
#include "render/surface_shader.hpp"
#include "render/transforms.hpp"

namespace atelier {

class Renderer {
 public:
  /// Shaders are found along `implementations`, then among the renderer's own.
  Renderer(Gl& gl, Implementations implementations, TransformFunctions transforms,
           std::vector<std::unique_ptr<Feature>> features);

  /// Hands the settings to every feature.
  void configure(const Settings& settings);

  /// Uploads what the scene needs, once; frees what the scene before it needed. The scene must outlive its drawing.
  void prepare(const Scene& scene);

  /// To be called where nodes of the prepared scene have moved: matrices are computed once and kept until then (or,
  /// where the view is camera-relative, until the eye moves).
  void nodes_moved() { placed_for_.reset(); }

  /// Clears the target to the background and draws the prepared scene. Throws ShaderError with the author's file and
  /// line, Error where the view asks what the driver or the target lacks.
  void render(const View& view, const Target& target);

  const SceneCounts& counts() const { return counts_; }  ///< of the last frame

  /// Builds anew every program one of whose files has changed. Where one cannot be built, the old one stays and the
  /// driver's words are returned; otherwise an empty string.
  std::string reload_changed_shaders();

 private:
  struct Program {
    GlProgram program;
    Uniforms uniforms;
    std::map<std::filesystem::path, std::filesystem::file_time_type> files;
  };
  struct UploadedMesh {
    GlVertexArray vertex_array;
    GlBuffer vertex_buffer, index_buffer;
    GLsizei count = 0;
    Box3 box;  ///< object space
  };
  struct Draw {
    int node = 0;
    glm::mat4 model{1.0f};
    glm::mat3 normal_matrix{1.0f};
  };
  /// What the matrices depend on beside the scene.
  struct Placement {
    bool camera_relative = false;
    glm::dvec3 origin{0};
    bool operator==(const Placement&) const = default;
  };

  std::filesystem::path find_shader(const std::string& name) const;
  Program build(const SurfaceKey& key) const;
  Program& program(const SurfaceKey& key);
  SurfaceKey key_for(const View& view, const Material& material) const;
  Viewpoint look(const View& view, const Target& target) const;
  void place(const Viewpoint& viewpoint);
  bool hidden(const Draw& draw, const Viewpoint& viewpoint) const;
  void begin(const Viewpoint& viewpoint, const Target& target);
  void draw(const Draw& draw, const Viewpoint& viewpoint);

  Gl& gl_;
  Implementations implementations_;
  TransformFunctions transforms_;
  std::vector<std::unique_ptr<Feature>> features_;
  const Scene* scene_ = nullptr;
  std::vector<UploadedMesh> meshes_;
  std::vector<Draw> draws_;              ///< of all nodes with a mesh
  std::optional<Placement> placed_for_;  ///< for which `draws_` is right
  SceneCounts counts_;
  std::map<SurfaceKey, Program> programs_;
};

}  // namespace atelier
