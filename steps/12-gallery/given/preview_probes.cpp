#include "12-gallery/given/preview_probes.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "12-gallery/gallery.hpp"
#include "gl/objects.hpp"
#include "gl/query.hpp"
#include "gl/state.hpp"
#include "gl/target.hpp"

namespace atelier::gallery {

namespace {

Numbers probe_preview_camera(ProbeContext&, const Arguments& in) {
  const Camera camera =
      preview_camera(in.mat4("exit"), in.vec2("half_size"), in.number("distance"), float(in.number("far")));
  Numbers out = atelier::numbers_of(camera.eye);
  const glm::dvec3 ahead = glm::normalize(camera.target - camera.eye), up(camera.up);
  append(out, atelier::numbers_of(ahead));
  append(out, atelier::numbers_of(glm::normalize(up - glm::dot(up, ahead) * ahead)));  // as a picture shows it
  append(out, Numbers{double(camera.fov_y), double(camera.near), double(camera.far), double(camera.projection)});
  return out;
}

/// Owns what make_preview has created.
struct Owned {
  Owned(Gl& gl, const Preview& preview) : framebuffer(gl, preview.framebuffer) {
    for (const GLuint texture : preview.textures) textures.emplace_back(gl, texture);
  }
  std::vector<GlTexture> textures;
  GlFramebuffer framebuffer;
};

/// What is bound: a texture on the active unit, a framebuffer to draw into and one to read.
Numbers bound(const Gl& gl) {
  return {double(integer_of(gl, GL_TEXTURE_BINDING_2D)), double(integer_of(gl, GL_DRAW_FRAMEBUFFER_BINDING)),
          double(integer_of(gl, GL_READ_FRAMEBUFFER_BINDING))};
}

/// State that neither making nor recording a preview needs to change.
std::vector<GLint> state_of(const Gl& gl) {
  std::vector<GLint> state;
  for (const GLenum name : {GL_ACTIVE_TEXTURE, GL_VIEWPORT, GL_SCISSOR_BOX, GL_SCISSOR_TEST, GL_DEPTH_TEST, GL_BLEND,
                            GL_CULL_FACE, GL_STENCIL_TEST, GL_DEPTH_WRITEMASK, GL_COLOR_WRITEMASK, GL_COLOR_CLEAR_VALUE,
                            GL_DEPTH_FUNC, GL_CURRENT_PROGRAM, GL_VERTEX_ARRAY_BINDING, GL_RENDERBUFFER_BINDING}) {
    std::array<GLint, 4> values{};  // at most
    gl.GetIntegerv(name, values.data());
    state.insert(state.end(), values.begin(), values.end());
  }
  return state;
}

double changed(const std::vector<GLint>& before, const std::vector<GLint>& after) {
  int count = 0;
  for (std::size_t i = 0; i < before.size(); ++i) count += before[i] != after[i];
  return count;
}

/// Whether a texture's levels have the size that mipmaps have, down to one texel, and no more of them.
bool has_all_levels(Gl& gl, int size) {
  GLint most = 0;
  gl.GetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, &most);
  for (int level = 0;; ++level) {
    const int side = size >> level;
    GLint width = 0, height = 0;
    gl.GetTexLevelParameteriv(GL_TEXTURE_2D, level, GL_TEXTURE_WIDTH, &width);
    gl.GetTexLevelParameteriv(GL_TEXTURE_2D, level, GL_TEXTURE_HEIGHT, &height);
    if (width != side || height != side) return false;
    if (side == 0) return true;
    if (level > most) return false;
  }
}

/// What is bound afterwards, and how much other state has changed; of each texture filters, wraps, format, size, and
/// whether it has all levels; whether the framebuffer is complete, which map is attached to it, and what else.
Numbers probe_make_preview(ProbeContext& context, const Arguments& in) {
  Gl& gl = context.gl;
  const int size = in.integer("size");
  const std::vector<GLint> before = state_of(gl);
  const Preview preview = make_preview(gl, size);
  const Owned owned(gl, preview);
  Numbers out = bound(gl);
  out.push_back(changed(before, state_of(gl)));
  reset_state(gl);
  gl.ActiveTexture(GL_TEXTURE0);
  for (const GLuint texture : preview.textures) {
    if (!texture) return Numbers(31, 0);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    append(out,
           texture_parameters(gl, GL_TEXTURE_2D,
                              {GL_TEXTURE_MAG_FILTER, GL_TEXTURE_MIN_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}));
    for (const GLenum name : {GL_TEXTURE_INTERNAL_FORMAT, GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT}) {
      GLint value = 0;
      gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, name, &value);
      out.push_back(value);
    }
    out.push_back(has_all_levels(gl, size));
  }
  gl.BindTexture(GL_TEXTURE_2D, 0);
  gl.BindFramebuffer(GL_FRAMEBUFFER, preview.framebuffer);
  out.push_back(preview.framebuffer && gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
  const auto attached = [&](GLenum place) {
    GLint type = 0, name = 0;
    gl.GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, place, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
    if (type == GL_NONE) return 0;
    gl.GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, place, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, &name);
    return type == GL_TEXTURE && GLuint(name) == preview.textures[0] ? 1 : 2;
  };
  out.push_back(preview.framebuffer ? attached(GL_COLOR_ATTACHMENT0) : 0);
  int others = 0;
  if (preview.framebuffer)
    for (const GLenum place : {GL_COLOR_ATTACHMENT0 + 1, GL_COLOR_ATTACHMENT0 + 2, GL_COLOR_ATTACHMENT0 + 3,
                               GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT})
      others += attached(place) != 0;
  out.push_back(others);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  return out;
}

