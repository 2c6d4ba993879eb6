#include "10-artstyles/given/truth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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
};

Camera3 camera_of(const Camera& camera, const glm::ivec2& size) {
  const double above = std::tan(double(camera.fov_y) / 2);
  return {.half = {above * size.x / size.y, above},
          .to_world = view_axes(camera),
          .eye = camera.eye,
          .orthographic = camera.projection == Projection::orthographic};
}

/// A lens as a function of places.
struct LensShape {
  bool equidistant;
  double half_angle, strength, power;
  glm::dvec2 half;  ///< Camera3::half
  double aspect;

  explicit LensShape(const Settings& settings, const Camera3& camera)
      : equidistant(settings.choice("fisheye.lens") == "equidistant"),
        half_angle(settings.real("fisheye.angle") * std::numbers::pi / 360),
        strength(settings.real("fisheye.strength")),
        power(settings.real("fisheye.power")),
        half(camera.half),
        aspect(camera.half.x / camera.half.y) {}

  bool inside(const glm::dvec2& place) const { return std::abs(place.x) <= aspect && std::abs(place.y) <= 1; }

  /// View space; none: black. All around, or as far as the picture shows it. Planes of the camera, or of a cube's
  /// faces, are at multiples of its length.
  std::optional<glm::dvec3> direction(const glm::dvec2& place, bool all_around) const {
    if (!equidistant) {
      const auto from = source(place);
      return from ? std::optional(glm::dvec3(*from * half.y, -1)) : std::nullopt;
    }
    const double angle = glm::length(place) * half_angle;
    if (angle > half_angle) return {};
    const glm::dvec2 way = angle > 0 ? glm::normalize(place) : glm::dvec2(0);
    const glm::dvec3 d(way * std::sin(angle), -std::cos(angle));
    if (all_around) return d / std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    return d.z < 0 && inside(glm::dvec2(d) / -d.z / half.y) ? std::optional(d / -d.z) : std::nullopt;
  }

