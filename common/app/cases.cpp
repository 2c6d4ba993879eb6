#include "app/cases.hpp"

#include <unistd.h>

#include <cstdio>

#include "app/thrown.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "case/exchange.hpp"
#include "gl/shader.hpp"

namespace atelier {

namespace {

void report_progress(std::optional<int> progress, const std::string& line) {
  if (!progress) return;
  std::fflush(nullptr);  // so that printed output belongs to this case
  // The judge has closed the pipe: there is nothing left to do.
  if (write(*progress, line.data(), line.size()) != ssize_t(line.size())) _exit(exit_usage);
}

using Answer = std::function<void(const Case&)>;

void answer_or_write_error(const Answer& answer, const Case& c, const std::filesystem::path& folder) {
  try {
    answer(c);
  } catch (const ShaderError& error) {
    write_case_error(folder / (c.name + ".build_error"), error.what());
  } catch (const Error& error) {
    write_case_error(folder / (c.name + ".error"), error.what());
  } catch (...) {
    write_case_error(folder / (c.name + ".exception"), thrown_in_words());
  }
}

}  // namespace

void answer_cases(const Answer& answer, const std::filesystem::path& file, const std::filesystem::path& folder,
                  std::optional<int> progress) {
  for (const Case& c : read_cases(file)) {
    report_progress(progress, "begin " + c.name + "\n");
    answer_or_write_error(answer, c, folder);
    report_progress(progress, "end " + c.name + "\n");
  }
}

void answer_cases(Painter& painter, const std::filesystem::path& file, const std::filesystem::path& folder,
                  std::optional<int> progress, bool stats) {
  const auto answer = [&](const Case& c) {
    if (!c.probe.empty()) return write_values(folder / (c.name + ".values"), painter.probe(c));
    write_pixels(folder / (c.name + ".pixels"), painter.paint(c));
    if (stats) write_file(folder / (c.name + ".stats"), cost_as_json(painter.cost()));
  };
  answer_cases(answer, file, folder, progress);
}

}  // namespace atelier
