#include "render/draw_constants.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>

namespace atelier {

namespace {

/// "[0]" .. for the components of a vector, "[0][0]" .. of a matrix, "" for a scalar.
std::vector<std::string> subscripts(const std::string& type) {
  static const std::map<std::string, std::pair<int, int>, std::less<>> columns_and_rows = {
      {"vec2", {1, 2}}, {"vec3", {1, 3}}, {"vec4", {1, 4}}, {"mat3", {3, 3}}, {"mat4", {4, 4}}};
  const auto found = columns_and_rows.find(type);
  if (found == columns_and_rows.end()) return {""};
  const auto [columns, rows] = found->second;
  std::vector<std::string> all;
  for (int column = 0; column < columns; ++column)
    for (int row = 0; row < rows; ++row)
      all.push_back(columns == 1 ? fmt::format("[{}]", row) : fmt::format("[{}][{}]", column, row));
  return all;
}

/// The length of an array, 0 if it does not exist; 1 if it is not an array.
int elements(const DrawConstant& constant, const Defines& structure) {
  if (constant.count.empty()) return 1;
  const auto found = structure.find(constant.count);
  return found != structure.end() ? std::stoi(found->second) : 0;
}

/// The members of an element: itself, if it is not a struct.
std::vector<DrawConstant::Member> parts(const DrawConstant& constant) {
  if (constant.members.empty()) return {{constant.type, ""}};
  return constant.members;
}

int components(const DrawConstant& constant, const Defines& structure) {
  std::size_t of_an_element = 0;
  for (const DrawConstant::Member& part : parts(constant)) of_an_element += subscripts(part.type).size();
  return elements(constant, structure) * int(of_an_element);
}

/// Fills the vec4s, component by component.
class Packer {
 public:
  /// Assigns the next components to a constant and adds the vertex stage's statements that set them to `statements`.
  /// Returns the GLSL expression with which the fragment stage rebuilds the constant.
  std::string pack(const DrawConstant& constant, const Defines& structure, std::string& statements);
  std::string array() const { return fmt::format("vec4 v_constants[{}];\n", (taken_ + 3) / 4); }

 private:
  std::string pack_part(const std::string& type, const std::string& place, std::string& statements);
  std::string pack_element(const DrawConstant& constant, const std::string& place, std::string& statements);

  int taken_ = 0;
};

/// A constructor call with these arguments.
std::string constructed(const std::string& constructor, const std::vector<std::string>& items) {
  std::string text = constructor + "(";
  for (const std::string& item : items) text += (&item == &items.front() ? "" : ", ") + item;
  return text + ")";
}

std::string Packer::pack_part(const std::string& type, const std::string& place, std::string& statements) {
  std::vector<std::string> packed;
  for (const std::string& subscript : subscripts(type)) {
    packed.push_back(fmt::format("v_constants[{}][{}]", taken_ / 4, taken_ % 4));
    statements += fmt::format("  {} = float({}{});\n", packed.back(), place, subscript);
    ++taken_;
  }
  return constructed(type, packed);
}

std::string Packer::pack_element(const DrawConstant& constant, const std::string& place, std::string& statements) {
  if (constant.members.empty()) return pack_part(constant.type, place, statements);
  std::vector<std::string> members;
  for (const DrawConstant::Member& member : constant.members)
    members.push_back(pack_part(member.type, place + "." + member.name, statements));
  return constructed(constant.type, members);
}

std::string Packer::pack(const DrawConstant& constant, const Defines& structure, std::string& statements) {
  if (constant.count.empty()) return pack_element(constant, constant.name, statements);
  std::vector<std::string> all;
  for (int i = 0; i < elements(constant, structure); ++i)
    all.push_back(pack_element(constant, fmt::format("{}[{}]", constant.name, i), statements));
  return constructed(constant.type + "[]", all);
}

std::string struct_declaration(const DrawConstant& constant) {
  if (constant.members.empty()) return "";
  std::string text = fmt::format("struct {} {{", constant.type);
  for (const DrawConstant::Member& member : constant.members) text += fmt::format(" {} {};", member.type, member.name);
  return text + " };\n";
}

/// "uniform vec3 u_ambient": the declaration without an array's length.
std::string uniform_head(const DrawConstant& constant) {
  return fmt::format("uniform {} {}", constant.type, constant.name);
}

}  // namespace

std::vector<DrawConstant> constants_that_fit(std::span<const DrawConstant> constants, const Defines& structure,
                                             int available) {
  std::vector<DrawConstant> fitting;
  for (const DrawConstant& constant : constants) {
    const int size = components(constant, structure);
    const bool known = std::ranges::any_of(fitting, [&](const DrawConstant& c) { return c.name == constant.name; });
    if (known || size == 0 || size > available) continue;
    available -= size;
    fitting.push_back(constant);
  }
  return fitting;
}

PassedConstants pass_as_varyings(std::span<const DrawConstant> constants, const Defines& structure,
                                 const std::string& vertex_text) {
  if (constants.empty()) return {};
  PassedConstants glsl;
  const auto declare = [&](const std::string& text) {
    if ((vertex_text + glsl.vertex_declarations).find(text) == std::string::npos) glsl.vertex_declarations += text;
  };
  Packer packer;
  for (const DrawConstant& constant : constants) {
    const std::string head = uniform_head(constant);
    declare(struct_declaration(constant));
    declare(constant.count.empty() ? head + ";\n" : fmt::format("{}[{}];\n", head, elements(constant, structure)));
    glsl.globals.push_back(
        {head + (constant.count.empty() ? ";" : "["), packer.pack(constant, structure, glsl.vertex_statements)});
  }
  glsl.vertex_declarations += "flat out " + packer.array();
  glsl.fragment_declarations = "flat in " + packer.array();
  return glsl;
}

void make_global(ShaderSource& fragment, const PassedConstants& glsl) {
  for (const auto& [declared, value] : glsl.globals) {
    const std::size_t line = fragment.text.find("\n" + declared);
    const std::size_t end = fragment.text.find(';', line);
    if (line == std::string::npos || end == std::string::npos)
      throw Error(fmt::format("a constant that is passed as a varying must be declared by a line that begins with: {}",
                              declared));
    fragment.text.insert(end, " = " + value);
    fragment.text.erase(line + 1, std::string_view("uniform ").size());
  }
}

}  // namespace atelier
