// Incoming and reflected light, against closed forms.
#include "catch.hpp"
#include "pieces.hpp"

namespace atelier::test {
namespace {

using oracle::albedo;
using oracle::arriving;
using oracle::Normalisation;
using oracle::Reflectance;

/// What a white highlight gives back, seen straight on, without normalisation:
/// 2 int cos^n(t/2) cos t sin t dt over 0..pi/2, by c = cos(t/2), is 8 (n + 2^(-n/2)) / ((n + 2)(n + 4)).
double albedo_closed_form(double n) {
  return 8 * (n + std::exp2(-n / 2)) / ((n + 2) * (n + 4));
}

}  // namespace

TEST_CASE("a point light falls off with the square of the distance, down to a millimetre", "[light]") {
  const Light light{.position = {1, 2, 3}, .colour = {8, 4, 2}};
  for (const double d : {0.01, 0.5, 1.0, 2.0, 1e4}) {
    const auto found = arriving(light, glm::dvec3(1, 2 - d, 3));
    // The position itself is rounded: 2^-52 of 3 m, over the distance.
    CHECK(std::abs(found.amount.r * d * d / 8 - 1) < 1e-13);
    CHECK(std::abs(found.distance / d - 1) < 1e-13);
    CHECK(found.to_light == glm::dvec3(0, 1, 0));
  }
  CHECK(arriving(light, {1, 2 - 1e-4, 3}).amount.r == Approx(8e6));
  CHECK(arriving(light, light.position).amount == glm::dvec3(0));
  CHECK(oracle::attenuation(2, {0.5, 0.25, 0.125}) == 1 / 1.5);
}

TEST_CASE("a spot light's cone is a smooth step of the cosine", "[light]") {
  const double degree = pi / 180;
  const struct {
    const char* name;
    double angle, inner, outer, share;
  } rows[] = {
      {"on the axis", 0, 20, 30, 1},
      {"just within the inner cone", 19.999, 20, 30, 1},
      {"just beyond the outer cone", 30.001, 20, 30, 0},
      {"equal angles, within", 29.999, 30, 30, 1},
      {"equal angles, beyond", 30.001, 30, 30, 0},
      {"no cone at all", 0.001, 0, 0, 0},
      {"all round", 180, 180, 180, 1},
      {"all round, sideways", 90, 180, 180, 1},
      {"a wide soft cone, behind", 179.999, 0, 180, 0},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    // A thousandth of a degree off the rim the step has risen by less than 1e-7.
    CHECK(std::abs(oracle::spot_cone(std::cos(row.angle * degree), row.inner * degree, row.outer * degree) -
                   row.share) < 1e-7);
  }
  const double halfway = (std::cos(20 * degree) + std::cos(30 * degree)) / 2;
  CHECK(oracle::spot_cone(halfway, 20 * degree, 30 * degree) == Approx(0.5));
  const double quarter = 0.75 * std::cos(30 * degree) + 0.25 * std::cos(20 * degree);
  CHECK(oracle::spot_cone(quarter, 20 * degree, 30 * degree) == Approx(0.15625));  // 3/16 - 2/64
  CHECK(oracle::spot_cone(-1, double(float(pi)), double(float(pi))) == 1);         // a float's pi is half a turn too
}

TEST_CASE("furnace: the albedo of the highlight equals its closed form", "[furnace]") {
  for (const double n : {1.0, 8.0, 100.0, 1e4}) {
    const double plain = albedo_closed_form(n);
    const struct {
      const char* name;
      Normalisation normalisation;
      double expected;
    } rows[] = {{"none", Normalisation::none, plain},
                {"n + 8", Normalisation::n_plus_8, plain * (n + 8) / 8},
                {"exact", Normalisation::exact, 1}};
    for (const auto& row : rows) {
      INFO(row.name << ", exponent " << n);
      const Reflectance mirror{.specular = glm::dvec3(1, 0.5, 0), .exponent = n, .normalisation = row.normalisation};
      const glm::dvec3 found = albedo(mirror, 1, 4000);
      // The midpoint rule is off by step^2 / 24 = 6.4e-9 times the difference of the slopes at both ends, below 4.
      CHECK(std::abs(found.r / row.expected - 1) < 6.5e-9 * 4 / plain);
      CHECK(std::abs(found.g / found.r - 0.5) < 1e-12);
      CHECK(found.b == 0);
    }
  }
  const Reflectance usual{.specular = glm::dvec3(1), .exponent = 8, .normalisation = Normalisation::n_plus_8};
  CHECK(std::abs(albedo(usual, 1, 2000).r - 1.075) < 1e-6);  // the hump
}

TEST_CASE("furnace: a diffuse surface reflects its colour in every direction", "[furnace]") {
  const Reflectance paper{.diffuse = {0.8, 0.4, 0.1}};
  for (const double cos_eye : {1.0, 0.5, 0.01})
    CHECK(glm::length(albedo(paper, cos_eye, 300) - paper.diffuse) < 1e-5);  // pi^2 / 24 / 300^2 = 5e-6
}

TEST_CASE("furnace: at oblique angles a normalised highlight reflects less, never more", "[furnace]") {
  for (const double n : {8.0, 64.0}) {
    const Reflectance mirror{.specular = glm::dvec3(1), .exponent = n, .normalisation = Normalisation::exact};
    double before = 1 + 1e-4;  // straight on; 1e-4 for the quadrature
    for (const double cos_eye : {0.9, 0.6, 0.3, 0.05}) {
      const double found = albedo(mirror, cos_eye, 200).r;
      INFO("exponent " << n << ", cosine " << cos_eye << ": " << found);
      CHECK(found < before);
      before = found;
    }
  }
}

TEST_CASE("reflection has the limits of the contract", "[light]") {
  const glm::dvec3 n(0, 1, 0), up(0, 1, 0), slant = glm::normalize(glm::dvec3(1, 1, 0));
  const Reflectance gloss{.diffuse = glm::dvec3(0.25), .specular = glm::dvec3(0.5), .exponent = 4};
  CHECK(reflected(gloss, n, up, up).r == 0.75);
  CHECK(reflected(gloss, n, up, -slant) == glm::dvec3(0));                       // from behind
  CHECK(reflected(gloss, n, up, glm::dvec3(1, 0, 0)) == glm::dvec3(0));          // along the surface
  CHECK(reflected(gloss, n, -slant, slant).r == Approx(0.25 * std::sqrt(0.5)));  // L = -V: no half vector
  Reflectance flat = gloss;
  flat.exponent = 0;
  CHECK(reflected(flat, n, slant, slant).r == Approx(0.75 * std::sqrt(0.5)));  // x^0 is 1

  // Near half maximum at n = 1e6 a cosine has lost nearly all its digits; cos^n = exp(-n a^2 / 2 - n a^4 / 12 - ...).
  Reflectance sharp{.specular = glm::dvec3(1), .exponent = 1e6};
  const double a = 1e-3, expected = std::exp(-1e6 * (a * a / 2 + std::pow(a, 4) / 12)) * std::cos(2 * a);
  const glm::dvec3 to_light(std::sin(2 * a), std::cos(2 * a), 0);
  CHECK(std::abs(reflected(sharp, n, up, to_light).r / expected - 1) < 1e-9);
}

}  // namespace atelier::test
