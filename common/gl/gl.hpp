// OpenGL's functions as one object, which is passed to all code that draws.
//
// `gl.BindBuffer(GL_ARRAY_BUFFER, id)` is `glBindBuffer(GL_ARRAY_BUFFER, id)` in books: the same name without the
// prefix, the same arguments. There are no global function pointers and there is no loader library (none works with
// OSMesa). The list below is exactly what this project uses.
#pragma once

#include <GL/glcorearb.h>

#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "gl/call_errors.hpp"
#include "gl/counts.hpp"

namespace atelier {

class GlMeter;

/// The functions: X(return type by glcorearb.h's typedef, name without the gl prefix).
#define ATELIER_GL_FUNCTIONS(X)                                                        \
  X(PFNGLACTIVETEXTUREPROC, ActiveTexture)                                             \
  X(PFNGLATTACHSHADERPROC, AttachShader)                                               \
  X(PFNGLBEGINQUERYPROC, BeginQuery)                                                   \
  X(PFNGLBINDATTRIBLOCATIONPROC, BindAttribLocation)                                   \
  X(PFNGLBINDBUFFERPROC, BindBuffer)                                                   \
  X(PFNGLBINDBUFFERBASEPROC, BindBufferBase)                                           \
  X(PFNGLBINDFRAGDATALOCATIONPROC, BindFragDataLocation)                               \
  X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                                         \
  X(PFNGLBINDRENDERBUFFERPROC, BindRenderbuffer)                                       \
  X(PFNGLBINDTEXTUREPROC, BindTexture)                                                 \
  X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                                         \
  X(PFNGLBLENDFUNCPROC, BlendFunc)                                                     \
  X(PFNGLBLITFRAMEBUFFERPROC, BlitFramebuffer)                                         \
  X(PFNGLBUFFERDATAPROC, BufferData)                                                   \
  X(PFNGLBUFFERSUBDATAPROC, BufferSubData)                                             \
  X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus)                           \
  X(PFNGLCLEARPROC, Clear)                                                             \
  X(PFNGLCLEARBUFFERFVPROC, ClearBufferfv)                                             \
  X(PFNGLCLEARCOLORPROC, ClearColor)                                                   \
  X(PFNGLCLEARDEPTHPROC, ClearDepth)                                                   \
  X(PFNGLCLEARSTENCILPROC, ClearStencil)                                               \
  X(PFNGLCOLORMASKPROC, ColorMask)                                                     \
  X(PFNGLCOMPILESHADERPROC, CompileShader)                                             \
  X(PFNGLCREATEPROGRAMPROC, CreateProgram)                                             \
  X(PFNGLCREATESHADERPROC, CreateShader)                                               \
  X(PFNGLCULLFACEPROC, CullFace)                                                       \
  X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                                             \
  X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)                                   \
  X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                                             \
  X(PFNGLDELETEQUERIESPROC, DeleteQueries)                                             \
  X(PFNGLDELETERENDERBUFFERSPROC, DeleteRenderbuffers)                                 \
  X(PFNGLDELETESHADERPROC, DeleteShader)                                               \
  X(PFNGLDELETETEXTURESPROC, DeleteTextures)                                           \
  X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)                                   \
  X(PFNGLDETACHSHADERPROC, DetachShader)                                               \
  X(PFNGLDEPTHFUNCPROC, DepthFunc)                                                     \
  X(PFNGLDEPTHMASKPROC, DepthMask)                                                     \
  X(PFNGLDEPTHRANGEPROC, DepthRange)                                                   \
  X(PFNGLDISABLEPROC, Disable)                                                         \
  X(PFNGLDISABLEVERTEXATTRIBARRAYPROC, DisableVertexAttribArray)                       \
  X(PFNGLDRAWARRAYSPROC, DrawArrays)                                                   \
  X(PFNGLDRAWBUFFERPROC, DrawBuffer)                                                   \
  X(PFNGLDRAWBUFFERSPROC, DrawBuffers)                                                 \
  X(PFNGLDRAWELEMENTSPROC, DrawElements)                                               \
  X(PFNGLENABLEPROC, Enable)                                                           \
  X(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray)                         \
  X(PFNGLENDQUERYPROC, EndQuery)                                                       \
  X(PFNGLFINISHPROC, Finish)                                                           \
  X(PFNGLFLUSHPROC, Flush)                                                             \
  X(PFNGLFRAMEBUFFERRENDERBUFFERPROC, FramebufferRenderbuffer)                         \
  X(PFNGLFRAMEBUFFERTEXTUREPROC, FramebufferTexture)                                   \
  X(PFNGLFRAMEBUFFERTEXTURE2DPROC, FramebufferTexture2D)                               \
  X(PFNGLFRAMEBUFFERTEXTURELAYERPROC, FramebufferTextureLayer)                         \
  X(PFNGLFRONTFACEPROC, FrontFace)                                                     \
  X(PFNGLGENBUFFERSPROC, GenBuffers)                                                   \
  X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                                         \
  X(PFNGLGENQUERIESPROC, GenQueries)                                                   \
  X(PFNGLGENRENDERBUFFERSPROC, GenRenderbuffers)                                       \
  X(PFNGLGENTEXTURESPROC, GenTextures)                                                 \
  X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                                         \
  X(PFNGLGENERATEMIPMAPPROC, GenerateMipmap)                                           \
  X(PFNGLGETACTIVEATTRIBPROC, GetActiveAttrib)                                         \
  X(PFNGLGETACTIVEUNIFORMPROC, GetActiveUniform)                                       \
  X(PFNGLGETATTRIBLOCATIONPROC, GetAttribLocation)                                     \
  X(PFNGLGETERRORPROC, GetError)                                                       \
  X(PFNGLGETFLOATVPROC, GetFloatv)                                                     \
  X(PFNGLGETFRAMEBUFFERATTACHMENTPARAMETERIVPROC, GetFramebufferAttachmentParameteriv) \
  X(PFNGLGETINTEGERVPROC, GetIntegerv)                                                 \
  X(PFNGLGETBUFFERPARAMETERIVPROC, GetBufferParameteriv)                               \
  X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)                                     \
  X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                                               \
  X(PFNGLGETQUERYOBJECTUI64VPROC, GetQueryObjectui64v)                                 \
  X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)                                       \
  X(PFNGLGETSHADERIVPROC, GetShaderiv)                                                 \
  X(PFNGLGETSTRINGPROC, GetString)                                                     \
  X(PFNGLGETSTRINGIPROC, GetStringi)                                                   \
  X(PFNGLGETTEXIMAGEPROC, GetTexImage)                                                 \
  X(PFNGLGETTEXLEVELPARAMETERIVPROC, GetTexLevelParameteriv)                           \
  X(PFNGLGETTEXPARAMETERFVPROC, GetTexParameterfv)                                     \
  X(PFNGLGETTEXPARAMETERIVPROC, GetTexParameteriv)                                     \
  X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)                                   \
  X(PFNGLGETVERTEXATTRIBIVPROC, GetVertexAttribiv)                                     \
  X(PFNGLISBUFFERPROC, IsBuffer)                                                       \
  X(PFNGLISENABLEDPROC, IsEnabled)                                                     \
  X(PFNGLISFRAMEBUFFERPROC, IsFramebuffer)                                             \
  X(PFNGLISPROGRAMPROC, IsProgram)                                                     \
  X(PFNGLISRENDERBUFFERPROC, IsRenderbuffer)                                           \
  X(PFNGLISTEXTUREPROC, IsTexture)                                                     \
  X(PFNGLISVERTEXARRAYPROC, IsVertexArray)                                             \
  X(PFNGLLINKPROGRAMPROC, LinkProgram)                                                 \
  X(PFNGLPIXELSTOREIPROC, PixelStorei)                                                 \
  X(PFNGLPOLYGONMODEPROC, PolygonMode)                                                 \
  X(PFNGLPOLYGONOFFSETPROC, PolygonOffset)                                             \
  X(PFNGLREADBUFFERPROC, ReadBuffer)                                                   \
  X(PFNGLREADPIXELSPROC, ReadPixels)                                                   \
  X(PFNGLRENDERBUFFERSTORAGEPROC, RenderbufferStorage)                                 \
  X(PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC, RenderbufferStorageMultisample)           \
  X(PFNGLSCISSORPROC, Scissor)                                                         \
  X(PFNGLSHADERSOURCEPROC, ShaderSource)                                               \
  X(PFNGLSTENCILFUNCPROC, StencilFunc)                                                 \
  X(PFNGLSTENCILMASKPROC, StencilMask)                                                 \
  X(PFNGLSTENCILOPPROC, StencilOp)                                                     \
  X(PFNGLTEXIMAGE2DPROC, TexImage2D)                                                   \
  X(PFNGLTEXIMAGE3DPROC, TexImage3D)                                                   \
  X(PFNGLTEXPARAMETERFPROC, TexParameterf)                                             \
  X(PFNGLTEXPARAMETERFVPROC, TexParameterfv)                                           \
  X(PFNGLTEXPARAMETERIPROC, TexParameteri)                                             \
  X(PFNGLTEXSUBIMAGE2DPROC, TexSubImage2D)                                             \
  X(PFNGLUNIFORM1FPROC, Uniform1f)                                                     \
  X(PFNGLUNIFORM1FVPROC, Uniform1fv)                                                   \
  X(PFNGLUNIFORM1IPROC, Uniform1i)                                                     \
  X(PFNGLUNIFORM2FPROC, Uniform2f)                                                     \
  X(PFNGLUNIFORM2FVPROC, Uniform2fv)                                                   \
  X(PFNGLUNIFORM3FVPROC, Uniform3fv)                                                   \
  X(PFNGLUNIFORM4FVPROC, Uniform4fv)                                                   \
  X(PFNGLUNIFORMMATRIX3FVPROC, UniformMatrix3fv)                                       \
  X(PFNGLUNIFORMMATRIX4FVPROC, UniformMatrix4fv)                                       \
  X(PFNGLUSEPROGRAMPROC, UseProgram)                                                   \
  X(PFNGLGETVERTEXATTRIBPOINTERVPROC, GetVertexAttribPointerv)                         \
  X(PFNGLVERTEXATTRIB4FPROC, VertexAttrib4f)                                           \
  X(PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer)                                 \
  X(PFNGLVIEWPORTPROC, Viewport)

