#include "cli/grader/visible_cases.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/strict_json.hpp"
#include "judge/compare/sidecar.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

/// The file without the cases in `hidden`. A file that does not use "hidden" is unchanged and keeps its layout.
std::string without_hidden(const std::string& text, const std::set<std::string>& hidden) {
  if (text.find("\"hidden\"") == text.npos) return text;
  OrderedJson document = OrderedJson::parse(text);
  if (document.contains("defaults")) document["defaults"].erase("hidden");
  document.erase("not_varied");  // it may name functions that only hidden cases test
  OrderedJson visible = OrderedJson::array();
  for (OrderedJson& object : document["cases"]) {
    if (hidden.contains(object["name"].get<std::string>())) continue;
    object.erase("hidden");
    visible.push_back(std::move(object));
  }
  document["cases"] = std::move(visible);
  return document.dump(2) + "\n";
}

void add_files_of(const judge::JudgedCase& c, const fs::path& folder, std::set<fs::path>& files) {
  const auto add = [&](const fs::path& file, bool needed) {
    if (fs::exists(file))
      files.insert(file);
    else if (needed)
      throw Error(fmt::format("{}: is missing; make it with ./atelier reference", file.string()));
  };
  if (c.profile == judge::Profile::values) {
    add(judge::values_path(folder, c.ask.name), c.expected.empty());
    add(judge::wrong_values_path(folder, c.ask.name), false);
    return;
  }
  for (const fs::path& picture : c.references) {
    add(picture, true);
    add(judge::sidecar_path(picture), true);
  }
  add(judge::atlas_path(folder, c.ask.name), false);
}

}  // namespace

VisibleCases visible_cases(const fs::path& case_file) {
  VisibleCases visible;
  std::set<std::string> hidden;
  for (judge::JudgedCase& c : judge::read_case_file(case_file).cases) {
    if (c.hidden) {
      hidden.insert(c.ask.name);
      visible.hidden_points += c.points;
      continue;
    }
    add_files_of(c, judge::references_folder(case_file), visible.files);
    visible.cases.push_back(std::move(c));
  }
  if (visible.cases.empty())
    throw Error(fmt::format("{}: every case is hidden; students need at least one", case_file.string()));
  visible.hidden = int(hidden.size());
  visible.text = without_hidden(read_file(case_file), hidden);
  return visible;
}

}  // namespace atelier
