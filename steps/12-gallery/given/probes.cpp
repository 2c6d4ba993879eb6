#include "12-gallery/given/probes.hpp"

#include <algorithm>
#include <vector>

#include "12-gallery/gallery.hpp"
#include "12-gallery/given/walk.hpp"
#include "12-gallery/given/wall_probe.hpp"
#include "gl/objects.hpp"
#include "gl/query.hpp"
#include "gl/state.hpp"
#include "gl/target.hpp"

namespace atelier {

namespace {

using namespace gallery;

// ---- A visitor

std::array<glm::dvec3, 8> eight_corners(const Arguments& in) {
  const auto& flat = in.numbers("corners");
  std::array<glm::dvec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = {flat.at(3 * i), flat.at(3 * i + 1), flat.at(3 * i + 2)};
  return corners;
}

Visitor visitor_of(const Arguments& in) {
  return {.position = in.vec3("position"), .velocity = in.vec3("velocity"), .room = in.integer("room")};
}

Numbers numbers_of(const Visitor& visitor) {
  Numbers out = atelier::numbers_of(visitor.position);
  append(out, atelier::numbers_of(visitor.velocity));
  out.push_back(visitor.room);
  return out;
}

/// For each of `points`: its signed distance from either plane, the larger one first. Then the lengths of both normals.
Numbers probe_side_planes(ProbeContext&, const Arguments& in) {
  const std::array<glm::dvec4, 2> planes = side_planes(in.mat4("frame"), in.vec2("half_size"));
  const auto& flat = in.numbers("points");
  Numbers out;
  for (std::size_t i = 0; i + 3 <= flat.size(); i += 3) {
    const glm::dvec4 point(flat[i], flat[i + 1], flat[i + 2], 1);
    const double first = glm::dot(planes[0], point), second = glm::dot(planes[1], point);
    append(out, Numbers{std::max(first, second), std::min(first, second)});
  }
  for (const glm::dvec4& plane : planes) out.push_back(glm::length(glm::dvec3(plane)));
  return out;
}

/// One number for each of `positions`.
Numbers probe_touches(ProbeContext&, const Arguments& in) {
  const auto& flat = in.numbers("positions");
  Numbers out;
  for (std::size_t i = 0; i + 3 <= flat.size(); i += 3)
    out.push_back(touches(in.mat4("frame"), in.vec2("half_size"), {flat[i], flat[i + 1], flat[i + 2]}));
  return out;
}

/// "steps": in how many equal steps the time passes.
Numbers probe_moved(ProbeContext&, const Arguments& in) {
  Visitor visitor = visitor_of(in);
  const int steps = in.integer("steps");
  for (int i = 0; i < steps; ++i) visitor = moved(visitor, in.vec2("walking"), in.number("seconds") / steps);
  return numbers_of(visitor);
}

/// "walls": four numbers each. Whether all corners are inside, whether the way is not longer than `most`, and the
/// position if `exact` is 1.
Numbers probe_held(ProbeContext&, const Arguments& in) {
  const auto& flat = in.numbers("walls");
  std::vector<glm::dvec4> walls;
  for (std::size_t i = 0; i + 4 <= flat.size(); i += 4)
    walls.emplace_back(flat[i], flat[i + 1], flat[i + 2], flat[i + 3]);
  const glm::dvec3 position = in.vec3("position"), at = held(walls, position);
  bool inside = true;
  for (const glm::dvec4& wall : walls)
    for (const glm::dvec3& corner : corners_of(at)) inside &= glm::dot(wall, glm::dvec4(corner, 1)) >= -1e-9;
  Numbers out{double(inside), double(glm::distance(position, at) <= in.number("most"))};
  if (in.number("exact") > 0.5) append(out, atelier::numbers_of(at));
  return out;
}

/// The walk through all rooms: position and room at each of `count` times, `step` seconds apart.
Numbers probe_walk(ProbeContext&, const Arguments& in) {
  Numbers out;
  for (const Ground::Entry& entry : Ground(in.integer("segments")).diary(in.integer("count"), in.number("step"))) {
    append(out, atelier::numbers_of(entry.position));
    out.push_back(entry.room);
  }
  return out;
}

// ---- Previews

Numbers probe_preview_camera(ProbeContext&, const Arguments& in) {
  const Camera camera =
      preview_camera(in.mat4("exit"), in.vec2("half_size"), in.number("distance"), float(in.number("far")));
  Numbers out = atelier::numbers_of(camera.eye);
  append(out, atelier::numbers_of(glm::normalize(camera.target - camera.eye)));
  append(out, atelier::numbers_of(glm::normalize(glm::dvec3(camera.up))));
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

/// What is bound afterwards; of each texture filters and wraps, size and format of the first and the last level, and
/// whether there is another; whether the framebuffer is complete, and which map is attached to it.
Numbers probe_make_preview(ProbeContext& context, const Arguments& in) {
  Gl& gl = context.gl;
  const int size = in.integer("size");
  const Preview preview = make_preview(gl, size);
  const Owned owned(gl, preview);
  Numbers out = bound(gl);
  const auto level = [&](int number) {
    for (const GLenum name : {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_INTERNAL_FORMAT}) {
      GLint value = 0;
      gl.GetTexLevelParameteriv(GL_TEXTURE_2D, number, name, &value);
      out.push_back(value);
    }
  };
  int last = 0;
  while (size >> (last + 1) > 0) ++last;
  for (const GLuint texture : preview.textures) {
    if (!texture) return Numbers(45, 0);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    append(out,
           texture_parameters(gl, GL_TEXTURE_2D,
                              {GL_TEXTURE_MAG_FILTER, GL_TEXTURE_MIN_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}));
    level(0);
    level(last);
    level(last + 1);
  }
  gl.BindTexture(GL_TEXTURE_2D, 0);
  gl.BindFramebuffer(GL_FRAMEBUFFER, preview.framebuffer);
  out.push_back(preview.framebuffer && gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
  for (const GLenum place : {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT}) {
    GLint type = 0, name = 0;
    gl.GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, place, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
    if (type == GL_TEXTURE)
      gl.GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, place, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, &name);
    out.push_back(type == GL_NONE ? 0 : GLuint(name) == preview.textures[0] ? 1 : 2);
  }
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  return out;
}

constexpr int tiny = 8;  ///< pixels: a side of the previews of probe_record

/// A preview by given code, every map of which is 0.5.
Preview plain_preview(Gl& gl) {
  Preview preview;
  gl.GenTextures(3, preview.textures.data());
  for (const GLuint texture : preview.textures) {
    gl.BindTexture(GL_TEXTURE_2D, texture);
    for (int level = 0; tiny >> level > 0; ++level) {
      const std::vector<float> pixels(std::size_t(tiny >> level) * std::size_t(tiny >> level) * 4, 0.5f);
      gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA16F, tiny >> level, tiny >> level, 0, GL_RGBA, GL_FLOAT,
                    pixels.data());
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

/// Red of a map: two corners of level 0, and the one pixel of the last level.
Numbers reds(Gl& gl, GLuint texture) {
  gl.BindTexture(GL_TEXTURE_2D, texture);
  std::vector<float> pixels(std::size_t(tiny * tiny) * 4), last(4);
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, pixels.data());
  gl.GetTexImage(GL_TEXTURE_2D, 3, GL_RGBA, GL_FLOAT, last.data());
  gl.BindTexture(GL_TEXTURE_2D, 0);
  return {double(pixels.front()), double(pixels[pixels.size() - 4]), double(last[0])};
}

/// Records into each of `maps`, one after another, a picture that is black, but for its right half, whose red is
/// 0.25 (i + 1); with a scissor rectangle in the way, if `scissor` is 1. What the three maps hold afterwards, what is
/// bound, the state that must not change, and whether the picture is still what it was.
Numbers probe_record(ProbeContext& context, const Arguments& in) {
  Gl& gl = context.gl;
  const Preview preview = plain_preview(gl);
  const Owned owned(gl, preview);
  const Target picture(gl, {.width = tiny, .height = tiny, .colour = ColourFormat::rgba16f});
  reset_state(gl);
  const bool scissor = in.number("scissor") > 0.5;
  const auto& maps = in.numbers("maps");
  for (std::size_t i = 0; i < maps.size(); ++i) {
    picture.bind(gl);
    gl.ClearColor(0, 0, 0, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(tiny / 2, 0, tiny / 2, tiny);
    gl.ClearColor(0.25f * float(i + 1), 0, 0, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Scissor(1, 1, 2, 2);
    if (!scissor) gl.Disable(GL_SCISSOR_TEST);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.Viewport(0, 0, 3, 2);
    record(gl, preview, Map(int(maps[i])), picture.framebuffer());
  }
  Numbers out;
  append(out, bound(gl));
  std::array<GLint, 4> viewport{}, box{};
  gl.GetIntegerv(GL_VIEWPORT, viewport.data());
  gl.GetIntegerv(GL_SCISSOR_BOX, box.data());
  append(out, viewport);
  append(out, box);
  out.push_back(gl.IsEnabled(GL_SCISSOR_TEST));
  reset_state(gl);
  for (const GLuint texture : preview.textures) append(out, reds(gl, texture));
  append(out, reds(gl, picture.colour_texture()));
  out.pop_back();  // it has no mipmaps
  return out;
}

/// "visible", "recorded", "recorded_of", "frames_since", "version": one number for each preview. How many are recorded,
/// then which.
Numbers probe_previews_to_record(ProbeContext&, const Arguments& in) {
  std::vector<PreviewState> states(in.numbers("visible").size());
  const auto number = [&](const char* name, std::size_t i) { return in.numbers(name).at(i); };
  for (std::size_t i = 0; i < states.size(); ++i)
    states[i] = {.visible = number("visible", i) > 0.5,
                 .version = std::uint64_t(number("version", i)),
                 .recorded = number("recorded", i) > 0.5,
                 .recorded_of = std::uint64_t(number("recorded_of", i)),
                 .frames_since = std::uint64_t(number("frames_since", i))};
  const std::vector<int> wanted = previews_to_record(states, in.integer("most"));
  Numbers out{double(wanted.size())};
  append(out, wanted);
  return out;
}

}  // namespace

std::map<std::string, Probe> gallery_probes() {
  return {
      {"hall_wall",
       [](ProbeContext&, const Arguments& in) {
         return seen_from_axis(hall_wall(in.integer("segments"), float(in.number("radius")), float(in.number("height")),
                                         float(in.number("repeat"))),
                               in.numbers("angles"), in.numbers("heights"));
       }},
      {"painting_frame",
       [](ProbeContext&, const Arguments& in) {
         return atelier::numbers_of(
             painting_frame(in.integer("index"), in.integer("count"), in.number("distance"), in.number("height")));
       }},
      {"meets",
       [](ProbeContext&, const Arguments& in) -> Numbers {
         return {double(meets(in.vec4("plane"), eight_corners(in)))};
       }},
      {"side_planes", probe_side_planes},
      {"touches", probe_touches},
      {"gone_through",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(gone_through(visitor_of(in), in.mat4("entry"), in.mat4("exit"), in.integer("into"),
                                        in.number("clearance"), in.number("speed")));
       }},
      {"moved", probe_moved},
      {"held", probe_held},
      {"walk", probe_walk},
      {"preview_camera", probe_preview_camera},
      {"make_preview", probe_make_preview},
      {"record", probe_record},
      {"previews_to_record", probe_previews_to_record},
      {"style_of",
       [](ProbeContext&, const Arguments& in) -> Numbers { return {double(style_of(in.integer("room")))}; }},
  };
}

}  // namespace atelier
