// A case: one picture to draw, or one function to call, as a step program gets it. The case file also says how the
// judge compares the answer (points, tolerances, references); the program never gets that part.
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

/// Named lists of numbers: the inputs of a probe. A vector is its components, a matrix its columns in order (as glm
/// stores them), a bool is 0 or 1, and a list of vectors is the components of all.
class Arguments {
 public:
  std::map<std::string, std::vector<double>> values;

  /// Each throws Error naming the argument if it is missing or has the wrong length.
  double number(const std::string& name) const;
  int integer(const std::string& name) const;
  glm::dvec2 vec2(const std::string& name) const;
  glm::dvec3 vec3(const std::string& name) const;
  glm::dvec4 vec4(const std::string& name) const;
  glm::dmat4 mat4(const std::string& name) const;
  const std::vector<double>& numbers(const std::string& name) const;
};

/// What a probe returns for one argument set, in the same layout as Arguments.
using Numbers = std::vector<double>;

/// The camera of a picture case; absent values come from the scene.
struct CaseCamera {
  std::optional<glm::dvec3> eye, target, up;
  std::optional<double> fov_y_degrees, near, far;
};

/// What a step program must do. If `probe` is set: call that function with each of `inputs`. Otherwise: draw.
struct Case {
  std::string name;   ///< [a-z0-9-]+, at most 64; names the files that the program writes
  std::string scene;  ///< a built-in scene's name, or a path to a .gltf, .glb or .obj file
  CaseCamera camera;
  glm::ivec2 size{256, 256};                     ///< pixels, 1..4096 a side
  std::map<std::string, SettingValue> settings;  ///< those that differ from the defaults
  std::string output = "colour";                 ///< "colour", or an intermediate that the program lists
  std::string probe;                             ///< the name of a probe that the program lists, or empty
  std::vector<Arguments> inputs;                 ///< of the probe
};

/// Reads one case from its JSON object. Skips the members that only the judge reads (points, hint, tolerance ...; see
/// tests/cases/README.md). Refuses unknown members, picture members in a probe and probe members in a picture. A
/// picture needs `name` and `scene`; a probe needs `name`, `probe` and `inputs`. An input's value is a number, true,
/// false, "nan", "inf", "-inf", or nested lists of these, flattened in order. Throws Error with `where` and the member:
/// "cases.json: case 'sphere': size: ...".
Case parse_case(const nlohmann::json& object, const std::string& where);

/// A picture's size, [width, height], each 1..4096 pixels. Throws Error with `where`, the value and what is allowed.
glm::ivec2 size_from_json(const nlohmann::json& value, const std::string& where);

/// The JSON that parse_case reads; the judge passes it to the program.
nlohmann::json to_json(const Case& c);

/// `object` plus the members of `defaults` that it lacks; `settings` and `camera` are merged member by member. A probe
/// does not inherit members that only pictures have, nor a picture those of probes.
nlohmann::json with_defaults(const nlohmann::json& defaults, const nlohmann::json& object, const std::string& where);

/// The case objects of a document {"schema": 1, "step", "title", "defaults": {...}, "cases": [...]}, each merged with
/// `defaults`; at least one. Throws Error naming the member.
std::vector<nlohmann::json> case_objects(const nlohmann::json& document, const std::string& where);

/// All cases in a file; names must be unique. Only the member `cases` is required. Also reads the judge's case files
/// and skips the judge's members. Throws Error naming the file, the case and the member.
std::vector<Case> read_cases(const std::filesystem::path& file);

}  // namespace atelier
