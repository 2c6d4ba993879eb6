// Which of two surfaces is in front: pairs of points a hundred-thousandth of their distance apart, drawn by the driver
// into depth buffers of each format with the step's own projections.
//
// A pair is misordered where the depth buffer does not hold the nearer point strictly nearer: a tie is decided by who
// was drawn first. N. Reed, "Depth Precision Visualized", 2015, shows why reversing helps floats and not integers.
#include "gl/target.hpp"
#include "stability/01-transforms/rows.hpp"

namespace atelier::stability {

namespace {

struct DepthKind {
  const char* name;
  DepthFormat format;
  bool reversed;
};
constexpr DepthKind kinds[] = {{"16 bits", DepthFormat::depth16, false},
                               {"24 bits", DepthFormat::depth24, false},
                               {"32-bit float", DepthFormat::depth32f, false},
                               {"32-bit float, reversed", DepthFormat::depth32f, true}};

constexpr int pairs = 2048;
constexpr double apart = 1e-5;  ///< of the distance

// A point in the middle of pixel (gl_VertexID), at the distance that its vertex holds. The row of the matrix that
// makes the depth is used as it is; x is chosen to survive the division by w.
const std::string vertex_text = R"(
layout(location = 0) in float a_distance;
uniform mat4 u_projection;
uniform float u_width;
void main() {
  vec4 clip = u_projection * vec4(0.0, 0.0, -a_distance, 1.0);
  gl_Position = vec4(((float(gl_VertexID) + 0.5) / u_width * 2.0 - 1.0) * clip.w, 0.0, clip.z, clip.w);
}
)";
const std::string fragment_text = "void main() {}\n";

/// Distances of pairs, the nearer point first, evenly spread in the logarithm over near..far.
std::vector<float> distances(double near, double far) {
  std::vector<float> out;
  for (int i = 0; i < pairs; ++i) {
    Trial t(70, i);
    const double range = std::log(far / near / (1 + 2 * apart));  // the farther one is before the far plane, too
    const double z = near * std::exp(range * t.between(0, 1));
    out.push_back(float(z));
    out.push_back(float(z * (1 + apart)));
  }
  return out;
}

/// The share of pairs that steps of 2^-bits can be expected to make equal: two depths that are d steps apart fall on
/// the same step with the probability 1 - d, in double precision.
double share_of_ties(int bits, double near, double far) {
  const std::vector<float> z = distances(near, far);
  double sum = 0;
  for (std::size_t i = 0; i < z.size(); i += 2) {
    // Depth 0..1 is exact::depth / 2 + 1/2; the difference is written out so that it keeps its digits.
    const double difference =
        near * far / (far - near) * (double(z[i + 1]) - double(z[i])) / (double(z[i]) * double(z[i + 1]));
    sum += std::max(0.0, 1 - difference * std::exp2(bits));
  }
  return sum / pairs;
}

/// What the depth buffer holds for each of the distances.
std::vector<float> drawn_depths(Gl& gl, const GlProgram& program, const DepthKind& kind, float near, float far,
                                const std::vector<float>& z) {
  const int width = int(z.size());
  const Target target(gl, {.width = width, .height = 1, .colour = ColourFormat::rgba8, .depth = kind.format});
  target.bind(gl);
  if (kind.reversed) gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_ALWAYS);
  gl.DepthMask(GL_TRUE);
  gl.UseProgram(program.id());
  Uniforms uniforms(gl, program.id());
  uniforms.set("u_width", float(width));
  uniforms.set("u_projection", kind.reversed ? transforms::perspective_reversed(1, 1, near, far)
                                             : transforms::perspective(1, 1, near, far));
  const GlVertexArray vertex_array(gl);
  const GlBuffer buffer(gl);
  gl.BindVertexArray(vertex_array.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer.id());
  gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(z.size() * sizeof(float)), z.data(), GL_STATIC_DRAW);
  gl.VertexAttribPointer(0, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl.EnableVertexAttribArray(0);
  gl.DrawArrays(GL_POINTS, 0, width);
  gl.BindVertexArray(0);
  gl.Disable(GL_DEPTH_TEST);
  if (kind.reversed) gl.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  check_gl_error(gl, "drawing depths");
  std::vector<float> depths;
  const Image image = target.read_depth(gl);
  for (const Rgba& p : image.pixels()) depths.push_back(p.r);
  return depths;
}

/// Draws the pairs; keeps the program over many ranges.
class DepthOrder {
 public:
  explicit DepthOrder(Gl& gl) : gl_(&gl) {
    const FindFile nothing = [](const std::string&) { return std::filesystem::path(); };
    program_ = build_program(gl, assemble_shader_text(nothing, vertex_text, "depth order, vertices", {}),
                             assemble_shader_text(nothing, fragment_text, "depth order, fragments", {}));
  }

  /// The share of pairs that come out wrong, 0..1.
  double misordered(const DepthKind& kind, double near, double far) const {
    const std::vector<float> z = distances(near, far);
    const std::vector<float> d = drawn_depths(*gl_, program_, kind, float(near), float(far), z);
    int wrong = 0;
    for (std::size_t i = 0; i < z.size(); i += 2) wrong += !(kind.reversed ? d[i] > d[i + 1] : d[i] < d[i + 1]);
    return double(wrong) / pairs;
  }

 private:
  Gl* gl_;
  GlProgram program_;
};

Sweep depth_order_sweep(Gl& gl) {
  const DepthOrder order(gl);
  Sweep sweep{.name = "depth-order",
              .title = "Pairs of surfaces, 1e-5 of their distance apart, drawn in the wrong order",
              .x_label = "far / near",
              .y_label = "share of misordered pairs",
              .log_y = false};
  for (const DepthKind& kind : kinds) {
    if (kind.reversed && !gl.ClipControl.call) continue;  // optional in OpenGL 3.3
    Curve curve{kind.name, {}};
    for (int step = 1; step <= 18; ++step) {
      const double ratio = std::pow(10.0, step / 2.0);
      curve.points.push_back({ratio, order.misordered(kind, 0.1, 0.1 * ratio)});
    }
    sweep.curves.push_back(std::move(curve));
  }
  return sweep;
}

}  // namespace

void add_depth_order_rows(Table& table, ShaderFunctions& shaders) {
  Gl& gl = shaders.gl();
  Group group = table.of("order of depths");
  if (gl.ClipControl.call)
    for (const double ratio : {1e5, 1e9})
      group.equals(fmt::format("far/near {:.0e}, 32-bit float, reversed: no pair is misordered", ratio),
                   [=, &gl] { return Values{DepthOrder(gl).misordered(kinds[3], 0.1, 0.1 * ratio)}; }, {0});
  // A test of this measurement as much as of the projection.
  for (const auto& [kind, bits] : {std::pair{0, 16}, {1, 24}, {2, 24}})
    for (const double ratio : {1e2, 1e5, 1e9})
      group.close(
          fmt::format("far/near {:.0e}, {}: as many as steps of 2^-{} make equal", ratio, kinds[kind].name, bits),
          {0.075, "of all pairs",
           "four standard deviations of a share of 2048 pairs are 0.044; the projection's own rounding moves a "
           "depth by half a step of 24 bits, which makes ties of some pairs and parts others"},
          [=, &gl, kind = kind, bits = bits] {
            return std::abs(DepthOrder(gl).misordered(kinds[kind], 0.1, 0.1 * ratio) -
                            share_of_ties(bits, 0.1, 0.1 * ratio));
          });
  table.sweeps.push_back([&gl] { return depth_order_sweep(gl); });
}

}  // namespace atelier::stability
