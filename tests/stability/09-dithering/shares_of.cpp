// shares_of: both kernels, as lists of numbers.
#include "stability/09-dithering/rows.hpp"

namespace atelier::stability {

using dithering::Kernel;
using dithering::Share;
using dithering::shares_of;

namespace {

/// (right, down, parts of `whole`) of each share, from the top and the left.
Values sorted_shares(Kernel kernel, double whole) {
  std::vector<glm::dvec3> shares;
  const std::vector<Share> found = shares_of(kernel);
  for (const Share& share : found) shares.emplace_back(share.right, share.down, whole * double(share.part));
  std::ranges::sort(shares,
                    [](const glm::dvec3& a, const glm::dvec3& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
  return all_values(shares);
}

/// The sum of all shares, and how many go to pixels that were visited before, or to the pixel itself.
Values sum_and_backward(Kernel kernel) {
  double sum = 0, backward = 0;
  const std::vector<Share> found = shares_of(kernel);
  for (const Share& share : found) {
    sum += double(share.part);
    backward += share.down < 0 || (share.down == 0 && share.right <= 0);
  }
  return {sum, backward};
}

}  // namespace

void add_shares_rows(Table& table) {
  Group group = table.of("shares_of");
  group.equals("Floyd and Steinberg: right, down, sixteenths of each share",
               [] { return sorted_shares(Kernel::floyd_steinberg, 16); }, {1, 0, 7, -1, 1, 3, 0, 1, 5, 1, 1, 1});
  group.equals("Atkinson: right, down, eighths of each share", [] { return sorted_shares(Kernel::atkinson, 8); },
               {1, 0, 1, 2, 0, 1, -1, 1, 1, 0, 1, 1, 1, 1, 1, 0, 2, 1});
  group.equals("Floyd and Steinberg: the sum, and shares of pixels visited before",
               [] { return sum_and_backward(Kernel::floyd_steinberg); }, {1, 0});
  group.equals("Atkinson: the sum, and shares of pixels visited before",
               [] { return sum_and_backward(Kernel::atkinson); }, {0.75, 0});
}

}  // namespace atelier::stability
