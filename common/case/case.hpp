// A case: one picture to draw, or one function to call, as a step program is asked for it. What the judge thinks of the
// answer (points, tolerances, references) stands beside it in the same file and is never handed to the program.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "case/settings.hpp"
#include "image/image.hpp"

namespace atelier {

/// Plain numbers under names: the inputs of a probe. A vector is its components, a matrix its columns one after another
/// (as glm stores them), a bool 0 or 1, a list of vectors one after another.
class Arguments {
 public:
  std::map<std::string, std::vector<double>> values;

  /// Each throws Error naming the argument where it is missing or has another length than asked.
  double number(const std::string& name) const;
  int integer(const std::string& name) const;
  glm::dvec2 vec2(const std::string& name) const;
  glm::dvec3 vec3(const std::string& name) const;
  glm::dvec4 vec4(const std::string& name) const;
  glm::dmat4 mat4(const std::string& name) const;
  const std::vector<double>& numbers(const std::string& name) const;
};

/// What a probe returns for one set of arguments, laid out like Arguments.
using Numbers = std::vector<double>;

/// Where a picture case looks from; what is absent is the scene's own.
struct CaseCamera {
  std::optional<glm::dvec3> eye, target, up;
  std::optional<double> fov_y_degrees, near, far;
};

/// What a step program is asked to do. `probe` set: call that function on each of `inputs`. Otherwise: draw.
struct Case {
  std::string name;   ///< [a-z0-9-]+, at most 64; names the files that the program writes
  std::string scene;  ///< a built-in scene's name, or a path to a .gltf, .glb or .obj file
  CaseCamera camera;
  glm::ivec2 size{256, 256};                     ///< pixels, 1..4096 a side
  std::map<std::string, SettingValue> settings;  ///< what differs from the defaults
  std::string output = "colour";                 ///< "colour", or an intermediate that the program lists
  std::string probe;                             ///< the name of a probe that the program lists, or empty
  std::vector<Arguments> inputs;                 ///< of the probe
};

/// Reads one case from its JSON object. Skips the members that only the judge reads (points, hint, tolerance ...; all
/// are listed in tests/cases/README.md) and refuses those that nobody knows, and those of a probe in a picture or the
/// reverse. A picture needs `name` and `scene`; a probe needs `name`, `probe` and `inputs`, and an input's value is a
/// number, true, false, "nan", "inf", "-inf", or lists of these, flattened in order. Throws Error with `where` and the
/// field: "cases.json: case 'sphere': size: ...".
Case parse_case(const nlohmann::json& object, const std::string& where);

/// The JSON that parse_case reads: what the judge hands to the program.
nlohmann::json to_json(const Case& c);

/// `object` with the members of `defaults` that it does not have itself; `settings` and `camera` are completed member
/// by member. A probe inherits no member that only pictures have, and the reverse.
nlohmann::json with_defaults(const nlohmann::json& defaults, const nlohmann::json& object, const std::string& where);

/// The case objects of a document {"schema": 1, "step", "title", "defaults": {...}, "cases": [...]}, each completed
/// from `defaults`; at least one. Throws Error naming the member.
std::vector<nlohmann::json> case_objects(const nlohmann::json& document, const std::string& where);

/// All cases in a file, of whose members only `cases` must be there; no name twice. The judge's case files can be read
/// too: what belongs to the judge is skipped. Throws Error naming the file, the case and the field.
std::vector<Case> read_cases(const std::filesystem::path& file);

}  // namespace atelier
