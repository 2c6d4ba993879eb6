#include "render/renderer.hpp"

#include <fmt/core.h>

#include "render/cull.hpp"

namespace atelier {

namespace {

/// Where the renderer's own shader files are: set by the build, as an absolute path.
const std::filesystem::path own_shaders = ATELIER_RENDER_SHADERS;

Box3 box_of(const Mesh& mesh) {
  Box3 box;
  for (const Vertex& vertex : mesh.vertices) box.add(glm::dvec3(vertex.position));
  return box;
}

/// Whether clip space has depths from 0 to w instead of from -w to w.
bool depth_from_zero(const View& view) {
  return view.reversed_depth && view.camera.projection == Projection::perspective;
}

}  // namespace

Renderer::Renderer(Gl& gl, Implementations implementations, TransformFunctions transforms,
                   std::vector<std::unique_ptr<Feature>> features)
    : gl_(gl),
      implementations_(std::move(implementations)),
      transforms_(std::move(transforms)),
      features_(std::move(features)) {}

void Renderer::configure(const Settings& settings) {
  for (auto& feature : features_) feature->configure(settings);
}

void Renderer::nodes_moved() {
  placed_for_.reset();
  if (scene_)
    for (auto& feature : features_) feature->moved(*scene_);
}

void Renderer::lights_moved() {
  if (scene_)
    for (auto& feature : features_) feature->moved(*scene_);
}

void Renderer::prepare(const Scene& scene) {
  validate(scene);
  meshes_.clear();
  placed_for_.reset();
  counts_ = {};
  scene_ = &scene;
  for (const Mesh& mesh : scene.meshes) {
    const MeshBuffers made = transforms_.upload_mesh(gl_, mesh.vertices, mesh.indices);
    meshes_.push_back({GlVertexArray(gl_, made.vertex_array), GlBuffer(gl_, made.vertex_buffer),
                       GlBuffer(gl_, made.index_buffer), made.count, box_of(mesh)});
    gl_.BindVertexArray(0);
  }
  check_gl_error(gl_, "upload_mesh");  // now, or it would be told of where nothing is wrong
  for (auto& feature : features_) feature->prepare(gl_, scene);
  check_gl_error(gl_, "making the textures of the scene");
}

// ---- Programs

std::filesystem::path Renderer::find_shader(const std::string& name) const {
  if (const auto found = implementations_.find(name); !found.empty()) return found;
  // Ours are found by the same rule: no name leads out of the folder, into files that are not for shaders to read.
  return Implementations({{own_shaders, ""}}).find(name);
}

namespace {

/// When each of the files that stages were put together from was last changed.
std::map<std::filesystem::path, std::filesystem::file_time_type> changes_of(
    std::initializer_list<const ShaderSource*> stages) {
  std::map<std::filesystem::path, std::filesystem::file_time_type> files;
  for (const ShaderSource* stage : stages)
    for (const auto& file : stage->files)
      if (std::error_code missing; std::filesystem::exists(file, missing))
        files[file] = std::filesystem::last_write_time(file);
  return files;
}

}  // namespace

Renderer::Program Renderer::build(const SurfaceKey& key) const {
  const SurfaceSources sources =
      assemble_surface([this](const std::string& name) { return find_shader(name); }, transforms_.glsl, key);
  GlProgram program = build_program(gl_, sources.vertex, sources.fragment);
  Uniforms uniforms(gl_, program.id());
  return {std::move(program), std::move(uniforms), changes_of({&sources.vertex, &sources.fragment})};
}

Renderer::Program Renderer::build(const PassSources& pass) const {
  const FindFile find = [this](const std::string& name) { return find_shader(name); };
  const auto stage = [&](const std::string& text, const char* which) {
    return assemble_shader_text(find, text, fmt::format("{} {} shader", pass.name, which), pass.structure);
  };
  const ShaderSource vertex = stage(pass_vertex_text(transforms_.glsl) + pass.vertex, "vertex"),
                     fragment = stage(pass.fragment, "fragment"), geometry = stage(pass.geometry, "geometry");
  GlProgram program = build_program(gl_, vertex, fragment, pass.geometry.empty() ? nullptr : &geometry);
  Uniforms uniforms(gl_, program.id());
  return {std::move(program), std::move(uniforms), changes_of({&vertex, &fragment, &geometry})};
}

template <class Key>
Renderer::Program& Renderer::program(std::map<Key, Program>& programs, const Key& key) {
  auto found = programs.find(key);
  if (found == programs.end()) found = programs.emplace(key, build(key)).first;
  return found->second;
}

template <class Key>
Renderer::Reloaded Renderer::reload_changed(std::map<Key, Program>& programs) {
  Reloaded reloaded;
  for (auto& [key, program] : programs)
    for (auto& [file, seen] : program.files) {
      std::error_code gone;
      const auto now = std::filesystem::last_write_time(file, gone);
      if (gone || now == seen) continue;
      try {
        program = build(key);
        reloaded.any = true;
      } catch (const Error& error) {
        reloaded.words = error.what();
        return reloaded;
      }
      break;  // `files` is a new map now
    }
  return reloaded;
}

std::string Renderer::reload_changed_shaders() {
  const Reloaded surfaces = reload_changed(programs_), passes = reload_changed(pass_programs_);
  if (passes.any && scene_)  // what was drawn with the old ones must not be kept
    for (auto& feature : features_) feature->moved(*scene_);
  return surfaces.words.empty() ? passes.words : surfaces.words;
}

SurfaceKey Renderer::key_for(const View& view, const Node& node) const {
  SurfaceKey key;
  key.output = view.output;
  for (const auto& feature : features_) {
    const Need need = feature->need(*scene_, view, node);
    if (!need.wanted) continue;
    key.features.push_back(feature.get());
    key.structure.insert(need.structure.begin(), need.structure.end());
  }
  if (scene_->materials[std::size_t(node.material)].two_sided) key.structure["TWO_SIDED"] = std::string("1");
  return key;
}

// ---- One frame

Viewpoint Renderer::look(const View& view, const Target& target) const {
  const Camera& camera = view.camera;
  const glm::dvec3 origin = view.camera_relative ? camera.eye : glm::dvec3(0);
  const auto moved = [&](const glm::dvec3& p) {
    return view.camera_relative ? transforms_.relative_to_eye(p, origin) : glm::vec3(p);
  };
  const float aspect = float(target.spec().width) / float(target.spec().height);
  glm::mat4 projection;
  if (camera.projection == Projection::orthographic) {
    const float top = camera.height / 2, right = top * aspect;
    // Reversed: the planes change places. Depth is even between them, so nothing is gained by a range from 0 to 1.
    const float first = view.reversed_depth ? camera.far : camera.near,
                last = view.reversed_depth ? camera.near : camera.far;
    projection = transforms_.orthographic(-right, right, -top, top, first, last);
  } else {
    const auto make = view.reversed_depth ? transforms_.perspective_reversed : transforms_.perspective;
    projection = make(camera.fov_y, aspect, camera.near, camera.far);
  }
  return {view, transforms_.look_at(moved(camera.eye), moved(camera.target), camera.up), projection, moved(camera.eye),
          origin};
}

void Renderer::place(const Viewpoint& viewpoint) {
  const Placement wanted{viewpoint.view.camera_relative, viewpoint.origin};
  if (placed_for_ == wanted) return;
  placed_for_.reset();
  std::vector<Joint> joints;
  joints.reserve(scene_->nodes.size());
  for (const Node& node : scene_->nodes) {
    glm::mat4 local;
    // Only roots stand in world space: what hangs below them is near its parent and needs no double precision.
    const bool move = node.parent < 0 && viewpoint.view.camera_relative;
    if (node.matrix) {
      local = *node.matrix;
      if (move) local[3] = glm::vec4(transforms_.relative_to_eye(glm::dvec3(local[3]), viewpoint.origin), 1);
    } else {
      const glm::vec3 translation =
          move ? transforms_.relative_to_eye(node.translation, viewpoint.origin) : glm::vec3(node.translation);
      local = transforms_.compose(translation, node.rotation_axis, node.rotation_angle, node.scale);
    }
    joints.push_back({node.parent, local});
  }
  const std::vector<glm::mat4> world = transforms_.world_matrices(joints);
  if (world.size() != joints.size())
    throw Error(fmt::format("world_matrices returned {} matrices for {} nodes", world.size(), joints.size()));
  items_.clear();
  for (std::size_t i = 0; i < world.size(); ++i)
    if (const auto mesh = scene_->nodes[i].mesh)
      items_.push_back({int(i), world[i], transforms_.normal_matrix(world[i]), meshes_[std::size_t(*mesh)].box});
  counts_.matrices = std::int64_t(world.size() + items_.size());
  placed_for_ = wanted;
}

bool Renderer::hidden(const Item& item, const Viewpoint& viewpoint) const {
  return viewpoint.view.cull && outside_view(viewpoint.projection, viewpoint.world_to_view, item.model, item.box,
                                             depth_from_zero(viewpoint.view));
}

/// Undoes what the frame before, a feature's passes or a student's function may have left.
void Renderer::clear_state() {
  if (gl_.ClipControl.call) gl_.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  gl_.DepthRange(0, 1);
  gl_.DepthMask(GL_TRUE);
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  gl_.CullFace(GL_BACK);
  for (const GLenum what : {GL_DEPTH_CLAMP, GL_POLYGON_OFFSET_FILL, GL_SCISSOR_TEST, GL_BLEND, GL_STENCIL_TEST})
    gl_.Disable(what);
}

void Renderer::begin(const Viewpoint& viewpoint, const Target& target) {
  const View& view = viewpoint.view;
  if (view.reversed_depth && !gl_.ClipControl.call)
    throw Error("reversed depth needs glClipControl (OpenGL 4.5 or ARB_clip_control), which this driver lacks");
  clear_state();
  target.bind(gl_);
  const bool from_zero = depth_from_zero(view);
  if (gl_.ClipControl.call) gl_.ClipControl(GL_LOWER_LEFT, GLenum(from_zero ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE));
  gl_.DepthFunc(GLenum(view.reversed_depth ? GL_GREATER : GL_LESS));
  gl_.ClearDepth(view.reversed_depth ? 0.0 : 1.0);
  const glm::vec3 background = view.output == "colour" ? scene_->background : glm::vec3(0);
  gl_.ClearColor(background.r, background.g, background.b, 1);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl_.Enable(GL_DEPTH_TEST);
  transforms_.set_wireframe(gl_, view.wireframe);
}

void Renderer::draw_mesh(const Item& item) {
  const UploadedMesh& mesh = meshes_[std::size_t(*scene_->nodes[std::size_t(item.node)].mesh)];
  if (!mesh.vertex_array || mesh.count <= 0) return;  // step 01's upload_mesh is not written yet: nothing to draw
  // A mirrored model turns its triangles round: what was counter-clockwise is clockwise now.
  gl_.FrontFace(GLenum(glm::determinant(glm::mat3(item.model)) < 0 ? GL_CW : GL_CCW));
  gl_.BindVertexArray(mesh.vertex_array.id());
  if (mesh.index_buffer)
    gl_.DrawElements(GL_TRIANGLES, mesh.count, GL_UNSIGNED_INT, nullptr);
  else
    gl_.DrawArrays(GL_TRIANGLES, 0, mesh.count);
}

/// What the draws of one view leave for the next one.
struct Renderer::Drawing {
  const Viewpoint& viewpoint;
  const Program* program = nullptr;  ///< in use
  std::optional<Binder> bound;       ///< has set what is the same for all its draws; a material's textures come behind
};

void Renderer::use(Program& chosen, const SurfaceKey& key, Drawing& drawing) {
  if (drawing.program == &chosen) return;
  gl_.UseProgram(chosen.program.id());
  Binder binder(gl_, chosen.uniforms);
  const Viewpoint& viewpoint = drawing.viewpoint;
  binder.set("u_view", viewpoint.world_to_view);
  binder.set("u_projection", viewpoint.projection);
  binder.set("u_eye_world", viewpoint.eye);
  for (const auto& feature : features_)
    if (key.has(*feature)) feature->bind_view(binder, *scene_, viewpoint);
  drawing.program = &chosen;
  drawing.bound.emplace(binder);
}

void Renderer::draw(const Item& item, Drawing& drawing) {
  const Node& node = scene_->nodes[std::size_t(item.node)];
  const Material& material = scene_->materials[std::size_t(node.material)];
  const SurfaceKey key = key_for(drawing.viewpoint.view, node);
  use(program(programs_, key), key, drawing);
  Binder binder = *drawing.bound;
  binder.set("u_model", item.model);
  binder.set("u_normal_matrix", item.normal_matrix);
  for (const auto& feature : features_)
    if (key.has(*feature)) feature->bind_material(binder, *scene_, material);
  if (material.two_sided || drawing.viewpoint.view.wireframe)
    gl_.Disable(GL_CULL_FACE);
  else
    gl_.Enable(GL_CULL_FACE);
  draw_mesh(item);
}

void Renderer::paint(const PassSources& pass, std::span<const int> items, const std::function<void(Binder&)>& bind) {
  if (items.empty()) return;
  Program& chosen = program(pass_programs_, pass);
  gl_.UseProgram(chosen.program.id());
  Binder binder(gl_, chosen.uniforms);
  bind(binder);
  for (const int i : items) {
    const Item& item = items_[std::size_t(i)];
    binder.set("u_model", item.model);
    draw_mesh(item);
  }
  gl_.BindVertexArray(0);
}

void Renderer::draw_all(const Viewpoint& viewpoint) {
  Drawing drawing{viewpoint};
  for (const Item& item : items_) {
    ++counts_.nodes;
    if (hidden(item, viewpoint))
      ++counts_.nodes_culled;
    else
      draw(item, drawing);
  }
}

bool Renderer::drawn_instead(const View& view, const Target& target) {
  for (const auto& feature : features_)
    if (feature->draw_instead(gl_, view, target)) return true;
  return false;
}

void Renderer::render(const View& view, const Target& target) {
  if (!scene_) throw Error("Renderer::render: no scene was prepared");
  counts_ = {};
  const Viewpoint viewpoint = look(view, target);
  place(viewpoint);
  clear_state();
  target.bind(gl_);  // a pass that forgets its viewport or its framebuffer must do so the same way every time
  for (const auto& feature : features_) feature->draw_before(gl_, *scene_, viewpoint, *this);
  begin(viewpoint, target);
  if (!drawn_instead(view, target)) draw_all(viewpoint);
  for (const auto& feature : features_) feature->count(counts_);
  gl_.BindVertexArray(0);
  transforms_.set_wireframe(gl_, false);
  check_gl_error(gl_, "drawing the scene");
}

}  // namespace atelier
