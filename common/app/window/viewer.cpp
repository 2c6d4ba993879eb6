#include "app/window/viewer.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <glm/gtc/constants.hpp>

#include "app/frame_settings.hpp"
#include "app/picture.hpp"
#include "base/error.hpp"
#include "base/near_names.hpp"
#include "gl/debug.hpp"

namespace atelier {
namespace {

constexpr double walking_pace = 1.6, seconds_of_a_step = 0.15;  // m/s; of a key's press

/// Throws for unknown names on the command line; errors of the program itself are shown in the window.
void check_names(const StepDescription& description, const std::string& scene, const std::string& output) {
  const auto& scenes = description.scenes;
  const bool known = std::find(scenes.begin(), scenes.end(), scene) != scenes.end();
  if (std::error_code unreadable; !known && !std::filesystem::is_regular_file(scene, unreadable))
    throw Error(fmt::format("--scene {}: {} has no such scene, and there is no such file{}", scene, description.name,
                            suggestion(scene, scenes)));
  std::vector<std::string> outputs;
  for (const OutputSpec& spec : description.outputs) outputs.push_back(spec.name);
  if (std::find(outputs.begin(), outputs.end(), output) == outputs.end())
    throw Error(
        fmt::format("--output {}: {} has no such output{}", output, description.name, suggestion(output, outputs)));
}

/// Runs a student's code; returns the message of its exception, or an empty string.
template <class Attempt>
std::string words_of(Attempt&& attempt) {
  try {
    attempt();
    return {};
  } catch (const std::exception& error) {
    return *error.what() ? error.what() : "an exception without a message was thrown";
  } catch (...) {
    return "an exception was thrown that is not a std::exception";
  }
}

}  // namespace

Viewer::Viewer(StepProgram& program, Gl& gl, const Implementations& implementations, const CommandLine& line)
    : program_(program),
      gl_(gl),
      settings_(with_window_defaults(program.description().settings, most_samples(gl))),
      first_camera_(line.picture.camera) {
  const StepDescription& described = description();
  if (described.scenes.empty()) throw Error(fmt::format("{}: it has no scene to show", described.name));
  scene_ = line.picture.scene.empty() ? described.scenes.front() : line.picture.scene;
  output_ = line.picture.output;
  check_names(described, scene_, output_);
  for (const auto& [name, text] : line.settings) settings_.set(name, text);
  program_.open(gl_, implementations);
}

Encoding Viewer::encoding() const {
  return encoding_of(description(), output_);
}

void Viewer::choose_scene(const std::string& name) {
  scene_ = name;
  take_camera_ = must_load_ = true;
}

void Viewer::choose_output(const std::string& name) {
  output_ = name;
  must_draw_ = true;
}

void Viewer::set(const std::string& name, const SettingValue& value) {
  settings_.set(name, value);
  must_load_ = true;  // a setting may change the scene
}

void Viewer::reset_settings() {
  settings_ = Settings(settings_.specs());
  must_load_ = true;
}

void Viewer::resize(glm::ivec2 pixels) {
  pixels = glm::clamp(pixels, 1, Image::max_side);
  if (pixels == size_) return;
  size_ = pixels;
  must_draw_ = true;
}

// ---- The camera

Camera Viewer::camera() const {
  // If not moved, the camera is exactly that of --out, to the last bit.
  Camera camera = program_.camera();
  if (first_camera_) camera = apply(*first_camera_, camera);
  if (!moved_) return camera;
  return walked() ? walker_.camera : camera_on(orbit_, camera, start_);
}

void Viewer::begin_at(const Camera& camera) {
  start_ = orbit_ = orbit_of(camera);
  walker_ = {.camera = camera};
}

void Viewer::walk(const Walking& walking, double seconds) {
  trouble.drawing = words_of([&] {
    const auto before = settings_.values();
    walker_ = program_.walk(walker_, walking, seconds, settings_);
    must_load_ |= settings_.values() != before;
  });
  moved_ = must_draw_ = true;
}

void Viewer::turn(glm::dvec2 way, double height) {
  const double radians = glm::pi<double>() / std::max(height, 1.0);
  if (walked()) return walk({.turn = way * radians}, 0);
  orbit_ = turned(orbit_, -way.x * radians, way.y * radians);
  moved_ = must_draw_ = true;
}

void Viewer::pan(glm::dvec2 way, double height) {
  if (walked())
    return walk({.velocity = {-walking_pace * glm::sign(way.x), 0}}, 4 * std::abs(way.x) / std::max(height, 1.0));
  orbit_ = panned(orbit_, way, metres_per_pixel(orbit_, camera(), height));
  moved_ = must_draw_ = true;
}

void Viewer::dolly(double steps) {
  if (walked()) return walk({.velocity = {0, walking_pace * glm::sign(steps)}}, std::abs(steps) * seconds_of_a_step);
  orbit_ = dollied(orbit_, steps);
  moved_ = must_draw_ = true;
}

void Viewer::arrow(glm::dvec2 direction) {
  constexpr double small = 0.04;  // of half a turn
  if (!walked() || direction.x != 0) return turn(glm::dvec2(-direction.x, direction.y) * small, 1);
  walk({.velocity = {0, walking_pace * direction.y}}, seconds_of_a_step);
}

void Viewer::reset_camera() {
  first_camera_.reset();
  if (loaded_) begin_at(program_.camera());
  must_draw_ = true;
}

void Viewer::advance(double seconds) {
  if (walked() && walker_.velocity != glm::dvec3(0)) walk({}, seconds);
  if (!playing_) return;
  time_ += seconds;
  must_draw_ = true;
}

// ---- Drawing

void Viewer::load() {
  loaded_ = false;
  trouble.drawing = words_of([&] { program_.load(scene_, settings_); });
  must_load_ = false;
  if (!trouble.drawing.empty()) return;
  loaded_ = must_draw_ = true;
  if (!take_camera_) return;
  // The command line's camera is only for the first scene.
  if (picture()) first_camera_.reset();
  take_camera_ = moved_ = false;
  begin_at(camera());
}

void Viewer::draw_into(const Target& target) {
  gl_.restart_counts();
  const auto begin = std::chrono::steady_clock::now();
  {
    const DebugGroup group(gl_, "frame");
    program_.draw({target, camera(), output_, time_}, settings_);
    target.resolve(gl_);
  }
  gl_.Finish();  // until here commands are only queued
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  if (gl_.counts().programs_linked == 0) times_.add(taken.count());  // frames that compile shaders are not timed
}

bool Viewer::draw() {
  if (must_load_) load();
  if (!must_draw_ || !loaded_) return false;
  must_draw_ = unfinished_ = false;
  trouble.drawing = words_of([&] {
    const TargetSpec spec = frame_target(size_, encoding(), program_.depth_format(settings_), settings_);
    if (!spare_ || spare_->spec() != spec) {
      spare_.reset();  // free the old one before the new one is made
      spare_ = std::make_unique<Target>(gl_, spec);
      label(gl_, *spare_, "picture");
    }
    draw_into(*spare_);
  });
  if (!trouble.drawing.empty()) return false;
  cost_ = {.gl = gl_.counts(), .scene = program_.counts(), .groups = gl_.groups()};
  std::swap(shown_, spare_);
  unfinished_ = program_.wants_another_frame();
  must_draw_ |= unfinished_;
  return true;
}

bool Viewer::reload_shaders() {
  const auto linked = gl_.counts().programs_linked;
  const std::string before = trouble.shaders;
  std::string refused;
  const std::string thrown = words_of([&] { refused = program_.reload_changed_shaders(); });
  trouble.shaders = thrown.empty() ? refused : thrown;
  const bool rebuilt = gl_.counts().programs_linked != linked;
  must_draw_ |= rebuilt;
  return rebuilt || trouble.shaders != before;
}

bool Viewer::retry() {
  if (trouble.drawing.empty()) return false;
  must_draw_ = true;
  must_load_ = !loaded_;
  return true;
}

CommandLine Viewer::command_line(CommandLine line) const {
  line.picture.scene = scene_;
  line.picture.output = output_;
  line.picture.camera = moved_ || !first_camera_ ? CaseCamera{} : *first_camera_;
  if (moved_) {
    const Camera now = camera();
    line.picture.camera.eye = now.eye;
    line.picture.camera.target = now.target;
  }
  line.settings.clear();
  for (const SettingSpec& spec : settings_.specs())
    if (const SettingValue& value = settings_.value(spec.name); value != spec.fallback)
      line.settings.emplace_back(spec.name, setting_text(value));
  return line;
}

}  // namespace atelier
