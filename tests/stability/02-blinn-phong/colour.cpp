// srgb_encode and srgb_decode, on the CPU and in the shader: at the joint of the two branches, below 0, above 1.
#include "stability/02-blinn-phong/rows.hpp"

namespace atelier::stability {

namespace {

/// IEC 61966-2-1 by exponential and logarithm of long doubles: neither the contract's powers nor common/image's.
long double exact_encode(long double x) {
  if (x <= 0) return 0;
  return x <= 0.0031308L ? 12.92L * x : 1.055L * std::exp(std::log(x) / 2.4L) - 0.055L;
}
long double exact_decode(long double x) {
  if (x <= 0) return 0;
  return x <= 0.04045L ? x / 12.92L : std::exp(std::log((x + 0.055L) / 1.055L) * 2.4L);
}

/// A curve under trial: both directions of the CPU's and of the shader's look alike from here.
struct Transfer {
  const char* name;
  std::function<Values(const std::vector<float>&)> apply;
  long double (*exact)(long double);
  float joint;  ///< where the straight part ends
  Bound bound;  ///< relative, 0..1
  bool on_cpu;
};

double curve_error(const Transfer& curve, const std::vector<float>& inputs) {
  Values expected;
  for (const float x : inputs) expected.push_back(double(curve.exact(x)));
  return each_relative(curve.apply(inputs), expected);
}

/// How often the curve falls from one of 4096 neighbouring inputs to the next.
double falls(const Transfer& curve) {
  std::vector<float> inputs;
  for (int i = 0; i <= 4096; ++i) inputs.push_back(float(i) / 4096);
  const Values y = curve.apply(inputs);
  double count = 0;
  for (std::size_t i = 1; i < y.size(); ++i) count += !(y[i] > y[i - 1]);
  return count;
}

void add_rows(Table& table, const Transfer& curve) {
  Group group = table.of(curve.name);
  group.equals("0 and -0", [=] { return curve.apply({0.0f, -0.0f}); }, {0, 0});
  group.equals("negative values", [=] { return curve.apply({-1e-30f, -1, -largest_float, -infinite}); }, {0, 0, 0, 0});
  group.close(
      "1",
      {3 * rounding_unit, "absolute", "a power near 1 and a difference: three roundings; 8-bit white survives 2e-3"},
      [=] { return std::abs(curve.apply({1}).front() - 1); });
  group.close("at the joint, and a float on either side", curve.bound, [=] {
    return curve_error(curve, {std::nextafter(curve.joint, 0.0f), curve.joint, std::nextafter(curve.joint, 1.0f)});
  });
  group.close("from 1e-30 to 1, 400 values", curve.bound, [=] {
    std::vector<float> inputs;
    for (int i = 0; i < 400; ++i) inputs.push_back(std::pow(10.0f, -30.0f * float(i) / 400));
    return curve_error(curve, inputs);
  });
  group.close("above one: 2, 100, 1e6, 1e15",
              {6e-6, "relative",
               "the float 2.4 is 9.5e-8 too large, which counts as often as the logarithm of 1e15 says, 35 times; as "
               "much again for drivers"},
              [=] {
                return curve_error(curve, {2, 100, 1e6f, 1e15f});
              });
  group.equals("it never falls, 4096 steps", [=] { return Values{falls(curve)}; }, {0});
  if (curve.on_cpu) {
    group.equals("infinity", [=] { return curve.apply({infinite}); }, {double(infinite)});
    group.nan("NaN", [=] { return curve.apply({not_a_number}); });
  }
}

/// The shader's function on the first component; all three components do the same.
std::function<Values(const std::vector<float>&)> in_shader(ShaderFunctions& shaders, const std::string& name) {
  return [&shaders, name](const std::vector<float>& inputs) {
    std::vector<ShaderInput> calls;
    for (const float x : inputs) calls.push_back({glm::vec4(x, x, x, 0)});
    Values out;
    for (const glm::vec4& y : shaders.evaluate(blinn_phong_function({"x"}, "vec4(" + name + "(x.rgb), 0.0)"), calls))
      out.push_back(y.r == y.g && y.g == y.b ? double(y.r) : double(not_a_number));
    return out;
  };
}

std::function<Values(const std::vector<float>&)> on_cpu(float (*function)(float)) {
  return [function](const std::vector<float>& inputs) {
    Values out;
    for (const float x : inputs) out.push_back(double(function(x)));
    return out;
  };
}

/// Decoding what was encoded, for random light over six powers of ten.
double round_trip(const Transfer& encode, const Transfer& decode) {
  std::vector<float> light;
  for (int i = 0; i < 2000; ++i) light.push_back(float(Trial(80, i).size_between(1e-6, 1)));
  const Values codes = encode.apply(light);
  return each_relative(decode.apply(std::vector<float>(codes.begin(), codes.end())),
                       Values(light.begin(), light.end()));
}

}  // namespace

void add_colour_rows(Table& table, ShaderFunctions& shaders) {
  const Bound cpu_encode{12 * rounding_unit, "relative",
                         "just above the joint 0.0955 - 0.055 leaves 0.04: roundings count 2.4 times, four of them"};
  const Bound cpu_decode{8 * rounding_unit, "relative",
                         "sum and quotient, their roundings counted 2.4 times by the power"};
  const Bound gpu{6e-6, "relative",
                  "pow is exp2(y log2 x): log2 of 0.003 is -8, a rounding of it 5e-7; drivers add as much again (GLSL "
                  "leaves pow's accuracy open)"};
  const Transfer encode{"srgb_encode", on_cpu(blinn_phong::srgb_encode), exact_encode, 0.0031308f, cpu_encode, true};
  const Transfer decode{"srgb_decode", on_cpu(blinn_phong::srgb_decode), exact_decode, 0.04045f, cpu_decode, true};
  const Transfer shader_encode{
      "srgb_encode (GLSL)", in_shader(shaders, "srgb_encode"), exact_encode, 0.0031308f, gpu, false};
  const Transfer shader_decode{
      "srgb_decode (GLSL)", in_shader(shaders, "srgb_decode"), exact_decode, 0.04045f, gpu, false};
  for (const Transfer& curve : {encode, decode, shader_encode, shader_decode}) add_rows(table, curve);
  table.of("srgb_decode(srgb_encode)")
      .close("2000 random values, 1e-6 to 1",
             {30 * rounding_unit, "relative", "12 roundings of the code, counted up to 2.4 times"},
             [=] { return round_trip(encode, decode); });
  table.of("srgb_decode(srgb_encode) (GLSL)")
      .close("2000 random values, 1e-6 to 1", {2e-5, "relative", "6e-6 of the code, counted up to 2.4 times, and 6e-6"},
             [=] { return round_trip(shader_encode, shader_decode); });
}

}  // namespace atelier::stability
