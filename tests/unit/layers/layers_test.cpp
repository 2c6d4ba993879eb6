// The allowed includes between the folders of common/; none may include a step.
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "base/file.hpp"
#include "catch.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
const fs::path common = fs::path(ATELIER_SOURCE_DIR) / "common";

/// The folders that each folder stands on, itself left out. A new arrow is a decision: write it down here.
const std::map<std::string, std::set<std::string>> allowed = {
    {"base", {}},
    {"image", {"base"}},
    {"image_io", {"base", "image"}},
    {"gl", {"base", "image"}},
    {"scene", {"base", "image"}},
    {"scene_import", {"base", "image", "image_io", "scene"}},
    {"oracle", {"base", "image", "scene"}},  // the truth shares nothing with what it is the truth for
    {"case", {"base", "image"}},
    {"render", {"base", "case", "gl", "image", "scene"}},
    {"app", {"base", "case", "gl", "image", "image_io", "oracle", "render", "scene", "scene_import"}},
    {"sandbox", {"base"}},
    {"judge",
     {"base", "case", "image", "image_io", "sandbox"}},  // no GL: it reads what programs wrote, and trusts none of it
    {"measure", {"base", "case", "image", "judge"}},     // it runs step programs, and links none
    {"grade", {"base", "case", "gl", "judge"}},
    {"cli", {"base", "case", "gl", "grade", "image", "image_io", "judge", "measure", "oracle", "sandbox", "scene"}},
};

struct Include {
  fs::path file;
  std::string target;  ///< what stands between the quotes
};

std::vector<Include> includes_below(const fs::path& folder) {
  static const std::regex line_of_include(R"re(^\s*#\s*include\s*"([^"]+)")re");
  std::vector<Include> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".hpp" && extension != ".cpp" && extension != ".glsl") continue;
    std::istringstream text(read_file(entry.path()));
    std::smatch match;
    for (std::string line; std::getline(text, line);)
      if (std::regex_search(line, match, line_of_include)) found.push_back({entry.path(), match[1]});
  }
  return found;
}

}  // namespace

TEST_CASE("every folder of common/ includes only allowed folders") {
  int seen = 0;
  for (const auto& entry : fs::directory_iterator(common)) {
    if (!entry.is_directory()) continue;
    const std::string folder = entry.path().filename().string();
    INFO("common/" << folder << " is not in the list of layers");
    REQUIRE(allowed.contains(folder));
    for (const Include& include : includes_below(entry.path())) {
      const std::string from = fs::path(include.target).begin()->string();
      INFO(include.file << " includes " << include.target);
      CHECK((from == folder || !allowed.contains(from) || allowed.at(folder).contains(from)));
      CHECK_FALSE(std::isdigit(static_cast<unsigned char>(from[0])));  // a step: 01-transforms/...
      ++seen;
    }
  }
  CHECK(seen > 300);  // the scan itself works
}

}  // namespace atelier
