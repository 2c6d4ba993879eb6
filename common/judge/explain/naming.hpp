// Recognises known mistakes in wrong answers.
//
// The atlas holds, for a case and a mistake, the picture that a solution with that mistake draws: encoded to 8 bits, at
// half size. An answer from the same view is compared with each of these pictures, pixel by pixel. An answer from
// another view is compared by the effect of a mistake: how it changes pixels of a given value, wherever they are.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "image/image.hpp"
#include "judge/compare/judged_case.hpp"

namespace atelier::judge {

/// A mistake's picture, in the form that make_atlas_picture() gives.
struct AtlasPicture {
  std::string mistake;
  Image picture;
  Image reference;        ///< the right picture, in the same form
  bool same_view = true;  ///< whether both were drawn with the camera, light and settings of the answer
};

/// Converts a picture from compared form to that of the atlas: box-filtered to half its size, rounded up, values 0..1.
/// Data are mapped channel by channel, so that the reference's range fills the middle half of 0..1.
Image make_atlas_picture(const Image& compared, const Image& reference_compared, Unit unit);

// A wrong name is worse than none, because it misleads the student. The thresholds were chosen with nine mistakes of
// one scene (tests/unit/judge/naming.cpp). In the same view other spellings of a mistake have a nearness of at most
// 0.004, the most similar mistake has 0.23, and the larger one of two mistakes made at once has 0.29. From eight other
// cameras and lights every recognised name is right, and nothing is recognised if the true mistake is removed from the
// atlas; then the most similar one has 0.43.

/// A mistake is recognised if its nearness (distance to it / distance to the reference) is at most this, so that it
/// explains nearly all, or in another view most, of the difference,
inline constexpr double max_nearness = 0.2;
inline constexpr double max_nearness_other_view = 0.4;
/// and at most this multiple of the second mistake's nearness, so that two similar mistakes are not confused,
inline constexpr double max_ratio_to_second = 0.75;
/// and if the second mistake's nearness is at least this, so that the answer does not match both.
inline constexpr double min_second_nearness = 0.05;

/// The distance of an answer from one mistake.
struct Candidate {
  std::string mistake;
  double distance = 0;    ///< between the answer and the mistake's picture
  double reference = 0;   ///< between the answer and the right picture, in the same measure
  bool same_view = true;  ///< true: overlaid_distance; false: effect_distance
};

/// All mistakes of the atlas, sorted by nearness. `yours` and `reference` are in the atlas's form.
std::vector<Candidate> rank_mistakes(const Image& yours, const Image& reference,
                                     const std::vector<AtlasPicture>& atlas);

/// The first of `ranked` if it fulfils the conditions above, or nothing.
std::optional<Candidate> recognise(const std::vector<Candidate>& ranked);

/// The forms of mistakes whose numbers a probe returned, all within the tolerance.
std::vector<std::string> recognise_values(const std::vector<Numbers>& yours,
                                          const std::map<std::string, std::vector<Numbers>>& wrong_values,
                                          const JudgedCase& c);

/// The mean over all pixels of the largest channel difference, less `dead_zone`.
double overlaid_distance(const Image& a, const Image& b);

/// Compares the effects of two pairs (right picture, wrong picture): the distribution of the difference for each
/// channel and value of the right picture. Returns the mean first Wasserstein distance of these distributions, 0..1.
/// The pairs may have different sizes and show different views of one scene.
double effect_distance(const Image& right_a, const Image& wrong_a, const Image& right_b, const Image& wrong_b);

}  // namespace atelier::judge
