#include "10-artstyles/given/style_passes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "02-blinn-phong/given/shaders_alone.hpp"
#include "08-post-processing/given/post_chain.hpp"
#include "base/error.hpp"
#include "oracle/frame.hpp"

namespace atelier {

// ---- Settings

std::vector<SettingSpec> style_settings() {
  const std::vector<std::string> styles = {"none", "painterly", "toon", "fisheye", "aberration"};
  return {
      {.name = "style.first", .fallback = std::string("none"), .choices = styles, .help = "a style"},
      {.name = "style.second",
       .fallback = std::string("none"),
       .choices = styles,
       .help = "a style of what the first one has made"},
      {.name = "paint.iterations", .fallback = 15, .low = 1, .high = 30, .help = "grids of strokes"},
      {.name = "paint.grid", .fallback = 10, .low = 2, .high = 64, .help = "pixels: the cells of the grids, about"},
      {.name = "paint.smallest", .fallback = 1, .low = 0, .high = 64, .help = "pixels: the radius of the finest brush"},
      {.name = "paint.largest",
       .fallback = 6,
       .low = 0,
       .high = 64,
       .help = "pixels: the radius of the broadest brush"},
      {.name = "paint.reach",
       .fallback = 4,
       .low = 0,
       .high = 32,
       .help = "pixels: how far around a stroke's centre the contrast is measured"},
      {.name = "paint.full",
       .fallback = 0.4,
       .low = 0.01,
       .high = 10,
       .help = "the relative contrast that takes the finest brush"},
      {.name = "paint.length", .fallback = 3.0, .low = 0, .high = 10, .help = "of strokes, in radii of the brush"},
      {.name = "paint.opacity", .fallback = 200, .low = 0, .high = 255, .help = "of the paint"},
      {.name = "paint.confined", .fallback = false, .help = "strokes do not cross borders in the picture"},
      {.name = "paint.border",
       .fallback = 150,
       .low = 0,
       .high = 1140,
       .help = "codes: the strength of an edge above which it is a border"},
      {.name = "paint.fast", .fallback = false, .help = "paint many pixels at a time; changes no pixel"},
      {.name = "paint.threads", .fallback = 2, .low = 1, .high = 8, .help = "that paint; changes no pixel"},
      {.name = "toon.outlines",
       .fallback = std::string("colour"),
       .choices = {"none", "colour", "surface", "both"},
       .help = "where lines are drawn: where the colour changes, or where depth or normal change"},
      {.name = "toon.low", .fallback = 0.5, .low = 0, .high = 4.4, .help = "edges up to this strength get no ink"},
      {.name = "toon.high",
       .fallback = 1.0,
       .low = 0.01,
       .high = 4.5,
       .help = "edges from this strength on are black; above toon.low"},
      {.name = "fisheye.lens",
       .fallback = std::string("power"),
       .choices = {"power", "equidistant"},
       .help = "which distances from the centre it changes into which"},
      {.name = "fisheye.strength", .fallback = 0.5, .low = 0, .high = 10, .help = "of the power lens"},
      {.name = "fisheye.power", .fallback = 2.0, .low = 1, .high = 8, .help = "of the distance, for the power lens"},
      {.name = "fisheye.angle",
       .fallback = 180.0,
       .low = 10,
       .high = 360,
       .help = "degrees: what the circle of the equidistant lens shows, from edge to edge"},
      {.name = "fisheye.from",
       .fallback = std::string("picture"),
       .choices = {"picture", "cube"},
       .help = "what the equidistant lens sees; cube: the scene in six directions, if it is the first style"},
      {.name = "fisheye.edge", .fallback = 512, .low = 16, .high = 2048, .help = "pixels: of the cube's faces"},
      {.name = "fisheye.faces",
       .fallback = std::string("needed"),
       .choices = {"needed", "all"},
       .help = "which faces of the cube are drawn"},
      {.name = "fisheye.restored", .fallback = false, .help = "undo the lens afterwards"},
      {.name = "aberration.amount",
       .fallback = 0.02,
       .low = 0,
       .high = 0.5,
       .help = "the greatest shift of a channel, as a part of the distance from the centre"},
      {.name = "aberration.turns", .fallback = 0.0, .low = 0, .high = 10, .help = "periods that have passed"},
  };
}

std::vector<OutputSpec> style_outputs() {
  std::vector<OutputSpec> outputs = post_outputs();
  outputs.push_back({"first", Encoding::linear, "the picture after the first style", Stage::pass});
  outputs.push_back({"second", Encoding::linear, "the picture after the second style", Stage::pass});
  outputs.push_back({"edges", Encoding::data, "how strongly the picture changes, as a part of the most that it can",
                     Stage::after_colour});
  outputs.push_back({"steps", Encoding::data, "red: steps in depth, green: bends of the surface", Stage::aside});
  outputs.push_back({"relief", Encoding::data,
                     "the picture's normal map, as n/2 + 1/2, distorted by the first style if it is a fish-eye",
                     Stage::aside});
  return outputs;
}

Painting painting_of(const Settings& settings) {
  Painting how{.iterations = settings.integer("paint.iterations"),
               .grid = settings.integer("paint.grid"),
               .brush = {.smallest = settings.integer("paint.smallest"),
                         .largest = settings.integer("paint.largest"),
                         .reach = settings.integer("paint.reach"),
                         .full = float(settings.real("paint.full"))},
               .length = settings.real("paint.length"),
               .opacity = settings.integer("paint.opacity"),
               .confined = settings.flag("paint.confined"),
               .border = settings.integer("paint.border"),
               .threads = settings.integer("paint.threads")};
  if (how.brush.smallest > how.brush.largest)
    throw Error(fmt::format("paint.smallest is {}: it must not be above paint.largest, which is {}", how.brush.smallest,
                            how.brush.largest));
  return how;
}

Styles styles_of(const Settings& settings) {
  const auto style = [&](const char* setting) {
    const std::string& name = settings.choice(setting);
    return name == "painterly"    ? Style::painterly
           : name == "toon"       ? Style::toon
           : name == "fisheye"    ? Style::fisheye
           : name == "aberration" ? Style::aberration
                                  : Style::none;
  };
  return {style("style.first"), style("style.second")};
}

bool begins_with_cube(const Settings& settings) {
  return styles_of(settings)[0] == Style::fisheye && settings.choice("fisheye.lens") == "equidistant" &&
         settings.choice("fisheye.from") == "cube";
}

// ---- Views

glm::dmat3 view_axes(const Camera& camera) {
  const oracle::ViewFrame frame = oracle::view_frame(camera.target - camera.eye, glm::dvec3(camera.up));
  return {frame.right, frame.up, -frame.ahead};
}

namespace {

const char* const glsl_file = "10-artstyles/given/style_passes.glsl";

void check_perspective(const View& view, const char* setting) {
  if (view.camera.projection == Projection::orthographic)
    throw Error(fmt::format("{} needs a camera in perspective: the scene's is orthographic", setting));
}

/// The frame of a cube's face as OpenGL looks it up, 0 to 5: ahead, and up.
struct Face {
  glm::dvec3 ahead, up;
};
constexpr std::array<Face, 6> faces = {{{{1, 0, 0}, {0, -1, 0}},
                                        {{-1, 0, 0}, {0, -1, 0}},
                                        {{0, 1, 0}, {0, 0, 1}},
                                        {{0, -1, 0}, {0, 0, -1}},
                                        {{0, 0, 1}, {0, -1, 0}},
                                        {{0, 0, -1}, {0, -1, 0}}}};

/// Whether a cone around -z reads something of a face: its nearest point is in the middle of the face ahead, 45 degrees
/// from the axis on those at the sides, and at the corners of the one behind. Filters read up to half a texel farther.
bool sees_face(std::size_t face, double cone, int edge) {
  const double half_angle = cone + std::atan(1.0 / edge);
  const double corner = std::numbers::pi - std::atan(std::numbers::sqrt2);
  return face == 5 || half_angle > (face == 4 ? corner : std::numbers::pi / 4);
}

ChainPass lens_pass(const char* name, const char* function) {
  ChainPass pass{.name = name, .code = {glsl_file, function}};
  pass.structure = no_lights();
  pass.smooth = true;
  return pass;
}

}  // namespace

void CubeOfViews::configure(const Settings& settings) {
  wanted_ = begins_with_cube(settings);
  all_faces_ = settings.choice("fisheye.faces") == "all";
  half_angle_ = glm::radians(settings.real("fisheye.angle") / 2);
  edge_ = settings.integer("fisheye.edge");
}

void CubeOfViews::draw_views(Gl& gl, const Scene&, const Viewpoint& viewpoint, ScenePainter& painter) {
  cube_ = nullptr;
  const std::vector<OutputSpec> chain = post_outputs();
  const std::string& output = viewpoint.view.output;
  const bool of_chain = output == "colour" || output == "first" || output == "second" || output == "edges" ||
                        std::ranges::count(chain, output, &OutputSpec::name) > 0;
  if (!wanted_ || !of_chain) return;
  check_perspective(viewpoint.view, "fisheye.from=cube");
  cube_ = painter.targets().take(CubeTargetSpec{.edge = edge_, .depth = DepthFormat::depth32f});
  const Camera& camera = viewpoint.view.camera;
  const glm::dmat3 to_world = view_axes(camera);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (!all_faces_ && !sees_face(i, half_angle_, edge_)) continue;
    View view = viewpoint.view;
    view.output = "colour";
    view.passes = false;
    view.camera.target = camera.eye + to_world * faces[i].ahead;
    view.camera.up = glm::vec3(to_world * faces[i].up);
    view.camera.fov_y = std::numbers::pi_v<float> / 2;
    painter.draw_view(view, cube_->face(int(i)));
  }
  gl.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

std::vector<ChainPass> CubeOfViews::passes(const Scene&, const View&) const {
  if (!cube_) return {};
  ChainPass pass = lens_pass("cube", "cube_pass");
  pass.begins = true;
  pass.structure["CUBE"] = "1";
  pass.structure["EQUIDISTANT"] = "1";
  pass.bind = [this](Binder& binder) {
    binder.set("u_half_angle", float(half_angle_));
    binder.texture("u_cube", cube_->texture(), GL_TEXTURE_CUBE_MAP);
  };
  return {pass};
}

// ---- Styles

void StylePasses::configure(const Settings& settings) {
  styles_ = styles_of(settings);
  cube_ = begins_with_cube(settings);
  equidistant_ = settings.choice("fisheye.lens") == "equidistant";
  restored_ = settings.flag("fisheye.restored");
  const std::string& outlines = settings.choice("toon.outlines");
  colour_edges_ = outlines == "colour" || outlines == "both";
  surface_edges_ = outlines == "surface" || outlines == "both";
  low_ = float(settings.real("toon.low"));
  high_ = float(settings.real("toon.high"));
  if (low_ >= high_) throw Error(fmt::format("toon.low is {}: it must be below toon.high, which is {}", low_, high_));
  half_angle_ = float(glm::radians(settings.real("fisheye.angle") / 2));
  strength_ = float(settings.real("fisheye.strength"));
  power_ = float(settings.real("fisheye.power"));
  amount_ = float(settings.real("aberration.amount"));
  turns_ = float(settings.real("aberration.turns"));
  painting_ = painting_of(settings);
  fast_ = settings.flag("paint.fast");
}

/// A pass that may look through the lens.
ChainPass StylePasses::shader_pass(const char* name, const char* function, const View& view) const {
  ChainPass pass = lens_pass(name, function);
  if (equidistant_) pass.structure["EQUIDISTANT"] = "1";
  pass.bind = [this, view](Binder& binder) {
    const float above = std::tan(view.camera.fov_y / 2);
    binder.set("u_half_height", above);
    binder.set("u_half_angle", half_angle_);
    binder.set("u_strength", strength_);
    binder.set("u_power", power_);
    binder.set("u_amount", amount_);
    binder.set("u_turns", turns_);
  };
  return pass;
}

void StylePasses::read_surfaces(ChainPass& pass, const View& view, bool behind_lens) const {
  if (behind_lens && cube_)
    throw Error("toon.outlines=surface after fisheye.from=cube: the six views have colours alone; use colour");
  check_perspective(view, "lines from surfaces (toon.outlines, output 'steps')");
  pass.reads = {"position", "normal"};
  pass.structure["SURFACES"] = "1";
  if (behind_lens) pass.structure["BEHIND_LENS"] = "1";
  pass.bind = [view, lens = pass.bind](Binder& binder) {
    lens(binder);
    const Camera& camera = view.camera;
    binder.set("u_eye_of_view", view.camera_relative ? glm::vec3(0) : glm::vec3(camera.eye));
    binder.set("u_ahead", glm::vec3(-view_axes(camera)[2]));
  };
}

ChainPass StylePasses::toon_pass(const char* name, const View& view, bool behind_lens) const {
  ChainPass pass = shader_pass(name, "toon_pass", view);
  pass.smooth = false;
  pass.structure["TOON"] = "1";
  if (colour_edges_) pass.structure["COLOUR_EDGES"] = "1";
  if (surface_edges_) read_surfaces(pass, view, behind_lens);
  pass.bind = [this, before = pass.bind](Binder& binder) {
    before(binder);
    binder.set("u_low", low_);
    binder.set("u_high", high_);
  };
  return pass;
}

ChainPass StylePasses::painterly_pass(const char* name) const {
  ChainPass pass{.name = name};
  pass.on_bytes = [this](ByteImage& picture, const PassInputs&) {
    artstyles::Picture source{picture.width, picture.height, std::vector<glm::u8vec4>(picture.rgba.size() / 4)};
    std::memcpy(source.pixels.data(), picture.rgba.data(), picture.rgba.size());
    const artstyles::Picture result = painted(source, painting_, fast_ ? fast_strokes() : student_strokes());
    if (result.pixels.size() != source.pixels.size())
      throw Error(fmt::format("paint_stroke has changed the number of pixels from {} to {}", source.pixels.size(),
                              result.pixels.size()));
    std::memcpy(picture.rgba.data(), result.pixels.data(), picture.rgba.size());
  };
  return pass;
}

ChainPass StylePasses::style_pass(std::size_t i, const char* name, const View& view) const {
  const bool seen_already = i == 0 && cube_;  // CubeOfViews has begun the picture with it
  const bool behind_lens = i == 1 && styles_[0] == Style::fisheye;
  switch (seen_already ? Style::none : styles_[i]) {
    case Style::painterly:
      return painterly_pass(name);
    case Style::toon:
      return toon_pass(name, view, behind_lens);
    case Style::fisheye:
      if (equidistant_) check_perspective(view, "fisheye.lens=equidistant");
      return shader_pass(name, "fisheye_pass", view);
    case Style::aberration:
      return shader_pass(name, "aberration_pass", view);
    case Style::none:
      break;
  }
  return {.name = name, .identity = true};
}

ChainPass StylePasses::relief_pass(const View& view) const {
  if (cube_) throw Error("output 'relief' after fisheye.from=cube: the six views have colours alone");
  if (styles_[0] == Style::fisheye && equidistant_) check_perspective(view, "fisheye.lens=equidistant");
  ChainPass pass = shader_pass("relief", "relief_pass", view);
  pass.reads = {"normal"};
  pass.begins = true;
  pass.structure["RELIEF"] = "1";
  if (styles_[0] == Style::fisheye) pass.structure["BEHIND_LENS"] = "1";
  pass.bind = [view, lens = pass.bind](Binder& binder) {
    lens(binder);
    binder.set("u_world_to_view", glm::mat3(glm::transpose(view_axes(view.camera))));
  };
  return pass;
}

std::vector<ChainPass> StylePasses::passes(const Scene&, const View& view) const {
  if (view.output == "relief") return {relief_pass(view)};
  if (view.output == "steps") {
    ChainPass steps = shader_pass("steps", "steps_pass", view);
    read_surfaces(steps, view, false);
    steps.begins = true;
    return {steps};
  }
  std::vector<ChainPass> all = {style_pass(0, "first", view), style_pass(1, "second", view)};
  if (restored_ && std::ranges::count(styles_, Style::fisheye) > 0)
    all.push_back(shader_pass("restored", "restored_pass", view));
  if (view.output == "edges") {
    all.push_back(shader_pass("edges", "edges_pass", view));
    all.back().smooth = false;
  }
  return all;
}

}  // namespace atelier
