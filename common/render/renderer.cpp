#include "render/renderer.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "gl/debug.hpp"
#include "gl/state.hpp"
#include "render/bind_viewpoint.hpp"
#include "render/cull.hpp"

namespace atelier {

namespace {

/// Whether clip space depths are from 0 to w instead of from -w to w.
bool depth_from_zero(const View& view) {
  return view.reversed_depth && view.camera.projection == Projection::perspective;
}

/// The outermost enclosing view, or the view itself.
const View& outermost(const View& view) {
  return view.parent ? outermost(*view.parent) : view;
}

}  // namespace

Renderer::Renderer(Gl& gl, Implementations implementations, TransformFunctions transforms,
                   std::vector<std::unique_ptr<Feature>> features, ChainFunctions chain)
    : gl_(gl),
      transforms_(std::move(transforms)),
      chain_functions_(std::move(chain)),
      features_(std::move(features)),
      programs_(gl, std::move(implementations), transforms_.glsl),
      pool_(gl),
      chain_(gl, programs_, pool_, chain_functions_) {}

void Renderer::configure(const Settings& settings, const RenderOptions& options) {
  options_ = options;
  for (auto& feature : features_) feature->configure(settings);
  variants_.clear();
}

// ---- A scene

void Renderer::take_lights() {
  lights_ = scene_->lights;
  for (const auto& feature : features_) feature->add_lights(*scene_, lights_);
  for (auto& feature : features_) feature->take_lights(lights_);
}

void Renderer::notify_moved() {
  if (!scene_) return;
  take_lights();
  for (auto& feature : features_) feature->moved(*scene_);
  variants_.clear();
}

void Renderer::nodes_moved() {
  if (nodes_) nodes_->moved();
  notify_moved();
}

void Renderer::lights_moved() {
  notify_moved();
}

void Renderer::prepare(const Scene& scene) {
  validate(scene);
  nodes_.reset();
  scene_ = nullptr;
  counts_ = {};
  variants_.clear();
  std::vector<std::vector<glm::vec4>> tangents(scene.meshes.size());
  for (std::size_t mesh = 0; mesh < tangents.size(); ++mesh)
    for (auto feature = features_.begin(); feature != features_.end() && tangents[mesh].empty(); ++feature)
      tangents[mesh] = (*feature)->tangents(scene, int(mesh));
  nodes_.emplace(gl_, transforms_, scene, tangents);
  skybox_ = scene.sky ? std::make_unique<Skybox>(gl_, *scene.sky) : nullptr;
  scene_ = &scene;
  take_lights();
  for (auto& feature : features_) feature->prepare(gl_, scene);
  check_gl_error(gl_, "making the textures of the scene");
}

bool Renderer::wants_another_frame() const {
  return std::ranges::any_of(features_, [](const auto& feature) { return feature->wants_another_frame(); });
}

bool Renderer::needs_stencil() const {
  for (const auto& feature : features_)
    if (scene_ && feature->needs_stencil(*scene_)) return true;
  return false;
}

// ---- Programs

std::string Renderer::reload_changed_shaders() {
  const Programs::Reloaded reloaded = programs_.reload_changed();
  if (reloaded.passes) notify_moved();  // discard what was drawn with the old programs
  return reloaded.words;
}

SurfaceKey Renderer::key_for(const View& view, const Node& node, const ViewKind& kind) const {
  SurfaceKey key;
  key.output = view.output;
  for (const auto& feature : features_) {
    const Need need = feature->need(*scene_, view, node);
    if (!need.wanted) continue;
    key.features.push_back(feature.get());
    key.structure.insert(need.structure.begin(), need.structure.end());
  }
  if (scene_->materials[std::size_t(node.material)].two_sided) key.structure["TWO_SIDED"] = std::string("1");
  if (kind.clipped) key.structure["CLIP_PLANE"] = std::string("1");
  if (node.kept) key.structure["KEPT"] = std::string("1");
  if (options_.constants_as_varyings) key.structure[constants_as_varyings] = std::string("1");
  if (kind.marks_non_finite) key.structure[marks_non_finite] = std::string("1");
  return key;
}

/// The program of each item: computed once, and again when the features' structure may have changed.
const std::vector<Renderer::Variant>& Renderer::variants(const View& view, const Target& target) {
  std::uint64_t version = 0;
  for (const auto& feature : features_) version += feature->structure_version();
  if (version != variants_version_) variants_.clear();
  variants_version_ = version;
  const ColourFormat format = target.spec().colour;
  const ViewKind kind{view.output, view.clip_plane.has_value(), view.openings_clip_plane.has_value(),
                      format == ColourFormat::rgba8 || format == ColourFormat::srgb8};
  if (const auto found = variants_.find(kind); found != variants_.end()) return found->second;
  std::vector<Variant> found;
  for (const Item& item : nodes_->items()) {
    const Node& node = scene_->nodes[std::size_t(item.node)];
    const bool left_out =
        std::ranges::any_of(features_, [&](const auto& feature) { return feature->hides(*scene_, view, node); });
    if (left_out) {
      found.push_back({});
      continue;
    }
    const Programs::Surface surface = programs_.surface(key_for(view, node, kind));
    found.push_back({&surface.key, &surface.program});
  }
  return variants_[kind] = std::move(found);
}

// ---- A view

Viewpoint Renderer::look(const View& view, const TargetSpec& target) const {
  const Camera& camera = view.camera;
  const glm::dvec3 origin = view.camera_relative ? outermost(view).camera.eye : glm::dvec3(0);
  const auto moved = [&](const glm::dvec3& p) {
    return view.camera_relative ? transforms_.relative_to_eye(p, origin) : glm::vec3(p);
  };
  const float aspect = float(target.width) / float(target.height);
  glm::mat4 projection;
  if (view.projection) {
    projection = *view.projection;
  } else if (camera.projection == Projection::orthographic) {
    const float top = camera.height / 2, right = top * aspect;
    // Reversed: swap the planes. Orthographic depth is linear, so a range from 0 to 1 would gain nothing.
    const float first = view.reversed_depth ? camera.far : camera.near,
                last = view.reversed_depth ? camera.near : camera.far;
    projection = transforms_.orthographic(-right, right, -top, top, first, last);
  } else {
    const auto make = view.reversed_depth ? transforms_.perspective_reversed : transforms_.perspective;
    projection = make(camera.fov_y, aspect, camera.near, camera.far);
  }
  if (!view.world_to_view)
    return {view,       transforms_.look_at(moved(camera.eye), moved(camera.target), camera.up),
            projection, moved(camera.eye),
            origin,     camera.eye};
  const glm::dvec3 eye(glm::inverse(glm::dmat4(*view.world_to_view))[3]);
  return {view, *view.world_to_view, projection, glm::vec3(eye), origin, view.eye.value_or(eye + origin)};
}

bool Renderer::hidden(const Item& item, const Viewpoint& viewpoint) const {
  return viewpoint.view.cull && outside_view(viewpoint.projection, viewpoint.world_to_view, item.model, item.box,
                                             depth_from_zero(viewpoint.view));
}

glm::vec3 Renderer::background(const View& view) const {
  if (view.output != "colour") return glm::vec3(0);
  return background_of_features(view).value_or(scene_->background);
}

std::optional<glm::vec3> Renderer::background_of_features(const View& view) const {
  std::optional<glm::vec3> colour;
  for (const auto& feature : features_)
    if (const std::optional<glm::vec3> replaced = feature->background(*scene_, view)) colour = replaced;
  return colour;
}

/// Sets depth state and the view's bounds; everything else has its default state.
void Renderer::set_bounds(const Viewpoint& viewpoint, const Target& target) {
  const View& view = viewpoint.view;
  reset_state(gl_);
  target.bind(gl_);
  const bool from_zero = depth_from_zero(view);
  if (gl_.ClipControl.call) gl_.ClipControl(GL_LOWER_LEFT, GLenum(from_zero ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE));
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GLenum(view.reversed_depth ? GL_GREATER : GL_LESS));
  gl_.ClearDepth(view.reversed_depth ? 0.0 : 1.0);
  if (view.scissor) {
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.Scissor(view.scissor->x, view.scissor->y, view.scissor->z, view.scissor->w);
  }
  if (view.stencil_level > 0) {
    gl_.Enable(GL_STENCIL_TEST);
    gl_.StencilFunc(GL_EQUAL, view.stencil_level, 0xff);
  }
  if (view.clip_plane) gl_.Enable(GL_CLIP_DISTANCE0);
  mirrored_ = view.mirrored;
}

