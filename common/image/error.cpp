#include "image/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <vector>

#include "base/error.hpp"
#include "image/compare.hpp"
#include "image/flip.hpp"

namespace atelier {
namespace {

constexpr double just_noticed = 3;  ///< levels of 255
constexpr double straight = 0.1;    ///< largest second difference, of the first one
constexpr int flip_threads = 2;     ///< the result does not depend on it

glm::dvec3 vector_of(const Rgba& p) {
  return {p.r, p.g, p.b};
}

void refuse_non_finite(const Image& image, const char* which) {
  const NonFinite found = find_non_finite(image);
  if (found.count > 0)
    throw Error(fmt::format("{} has {} pixels that are not finite, the first at ({}, {})", which, found.count,
                            found.first[0].x, found.first[0].y));
}

/// The square root of the mean of `squared` over all pairs of pixels.
template <class Squared>
double root_of_mean(const Image& a, const Image& b, Squared squared) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i)
    sum += squared(vector_of(a.pixels()[i]), vector_of(b.pixels()[i]));
  return std::sqrt(sum / double(a.pixels().size()));
}

double squared_length(const glm::dvec3& v) {
  return glm::dot(v, v);
}

/// Radians; accurate also for nearly parallel vectors, where the cosine has lost its digits.
double angle(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

double share_misclassified(const Image& picture, const Image& truth, Encoding encoding) {
  const auto seen = [&](const Image& image) {
    return encoding == Encoding::linear ? encode_for_comparison(image) : image;
  };
  return compare_strict(seen(picture), seen(truth), Measure::level, just_noticed).share;
}

double mean_flip(const Image& picture, const Image& truth, Encoding encoding) {
  return flip(truth, picture, {.encoding = encoding, .threads = flip_threads}).mean;
}

/// How much a picture changes per pixel, by central differences of the three channels together; 0 along the border, and
/// where the second difference is too large for a slope: at edges and in noise.
double gradient(const Image& image, int x, int y) {
  if (x == 0 || y == 0 || x + 1 == image.width() || y + 1 == image.height()) return 0;
  const auto at = [&](int dx, int dy) { return vector_of(image.at(x + dx, y + dy)); };
  const double slope = std::sqrt(squared_length(at(1, 0) - at(-1, 0)) + squared_length(at(0, 1) - at(0, -1))) / 2;
  const double bend = std::sqrt(squared_length(at(1, 0) - 2.0 * at(0, 0) + at(-1, 0)) +
                                squared_length(at(0, 1) - 2.0 * at(0, 0) + at(0, -1)));
  return bend < straight * slope ? slope : 0;
}

double median_displacement(const Image& picture, const Image& truth) {
  std::vector<double> moved;
  for (int y = 0; y < truth.height(); ++y)
    for (int x = 0; x < truth.width(); ++x)
      if (const double slope = gradient(truth, x, y); slope > 0)
        moved.push_back(glm::length(vector_of(picture.at(x, y)) - vector_of(truth.at(x, y))) / slope);
  if (moved.empty()) return 0;
  const auto middle = moved.begin() + std::ptrdiff_t(moved.size() / 2);
  std::nth_element(moved.begin(), middle, moved.end());
  return *middle;
}

/// The fraction of pixels for which `is` returns true, given both red channels.
template <class Is>
double share_of(const Image& picture, const Image& truth, Is is) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < truth.pixels().size(); ++i) count += is(picture.pixels()[i].r, truth.pixels()[i].r);
  return double(count) / double(truth.pixels().size());
}

/// Blurred along one axis; weights of pixels outside the picture are left out.
Image blurred(const Image& image, const glm::ivec2& along) {
  constexpr double sigma = 2;
  constexpr int reach = 6;
  std::array<double, reach + 1> bell{};  // by distance
  for (int k = 0; k <= reach; ++k) bell[std::size_t(k)] = std::exp(-k * k / (2 * sigma * sigma));
  Image result(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      glm::dvec3 sum(0);
      double weights = 0;
      for (int k = -reach; k <= reach; ++k) {
        const glm::ivec2 at = glm::ivec2(x, y) + k * along;
        if (at.x < 0 || at.y < 0 || at.x >= image.width() || at.y >= image.height()) continue;
        const double weight = bell[std::size_t(std::abs(k))];
        sum += weight * vector_of(image.at(at.x, at.y));
        weights += weight;
      }
      const glm::vec3 mean(sum / weights);
      result.at(x, y) = {mean.r, mean.g, mean.b, 1};
    }
  return result;
}

