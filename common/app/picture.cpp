#include "app/picture.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>

#include "app/frame_settings.hpp"
#include "base/error.hpp"
#include "gl/debug.hpp"
#include "gl/state.hpp"
#include "image/average.hpp"

namespace atelier {

Camera apply(const CaseCamera& change, Camera camera) {
  if (change.eye) camera.eye = *change.eye;
  if (change.target) camera.target = *change.target;
  if (change.up) camera.up = glm::vec3(*change.up);
  if (change.fov_y_degrees) camera.fov_y = float(glm::radians(*change.fov_y_degrees));
  if (change.near) camera.near = float(*change.near);
  if (change.far) camera.far = float(*change.far);
  return camera;
}

Painter::Painter(StepProgram& program, HeadlessContext& context, const Implementations& implementations)
    : program_(program),
      context_(context),
      implementations_(implementations),
      shader_probe_(context_.gl(), implementations_) {
  program_.open(context_.gl(), implementations_);
}

void check_output(const StepDescription& description, const std::string& output) {
  const auto& outputs = description.outputs;
  if (std::none_of(outputs.begin(), outputs.end(), [&](const auto& o) { return o.name == output; })) {
    std::vector<std::string> names;
    for (const OutputSpec& spec : outputs) names.push_back(spec.name);
    throw Error(fmt::format("output '{}': {} offers {}", output, description.name, fmt::join(names, ", ")));
  }
}

Encoding encoding_of(const StepDescription& description, const std::string& output) {
  for (const OutputSpec& spec : description.outputs)
    if (spec.name == output) return spec.encoding;
  return Encoding::data;
}

Settings settings_for(const StepDescription& description, const Case& c) {
  Settings settings(description.settings);
  for (const auto& [name, value] : c.settings) settings.set(name, value);
  return settings;
}

const Target& Painter::target_for(const TargetSpec& spec) {
  if (!target_ || target_->spec() != spec) {
    target_.reset();  // free the old one before the new one is made
    target_.emplace(gl(), spec);
    label(gl(), *target_, "picture");
  }
  return *target_;
}

/// Draws one frame and stores its counts; returns the seconds until OpenGL has finished.
double Painter::draw(const Frame& frame, const Settings& settings) {
  gl().restart_counts();
  const auto begin = std::chrono::steady_clock::now();
  {
    const DebugGroup group(gl(), "frame");
    program_.draw(frame, settings);
    frame.target.resolve(gl());
  }
  gl().Finish();  // until here commands are only queued
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  cost_ = {.gl = gl().counts(), .scene = program_.counts(), .groups = gl().groups()};
  return taken.count();
}

namespace {

/// Counts fragments until the end of the scope.
class FragmentCount {
 public:
  explicit FragmentCount(Gl& gl) : gl_(gl) { gl_.count_fragments(true); }
  ~FragmentCount() { gl_.count_fragments(false); }
  FragmentCount(const FragmentCount&) = delete;
  FragmentCount& operator=(const FragmentCount&) = delete;

 private:
  Gl& gl_;
};

/// Throws an error that names the setting, before Target would throw its own.
void check_supersampling(const Gl& gl, glm::ivec2 size, int factor, int samples) {
  const int longest = longest_side(gl, samples);
  if (factor == 1 || std::max(size.x, size.y) * factor <= longest) return;
  throw Error(
      fmt::format("frame.supersampling={}: a picture of {}x{} would be drawn as {}x{} pixels, and this driver "
                  "has sides up to {}; choose a smaller factor or a smaller picture",
                  factor, size.x, size.y, size.x * factor, size.y * factor, longest));
}

}  // namespace

Image Painter::paint(const Case& picture, double time) {
  const StepDescription& description = program_.description();
  check_output(description, picture.output);
  const Settings settings = settings_for(description, picture);
  program_.load(picture.scene.empty() ? description.scenes.at(0) : picture.scene, settings);
  const Encoding encoding = encoding_of(description, picture.output);
  const int factor = supersampling_of(encoding, settings);
  const TargetSpec spec = frame_target(picture.size * factor, encoding, program_.depth_format(settings), settings);
  check_supersampling(gl(), picture.size, factor, spec.samples);
  const Target& target = target_for(spec);
  const Frame frame{target, apply(picture.camera, program_.camera()), picture.output, time};
  constexpr int warming_up = 2;
  std::vector<double> seconds;
  if (timed_frames_ > 0) {
    for (int i = 0; i < warming_up; ++i) draw(frame, settings);
    for (int i = 0; i < timed_frames_; ++i) seconds.push_back(draw(frame, settings));
  }
  if (timed_frames_ == 0 || counts_fragments_) {
    std::optional<FragmentCount> counted;
    if (counts_fragments_) counted.emplace(gl());
    draw(frame, settings);
  }
  if (!seconds.empty()) cost_.frames = timings_of(seconds);
  Image drawn = target.read_colour(gl());
  return factor > 1 ? averaged(drawn, factor, encoding) : drawn;
}

std::vector<Numbers> Painter::probe(const Case& values) {
  const auto& probes = program_.description().probes;
  const auto found = probes.find(values.probe);
  if (found == probes.end()) {
    std::vector<std::string> names;
    for (const auto& [name, function] : probes) names.push_back(name);
    throw Error(
        fmt::format("probe '{}': {} offers {}", values.probe, program_.description().name, fmt::join(names, ", ")));
  }
  ProbeContext probe_context{gl(), shader_probe_};
  std::vector<Numbers> results;
  for (const Arguments& arguments : values.inputs) {
    reset_state(gl());
    results.push_back(found->second(probe_context, arguments));
  }
  check_gl_error(gl(), ("probe " + values.probe).c_str());  // else the error would be reported in the next case
  return results;
}

}  // namespace atelier
