#include "synthetic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "image/colour.hpp"

namespace atelier::judge::test {
namespace {

using glm::dvec3;

constexpr double far_away = 1e9;

struct Ray {
  dvec3 origin, direction;
};

const dvec3 centre{0, 1, 0};

/// A number 0..1 that depends on its arguments alone.
double hashed(std::uint32_t x, std::uint32_t y, std::uint32_t z = 0) {
  std::uint32_t h = x * 0x9e3779b1u ^ y * 0x85ebca77u ^ z * 0xc2b2ae3du;
  h = (h ^ h >> 15) * 0x2c1b3c6du;
  h = (h ^ h >> 12) * 0x297a2d39u;
  return double(h ^ h >> 15) / 4294967295.0;
}

Ray ray_through(const Drawing& d, double x, double y) {
  const dvec3 eye{4.5 * std::sin(d.yaw), 2.2, 4.5 * std::cos(d.yaw)};
  const dvec3 forward = glm::normalize(dvec3(0, 0.8, 0) - eye);
  const dvec3 right = glm::normalize(glm::cross(forward, dvec3(0, 1, 0))), up = glm::cross(right, forward);
  const double u = 2 * (x + d.offset_x) / d.size - 1, v = 1 - 2 * (y + d.offset_y) / d.size;
  return {eye, glm::normalize(forward + 0.45 * (u * right + v * up))};
}

/// Distance along the ray, or far_away. `reformulated` solves the quadratic by its other root formula.
double hit_sphere(const Ray& ray, bool reformulated) {
  const dvec3 to = ray.origin - centre;
  const double b = glm::dot(to, ray.direction), c = glm::dot(to, to) - 1, discriminant = b * b - c;
  if (discriminant < 0) return far_away;
  const double root = std::sqrt(discriminant);
  const double t = reformulated ? c / (-b + root) : -b - root;
  return t > 1e-6 ? t : far_away;
}

double hit_floor(const Ray& ray) {
  const double t = ray.direction.y < 0 ? -ray.origin.y / ray.direction.y : far_away;
  return t;
}

dvec3 texel(int x, int y) {
  const auto wrap = [](int v) { return std::uint32_t(v & 7); };
  return {0.2 + 0.7 * hashed(wrap(x), wrap(y), 1), 0.2 + 0.7 * hashed(wrap(x), wrap(y), 2),
          0.2 + 0.7 * hashed(wrap(x), wrap(y), 3)};
}

dvec3 floor_colour(const Drawing& d, double x, double z) {
  const double u = 2 * x - 0.5 + d.texel_offset, v = 2 * z - 0.5 + d.texel_offset;
  const int i = int(std::floor(u)), j = int(std::floor(v));
  const double fu = u - i, fv = v - j;
  if (d.nearest) return texel(fu < 0.5 ? i : i + 1, fv < 0.5 ? j : j + 1);
  return glm::mix(glm::mix(texel(i, j), texel(i + 1, j), fu), glm::mix(texel(i, j + 1), texel(i + 1, j + 1), fu), fv);
}

/// The sphere's normal with bumps, as a normal map would give them: red along the equator, green along the meridian.
dvec3 bumpy_normal(const Drawing& d, const dvec3& n) {
  const dvec3 along = glm::normalize(glm::cross(dvec3(0, 1, 1e-3), n)), upward = glm::cross(n, along);
  const double red = 0.15 * std::sin(14 * n.x), green = 0.25 * std::sin(17 * n.y + 1);
  return glm::normalize(n + red * along + (d.green_flipped ? -green : green) * upward);
}

double highlight(const Drawing& d, const dvec3& n, const dvec3& l, const dvec3& v) {
  if (d.no_highlight || glm::dot(n, l) <= 0) return 0;
  const double cosine =
      d.mirrored_for_half ? glm::dot(2 * glm::dot(n, l) * n - l, v) : glm::dot(n, glm::normalize(l + v));
  if (cosine <= 0) return 0;
  return 0.8 * (d.reformulated ? std::exp(d.exponent * std::log(cosine)) : std::pow(cosine, d.exponent));
}

struct Surface {
  double distance = far_away;
  dvec3 position{0}, normal{0}, albedo{0};
  bool sphere = false;
};

std::optional<Surface> hit(const Drawing& d, const Ray& ray) {
  const double sphere = hit_sphere(ray, d.reformulated), ground = hit_floor(ray);
  Surface s;
  s.distance = std::min(sphere, ground);
  if (s.distance > 40) return std::nullopt;
  s.position = ray.origin + s.distance * ray.direction;
  s.sphere = sphere < ground;
  s.normal = s.sphere ? bumpy_normal(d, glm::normalize(s.position - centre)) : dvec3(0, 1, 0);
  s.albedo = s.sphere ? dvec3(0.7, 0.25, 0.15) : floor_colour(d, s.position.x, s.position.z);
  return s;
}

dvec3 shade(const Drawing& d, const Ray& ray) {
  const auto s = hit(d, ray);
  if (!s) return {0.10, 0.15, 0.25};
  const dvec3 light{3 * std::sin(d.light_yaw), 4, 3 * std::cos(d.light_yaw)};
  const dvec3 l = glm::normalize(light - s->position);
  const dvec3 ambient = d.no_ambient ? dvec3(0) : 0.12 * s->albedo;
  bool lit = d.no_shadow || s->sphere || hit_sphere({s->position, l}, d.reformulated) == far_away;
  if (d.hole_in_shadow && glm::length(s->position - dvec3(-1.45, 0, -0.3)) < 0.1) lit = true;
  if (!lit) return ambient;
  const double cosine = d.no_cosine ? 1 : std::max(0.0, glm::dot(s->normal, l));
  const dvec3 diffuse = d.reformulated ? s->albedo * (0.8 * cosine) : 0.8 * cosine * s->albedo;
  return ambient + diffuse + dvec3(s->sphere ? highlight(d, s->normal, l, -ray.direction) : 0.0);
}

template <class Sample>
Image each_pixel(const Drawing& d, Sample sample) {
  Image image(d.size, d.size);
  for (int y = 0; y < d.size; ++y)
    for (int x = 0; x < d.size; ++x) {
      const dvec3 c = sample(x, y);
      image.at(x, y) = {float(c.x), float(c.y), float(c.z), 1};
    }
  return image;
}

}  // namespace

Image draw(const Drawing& d) {
  return each_pixel(d, [&](int x, int y) {
    dvec3 sum(0);
    for (double sy : {0.25, 0.75})
      for (double sx : {0.25, 0.75}) sum += shade(d, ray_through(d, x + sx, y + sy));
    return sum / 4.0;
  });
}

Image draw_normals(const Drawing& d) {
  return each_pixel(d, [&](int x, int y) {
    const auto s = hit(d, ray_through(d, x + 0.5, y + 0.5));
    return (s ? s->normal : dvec3(0, 0, 1)) * 0.5 + 0.5;
  });
}

Image draw_depth(const Drawing& d) {
  return each_pixel(d, [&](int x, int y) {
    const auto s = hit(d, ray_through(d, x + 0.5, y + 0.5));
    return dvec3(s ? s->distance : 40);
  });
}

Image with_noise(const Image& linear, double amplitude) {
  Image noisy = linear;
  for (int y = 0; y < linear.height(); ++y)
    for (int x = 0; x < linear.width(); ++x) {
      const auto channel = [&](float v, std::uint32_t k) {
        const double noise = amplitude * (2 * hashed(std::uint32_t(x), std::uint32_t(y), k) - 1) / 255;
        return float(srgb_decode(srgb_encode(double(v)) + noise));
      };
      Rgba& p = noisy.at(x, y);
      p = {channel(p.r, 11), channel(p.g, 12), channel(p.b, 13), 1};
    }
  return noisy;
}

Image with_line(Image linear, int length) {
  const int y = linear.height() / 2, left = (linear.width() - length) / 2;
  for (int x = left; x < left + length; ++x)
    for (float* v : {&linear.at(x, y).r, &linear.at(x, y).g, &linear.at(x, y).b}) *v *= 0.67f;
  return linear;
}

Image dithered_ramp(int size, bool transposed) {
  // The 8x8 matrix by the recursion M(2n) = [4 M(n), 4 M(n) + 2; 4 M(n) + 3, 4 M(n) + 1] (B. E. Bayer, 1973).
  const auto rank = [](int x, int y) {
    int value = 0;
    for (int bit = 0; bit < 3; ++bit) {
      const int bx = x >> bit & 1, by = y >> bit & 1;
      value = 4 * value + (2 * (bx ^ by) + by);
    }
    return value;
  };
  Image image(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double threshold = ((transposed ? rank(y & 7, x & 7) : rank(x & 7, y & 7)) + 0.5) / 64;
      const float v = double(x) / size > threshold ? 1.0f : 0.0f;
      image.at(x, y) = {v, v, v, 1};
    }
  return image;
}

JudgedCase picture_case(Profile profile, Unit unit, double delta, int budget) {
  JudgedCase c;
  c.ask.name = "sphere";
  c.ask.scene = "sphere";
  c.ask.size = {Drawing{}.size, Drawing{}.size};
  c.title = "A sphere over a floor";
  c.asked = "A bumpy sphere over a textured floor.";
  c.hint = "Look at the light.";
  c.points = 10;
  c.profile = profile;
  c.unit = unit;
  c.delta = delta;
  c.budget = budget;
  c.references = {"sphere.exr"};
  return c;
}

Answer answer_of(Image picture) {
  Answer answer;
  answer.ended = Answer::Ended::normally;
  answer.pixels = std::move(picture);
  return answer;
}

Answer answer_of(std::vector<Numbers> values) {
  Answer answer;
  answer.ended = Answer::Ended::normally;
  answer.values = std::move(values);
  return answer;
}

Image moved(const Image& image, const std::function<glm::ivec2(int, int)>& source) {
  Image result(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const glm::ivec2 at = source(x, y);
      result.at(x, y) = image.at(std::clamp(at.x, 0, image.width() - 1), std::clamp(at.y, 0, image.height() - 1));
    }
  return result;
}

Image changed(Image image, const std::function<Rgba(const Rgba&)>& value) {
  for (Rgba& p : image.pixels()) p = value(p);
  return image;
}

}  // namespace atelier::judge::test
