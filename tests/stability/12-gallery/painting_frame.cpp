// painting_frame: one painting and a million, in a hall from a nanometre to a thousand kilometres.
#include "stability/12-gallery/rows.hpp"

namespace atelier::stability {

using namespace gallery;

namespace {

constexpr long double two_pi = 2 * std::numbers::pi_v<long double>;

/// The angle has three roundings and is below 2 pi; sine and cosine have one more.
constexpr double axis_error = 32 * double_unit;

/// How far a frame is off: its place, as a share of the distance, or its axes.
double frame_error(const glm::dmat4& frame, int index, int count, double distance, double height, bool place) {
  const long double turn = two_pi * index / count, s = std::sin(turn), c = std::cos(turn);
  if (place) {
    const Exact centre(-s * distance, height, -c * distance);
    return largest_of(origin(frame) - centre) / distance;
  }
  return std::max({largest_of(axis(frame, 0) - Exact(c, 0, -s)), largest_of(axis(frame, 1) - Exact(0, 1, 0)),
                   largest_of(axis(frame, 2) - Exact(s, 0, c))});
}

/// The largest error of 500 paintings and of the last one.
double worst_frame(int count, double distance, bool place) {
  const auto error = [=](int index) {
    return frame_error(painting_frame(index, count, distance, 1.5), index, count, distance, 1.5, place);
  };
  return worst_of(500, 2010, [=](Trial& t) { return std::max(error(int(t.between(0, count))), error(count - 1)); });
}

double not_orthonormal(const glm::dmat4& frame) {
  double worst = std::abs(double(glm::dot(axis(frame, 0), glm::cross(axis(frame, 1), axis(frame, 2)))) - 1);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      worst = std::max(worst, std::abs(double(glm::dot(axis(frame, i), axis(frame, k))) - (i == k ? 1 : 0)));
  return worst;
}

}  // namespace

void add_painting_rows(Table& table) {
  Group group = table.of("painting_frame");
  for (const int count : {1, 2, 3, 4, 6, 7, 1000, 1'000'000}) {
    group.close(fmt::format("{} paintings: axes", count),
                {axis_error, "absolute", "an angle up to 2 pi with three roundings, its sine and cosine"},
                [=] { return worst_frame(count, 5, false); });
    for (const double distance : {1e-9, 5.0, million})
      group.close(fmt::format("{} paintings {:g} m from the axis: places", count, distance),
                  {axis_error, "of the distance", "the axis with its error, times the distance"},
                  [=] { return worst_frame(count, distance, true); });
    group.close(fmt::format("{} paintings: orthonormal, right-handed", count),
                {8 * double_unit, "absolute", "sums of two squares of a sine and a cosine with a rounding each"}, [=] {
                  return worst_of(500, 2011, [=](Trial& t) {
                    return not_orthonormal(painting_frame(int(t.between(0, count)), count, million, 1.5));
                  });
                });
  }
  for (const int count : {1, 7, 1'000'000})
    for (const double distance : {1e-9, 5.0, million})
      group.equals(fmt::format("painting 0 of {}, {:g} m away: exact", count, distance),
                   [=] { return values(painting_frame(0, count, distance, 1.6)); },
                   {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1.6, -distance, 1});
  for (const double height : {-million, -1e-9, 0.0, 1e-9, 1.6, million})
    group.equals(fmt::format("a height of {:g} m stays, upright to the last bit, 1000 paintings: others", height),
                 [=] {
                   return Values{worst_of(1000, 2012, [=](Trial& t) {
                     const glm::dmat4 frame = painting_frame(int(t.between(0, 1000)), 1000, 5, height);
                     return double(frame[3].y != height || glm::dvec3(frame[1]) != glm::dvec3(0, 1, 0) ||
                                   frame[0].y != 0 || frame[2].y != 0);
                   })};
                 },
                 {0});
}

}  // namespace atelier::stability
