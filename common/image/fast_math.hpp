// Logarithm, power and cube root without branches or calls, so that compilers vectorise loops over them.
//
// The standard pow is exact to the last bit and takes about 20 ns; a picture of two million pixels needs a dozen per
// pixel. These take a tenth of that, vectorised, with an error of a few units in the last place of a float.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

/// Compiles a function twice, for any x86-64 and for AVX2 (eight floats at a time instead of four); the loader chooses.
/// Both give the same bits, since products and sums are never fused (-ffp-contract=off). Disabled under
/// AddressSanitizer, because the loader chooses before it is initialised.
#if defined(__x86_64__) && defined(__ELF__) && defined(__GNUC__) && !defined(__SANITIZE_ADDRESS__)
#define ATELIER_ALSO_FOR_AVX2 __attribute__((target_clones("avx2", "default")))
#else
#define ATELIER_ALSO_FOR_AVX2
#endif

namespace atelier::fast {

/// log2 of a positive, normal, finite x; absolute error below 1.1e-6 over 2^-20..2^4 (a float near 20 has no finer
/// step). Zero and subnormal numbers give a finite value near -127, which the caller must replace.
///
/// x = 2^e m with m in [sqrt(1/2), sqrt 2), and ln m = 2 artanh((m - 1) / (m + 1)), whose series converges quickly
/// there.
inline float log2(float x) {
  constexpr std::int32_t half_root = 0x3f3504f3;  // the bits of sqrt(1/2)
  const std::int32_t bits = std::bit_cast<std::int32_t>(x);
  const std::int32_t exponent = (bits - half_root) >> 23;
  const float m = std::bit_cast<float>(bits - exponent * (1 << 23));
  const float s = (m - 1) / (m + 1), s2 = s * s;
  constexpr float two_over_ln2 = 2.8853900818f;
  return float(exponent) + two_over_ln2 * s * (1 + s2 * (1 / 3.0f + s2 * (1 / 5.0f + s2 * (1 / 7.0f + s2 / 9))));
}

/// 2^x for x in -126..127; relative error below 3e-7. Outside that range the result is meaningless.
///
/// x = k + f with k whole and |f| <= 1/2: 2^k is an exponent, 2^f = e^(f ln 2) is its Taylor polynomial of degree six.
inline float exp2(float x) {
  constexpr float shift = 12582912;  // 1.5 * 2^23: adding it rounds to whole numbers
  const float k = (x + shift) - shift, t = (x - k) * 0.69314718056f;
  const float power = 1 + t * (1 + t * (1 / 2.0f + t * (1 / 6.0f + t * (1 / 24.0f + t * (1 / 120.0f + t / 720)))));
  return std::bit_cast<float>(std::bit_cast<std::int32_t>(power) + std::int32_t(k) * (1 << 23));
}

/// x^y for positive, normal x and a result in the range of exp2.
inline float pow(float x, float y) {
  return exp2(y * log2(x));
}

/// The cube root of x in 2^-64..2^64; relative error below 3e-7.
///
/// A third of the float's bits is a third of its logarithm: error at most 4 %. Halley's step cubes the error; two
/// suffice.
inline float cbrt(float x) {
  // A float product, since SIMD has no integer division. The constant maps 1 to about 1.
  float y = std::bit_cast<float>(std::int32_t(float(std::bit_cast<std::int32_t>(x)) * (1 / 3.0f)) + 0x2a5137a0);
  for (int step = 0; step < 2; ++step) {
    const float cube = y * y * y;
    y = y * (cube + 2 * x) / (2 * cube + x);
  }
  return y;
}

/// The sRGB curve on 0..1; differs from srgb_encode by less than 1e-6 (1/4000 of an 8-bit level).
///
/// x^(1/2.4) = t^(5/3) with t = x^(1/4), two square roots. In t the curved part, 0.0031308^(1/4) <= t <= 1, is almost
/// straight: its Chebyshev interpolant of degree seven, in u = -1..1 over that range, is within 5.1e-7.
inline float srgb_encode(float x) {
  const float t = std::sqrt(std::sqrt(x)), u = (t - 0.618272516f) * (1 / 0.381727484f);
  const float high = 1.37415395e-3f + u * (-3.89319413e-4f + u * (2.00126682e-4f + u * -8.03033197e-5f));
  const float curved = 0.418389675f + u * (0.487126072f + u * (0.100260654f + u * (-6.88124583e-3f + u * high)));
  return x <= 0.0031308f ? 12.92f * x : curved;
}

/// Its inverse on 0..1; differs from srgb_decode by less than 1e-6.
inline float srgb_decode(float x) {
  const float straight = x * (1 / 12.92f), curved = pow((x + 0.055f) * (1 / 1.055f), 2.4f);
  return x <= 0.04045f ? straight : curved;
}

/// x within 0..1; NaN becomes 0.
inline float clamp01(float x) {
  const float positive = x > 0 ? x : 0;
  return positive < 1 ? positive : 1;
}

}  // namespace atelier::fast
