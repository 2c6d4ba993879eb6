#include "render/chain_runner.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "gl/debug.hpp"
#include "gl/state.hpp"
#include "gl/write_colour.hpp"
#include "image/colour.hpp"

namespace atelier {

namespace {

bool on_cpu(const ChainPass& pass) {
  return pass.on_floats || pass.on_bytes;
}

bool stores_8_bits(ColourFormat format) {
  return format == ColourFormat::srgb8 || format == ColourFormat::rgba8;
}

ByteImage bytes_of(const Image& image) {
  ByteImage bytes{image.width(), image.height(), std::vector<std::uint8_t>(4 * image.pixels().size())};
  std::uint8_t* to = bytes.rgba.data();
  for (const Rgba& p : image.pixels()) {
    to[0] = srgb_code(p.r);
    to[1] = srgb_code(p.g);
    to[2] = srgb_code(p.b);
    to[3] = std::uint8_t(std::clamp(p.a, 0.0f, 1.0f) * 255 + 0.5f);
    to += 4;
  }
  return bytes;
}

Image image_of(const ByteImage& bytes, const ChainPass& pass) {
  if (bytes.rgba.size() != std::size_t(bytes.width) * std::size_t(bytes.height) * 4)
    throw Error(fmt::format("pass '{}': {} bytes for {}x{} pixels of 4", pass.name, bytes.rgba.size(), bytes.width,
                            bytes.height));
  Image image(bytes.width, bytes.height);
  const std::uint8_t* from = bytes.rgba.data();
  for (Rgba& p : image.pixels()) {
    p = {linear_of_code(from[0]), linear_of_code(from[1]), linear_of_code(from[2]), float(from[3]) / 255};
    from += 4;
  }
  return image;
}

/// A pass that copies: for a CPU pass's result to the target.
ChainPass copy_pass() {
  return {.name = "copy", .code = {"chain_copy.glsl", "copied"}};
}

/// How the texture that is bound to the active unit is filtered.
void set_filter(Gl& gl, bool smooth) {
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, smooth ? GL_LINEAR : GL_NEAREST);
}

}  // namespace

bool has_pass(const std::vector<ChainPass>& passes, const std::string& output) {
  return std::ranges::any_of(passes, [&](const ChainPass& pass) { return pass.name == output; });
}

std::vector<ChainPass> passes_to_run(std::vector<ChainPass> passes, const std::string& output) {
  const auto last = std::ranges::find(passes, output, &ChainPass::name);
  if (last == passes.end() && output != "colour") return {};
  if (last != passes.end()) passes.erase(last + 1, passes.end());
  std::erase_if(passes, &ChainPass::identity);
  const auto begin = std::find_if(passes.rbegin(), passes.rend(), [](const ChainPass& pass) { return pass.begins; });
  if (begin != passes.rend()) passes.erase(passes.begin(), begin.base() - 1);
  return passes;
}

/// The textures that passes read and the targets that they draw into.
struct ChainRunner::Pictures {
  std::shared_ptr<const Target> scene;                          ///< or what a pass that begins a picture has made
  TargetSpec turn;                                              ///< of the two alternating targets
  std::array<std::shared_ptr<const Target>, 2> turns;           ///< created when needed
  std::map<std::string, std::shared_ptr<const Target>> inputs;  ///< by the name of the output
};

ChainRunner::Pictures ChainRunner::draw_scene(const std::vector<ChainPass>& passes, ColourFormat format,
                                              const Target& target, const DrawOutput& draw) {
  TargetSpec spec = target.spec();
  spec.colour = format;
  const bool drawn = !passes.front().begins;
  TargetSpec turn = spec;
  turn.depth = DepthFormat::none;
  turn.samples = 1;
  Pictures pictures{.turn = turn};
  if (drawn || passes.size() > 1) pictures.inputs["colour"] = pictures.scene = pool_.take(drawn ? spec : turn);
  if (drawn) {
    draw("colour", *pictures.scene);
    pictures.scene->resolve(gl_);
  }
  spec.samples = 1;
  spec.colour = ColourFormat::rgba32f;
  spec.depth = target.spec().depth;
  for (const ChainPass& pass : passes)
    for (const std::string& output : pass.reads)
      if (!pictures.inputs.contains(output)) {
        pictures.inputs[output] = pool_.take(spec);
        draw(output, *pictures.inputs[output]);
      }
  return pictures;
}

