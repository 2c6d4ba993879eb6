// Which known mistake does a wrong answer look like?
//
// The atlas of a step holds, for a case and a mistake, what a solution with that mistake draws: encoded to 8 bits, at
// half size. An answer to the very case, from the same camera, is laid over each of these pictures. An answer to a case
// whose numbers were drawn at random has no such picture; then what counts is what the mistake *does* to a pixel of a
// given value, wherever on the screen that pixel is.
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
  Image reference;        ///< the right picture beside it, in the same form
  bool same_view = true;  ///< whether both were drawn with the numbers (camera, light ...) of the answer at hand
};

/// A picture in compared form as the atlas keeps it: box-filtered to half its size, rounded up, values 0..1. Data in
/// other ranges are mapped by `reference`, channel by channel, so that its own range fills the middle half.
Image make_atlas_picture(const Image& compared, const Image& reference_compared, Unit unit);

// A wrong name is worse than none: it sends a student to search where nothing is wrong. The margins were chosen on nine
// mistakes of one scene (tests/unit/judge/explain/naming.cpp). In the same view other spellings of a mistake come to
// 0.004 at most, its nearest relative to 0.23, and the larger one of two mistakes made at once to 0.29. From eight
// other cameras and lights every name given is right, and none is given when the true mistake is taken out of the
// atlas, where its nearest relative comes to 0.43.

/// A name is given where the answer is at most this many times as far from the mistake as from the reference: the
/// mistake explains nearly all, or from elsewhere most, of what is wrong.
inline constexpr double nearer_than_reference = 0.2;
inline constexpr double nearer_than_reference_elsewhere = 0.4;
/// ... and at most this many times as far as from the second nearest mistake: what two mistakes do alike gets no name.
inline constexpr double nearer_than_second = 0.75;
/// ... and where the second nearest is not itself on the answer, up to this share of the reference's distance.
inline constexpr double told_apart = 0.05;

/// How far an answer lies from one mistake.
struct Candidate {
  std::string mistake;
  double distance = 0;    ///< of the answer and the mistake's picture
  double reference = 0;   ///< of the answer and the right picture, measured in the same way
  bool same_view = true;  ///< which of the two ways it was
};

/// All mistakes of the atlas, the nearest (by distance / reference) first. `yours` and `reference` are in the atlas'
/// form.
std::vector<Candidate> rank_mistakes(const Image& yours, const Image& reference,
                                     const std::vector<AtlasPicture>& atlas);

/// The first of `ranked` where the two margins above hold, or nothing.
std::optional<Candidate> recognised(const std::vector<Candidate>& ranked);

/// The mistake whose numbers a probe returned: all within the tolerance, a NaN where it has a NaN, and no other
/// mistake's.
std::optional<std::string> recognise_values(const std::vector<Numbers>& yours,
                                            const std::map<std::string, std::vector<Numbers>>& wrong_values,
                                            const JudgedCase& c);

/// Sum over pixels of the largest channel difference beyond `dead_zone`, over the number of pixels.
double overlaid_distance(const Image& a, const Image& b);

/// How differently two pairs (right picture, wrong picture) behave: what the wrong one shows where the right one has a
/// given value, channel by channel. The mean first Wasserstein distance of these distributions, in 0..1. The pairs may
/// be of different sizes and views of one scene.
double effect_distance(const Image& right_a, const Image& wrong_a, const Image& right_b, const Image& wrong_b);

}  // namespace atelier::judge
