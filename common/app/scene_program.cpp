#include "app/scene_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <vector>

#include "app/frame_settings.hpp"
#include "scene/depth_range.hpp"
#include "scene_import/scene_import.hpp"

namespace atelier {

namespace {

bool is_model_file(const std::string& name) {
  std::string extension = std::filesystem::path(name).extension().string();
  for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  return extension == ".gltf" || extension == ".glb" || extension == ".obj";
}

/// Imports a model; prints on stderr what was fixed or left out.
Scene import_with_notes(const std::string& file) {
  std::vector<std::string> notes;
  Scene scene = import_scene(file, &notes);
  for (const std::string& note : notes)
    fmt::print(stderr, "note: {}\n", note.starts_with(file) ? note : file + ": " + note);
  return scene;
}

/// The format of pictures between two passes; none: that of the final picture.
std::optional<ColourFormat> chain_format(const StepDescription& description, const Settings& settings) {
  if (!lists(description, "chain.format")) return {};
  const std::string& format = settings.choice("chain.format");
  if (format == "frame") return {};
  return format == "8" ? ColourFormat::srgb8 : format == "16f" ? ColourFormat::rgba16f : ColourFormat::rgba32f;
}

RenderOptions options_of(const StepDescription& description, const Settings& settings) {
  return {.chain_format = chain_format(description, settings),
          .constants_as_varyings = settings.choice("draw.constants") == "varyings"};
}

/// The same depth with a stencil buffer. There is none with 16 bits.
DepthFormat with_stencil(DepthFormat format) {
  return format == DepthFormat::depth32f ? DepthFormat::depth32f_stencil8 : DepthFormat::depth24_stencil8;
}

}  // namespace

bool lists(const StepDescription& description, const std::string& setting) {
  return std::any_of(description.settings.begin(), description.settings.end(),
                     [&](const SettingSpec& spec) { return spec.name == setting; });
}

std::vector<SettingSpec> view_settings() {
  return {
      {.name = "depth.format",
       .fallback = std::string("24"),
       .choices = {"16", "24", "32f", "32f-reversed"},
       .help = "how depth is stored; reversed: 1 at the near plane, which distributes float precision better"},
      {.name = "world.camera_relative",
       .fallback = false,
       .help = "translate the world so that the eye is its origin, in double precision, before conversion to float"},
      {.name = "draw.wireframe", .fallback = false, .help = "edges instead of faces"},
      {.name = "camera.fit_depth",
       .fallback = false,
       .help = "fit the near and far planes to the visible objects, for better depth precision"},
      {.name = "draw.cull", .fallback = false, .help = "skip nodes whose boxes are outside the view"},
  };
}

SettingSpec draw_constants_setting() {
  return {.name = "draw.constants",
          .fallback = std::string("uniforms"),
          .choices = {"uniforms", "varyings"},
          .help =
              "how constants of a draw reach its pixels; varyings: cheaper per pixel if the driver fetches uniforms "
              "for every pixel (without a GPU), more expensive per triangle"};
}

SettingSpec chain_format_setting() {
  return {.name = "chain.format",
          .fallback = std::string("frame"),
          .choices = {"frame", "32f", "16f", "8"},
          .help = "how pictures between two passes are stored; frame: like the final picture"};
}

SceneProgram::SceneProgram(SceneStep step) : step_(std::move(step)) {
  description_ = {.name = step_.name, .title = step_.title, .imports = true, .probes = step_.probes};
  for (const NamedScene& scene : step_.scenes) description_.scenes.push_back(scene.name);
  for (const auto& group : step_.settings)
    description_.settings.insert(description_.settings.end(), group.begin(), group.end());
  description_.settings.push_back(draw_constants_setting());
  for (SettingSpec& spec : frame_settings()) description_.settings.push_back(std::move(spec));
  description_.outputs = {{"colour", Encoding::linear, "what is seen", Stage::colour}};
  for (const OutputSpec& output : step_.outputs) description_.outputs.push_back(output);
  const auto add = [&](const char* name, const char* help) {
    description_.outputs.push_back({name, Encoding::data, help, Stage::surface});
  };
  add("position", "the position in world space, metres");
  add("depth", "depth as it is stored: 0 to 1");
  add("texcoord", "the texture coordinate as (u, v, 0)");
  add("normal", "the normal n in world space, as n/2 + 1/2");
}

void SceneProgram::open(Gl& gl, const Implementations& implementations) {
  FeatureList features;
  step_.features(features);
  renderer_ = std::make_unique<Renderer>(gl, implementations, step_.transforms, features.take(), step_.chain);
}

void SceneProgram::load(const std::string& scene, const Settings& settings) {
  Loaded wanted{scene, settings.values()};
  if (loaded_ == wanted && !is_model_file(scene)) return;  // a model file may have changed
  loaded_.reset();
  scene_ = is_model_file(scene) ? import_with_notes(scene) : make_scene(step_.scenes, scene, settings);
  boxes_.clear();
  renderer_->configure(settings, options_of(description_, settings));
  renderer_->prepare(scene_);
  loaded_ = std::move(wanted);
}

bool SceneProgram::is_walked() const {
  return step_.walk && loaded_ && !is_model_file(loaded_->scene);
}

/// Another place in the same scene: nothing is made or drawn again that stays as it was. A scene with portals is loaded
/// again, since others may be open from there.
Walker SceneProgram::walk(const Walker& walker, const Walking& walking, double seconds, Settings& settings) {
  const auto before = settings.values();
  const Walker after = step_.walk(walker, walking, seconds, settings);
  if (settings.values() != before && loaded_->settings == before && scene_.portals.empty()) {
    renderer_->configure(settings, options_of(description_, settings));
    loaded_->settings = settings.values();
    scene_.camera = after.camera;  // where one has come in
  }
  return after;
}

DepthFormat SceneProgram::depth_format(const Settings& settings) const {
  const std::string format = lists(description_, "depth.format") ? settings.choice("depth.format") : "24";
  const DepthFormat plain = format == "16"   ? DepthFormat::depth16
                            : format == "24" ? DepthFormat::depth24
                                             : DepthFormat::depth32f;
  return renderer_ && renderer_->needs_stencil() ? with_stencil(plain) : plain;
}

void SceneProgram::draw(const Frame& frame, const Settings& settings) {
  View view{.camera = step_.visit ? step_.visit(scene_, frame.camera, settings) : frame.camera, .output = frame.output};
  if (lists(description_, "depth.format")) view.reversed_depth = settings.choice("depth.format") == "32f-reversed";
  if (lists(description_, "world.camera_relative")) view.camera_relative = settings.flag("world.camera_relative");
  view.cull = !lists(description_, "draw.cull") || settings.flag("draw.cull");
  if (lists(description_, "camera.fit_depth") && settings.flag("camera.fit_depth")) {
    if (boxes_.empty()) boxes_ = node_boxes(scene_);
    const TargetSpec& picture = frame.target.spec();
    view.camera = fit_depth(view.camera, double(picture.width) / picture.height, boxes_);
  }
  if (lists(description_, "draw.wireframe")) view.wireframe = settings.flag("draw.wireframe");
  renderer_->render(view, frame.target);
}

Image SceneProgram::truth(const TruthRequest& request, const Settings& settings) const {
  if (!step_.truth) return StepProgram::truth(request, settings);
  std::optional<Scene> model;
  if (is_model_file(request.scene)) model = import_scene(request.scene);
  return trace_scene(step_.truth(request, settings, std::move(model)), request, description_, settings);
}

}  // namespace atelier
