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

class Renderer : private NodePainter {
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
  void nodes_moved();
  /// To be called where lights of the prepared scene have moved or changed.
  void lights_moved();

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
  /// What the matrices depend on beside the scene.
  struct Placement {
    bool camera_relative = false;
    glm::dvec3 origin{0};
    bool operator==(const Placement&) const = default;
  };

  std::filesystem::path find_shader(const std::string& name) const;
  Program build(const SurfaceKey& key) const;
  Program build(const PassSources& pass) const;
  template <class Key>
  Program& program(std::map<Key, Program>& programs, const Key& key);
  struct Reloaded {
    bool any = false;
    std::string words;  ///< the driver's, where it refused one
  };
  template <class Key>
  Reloaded reload_changed(std::map<Key, Program>& programs);
  void clear_state();
  SurfaceKey key_for(const View& view, const Node& node) const;
  Viewpoint look(const View& view, const Target& target) const;
  void place(const Viewpoint& viewpoint);
  bool hidden(const Item& item, const Viewpoint& viewpoint) const;
  void begin(const Viewpoint& viewpoint, const Target& target);
  struct Drawing;
  void use(Program& chosen, const SurfaceKey& key, Drawing& drawing);
  void draw(const Item& item, Drawing& drawing);
  void draw_mesh(const Item& item);
  void draw_all(const Viewpoint& viewpoint);
  bool drawn_instead(const View& view, const Target& target);

  std::span<const Item> items() const override { return items_; }
  void paint(const PassSources& pass, std::span<const int> items, const std::function<void(Binder&)>& bind) override;

  Gl& gl_;
  Implementations implementations_;
  TransformFunctions transforms_;
  std::vector<std::unique_ptr<Feature>> features_;
  const Scene* scene_ = nullptr;
  std::vector<UploadedMesh> meshes_;
  std::vector<Item> items_;              ///< of all nodes with a mesh
  std::optional<Placement> placed_for_;  ///< for which `items_` is right
  SceneCounts counts_;
  std::map<SurfaceKey, Program> programs_;
  std::map<PassSources, Program> pass_programs_;
};

}  // namespace atelier