int ChainRunner::next_target(int source) const {
  const int next = functions_.next_target(source);
  if (next != 0 && next != 1)
    throw Error(fmt::format("next_target({}) is {}: a chain has the targets 0 and 1", source, next));
  return next;
}

void ChainRunner::run_shader(const ChainPass& pass, const Pictures& pictures, const Target* source,
                             const Target& target) {
  Defines structure = pass.structure;
  if (stores_8_bits(target.spec().colour)) structure["STORED_IN_8_BITS"] = "1";
  Program& program = programs_.chain_pass({pass.code, pass.reads, structure, functions_.glsl});
  reset_state(gl_);
  target.bind(gl_);
  gl_.UseProgram(program.program.id());
  Binder binder(gl_, program.uniforms);
  if (source) {
    binder.texture("u_picture", source->colour_texture());
    if (pass.smooth) set_filter(gl_, true);
  }
  binder.set("u_size", glm::vec2(target.spec().width, target.spec().height));
  for (const std::string& output : pass.reads)
    binder.texture("u_" + output, pictures.inputs.at(output)->colour_texture());
  if (pass.bind) pass.bind(binder);
  functions_.draw_full_screen(gl_);
  if (source && pass.smooth) {
    gl_.BindTexture(GL_TEXTURE_2D, source->colour_texture());
    set_filter(gl_, false);
  }
  check_gl_error(gl_, ("running the pass " + pass.name).c_str());
}

void ChainRunner::run_on_cpu(const ChainPass& pass, const Pictures& pictures, const Target& source,
                             const Target& target) {
  PassInputs inputs;
  for (const std::string& output : pass.reads) inputs.emplace(output, pictures.inputs.at(output)->read_colour(gl_));
  Image picture = source.read_colour(gl_);
  const glm::ivec2 size(picture.width(), picture.height());
  if (pass.on_bytes) {
    ByteImage bytes = bytes_of(picture);
    pass.on_bytes(bytes, inputs);
    picture = image_of(bytes, pass);
  } else {
    pass.on_floats(picture, inputs);
  }
  if (glm::ivec2(picture.width(), picture.height()) != size)
    throw Error(fmt::format("pass '{}' returned {}x{} pixels for {}x{}: a pass must keep the size", pass.name,
                            picture.width(), picture.height(), size.x, size.y));
  write_colour(gl_, target, picture);
}

void ChainRunner::run(const std::vector<ChainPass>& given, ColourFormat format, const Target& target,
                      const DrawOutput& draw) {
  if (!functions_.next_target || !functions_.draw_full_screen || functions_.glsl.empty())
    throw Error("a chain of passes needs the functions of step 08, which this program does not pass to the renderer");
  std::vector<ChainPass> passes = given;
  if (on_cpu(passes.back())) passes.push_back(copy_pass());
  for (const ChainPass& pass : passes)
    if (pass.begins && (on_cpu(pass) || std::ranges::count(pass.reads, "colour") > 0))
      throw Error(
          fmt::format("pass '{}' begins a picture: it must be a shader that does not read 'colour'", pass.name));
  Pictures pictures = draw_scene(passes, format, target, draw);
  const Target* source = passes.front().begins ? nullptr : pictures.scene.get();
  int at = -1;
  for (const ChainPass& pass : passes) {
    const Target* next = &target;
    if (&pass != &passes.back()) {
      if (pass.begins) {
        next = pictures.scene.get();
      } else {
        at = next_target(at);
        auto& turn = pictures.turns[std::size_t(at)];
        if (!turn) turn = pool_.take(pictures.turn);
        next = turn.get();
      }
    }
    const DebugGroup group(gl_, "pass: " + pass.name);
    if (on_cpu(pass))
      run_on_cpu(pass, pictures, *source, *next);
    else
      run_shader(pass, pictures, source, *next);
    source = next;
  }
}

}  // namespace atelier