void Renderer::begin(const Viewpoint& viewpoint, const Target& target) {
  const View& view = viewpoint.view;
  if (view.reversed_depth && !gl_.ClipControl.call)
    throw Error("reversed depth needs glClipControl (OpenGL 4.5 or ARB_clip_control), which this driver lacks");
  set_bounds(viewpoint, target);
  if (!view.parent) {  // otherwise the pixels belong to the enclosing view
    const glm::vec3 colour = background(view);
    gl_.ClearColor(colour.r, colour.g, colour.b, 1);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | (has_stencil(target.spec()) ? GL_STENCIL_BUFFER_BIT : 0));
  }
}

/// State shared by consecutive draws of a view.
struct Renderer::Drawing {
  const Viewpoint& viewpoint;
  const Program* program = nullptr;  ///< in use
  std::optional<Binder> bound;       ///< has set the view's uniforms; a material's textures use the next units
};

void Renderer::use(const Variant& variant, Drawing& drawing) {
  if (drawing.program == variant.program) return;
  gl_.UseProgram(variant.program->program.id());
  Binder binder(gl_, variant.program->uniforms);
  bind_viewpoint(binder, drawing.viewpoint);
  for (const auto& feature : features_)
    if (variant.key->has(*feature)) feature->bind_view(binder, *scene_, drawing.viewpoint);
  drawing.program = variant.program;
  drawing.bound.emplace(binder);
}

