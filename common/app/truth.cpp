#include "app/truth.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "app/cases.hpp"
#include "app/picture.hpp"
#include "base/error.hpp"
#include "case/exchange.hpp"

namespace atelier {

namespace {

constexpr const char* only_of_truth = "thing";  // which node is visible: OpenGL has no such output

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool stderr_is_a_terminal() {
  const char* terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && terminal && std::string_view(terminal) != "dumb";
}

}  // namespace

Image trace_case(const StepProgram& program, const Case& picture, int samples) {
  const StepDescription& description = program.description();
  if (picture.output != only_of_truth) check_output(description, picture.output);
  const auto bar = std::make_shared<ProgressBar>(stderr, stderr_is_a_terminal());
  return program.truth({.scene = picture.scene.empty() ? description.scenes.at(0) : picture.scene,
                        .camera = picture.camera,
                        .size = picture.size,
                        .output = picture.output,
                        .samples = samples,
                        .progress = [bar](double done) { bar->show(done); }},
                       settings_for(description, picture));
}

void trace_cases(const StepProgram& program, const std::filesystem::path& cases, const std::filesystem::path& folder,
                 int samples, std::optional<int> progress) {
  const auto answer = [&](const Case& c) {
    if (!c.probe.empty()) throw Error("probe '" + c.probe + "': only pictures are traced");
    write_pixels(folder / (c.name + ".pixels"), trace_case(program, c, samples));
  };
  answer_cases(answer, cases, folder, progress);
}

ProgressBar::ProgressBar(std::FILE* out, bool terminal, double patience_s)
    : out_(out), terminal_(terminal), patience_s_(patience_s), began_s_(now_s()) {}

ProgressBar::~ProgressBar() {
  if (shown_ < 0) return;
  fmt::print(out_, "\r\x1b[K");
  std::fflush(out_);
}

void ProgressBar::show(double done) {
  if (!terminal_ || now_s() - began_s_ < patience_s_) return;
  const int percent = int(100 * done);
  if (percent == shown_) return;
  shown_ = percent;
  const int full = 40 * percent / 100;
  fmt::print(out_, "\rtracing [{:#<{}}{:.<{}}] {:3} %", "", full, "", 40 - full, percent);
  std::fflush(out_);
}

}  // namespace atelier
