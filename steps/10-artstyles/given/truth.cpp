#include "10-artstyles/given/truth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <vector>

#include "03-shadow-mapping/given/truth.hpp"
#include "08-post-processing/given/truth.hpp"
#include "10-artstyles/given/exact_strokes.hpp"
#include "10-artstyles/given/scenes.hpp"
#include "10-artstyles/given/style_passes.hpp"
#include "app/picture.hpp"
#include "image/colour.hpp"

namespace atelier {

namespace {

glm::dvec3 rgb(const Rgba& p) {
  return {p.r, p.g, p.b};
}

Rgba opaque(const glm::dvec3& c) {
  const glm::vec3 f(c);
  return {f.r, f.g, f.b, 1};
}

/// A function of each pixel (x, y).
template <class Value>
Image drawn(const glm::ivec2& size, const Value& value) {
  Image image(size.x, size.y);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) image.at(x, y) = opaque(value(x, y));
  return image;
}

glm::ivec2 size_of(const Image& image) {
  return {image.width(), image.height()};
}

const Rgba& clamped(const Image& image, int x, int y) {
  return image.at(std::clamp(x, 0, image.width() - 1), std::clamp(y, 0, image.height() - 1));
}

// ---- Places: in half heights from the centre, y up

glm::dvec2 place_of(double x, double y, const glm::ivec2& size) {
  return glm::dvec2(2 * x - size.x, size.y - 2 * y) / double(size.y);
}

/// Linearly filtered, at a place.
glm::dvec3 sampled(const Image& image, const glm::dvec2& place) {
  const double x = (place.x * image.height() + image.width()) / 2 - 0.5,
               y = (image.height() - place.y * image.height()) / 2 - 0.5;
  const int left = int(std::floor(x)), top = int(std::floor(y));
  const double right_part = x - left, low_part = y - top;
  const auto row = [&](int v) {
    return glm::mix(rgb(clamped(image, left, v)), rgb(clamped(image, left + 1, v)), right_part);
  };
  return glm::mix(row(top), row(top + 1), low_part);
}

struct Camera3 {
  glm::dvec2 half{1};  ///< of the picture, 1 m ahead of the eye
  glm::dmat3 to_world{1};
  glm::dvec3 eye{0};
  bool orthographic = false;
  double far = 1;
};

Camera3 camera_of(const Camera& camera, const glm::ivec2& size) {
  const double above = std::tan(double(camera.fov_y) / 2);
  return {.half = {above * size.x / size.y, above},
          .to_world = glm::dmat3(glm::inverse(glm::lookAt(camera.eye, camera.target, glm::dvec3(camera.up)))),
          .eye = camera.eye,
          .orthographic = camera.projection == Projection::orthographic,
          .far = double(camera.far)};
}

/// A lens as a function of places. Half angle and exponents as in the settings.
struct LensShape {
  bool equidistant;
  double half_angle, strength, power;
  bool all_around;  ///< it sees more than the picture
  glm::dvec2 half;  ///< Camera3::half
  double aspect;

  explicit LensShape(const Settings& settings, const Camera3& camera)
      : equidistant(settings.choice("fisheye.lens") == "equidistant"),
        half_angle(settings.real("fisheye.angle") * std::numbers::pi / 360),
        strength(settings.real("fisheye.strength")),
        power(settings.real("fisheye.power")),
        all_around(begins_with_cube(settings)),
        half(camera.half),
        aspect(camera.half.x / camera.half.y) {}

  bool inside(const glm::dvec2& place) const { return std::abs(place.x) <= aspect && std::abs(place.y) <= 1; }

  /// View space; none: black.
  std::optional<glm::dvec3> direction(const glm::dvec2& place) const {
    if (!equidistant) {
      const auto from = source(place);
      if (!from) return {};
      return glm::dvec3(*from * half.y, -1);
    }
    const double angle = glm::length(place) * half_angle;
    if (angle > half_angle) return {};
    const glm::dvec2 way = angle > 0 ? glm::normalize(place) : glm::dvec2(0);
    const glm::dvec3 d(way * std::sin(angle), -std::cos(angle));
    if (!all_around && (d.z >= 0 || !inside(glm::dvec2(d) / -d.z / half.y))) return {};
    return d;
  }