void Renderer::draw(const Item& item, const Variant& variant, Drawing& drawing) {
  const Node& node = scene_->nodes[std::size_t(item.node)];
  const Material& material = scene_->materials[std::size_t(node.material)];
  use(variant, drawing);
  Binder binder = *drawing.bound;
  binder.set("u_model", item.model);
  binder.set("u_normal_matrix", item.normal_matrix);
  binder.set("u_mirrored", int(item.mirrored));
  if (item.kept) binder.set("u_kept", *item.kept);
  for (const auto& feature : features_)
    if (variant.key->has(*feature)) feature->bind_material(binder, *scene_, material);
  if (material.two_sided || drawing.viewpoint.view.wireframe)
    gl_.Disable(GL_CULL_FACE);
  else
    gl_.Enable(GL_CULL_FACE);
  nodes_->draw(item, mirrored_);
}

void Renderer::draw_nodes(const Viewpoint& viewpoint, const Target& target) {
  const std::vector<Variant>& chosen = variants(viewpoint.view, target);
  transforms_.set_wireframe(gl_, viewpoint.view.wireframe);
  Drawing drawing{viewpoint};
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const Item& item = nodes_->items()[i];
    if (!chosen[i].program) continue;
    ++counts_.nodes;
    if (hidden(item, viewpoint))
      ++counts_.nodes_culled;
    else
      draw(item, chosen[i], drawing);
  }
  gl_.BindVertexArray(0);
}

/// The sky is a part of colour alone. A feature's background hides it: all light from infinity is lost in fog.
void Renderer::draw_sky(const Viewpoint& viewpoint) {
  const View& view = viewpoint.view;
  if (!skybox_ || view.output != "colour" || background_of_features(view)) return;
  skybox_->draw(viewpoint, programs_.pass(Skybox::pass()));
  ++counts_.skies;
}

bool Renderer::drawn_instead(const View& view, const Target& target) {
  return std::any_of(features_.rbegin(), features_.rend(),
                     [&](const auto& feature) { return feature->draw_instead(gl_, view, target); });
}

/// What features draw for a view before its surfaces.
void Renderer::draw_before(const Viewpoint& viewpoint, const Target& target) {
  mirrored_ = false;  // of this view, not of one that was drawn before
  for (const auto& feature : features_) {
    reset_state(gl_);
    target.bind(gl_);  // so that a pass that forgets to set viewport or framebuffer behaves the same every time
    feature->draw_before(gl_, *scene_, viewpoint, *this);
  }
}

