#include "gl/meter.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "gl/texel.hpp"

namespace atelier {
namespace {

std::int64_t triangles_of(GLenum mode, GLsizei corners) {
  switch (mode) {
    case GL_TRIANGLES:
      return corners / 3;
    case GL_TRIANGLE_STRIP:
    case GL_TRIANGLE_FAN:
      return std::max(corners - 2, 0);
    default:
      return 0;
  }
}

std::int64_t bytes_of_level(const GlMeter::Level& level) {
  return level.width * level.height * level.depth * texel_bytes(level.format);
}

/// The texture target that a sampler reads; GL_NONE for uniforms of other types.
GLenum sampled_target(GLenum type) {
  switch (type) {
    case GL_SAMPLER_2D:
    case GL_SAMPLER_2D_SHADOW:
    case GL_INT_SAMPLER_2D:
    case GL_UNSIGNED_INT_SAMPLER_2D:
      return GL_TEXTURE_2D;
    case GL_SAMPLER_2D_ARRAY:
    case GL_SAMPLER_2D_ARRAY_SHADOW:
    case GL_INT_SAMPLER_2D_ARRAY:
    case GL_UNSIGNED_INT_SAMPLER_2D_ARRAY:
      return GL_TEXTURE_2D_ARRAY;
    case GL_SAMPLER_CUBE:
    case GL_SAMPLER_CUBE_SHADOW:
      return GL_TEXTURE_CUBE_MAP;
    case GL_SAMPLER_3D:
      return GL_TEXTURE_3D;
    case GL_SAMPLER_2D_MULTISAMPLE:
      return GL_TEXTURE_2D_MULTISAMPLE;
    default:
      return GL_NONE;
  }
}

/// The binding target for a target of glTexImage2D: the six faces belong to one texture.
GLenum binding_of(GLenum target) {
  const bool side = target >= GL_TEXTURE_CUBE_MAP_POSITIVE_X && target <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z;
  return side ? GLenum(GL_TEXTURE_CUBE_MAP) : target;
}

/// A group's counts are the sums at its end minus those at its beginning.
void add(GlGroup& group, const GlCounts& sums, int sign) {
  group.passes += sign * sums.passes;
  group.draws += sign * sums.draws;
  group.triangles += sign * sums.triangles;
  group.fragments += sign * sums.fragments.value_or(0);
}

}  // namespace

// ---- The counts

void GlMeter::restart() {
  end_query();
  counts_ = {};
  if (query_) counts_.fragments = 0;
  in_pass_ = false;
  last_program_ = 0;
  programs_drawn_with_.clear();
  textures_read_.clear();
  attributes_read_.clear();
  targets_.clear();

  // Groups that are still open are listed again, with counts from 0.
  std::vector<GlGroup> still_open;
  for (auto& listed : open_groups_) {
    if (!listed) continue;
    still_open.push_back({.depth = groups_[*listed].depth, .name = groups_[*listed].name});
    listed = still_open.size() - 1;
  }
  groups_ = std::move(still_open);
}

GlCounts GlMeter::counts() {
  add_fragments();
  GlCounts counts = counts_;
  counts.variants = std::int64_t(programs_drawn_with_.size());
  counts.attributes = std::int64_t(attributes_read_.size());
  counts.texture_sources = std::int64_t(textures_read_.size());
  for (const auto& [what, bytes] : targets_) counts.target_bytes += bytes;
  std::set<GLuint> attached;
  for (const auto& [framebuffer, attachments] : framebuffers_)
    for (const auto& [point, what] : attachments)
      if (!what.renderbuffer) attached.insert(what.name);
  for (const auto& [texture, levels] : textures_)
    if (!attached.contains(texture)) counts.texture_bytes += bytes_of({false, texture});
  return counts;
}

// ---- Fragments

void GlMeter::count_fragments(bool wanted) {
  if (wanted == (query_ != 0)) return;
  if (wanted) {
    gl_.GenQueries(1, &query_);
    counts_.fragments = 0;
  } else {
    end_query();
    gl_.DeleteQueries(1, &query_);
    query_ = 0;
    counts_.fragments.reset();
  }
}

/// Returns the samples passed since the query began; 0 if there is none. Waits for the draws to be done.
std::int64_t GlMeter::end_query() {
  if (!in_query_) return 0;
  gl_.EndQuery(GL_SAMPLES_PASSED);
  in_query_ = false;
  GLuint64 passed = 0;
  gl_.GetQueryObjectui64v(query_, GL_QUERY_RESULT, &passed);
  return std::int64_t(passed);
}

void GlMeter::add_fragments() {
  if (query_) *counts_.fragments += end_query();
}

// ---- Groups

int GlMeter::begin_group(std::string_view name) {
  add_fragments();
  auto& listed = open_groups_.emplace_back();
  if (groups_.size() < most_groups) {
    listed = groups_.size();
    groups_.push_back({.depth = int(open_groups_.size()) - 1, .name = std::string(name)});
    add(groups_.back(), counts_, -1);
  }
  return int(open_groups_.size());
}

void GlMeter::end_group() {
  if (open_groups_.empty()) return;
  add_fragments();
  if (const auto listed = open_groups_.back()) add(groups_[*listed], counts_, 1);
  open_groups_.pop_back();
}

std::vector<GlGroup> GlMeter::groups() {
  add_fragments();
  std::vector<GlGroup> groups = groups_;
  for (const auto& listed : open_groups_)
    if (listed) add(groups[*listed], counts_, 1);
  return groups;
}

// ---- Draws and passes

void GlMeter::begin_pass() {
  if (in_pass_) return;
  in_pass_ = true;
  ++counts_.passes;
  if (const auto found = framebuffers_.find(framebuffer_); found != framebuffers_.end())
    for (const auto& [point, what] : found->second) targets_[what] = bytes_of(what);
}

void GlMeter::draw(GLenum mode, GLsizei corners) {
  begin_pass();
  ++counts_.draws;
  counts_.triangles += triangles_of(mode, corners);
  counts_.vertices += std::max(corners, 0);
  if (query_ && !in_query_) {
    gl_.BeginQuery(GL_SAMPLES_PASSED, query_);
    in_query_ = true;
  }
  const auto found = programs_.find(program_);
  if (found == programs_.end()) return;
  programs_drawn_with_.insert(program_);
  attributes_read_.insert(found->second.attributes.begin(), found->second.attributes.end());
  for (const auto& [location, sampler] : found->second.samplers)
    if (const auto bound = bound_textures_.find({GLuint(sampler.unit), sampler.target}); bound != bound_textures_.end())
      textures_read_.insert(bound->second);
}

void GlMeter::clear() {
  begin_pass();
  ++counts_.clears;
}

void GlMeter::blit() {
  begin_pass();
}

void GlMeter::bind_framebuffer(GLenum target, GLuint framebuffer) {
  if (target != GL_DRAW_FRAMEBUFFER) read_framebuffer_ = framebuffer;
  if (target == GL_READ_FRAMEBUFFER || framebuffer == framebuffer_) return;
  framebuffer_ = framebuffer;
  in_pass_ = false;
}

void GlMeter::attach(GLenum target, GLenum attachment, const Attachment& what) {
  const GLuint framebuffer = framebuffer_at(target);
  if (what.name)
    framebuffers_[framebuffer][attachment] = what;
  else
    framebuffers_[framebuffer].erase(attachment);
  if (framebuffer == framebuffer_) in_pass_ = false;
}

void GlMeter::attach_texture(GLenum target, GLenum attachment, GLuint texture) {
  attach(target, attachment, {false, texture});
}

void GlMeter::attach_renderbuffer(GLenum target, GLenum attachment, GLuint renderbuffer) {
  attach(target, attachment, {true, renderbuffer});
}

void GlMeter::delete_framebuffers(GLsizei count, const GLuint* framebuffers) {
  for (GLsizei i = 0; i < count; ++i) framebuffers_.erase(framebuffers[i]);
}

// ---- Programs

void GlMeter::link_program(GLuint program) {
  ++counts_.programs_linked;
  programs_.erase(program);  // read again when it is used: linking gives new locations
}

void GlMeter::use_program(GLuint program) {
  if (program && program != last_program_) ++counts_.program_switches;
  if (program) last_program_ = program;
  program_ = program;
  if (program && !programs_.contains(program)) programs_[program] = read_program(program);
}

void GlMeter::delete_program(GLuint program) {
  programs_.erase(program);
}

void GlMeter::set_int(GLint location, GLint value) {
  const auto program = programs_.find(program_);
  if (program == programs_.end()) return;
  if (const auto sampler = program->second.samplers.find(location); sampler != program->second.samplers.end())
    sampler->second.unit = value;
}

GlMeter::Program GlMeter::read_program(GLuint program) const {
  Program facts;
  std::array<GLchar, 256> name{};
  GLint size = 0, count = 0;
  GLenum type = GL_NONE;
  gl_.GetProgramiv(program, GL_ACTIVE_ATTRIBUTES, &count);
  for (GLint i = 0; i < count; ++i) {
    gl_.GetActiveAttrib(program, GLuint(i), GLsizei(name.size()), nullptr, &size, &type, name.data());
    // Built-in inputs like gl_VertexID are listed too, without a location: no buffer feeds them.
    if (const GLint location = gl_.GetAttribLocation(program, name.data()); location >= 0)
      facts.attributes.insert(location);
  }
  gl_.GetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
  for (GLint i = 0; i < count; ++i) {
    gl_.GetActiveUniform(program, GLuint(i), GLsizei(name.size()), nullptr, &size, &type, name.data());
    const GLenum target = sampled_target(type);
    if (target == GL_NONE) continue;
    const std::string array = std::string(name.data()).substr(0, std::string(name.data()).find('['));
    for (GLint element = 0; element < size; ++element) {
      const std::string one = size > 1 ? array + "[" + std::to_string(element) + "]" : name.data();
      facts.samplers[gl_.GetUniformLocation(program, one.c_str())] = {target, 0};
    }
  }
  return facts;
}

// ---- Storage

void GlMeter::active_texture(GLenum unit) {
  unit_ = unit - GL_TEXTURE0;
}

void GlMeter::bind_texture(GLenum target, GLuint texture) {
  if (texture)
    bound_textures_[{unit_, target}] = texture;
  else
    bound_textures_.erase({unit_, target});
}

std::map<GlMeter::Face, GlMeter::Level>* GlMeter::bound_levels(GLenum target) {
  const auto bound = bound_textures_.find({unit_, binding_of(target)});
  return bound == bound_textures_.end() ? nullptr : &textures_[bound->second];
}

void GlMeter::texture_level(GLenum target, GLint level, const Level& size) {
  counts_.allocated_bytes += bytes_of_level(size);
  if (auto* levels = bound_levels(target)) (*levels)[{target, level}] = size;
}

void GlMeter::generate_mipmap(GLenum target) {
  auto* levels = bound_levels(target);
  if (!levels) return;
  const std::map<Face, Level> before = *levels;
  for (const auto& [face, base] : before) {
    if (face.second != 0) continue;
    // An array has the same number of layers on every level.
    const bool layers = target == GL_TEXTURE_2D_ARRAY;
    Level size = base;
    for (GLint level = 1; size.width > 1 || size.height > 1 || (!layers && size.depth > 1); ++level) {
      size.width = std::max<std::int64_t>(size.width / 2, 1);
      size.height = std::max<std::int64_t>(size.height / 2, 1);
      if (!layers) size.depth = std::max<std::int64_t>(size.depth / 2, 1);
      Level& kept = (*levels)[{face.first, level}];
      if (kept == size) continue;  // only its texels change
      counts_.allocated_bytes += bytes_of_level(size);
      kept = size;
    }
  }
}

void GlMeter::delete_textures(GLsizei count, const GLuint* textures) {
  for (GLsizei i = 0; i < count; ++i) {
    textures_.erase(textures[i]);
    std::erase_if(bound_textures_, [&](const auto& bound) { return bound.second == textures[i]; });
  }
}

void GlMeter::bind_renderbuffer(GLuint renderbuffer) {
  renderbuffer_ = renderbuffer;
}

void GlMeter::renderbuffer_storage(const Level& size, GLsizei samples) {
  const std::int64_t bytes = bytes_of_level(size) * std::max(samples, 1);
  counts_.allocated_bytes += bytes;
  renderbuffers_[renderbuffer_] = bytes;
}

void GlMeter::delete_renderbuffers(GLsizei count, const GLuint* renderbuffers) {
  for (GLsizei i = 0; i < count; ++i) renderbuffers_.erase(renderbuffers[i]);
}

std::int64_t GlMeter::bytes_of(const Attachment& what) const {
  if (what.renderbuffer) {
    const auto found = renderbuffers_.find(what.name);
    return found == renderbuffers_.end() ? 0 : found->second;
  }
  std::int64_t bytes = 0;
  if (const auto found = textures_.find(what.name); found != textures_.end())
    for (const auto& [face, level] : found->second) bytes += bytes_of_level(level);
  return bytes;
}

// ---- Which calls are counted

void count_calls(Gl& gl) {
  using M = GlMeter;
  gl.DrawArrays.count = [](M& m, GLenum mode, GLint, GLsizei corners) { m.draw(mode, corners); };
  gl.DrawElements.count = [](M& m, GLenum mode, GLsizei corners, GLenum, const void*) { m.draw(mode, corners); };
  gl.Clear.count = [](M& m, GLbitfield) { m.clear(); };
  gl.ClearBufferfv.count = [](M& m, GLenum, GLint, const GLfloat*) { m.clear(); };
  gl.BlitFramebuffer.count = [](M& m, GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLbitfield, GLenum) {
    m.blit();
  };
  gl.BindFramebuffer.count = [](M& m, GLenum target, GLuint name) { m.bind_framebuffer(target, name); };
  gl.FramebufferTexture.count = [](M& m, GLenum target, GLenum point, GLuint texture, GLint) {
    m.attach_texture(target, point, texture);
  };
  gl.FramebufferTexture2D.count = [](M& m, GLenum target, GLenum point, GLenum, GLuint texture, GLint) {
    m.attach_texture(target, point, texture);
  };
  gl.FramebufferTextureLayer.count = [](M& m, GLenum target, GLenum point, GLuint texture, GLint, GLint) {
    m.attach_texture(target, point, texture);
  };
  gl.FramebufferRenderbuffer.count = [](M& m, GLenum target, GLenum point, GLenum, GLuint name) {
    m.attach_renderbuffer(target, point, name);
  };
  gl.DeleteFramebuffers.count = [](M& m, GLsizei count, const GLuint* names) { m.delete_framebuffers(count, names); };

  gl.LinkProgram.count = [](M& m, GLuint program) { m.link_program(program); };
  gl.UseProgram.count = [](M& m, GLuint program) { m.use_program(program); };
  gl.DeleteProgram.count = [](M& m, GLuint program) { m.delete_program(program); };
  gl.Uniform1i.count = [](M& m, GLint location, GLint value) { m.set_int(location, value); };

  gl.ActiveTexture.count = [](M& m, GLenum unit) { m.active_texture(unit); };
  gl.BindTexture.count = [](M& m, GLenum target, GLuint texture) { m.bind_texture(target, texture); };
  gl.TexImage2D.count = [](M& m, GLenum target, GLint level, GLint format, GLsizei width, GLsizei height, GLint, GLenum,
                           GLenum, const void*) {
    m.texture_level(target, level, {GLenum(format), width, height, 1});
  };
  gl.TexImage3D.count = [](M& m, GLenum target, GLint level, GLint format, GLsizei width, GLsizei height, GLsizei depth,
                           GLint, GLenum, GLenum, const void*) {
    m.texture_level(target, level, {GLenum(format), width, height, depth});
  };
  gl.GenerateMipmap.count = [](M& m, GLenum target) { m.generate_mipmap(target); };
  gl.DeleteTextures.count = [](M& m, GLsizei count, const GLuint* names) { m.delete_textures(count, names); };
  gl.BindRenderbuffer.count = [](M& m, GLenum, GLuint name) { m.bind_renderbuffer(name); };
  gl.RenderbufferStorage.count = [](M& m, GLenum, GLenum format, GLsizei width, GLsizei height) {
    m.renderbuffer_storage({format, width, height, 1}, 1);
  };
  gl.RenderbufferStorageMultisample.count = [](M& m, GLenum, GLsizei samples, GLenum format, GLsizei width,
                                               GLsizei height) {
    m.renderbuffer_storage({format, width, height, 1}, samples);
  };
  gl.DeleteRenderbuffers.count = [](M& m, GLsizei count, const GLuint* names) { m.delete_renderbuffers(count, names); };
}

}  // namespace atelier
