// Counts the calls through Gl. For this it tracks a part of OpenGL's state: which textures are bound, which programs
// read them, how large the attachments of a framebuffer are.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "gl/counts.hpp"
#include "gl/gl.hpp"

namespace atelier {

/// Each function is called just before the OpenGL function of the same name. Bytes are nominal sizes of the formats
/// (gl/texel.hpp).
class GlMeter {
 public:
  explicit GlMeter(const Gl& gl) : gl_(gl) {}

  void restart();
  GlCounts counts();
  void count_fragments(bool wanted);

  // Groups
  int begin_group(std::string_view name);  ///< returns how many are open now
  void end_group();                        ///< the one that began last; does nothing if none is open
  std::vector<GlGroup> groups();

  // Draws and passes
  void draw(GLenum mode, GLsizei corners);
  void clear();
  void blit();
  void bind_framebuffer(GLenum target, GLuint framebuffer);
  void attach_texture(GLenum target, GLenum attachment, GLuint texture);
  void attach_renderbuffer(GLenum target, GLenum attachment, GLuint renderbuffer);
  void delete_framebuffers(GLsizei count, const GLuint* framebuffers);

  // Programs
  void link_program(GLuint program);
  void use_program(GLuint program);
  void delete_program(GLuint program);
  void set_int(GLint location, GLint value);  ///< glUniform1i, which sets a sampler's unit

  // Storage
  struct Level {
    GLenum format = GL_NONE;
    std::int64_t width = 0, height = 0, depth = 0;  ///< texels; depth counts the layers of an array too
    bool operator==(const Level&) const = default;
  };
  void active_texture(GLenum unit);
  void bind_texture(GLenum target, GLuint texture);
  void texture_level(GLenum target, GLint level, const Level& size);
  void generate_mipmap(GLenum target);
  void delete_textures(GLsizei count, const GLuint* textures);
  void bind_renderbuffer(GLuint renderbuffer);
  void renderbuffer_storage(const Level& size, GLsizei samples);
  void delete_renderbuffers(GLsizei count, const GLuint* renderbuffers);

 private:
  struct Sampler {
    GLenum target = GL_TEXTURE_2D;
    GLint unit = 0;
  };
  struct Program {
    std::set<GLint> attributes;         ///< locations that it reads
    std::map<GLint, Sampler> samplers;  ///< by the uniform's location
  };
  /// One of the two things that can be attached to a framebuffer.
  struct Attachment {
    bool renderbuffer = false;
    GLuint name = 0;
    auto operator<=>(const Attachment&) const = default;
  };
  using Face = std::pair<GLenum, GLint>;  ///< target (or face of a cube) and level

  Program read_program(GLuint program) const;
  void begin_pass();
  std::int64_t end_query();
  void add_fragments();
  GLuint framebuffer_at(GLenum target) const {
    return target == GL_READ_FRAMEBUFFER ? read_framebuffer_ : framebuffer_;
  }
  void attach(GLenum target, GLenum attachment, const Attachment& what);
  std::map<Face, Level>* bound_levels(GLenum target);
  std::int64_t bytes_of(const Attachment& what) const;

  const Gl& gl_;

  // Tracked for the lifetime of the context
  std::map<GLuint, Program> programs_;
  std::map<GLuint, std::map<Face, Level>> textures_;
  std::map<GLuint, std::int64_t> renderbuffers_;                 ///< bytes
  std::map<GLuint, std::map<GLenum, Attachment>> framebuffers_;  ///< by attachment point
  std::map<std::pair<GLuint, GLenum>, GLuint> bound_textures_;   ///< by unit and target
  GLuint unit_ = 0, program_ = 0, framebuffer_ = 0, read_framebuffer_ = 0, renderbuffer_ = 0;

  GLuint query_ = 0;       ///< of samples passed; 0 unless fragments are counted
  bool in_query_ = false;  ///< from a draw to the next beginning or end of a group

  // Since the last restart
  GlCounts counts_;  ///< those that are plain sums
  bool in_pass_ = false;
  GLuint last_program_ = 0;
  std::set<GLuint> programs_drawn_with_, textures_read_;
  std::set<GLint> attributes_read_;
  std::map<Attachment, std::int64_t> targets_;  ///< bytes of what was drawn into

  // Groups beyond the listed ones are tracked too, so that ends match their beginnings
  static constexpr std::size_t most_groups = 256;
  std::vector<GlGroup> groups_;                          ///< of an open one: the sums before it, negated
  std::vector<std::optional<std::size_t>> open_groups_;  ///< indices into groups_; empty if not listed
};

/// Makes every counted function of `gl` report its calls to `meter`.
void count_calls(Gl& gl);

}  // namespace atelier