double rmse_of_blurred(const Image& picture, const Image& truth, bool codes, Encoding encoding) {
  if (codes && encoding == Encoding::data)
    throw Error("blurred_codes is a difference of colours, and this output is data");
  const auto seen = [&](const Image& image) {
    return blurred(blurred(codes && encoding == Encoding::linear ? encode_for_comparison(image) : image, {1, 0}),
                   {0, 1});
  };
  return root_of_mean(seen(picture), seen(truth),
                      [](const auto& a, const auto& b) { return squared_length(a - b) / 3; });
}

double mean_of(const Image& image) {
  double sum = 0;
  for (const Rgba& p : image.pixels()) sum += double(p.r) + p.g + p.b;
  return sum / (3.0 * double(image.pixels().size()));
}

}  // namespace

std::string to_string(ErrorMetric metric) {
  switch (metric) {
    case ErrorMetric::rmse:
      return "rmse";
    case ErrorMetric::flip:
      return "flip";
    case ErrorMetric::misclassified:
      return "misclassified";
    case ErrorMetric::distance:
      return "distance";
    case ErrorMetric::degrees:
      return "degrees";
    case ErrorMetric::displacement:
      return "displacement";
    case ErrorMetric::acne:
      return "acne";
    case ErrorMetric::leak:
      return "leak";
    case ErrorMetric::wrong:
      return "wrong";
    case ErrorMetric::blurred_codes:
      return "blurred_codes";
    case ErrorMetric::blurred_light:
      return "blurred_light";
    case ErrorMetric::mean:
      return "mean";
  }
  return "mean";
}

double error_of(const Image& picture, const Image& truth, ErrorMetric metric, Encoding encoding) {
  refuse_non_finite(picture, "the picture");
  if (metric == ErrorMetric::mean) return mean_of(picture);
  refuse_non_finite(truth, "its truth");
  if (!picture.same_size(truth) || picture.empty())
    throw Error(fmt::format("a picture of {}x{} and a truth of {}x{} cannot be compared", picture.width(),
                            picture.height(), truth.width(), truth.height()));
  switch (metric) {
    case ErrorMetric::flip:
      return mean_flip(picture, truth, encoding);
    case ErrorMetric::misclassified:
      return share_misclassified(picture, truth, encoding);
    case ErrorMetric::displacement:
      return median_displacement(picture, truth);
    case ErrorMetric::acne:
      return share_of(picture, truth, [](float seen, float is) { return seen < is - 0.5f; });
    case ErrorMetric::leak:
      return share_of(picture, truth, [](float seen, float is) { return seen > is + 0.5f; });
    case ErrorMetric::wrong:
      return share_of(picture, truth, [](float seen, float is) { return (seen >= 0.5f) != (is >= 0.5f); });
    case ErrorMetric::distance:
      return root_of_mean(picture, truth, [](const auto& a, const auto& b) { return squared_length(a - b); });
    case ErrorMetric::degrees:
      return 180 / std::numbers::pi * root_of_mean(picture, truth, [](const auto& a, const auto& b) {
               return std::pow(angle(2.0 * a - 1.0, 2.0 * b - 1.0), 2);
             });
    case ErrorMetric::blurred_codes:
    case ErrorMetric::blurred_light:
      return rmse_of_blurred(picture, truth, metric == ErrorMetric::blurred_codes, encoding);
    case ErrorMetric::rmse:
    case ErrorMetric::mean:
      break;
  }
  return root_of_mean(picture, truth, [](const auto& a, const auto& b) { return squared_length(a - b) / 3; });
}

}  // namespace atelier
