#include "render/programs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <tuple>

#include "gl/debug.hpp"
#include "gl/query.hpp"

namespace atelier {

namespace {

/// The folder of the renderer's own shader files: an absolute path, set by the build.
const std::filesystem::path own_shaders = ATELIER_RENDER_SHADERS;

/// The modification time of each file that the stages include.
std::map<std::filesystem::path, std::filesystem::file_time_type> changes_of(
    std::initializer_list<const ShaderSource*> stages) {
  std::map<std::filesystem::path, std::filesystem::file_time_type> files;
  for (const ShaderSource* stage : stages)
    for (const auto& file : stage->files)
      if (std::error_code missing; std::filesystem::exists(file, missing))
        files[file] = std::filesystem::last_write_time(file);
  return files;
}

Program linked(Gl& gl, const std::string& name, const ShaderSource& vertex, const ShaderSource& fragment,
               const ShaderSource* geometry = nullptr) {
  GlProgram program = build_program(gl, vertex, fragment, geometry);
  label(gl, GL_PROGRAM, program.id(), name);
  Uniforms uniforms(gl, program.id());
  auto files = geometry ? changes_of({&vertex, &fragment, geometry}) : changes_of({&vertex, &fragment});
  return {std::move(program), std::move(uniforms), std::move(files)};
}

/// A pass's vertex stage that also clips at the plane where a node ends.
std::string with_end(const std::string& vertex) {
  return "#define main main_of_pass\n" + vertex +
         "\n#undef main\n"
         "uniform vec4 u_kept;\n"
         "void main() {\n"
         "  main_of_pass();\n"
         "  gl_ClipDistance[1] = dot(u_kept, vec4(world_position(u_model, a_position), 1.0));\n"
         "}\n";
}

}  // namespace

bool ChainKey::operator<(const ChainKey& other) const {
  return std::tie(code.include, code.function, reads, structure, full_screen_glsl) <
         std::tie(other.code.include, other.code.function, other.reads, other.structure, other.full_screen_glsl);
}

Programs::Programs(Gl& gl, Implementations implementations, std::string transforms_glsl)
    : gl_(gl),
      implementations_(std::move(implementations)),
      transforms_glsl_(std::move(transforms_glsl)),
      varyings_(std::min({integer_of(gl, GL_MAX_VARYING_COMPONENTS), integer_of(gl, GL_MAX_VERTEX_OUTPUT_COMPONENTS),
                          integer_of(gl, GL_MAX_FRAGMENT_INPUT_COMPONENTS)})) {}

std::filesystem::path Programs::find(const std::string& name) const {
  if (const auto found = implementations_.find(name); !found.empty()) return found;
  // Use the same rule for our own files: no name may lead out of the folder.
  return Implementations({{own_shaders, ""}}).find(name);
}

Program Programs::build(const SurfaceKey& key) const {
  const SurfaceSources sources =
      assemble_surface([this](const std::string& name) { return find(name); }, transforms_glsl_, key, varyings_);
  return linked(gl_, "surface: " + key.output, sources.vertex, sources.fragment);
}

Program Programs::build(const PassSources& pass) const {
  const auto stage = [&](const std::string& text, const char* which) {
    return assemble_shader_text([this](const std::string& name) { return find(name); }, text,
                                fmt::format("{} {} shader", pass.name, which), pass.structure);
  };
  const ShaderSource geometry = stage(pass.geometry, "geometry");
  std::string vertex = pass_vertex_text(transforms_glsl_) + pass.vertex;
  if (pass.structure.contains("KEPT") && pass.geometry.empty()) vertex = with_end(vertex);
  return linked(gl_, pass.name, stage(vertex, "vertex"), stage(pass.fragment, "fragment"),
                pass.geometry.empty() ? nullptr : &geometry);
}

Program Programs::build(const ChainKey& key) const {
  const auto stage = [&](const std::string& text, const char* which) {
    return assemble_shader_text([this](const std::string& name) { return find(name); }, text,
                                fmt::format("{} shader of a pass", which), key.structure);
  };
  const std::string vertex = fmt::format(
      "#include \"{}\"\n"
      "out vec2 v_texcoord;\n"
      "void main() {{\n"
      "  gl_Position = vec4(full_screen_corner(gl_VertexID), 0.0, 1.0);\n"
      "  v_texcoord = gl_Position.xy * 0.5 + 0.5;\n"
      "}}\n",
      key.full_screen_glsl);
  std::string fragment =
      "in vec2 v_texcoord;\nout vec4 o_colour;\nuniform sampler2D u_picture;\nuniform vec2 u_size;\n";
  for (const std::string& name : key.reads) fragment += fmt::format("uniform sampler2D u_{};\n", name);
  fragment += fmt::format("#include \"{}\"\nvoid main() {{ o_colour = {}(v_texcoord); }}\n", key.code.include,
                          key.code.function);
  return linked(gl_, "pass: " + key.code.function, stage(vertex, "vertex"), stage(fragment, "fragment"));
}

template <class Key>
typename std::map<Key, Program>::iterator Programs::kept(std::map<Key, Program>& programs, const Key& key) const {
  const auto found = programs.find(key);
  return found != programs.end() ? found : programs.emplace(key, build(key)).first;
}

Programs::Surface Programs::surface(const SurfaceKey& key) {
  const auto found = kept(surfaces_, key);
  return {found->first, found->second};
}
Program& Programs::pass(const PassSources& pass) {
  return kept(passes_, pass)->second;
}
Program& Programs::chain_pass(const ChainKey& key) {
  return kept(chain_, key)->second;
}

/// Whether one has changed; `words` gets the driver's log if it rejected one.
template <class Key>
bool Programs::reload_changed(std::map<Key, Program>& programs, std::string& words) const {
  bool any = false;
  for (auto& [key, program] : programs)
    for (auto& [file, seen] : program.files) {
      std::error_code gone;
      const auto now = std::filesystem::last_write_time(file, gone);
      if (gone || now == seen) continue;
      try {
        program = build(key);
        any = true;
      } catch (const Error& error) {
        if (words.empty()) words = error.what();
        return any;
      }
      break;  // `files` is a new map now
    }
  return any;
}

Programs::Reloaded Programs::reload_changed() {
  Reloaded reloaded;
  reload_changed(surfaces_, reloaded.words);
  reloaded.passes = reload_changed(passes_, reloaded.words);
  reload_changed(chain_, reloaded.words);
  return reloaded;
}

}  // namespace atelier