/// A preview by given code, every map of which is 0.5.
Preview plain_preview(Gl& gl, int size) {
  Preview preview;
  gl.GenTextures(3, preview.textures.data());
  for (const GLuint texture : preview.textures) {
    gl.BindTexture(GL_TEXTURE_2D, texture);
    for (int level = 0, side = size; side > 0; ++level, side /= 2) {
      const std::vector<float> pixels(std::size_t(side) * std::size_t(side) * 4, 0.5f);
      gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA16F, side, side, 0, GL_RGBA, GL_FLOAT, pixels.data());
    }
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  }
  gl.BindTexture(GL_TEXTURE_2D, 0);
  gl.GenFramebuffers(1, &preview.framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, preview.framebuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, preview.textures[0], 0);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  return preview;
}

/// Red of a square texture: the lower left pixel, the upper left one, the upper right one.
Numbers corners_of_picture(Gl& gl, GLuint texture, int size) {
  const std::size_t side(static_cast<std::size_t>(size));
  std::vector<float> pixels(side * side * 4);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, pixels.data());
  gl.BindTexture(GL_TEXTURE_2D, 0);
  return {double(pixels.front()), double(pixels[(side - 1) * side * 4]), double(pixels[(side * side - 1) * 4])};
}

double last_mipmap(Gl& gl, GLuint texture, int size) {
  int last = 0;
  while (size >> (last + 1) > 0) ++last;
  std::array<float, 4> pixel{};
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.GetTexImage(GL_TEXTURE_2D, last, GL_RGBA, GL_FLOAT, pixel.data());
  gl.BindTexture(GL_TEXTURE_2D, 0);
  return double(pixel[0]);
}

/// Records into each of `maps`, one after another, a picture that is black, but for its upper right quarter, whose red
/// is 0.25 (i + 1); with a scissor rectangle in the way, if `scissor` is 1. What is bound afterwards, how much other
/// state has changed, what the three maps hold, and whether the picture is still what it was.
Numbers probe_record(ProbeContext& context, const Arguments& in) {
  Gl& gl = context.gl;
  const int size = in.integer("size"), half = size / 2;
  const Preview preview = plain_preview(gl, size);
  const Owned owned(gl, preview);
  const Target picture(gl, {.width = size, .height = size, .colour = ColourFormat::rgba16f});
  reset_state(gl);
  const auto parameters_of_maps = [&] {
    std::vector<GLint> all;
    for (const GLuint texture : preview.textures) {
      gl.BindTexture(GL_TEXTURE_2D, texture);
      for (const GLenum name :
           {GL_TEXTURE_MAG_FILTER, GL_TEXTURE_MIN_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_MAX_LEVEL})
        gl.GetTexParameteriv(GL_TEXTURE_2D, name, &all.emplace_back());
    }
    gl.BindTexture(GL_TEXTURE_2D, 0);
    return all;
  };
  const std::vector<GLint> parameters = parameters_of_maps();
  double other_state = 0;
  const auto& maps = in.numbers("maps");
  for (std::size_t i = 0; i < maps.size(); ++i) {
    picture.bind(gl);
    gl.ClearColor(0, 0, 0, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(half, half, half, half);
    gl.ClearColor(0.25f * float(i + 1), 0, 0, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Scissor(1, 1, 2, 2);
    if (in.number("scissor") < 0.5) gl.Disable(GL_SCISSOR_TEST);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.Viewport(0, 0, 3, 2);
    const std::vector<GLint> before = state_of(gl);
    record(gl, preview, Map(int(maps[i])), picture.framebuffer());
    other_state += changed(before, state_of(gl));
  }
  Numbers out = bound(gl);
  reset_state(gl);
  gl.ActiveTexture(GL_TEXTURE0);
  out.push_back(other_state + changed(parameters, parameters_of_maps()));
  for (const GLuint texture : preview.textures) {
    append(out, corners_of_picture(gl, texture, size));
    out.push_back(last_mipmap(gl, texture, size));
  }
  append(out, corners_of_picture(gl, picture.colour_texture(), size));
  return out;
}

/// "visible", "recorded", "recorded_of", "frames_since", "version": one number for each preview. Which are recorded, in
/// their order; -1 in the places of those that are not.
Numbers probe_previews_to_record(ProbeContext&, const Arguments& in) {
  std::vector<PreviewState> states(in.numbers("visible").size());
  const auto number = [&](const char* name, std::size_t i) { return in.numbers(name).at(i); };
  for (std::size_t i = 0; i < states.size(); ++i)
    states[i] = {.visible = number("visible", i) > 0.5,
                 .version = std::uint64_t(number("version", i)),
                 .recorded = number("recorded", i) > 0.5,
                 .recorded_of = std::uint64_t(number("recorded_of", i)),
                 .frames_since = std::uint64_t(number("frames_since", i))};
  Numbers out;
  append(out, previews_to_record(states, in.integer("most")));
  out.resize(std::max(out.size(), states.size()), -1);
  return out;
}

}  // namespace

}  // namespace atelier::gallery

namespace atelier {

std::map<std::string, Probe> preview_probes() {
  using namespace gallery;
  return {{"preview_camera", probe_preview_camera},
          {"make_preview", probe_make_preview},
          {"record", probe_record},
          {"previews_to_record", probe_previews_to_record}};
}

}  // namespace atelier
