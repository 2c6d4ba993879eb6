#include "judge/run/build_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/sha256.hpp"

namespace atelier::judge {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::uintmax_t hashed_limit = 1 << 20;  ///< bytes; larger files are identified by size and time

fs::path record_of(const Recipe& recipe) {
  return recipe.product.string() + ".record";
}

}  // namespace

std::string fingerprint(const fs::path& file) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  if (error) return {};
  if (size > hashed_limit) {
    const auto time = fs::last_write_time(file, error);
    return error ? std::string() : fmt::format("{} bytes at {}", size, time.time_since_epoch().count());
  }
  try {
    return sha256(read_file(file, hashed_limit));
  } catch (const Error&) {
    return {};
  }
}

Inputs fingerprints(const std::vector<std::string>& paths, const fs::path& folder) {
  Inputs inputs;
  for (const std::string& path : paths) inputs.emplace_back(path, fingerprint(folder / path));
  return inputs;
}

std::optional<std::string> recorded_log(const Recipe& recipe) {
  if (!fs::is_regular_file(recipe.product) || !fs::is_regular_file(record_of(recipe))) return {};
  try {
    const json record = json::parse(read_file(record_of(recipe)));
    if (record.at("command").get<std::vector<std::string>>() != recipe.command) return {};
    const Inputs inputs = record.at("inputs").get<Inputs>();
    const bool same = std::all_of(inputs.begin(), inputs.end(), [&](const auto& input) {
      return !input.second.empty() && fingerprint(recipe.folder / input.first) == input.second;
    });
    if (same) return record.at("log").get<std::string>();
  } catch (const json::exception&) {
    // An unreadable record counts as missing, so the product is made again.
  }
  return {};
}

void write_record(const Recipe& recipe, const Inputs& inputs, const std::string& log) {
  const json record = {{"command", recipe.command}, {"inputs", inputs}, {"log", log}};
  write_file(record_of(recipe), record.dump(1, ' ', false, json::error_handler_t::replace) + "\n");
}

void forget_record(const Recipe& recipe) {
  std::error_code ignored;
  fs::remove(record_of(recipe), ignored);
}

std::vector<std::string> read_dependencies(const fs::path& file) {
  const std::string text = read_file(file);
  std::vector<std::string> paths;
  std::string path;
  const auto finish = [&] {
    if (!path.empty()) paths.push_back(std::exchange(path, {}));
  };
  for (std::size_t i = std::min(text.find(": "), text.size()) + 1; i < text.size(); ++i) {
    const bool escaped = text[i] == '\\' && i + 1 < text.size();
    if (escaped && (text[i + 1] == ' ' || text[i + 1] == '#')) {
      path += text[++i];
    } else if (text[i] == '$' && i + 1 < text.size() && text[i + 1] == '$') {
      path += text[++i];
    } else if (text[i] == ' ' || text[i] == '\n' || (escaped && text[i + 1] == '\n')) {
      finish();
      if (escaped) ++i;
    } else {
      path += text[i];
    }
  }
  finish();
  return paths;
}

}  // namespace atelier::judge