  /// The place of the picture from which this one takes its colour.
  std::optional<glm::dvec2> source(const glm::dvec2& place) const {
    if (!equidistant) {
      const glm::dvec2 from = place * (1 + strength * std::pow(glm::length(place), power));
      return inside(from) ? std::optional(from) : std::nullopt;
    }
    const auto d = direction(place);
    return d ? std::optional(glm::dvec2(*d) / -d->z / half.y) : std::nullopt;
  }

  /// The place at which the lens shows this one.
  std::optional<glm::dvec2> shown_at(const glm::dvec2& place) const {
    const double r = glm::length(place);
    if (r == 0) return place;
    if (equidistant) {
      const double at = std::atan(r * half.y) / half_angle;
      const glm::dvec2 found = place * (at / r);
      return at <= 1 && inside(found) ? std::optional(found) : std::nullopt;
    }
    double low = 0, high = r;
    for (int i = 0; i < 80; ++i) {
      const double middle = (low + high) / 2;
      (middle + strength * std::pow(middle, power + 1) < r ? low : high) = middle;
    }
    return place * (low / r);
  }
};

Image through_lens(const Image& image, const LensShape& lens) {
  return drawn(size_of(image), [&](int x, int y) {
    const auto from = lens.source(place_of(x + 0.5, y + 0.5, size_of(image)));
    return from ? sampled(image, *from) : glm::dvec3(0);
  });
}

Image restored(const Image& image, const LensShape& lens) {
  return drawn(size_of(image), [&](int x, int y) {
    const auto from = lens.shown_at(place_of(x + 0.5, y + 0.5, size_of(image)));
    return from ? sampled(image, *from) : glm::dvec3(0);
  });
}

// ---- Toon

/// By its two halves: Sobel's gradient is a difference of smoothed rows, and of smoothed columns.
double edge_at(const Image& image, int x, int y) {
  double most = 0;
  for (int channel = 0; channel < 3; ++channel) {
    const auto value = [&](int dx, int dy) {
      return std::sqrt(std::clamp(rgb(clamped(image, x + dx, y + dy))[channel], 0.0, 1.0));
    };
    const auto column = [&](int dx) { return value(dx, -1) + 2 * value(dx, 0) + value(dx, 1); };
    const auto row = [&](int dy) { return value(-1, dy) + 2 * value(0, dy) + value(1, dy); };
    most = std::max(most, std::hypot(column(1) - column(-1), row(1) - row(-1)));
  }
  return most;
}

double smooth(double low, double high, double v) {
  const double t = std::clamp((v - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// What is seen in each pixel.
struct Geometry {
  Image positions, normals;
  Camera3 camera;
  std::optional<LensShape> lens;  ///< that distorts it

  /// The normal, and 1/depth; 0 where nothing is seen.
  glm::dvec4 at(int x, int y) const {
    x = std::clamp(x, 0, normals.width() - 1);
    y = std::clamp(y, 0, normals.height() - 1);
    if (lens) {
      const auto from = lens->source(place_of(x + 0.5, y + 0.5, size_of(normals)));
      if (!from) return glm::dvec4(0);
      x = std::clamp(int(std::floor((from->x * normals.height() + normals.width()) / 2)), 0, normals.width() - 1);
      y = std::clamp(int(std::floor((1 - from->y) * normals.height() / 2)), 0, normals.height() - 1);
    }
    const glm::dvec3 code = rgb(normals.at(x, y));
    if (code == glm::dvec3(0)) return glm::dvec4(0);
    const double depth = -(glm::transpose(camera.to_world) * (rgb(positions.at(x, y)) - camera.eye)).z;
    return {glm::normalize(2.0 * code - 1.0), camera.orthographic ? camera.far - depth : 1 / depth};
  }

  glm::dvec2 steps(int x, int y) const {
    const glm::dvec4 here = at(x, y);
    glm::dvec2 most(0);
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const glm::dvec4 a = at(x + dx, y + dy), b = at(x - dx, y - dy);
        const double nearest = std::max({here.w, a.w, b.w});
        if (nearest > 0) most.x = std::max(most.x, std::abs((a.w - here.w) + (b.w - here.w)) / nearest);
        most.y = std::max(most.y, glm::length(glm::dvec3(a) - glm::dvec3(here)));
      }
    return most;
  }
};

Image toon(const Image& image, const Settings& settings, const Geometry& geometry) {
  const std::string& outlines = settings.choice("toon.outlines");
  const double low = settings.real("toon.low"), high = settings.real("toon.high");
  return drawn(size_of(image), [&](int x, int y) {
    const double brightness = std::sqrt(std::clamp(luma_of(rgb(image.at(x, y))), 0.0, 1.0));
    const double grey = std::floor(5 * brightness + 0.5) / 5;
    double light = grey * grey;
    if (outlines == "colour" || outlines == "both") light *= 1 - smooth(low, high, edge_at(image, x, y));
    if (outlines == "surface" || outlines == "both") {
      const glm::dvec2 steps = geometry.steps(x, y);
      light *= 1 - std::max(smooth(0.02, 0.05, steps.x), smooth(0.35, 0.6, steps.y));
    }
    return glm::dvec3(light);
  });
}

// ---- The others

Image aberrated(const Image& image, const Settings& settings) {
  const double amount = settings.real("aberration.amount"), turns = settings.real("aberration.turns");
  return drawn(size_of(image), [&](int x, int y) {
    glm::dvec3 colour;
    for (int c = 0; c < 3; ++c) {
      const double phase = 2 * std::numbers::pi * (turns + c / 3.0);
      colour[c] = sampled(image, place_of(x + 0.5, y + 0.5, size_of(image)) * (1 + amount * std::sin(phase)))[c];
    }
    return colour;
  });
}

Image painted(const Image& image, const Settings& settings) {
  artstyles::Picture source{image.width(), image.height(), {}};
  for (const Rgba& p : image.pixels()) source.pixels.emplace_back(srgb_code(p.r), srgb_code(p.g), srgb_code(p.b), 255);
  Painting how = painting_of(settings);
  how.threads = 1;
  const artstyles::Picture result = painted(source, how, exact_strokes());
  return drawn(size_of(image), [&](int x, int y) {
    const glm::u8vec4& p = result.pixels[std::size_t(y * image.width() + x)];
    return glm::dvec3(linear_of_code(p.r), linear_of_code(p.g), linear_of_code(p.b));
  });
}

/// Changes nothing but places, so that it may come before passes that handle one pixel after another.
bool chain_handles_pixels(const Settings& settings) {
  return settings.real("bloom.strength") == 0 && settings.real("overlay.amount") == 0;
}

}  // namespace

SceneTruth style_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model) {
  if (!model) model = make_scene(style_scenes(), request.scene, settings);
  const std::string wanted = request.output;
  const std::array own = {"first", "second", "edges", "steps", "relief"};
  const bool is_own = std::ranges::count(own, wanted) > 0;
  TruthRequest before = request;
  if (is_own) before.output = "colour";
  SceneTruth truth = post_truth(before, settings, std::move(model));
  use_shadows(truth.shading, settings);
  for (Light& light : truth.scene.lights)
    if (light.type == LightType::point) light.casts_shadow = false;  // as in the program: see step 04
  if (!is_own && wanted != "colour") return truth;

  const Camera3 camera = camera_of(apply(request.camera, truth.scene.camera), request.size);
  const LensShape lens(settings, camera);
  const Styles styles = styles_of(settings);
  const bool restores = settings.flag("fisheye.restored");
  const bool traces_lens = styles[0] == Style::fisheye && !restores && !camera.orthographic &&
                           (lens.all_around || chain_handles_pixels(settings)) && wanted != "steps" &&
                           wanted != "relief";
  SceneTruth geometry = truth;
  geometry.finish = nullptr;
  geometry.output.clear();
  const auto trace = [=](const char* output) {
    TruthRequest other = request;
    other.output = output;
    other.samples = 1;
    return trace_scene(geometry, other, {}, settings);
  };
  const auto surfaces = [=](bool behind_lens) {
    return Geometry{trace("position"), trace("normal"), camera, behind_lens ? std::optional(lens) : std::nullopt};
  };
  if (wanted == "relief") {
    truth = geometry;
    truth.output = "normal";
    truth.finish = [=](const Image& normals) {
      const bool distorts = styles[0] == Style::fisheye;
      return drawn(size_of(normals), [&](int x, int y) {
        const glm::dvec2 place = place_of(x + 0.5, y + 0.5, size_of(normals));
        const auto from = distorts ? lens.source(place) : std::optional(place);
        if (!from) return glm::dvec3(0);
        // Smooth or not, normals are filtered as the program does it.
        const glm::dvec3 code =
            rgb(clamped(normals, int(std::floor((from->x * normals.height() + normals.width()) / 2)),
                        int(std::floor((1 - from->y) * normals.height() / 2))));
        if (code == glm::dvec3(0)) return glm::dvec3(0);
        glm::dvec3 normal = glm::transpose(camera.to_world) * glm::normalize(2.0 * code - 1.0);
        normal = glm::normalize(glm::dvec3(normal.x, normal.y, std::max(normal.z, 0.01)));  // no overhangs
        if (distorts) {
          // A plane with this normal through the source has the slopes -n.xy / n.z; along both axes of the picture.
          const double h = 1e-4;
          const auto height = [&](const glm::dvec2& p) {
            const auto at = lens.source(p).value_or(*from);
            return -(normal.x * (at.x - from->x) + normal.y * (at.y - from->y)) / normal.z;
          };
          const double along = (height(place + glm::dvec2(h, 0)) - height(place - glm::dvec2(h, 0))) / (2 * h);
          const double up = (height(place + glm::dvec2(0, h)) - height(place - glm::dvec2(0, h))) / (2 * h);
          normal = glm::normalize(glm::dvec3(-along, -up, 1));
        }
        return 0.5 * normal + 0.5;
      });
    };
    return truth;
  }
  if (traces_lens)
    truth.lens = [lens, aspect = lens.aspect](const glm::dvec2& at) {
      return lens.direction({(2 * at.x - 1) * aspect, 1 - 2 * at.y});
    };
  truth.finish = [=, finish = truth.finish](Image image) {
    if (finish) image = finish(std::move(image));
    if (wanted == "steps") {
      const Geometry g = surfaces(false);
      return drawn(size_of(image), [&](int x, int y) { return glm::dvec3(g.steps(x, y), 0); });
    }
    for (std::size_t i = 0; i < styles.size(); ++i) {
      if (styles[i] == Style::painterly) image = painted(image, settings);
      if (styles[i] == Style::aberration) image = aberrated(image, settings);
      if (styles[i] == Style::fisheye && !(i == 0 && traces_lens)) image = through_lens(image, lens);
      if (styles[i] == Style::toon) {
        const std::string& outlines = settings.choice("toon.outlines");
        const bool reads = outlines == "surface" || outlines == "both";
        image = toon(image, settings, reads ? surfaces(i == 1 && styles[0] == Style::fisheye) : Geometry{});
      }
      if (i == 0 && wanted == "first") return image;
    }
    const bool had_lens = std::ranges::count(styles, Style::fisheye) > 0;
    if (wanted != "second" && restores && had_lens) image = restored(image, lens);
    if (wanted != "edges") return image;
    return drawn(size_of(image), [&](int x, int y) { return glm::dvec3(edge_at(image, x, y) / std::sqrt(20.0)); });
  };
  return truth;
}

}  // namespace atelier
