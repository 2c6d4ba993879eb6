#include "09-dithering/dithering.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace atelier::dithering {

// TODO(09-dithering): what your functions below share, if anything

std::vector<int> bayer_matrix(int size) {
  // TODO(09-dithering): four of the smaller ones
  return std::vector<int>(std::size_t(size) * std::size_t(size), 0);
}

std::vector<Share> shares_of(Kernel kernel) {
  // TODO(09-dithering): who gets how much?
  static_cast<void>(kernel);
  return {};
}

std::vector<std::uint8_t> diffused(std::span<const float> values, int width, const Diffusion& how) {
  // TODO(09-dithering): level, error, neighbours
  static_cast<void>(width);
  static_cast<void>(how);
  return std::vector<std::uint8_t>(values.size(), 0);
}

std::vector<int> blue_noise(int size, std::span<const int> first) {
  // TODO(09-dithering): relax, take away, add
  static_cast<void>(first);
  return std::vector<int>(std::size_t(size) * std::size_t(size), 0);
}

std::vector<std::uint8_t> bitmap_file(std::span<const std::uint8_t> bits, int width) {
  // TODO(09-dithering): two headers, two colours, rows
  static_cast<void>(bits);
  static_cast<void>(width);
  return {};
}

std::vector<std::uint8_t> diffused_fast(std::span<const std::uint8_t> codes, int width, int levels) {
  // TODO(09-dithering): several rows at once
  static_cast<void>(width);
  static_cast<void>(levels);
  return std::vector<std::uint8_t>(codes.size(), 0);
}

}  // namespace atelier::dithering