void Renderer::draw_scene(const View& view, const Target& target) {
  const Viewpoint viewpoint = look(view, target.spec());
  counts_.matrices += nodes_->place(view.camera_relative, viewpoint.origin);
  const glm::ivec4 pixels = view.scissor.value_or(glm::ivec4(0, 0, target.spec().width, target.spec().height));
  ++counts_.views;
  counts_.view_pixels += std::int64_t(pixels.z) * pixels.w;
  const bool instead =
      std::ranges::any_of(features_, [&](const auto& feature) { return feature->may_draw_instead(view); });
  const bool nests = !instead && needs_stencil();
  if (!nests) draw_before(viewpoint, target);
  const DebugGroup group(gl_, (view.parent ? "scene inside: " : "scene: ") + view.output);
  begin(viewpoint, target);
  if (nests) {
    // Views inside come first: what their openings hide need not be shaded, and their maps replace those of this view.
    for (const auto& feature : features_) feature->draw_inside(gl_, *scene_, viewpoint, target, *this);
    draw_before(viewpoint, target);
    set_bounds(viewpoint, target);
  }
  if (instead && drawn_instead(view, target)) return;
  draw_nodes(viewpoint, target);
  draw_sky(viewpoint);
}

std::vector<ChainPass> Renderer::passes(const View& view) const {
  std::vector<ChainPass> all;
  for (const auto& feature : features_)
    for (ChainPass& pass : feature->passes(*scene_, view)) all.push_back(std::move(pass));
  return all;
}

void Renderer::draw_with_chain(const View& view, const Target& target) {
  const std::vector<ChainPass> all = view.passes ? passes(view) : std::vector<ChainPass>{};
  const auto draw = [&](const std::string& output, const Target& into) {
    View drawn = view;
    drawn.output = output;
    draw_scene(drawn, into);
  };
  const std::vector<ChainPass> active = passes_to_run(all, view.output);
  if (!active.empty()) return chain_.run(active, options_.chain_format.value_or(target.spec().colour), target, draw);
  draw(has_pass(all, view.output) ? "colour" : view.output, target);
}

void Renderer::render(const View& view, const Target& target) {
  if (!scene_) throw Error("Renderer::render: no scene was prepared");
  counts_ = {};
  const Viewpoint viewpoint = look(view, target.spec());
  counts_.matrices += nodes_->place(view.camera_relative, viewpoint.origin);
  for (const auto& feature : features_) {
    reset_state(gl_);
    feature->draw_views(gl_, *scene_, viewpoint, *this);
  }
  draw_with_chain(view, target);
  pool_.end_frame();
  for (const auto& feature : features_) feature->count(counts_);
  transforms_.set_wireframe(gl_, false);
  reset_state(gl_);
  check_gl_error(gl_, "drawing the scene");
}

// ---- For features that draw

void Renderer::paint(const PassSources& pass, std::span<const int> items, const std::function<void(Binder&)>& bind) {
  if (items.empty()) return;
  // First the whole nodes, then those that end at a plane, which need another program.
  for (const bool kept : {false, true}) {
    Program* chosen = nullptr;
    std::optional<Binder> binder;
    for (const int i : items) {
      const Item& item = nodes_->items()[std::size_t(i)];
      if (item.kept.has_value() != kept) continue;
      if (!chosen) {
        PassSources sources = pass;
        if (kept) sources.structure["KEPT"] = "1";
        chosen = &programs_.pass(sources);
        gl_.UseProgram(chosen->program.id());
        binder.emplace(gl_, chosen->uniforms);
        bind(*binder);
      }
      if (kept) binder->set("u_kept", *item.kept);
      binder->set("u_model", item.model);
      nodes_->draw(item, mirrored_);
    }
  }
  gl_.BindVertexArray(0);
}

void Renderer::draw_view(const View& view, const Target& target) {
  const DebugGroup group(gl_, "view");
  draw_with_chain(view, target);
  target.resolve(gl_);
}

}  // namespace atelier