/// Functions of GL 4.3 or KHR_debug, which name objects and parts of a frame (gl/debug.hpp), and report errors
/// (gl/call_errors.hpp).
#define ATELIER_GL_DEBUG_FUNCTIONS(X)                    \
  X(PFNGLDEBUGMESSAGECALLBACKPROC, DebugMessageCallback) \
  X(PFNGLDEBUGMESSAGECONTROLPROC, DebugMessageControl)   \
  X(PFNGLGETOBJECTLABELPROC, GetObjectLabel)             \
  X(PFNGLOBJECTLABELPROC, ObjectLabel)                   \
  X(PFNGLPOPDEBUGGROUPPROC, PopDebugGroup)               \
  X(PFNGLPUSHDEBUGGROUPPROC, PushDebugGroup)

/// The driver's limits for KHR_debug; all 0 without it. A name must have fewer bytes than its limit.
struct GlDebugLimits {
  GLint label = 0, message = 0;  ///< names of objects, and of groups
  GLint group_depth = 0;         ///< most groups open at a time, including the unnamed default group
};

/// The loaded functions of the current context. Created by a context; valid while that exists and is current.
class Gl {
 public:
  using Resolver = void* (*)(const char* name);  ///< "glClear" to its address, or null

  /// Throws Error naming the first function that the context lacks, or its version if that is below 3.3.
  explicit Gl(Resolver resolve);
  ~Gl();
  Gl(const Gl&) = delete;
  Gl& operator=(const Gl&) = delete;