  /// The place of the picture from which this one takes its colour.
  std::optional<glm::dvec2> source(const glm::dvec2& place) const {
    if (!equidistant) {
      const glm::dvec2 from = place * (1 + strength * std::pow(glm::length(place), power));
      return inside(from) ? std::optional(from) : std::nullopt;
    }
    const auto d = direction(place, false);
    return d ? std::optional(glm::dvec2(*d) / half.y) : std::nullopt;
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
    return {glm::normalize(2.0 * code - 1.0), 1 / depth};
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

// ---- Relief

/// The normal in view space that the lens shows at a place, whose source has this one: that of a plane, by its heights.
glm::dvec3 behind_lens(const glm::dvec3& normal, const LensShape& lens, const glm::dvec2& place) {
  constexpr double h = 1e-4;
  const glm::dvec2 here = lens.source(place).value();
  /// The difference of heights along one axis of the picture, by its length; on one side alone at the lens's edge.
  const auto slope = [&](const glm::dvec2& step) {
    const auto after = lens.source(place + step), before = lens.source(place - step);
    const glm::dvec2 way = after.value_or(here) - before.value_or(here);
    return -(normal.x * way.x + normal.y * way.y) / normal.z / (h * ((after ? 1 : 0) + (before ? 1 : 0)));
  };
  return glm::normalize(glm::dvec3(-slope({h, 0}), -slope({0, h}), 1));
}

Image relief_of(const Image& normals, const Camera3& camera, const std::optional<LensShape>& lens) {
  return drawn(size_of(normals), [&](int x, int y) {
    const glm::dvec2 place = place_of(x + 0.5, y + 0.5, size_of(normals));
    const auto from = lens ? lens->source(place) : std::optional(place);
    if (!from) return glm::dvec3(0);
    const double u = (from->x * normals.height() + normals.width()) / 2, v = (1 - from->y) * normals.height() / 2;
    const glm::dvec3 code = rgb(clamped(normals, int(std::floor(u)), int(std::floor(v))));
    if (code == glm::dvec3(0)) return glm::dvec3(0);
    glm::dvec3 normal = glm::transpose(camera.to_world) * glm::normalize(2.0 * code - 1.0);
    normal = glm::normalize(glm::dvec3(normal.x, normal.y, std::max(normal.z, 0.01)));  // no overhangs
    return 0.5 * (lens ? behind_lens(normal, *lens, place) : normal) + 0.5;
  });
}

// ---- All together

/// What the styles of a picture need.
struct Studio {
  Settings settings;
  std::string wanted;  ///< the output
  Camera3 camera;
  LensShape lens;
  std::function<Image(const char* output)> trace;  ///< of the scene without lens and styles

  Styles styles = styles_of(settings);
  bool cube = begins_with_cube(settings);

  bool first_is_lens() const { return styles[0] == Style::fisheye; }

  /// Whether the lens is undone afterwards.
  bool restores() const {
    return settings.flag("fisheye.restored") && (wanted == "colour" || wanted == "edges") &&
           std::ranges::count(styles, Style::fisheye) > 0;
  }

  /// Whether rays go where the first style's lens looks; otherwise it looks at the picture. All that may come between
  /// them are passes that handle one pixel after another.
  bool traces_lens() const {
    const bool pixels_alone = settings.real("bloom.strength") == 0 && settings.real("overlay.amount") == 0;
    return cube || (first_is_lens() && !restores() && !camera.orthographic && pixels_alone);
  }

  Geometry surfaces(bool behind_lens) const {
    return {trace("position"), trace("normal"), camera, behind_lens ? std::optional(lens) : std::nullopt};
  }

  Image styled(Image image, std::size_t i) const {
    switch (styles[i]) {
      case Style::painterly:
        return painted(image, settings);
      case Style::aberration:
        return aberrated(image, settings);
      case Style::fisheye:
        return i == 0 && traces_lens() ? image : through_lens(image, lens);
      case Style::toon: {
        const std::string& outlines = settings.choice("toon.outlines");
        const bool reads = outlines == "surface" || outlines == "both";
        return toon(image, settings, reads ? surfaces(i == 1 && first_is_lens()) : Geometry{});
      }
      case Style::none:
        break;
    }
    return image;
  }

  /// From the picture of step 08's chain to the wanted output.
  Image finished(Image image) const {
    image = styled(std::move(image), 0);
    if (wanted == "first") return image;
    image = styled(std::move(image), 1);
    if (restores()) image = restored(image, lens);
    if (wanted != "edges") return image;
    return drawn(size_of(image), [&](int x, int y) { return glm::dvec3(edge_at(image, x, y) / std::sqrt(20.0)); });
  }
};

/// Whether an output is one of this step's, which are made from the picture.
bool is_of_styles(const std::string& output) {
  const std::array own = {"first", "second", "edges", "steps", "relief"};
  return std::ranges::count(own, output) > 0;
}

}  // namespace

SceneTruth style_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model) {
  if (!model) model = make_scene(style_scenes(), request.scene, settings);
  TruthRequest before = request;
  if (is_of_styles(request.output)) before.output = "colour";
  SceneTruth truth = post_truth(before, settings, std::move(model));
  use_shadows_without_cubes(truth, settings);
  return in_styles(std::move(truth), request, settings);
}

SceneTruth in_styles(SceneTruth truth, const TruthRequest& request, const Settings& settings) {
  const std::string wanted = request.output;
  if (!is_of_styles(wanted) && wanted != "colour") return truth;

  SceneTruth geometry = truth;
  geometry.finish = nullptr;
  geometry.output.clear();
  const auto trace = [=](const char* output) {
    TruthRequest other = request;
    other.output = output;
    other.samples = 1;
    return trace_scene(geometry, other, {}, settings);
  };
  const Camera camera_of_view = truth.camera.value_or(apply(request.camera, truth.scene.camera));
  const Camera3 camera = camera_of(camera_of_view, request.size);
  const Studio studio{settings, wanted, camera, LensShape(settings, camera), trace};
  if (wanted == "steps" || wanted == "relief") {
    truth = geometry;
    truth.output = "normal";
    truth.finish = [=](const Image& normals) {
      if (wanted == "relief")
        return relief_of(normals, camera, studio.first_is_lens() ? std::optional(studio.lens) : std::nullopt);
      const Geometry surfaces = studio.surfaces(false);
      return drawn(size_of(normals), [&](int x, int y) { return glm::dvec3(surfaces.steps(x, y), 0); });
    };
    return truth;
  }
  if (studio.traces_lens())
    truth.lens = [lens = studio.lens, cube = studio.cube](const glm::dvec2& at) {
      return lens.direction({(2 * at.x - 1) * lens.aspect, 1 - 2 * at.y}, cube);
    };
  truth.finish = [studio, chain = truth.finish](Image image) {
    return studio.finished(chain ? chain(std::move(image)) : std::move(image));
  };
  return truth;
}

}  // namespace atelier