  /// Counts since restart_counts() or, if it was never called, since construction.
  GlCounts counts();
  /// The groups since then in the order in which they began, at most the first 256; an open group has its counts so
  /// far.
  std::vector<GlGroup> groups();
  void restart_counts();
  /// From now on fragments are counted too, or no longer. Each group then waits for its own drawing, so a frame that is
  /// timed should not count them.
  void count_fragments(bool wanted);

  /// Work between the two calls also counts for the group `name` and for those around it. begin_group returns how many
  /// groups are open now. Called by DebugGroup (gl/debug.hpp), which pairs the calls.
  int begin_group(std::string_view name);
  void end_group();

  /// One function: calls it, after it has reported the call to the meter if the counts depend on it. If the driver
  /// reports an error meanwhile, the call's name and arguments are kept for check_gl_error.
  template <class Signature>
  class Function;
  template <class Result, class... Parameters>
  class Function<Result (*)(Parameters...)> {
   public:
    Result operator()(Parameters... parameters) const {
      if (count) count(*meter, parameters...);
      if constexpr (std::is_void_v<Result>) {
        call(parameters...);
        if (errors->reported()) name_error(parameters...);
      } else {
        const Result result = call(parameters...);
        if (errors->reported()) name_error(parameters...);
        return result;
      }
    }
    Result (*call)(Parameters...) = nullptr;
    void (*count)(GlMeter&, Parameters...) = nullptr;
    GlMeter* meter = nullptr;
    GlCallErrors* errors = nullptr;
    const char* name = nullptr;  ///< without "gl"

   private:
    [[gnu::cold, gnu::noinline]] void name_error(Parameters... parameters) const {
      errors->name_call(name, std::vector<GlArgument>{GlArgument(parameters)...});
    }
  };

#define ATELIER_GL_MEMBER(type, name) Function<type> name;
  ATELIER_GL_FUNCTIONS(ATELIER_GL_MEMBER)

  /// glClipControl if the context has GL 4.5 or ARB_clip_control; otherwise its `call` is null.
  Function<PFNGLCLIPCONTROLPROC> ClipControl;

  // Available if the context has GL 4.3 or KHR_debug; otherwise their `call` is null.
  ATELIER_GL_DEBUG_FUNCTIONS(ATELIER_GL_MEMBER)
#undef ATELIER_GL_MEMBER

  /// Of the calls through this object. check_gl_error takes them.
  GlCallErrors& call_errors() const {
    return *errors_;
  }
  const GlDebugLimits& debug_limits() const {
    return debug_limits_;
  }
  bool has_extension(const char* name) const;
  int version() const {
    return version_;
  }                                 ///< 33 for 3.3
  std::string description() const;  ///< "llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile) Mesa 22.3.6"

 private:
  std::unique_ptr<GlMeter> meter_;
  std::unique_ptr<GlCallErrors> errors_;
  GlDebugLimits debug_limits_;
  int version_ = 0;
};

/// If OpenGL's error flags are set, clears them and throws Error with `doing`, their names and, if the driver reports
/// which, the first call that failed, with its arguments and the reason (gl/call_errors.hpp).
void check_gl_error(const Gl& gl, const char* doing);

}  // namespace atelier
