// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/orient2d.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace multimesh {

namespace {

/// A sum of products of doubles without rounding: a fixed-point number that has room for the least and the
/// largest of them, in two's complement.
class ExactSum {
 public:
  void add(double x, double y) { add(x, y, false); }
  void subtract(double x, double y) { add(x, y, true); }
  int sign() const {
    if (words_.back() >> 31U != 0) return -1;
    for (const std::uint32_t w : words_)
      if (w != 0) return 1;
    return 0;
  }

 private:
  /// Products are multiples of 2^-2148, the square of the least double, and less than 2^2048.
  static constexpr int lowest = -2148, bits = 32;
  static constexpr std::size_t size = 132;  // 4224 bits; a few are left for carries and the sign

  void add(double x, double y, bool negative) {
    if (x == 0 || y == 0) return;
    const Parts p(x), q(y);
    negative ^= p.negative != q.negative;
    // p.high q.high 2^64 + (p.high q.low + p.low q.high) 2^32 + p.low q.low
    const int exponent = p.exponent + q.exponent - lowest;
    add_at(exponent, p.low * q.low, negative);
    add_at(exponent + bits, p.low * q.high, negative);
    add_at(exponent + bits, p.high * q.low, negative);
    add_at(exponent + 2 * bits, p.high * q.high, negative);
  }

  /// A double as (high 2^32 + low) 2^exponent.
  struct Parts {
    explicit Parts(double x) : negative(x < 0) {
      int e = 0;
      const double fraction = std::frexp(std::abs(x), &e);
      // Of a subnormal number, the fraction has fewer digits: the exponent stays at the least one.
      const int digits = e < -1021 ? e + 1074 : 53;
      const auto whole = static_cast<std::uint64_t>(std::ldexp(fraction, digits));
      exponent = e - digits;
      high = whole >> 32U, low = whole & 0xffffffffU;
    }
    bool negative;
    int exponent = 0;
    std::uint64_t high = 0, low = 0;
  };

  void add_at(int position, std::uint64_t value, bool negative) {
    auto word = static_cast<std::size_t>(position / bits);
    const int shift = position % bits;
    const std::array<std::uint64_t, 3> parts{value << shift & 0xffffffffU,
                                             value >> (bits - shift) & 0xffffffffU,
                                             shift == 0 ? 0 : value >> (2 * bits - shift)};
    std::uint64_t carry = 0;
    for (std::size_t i = 0; word < size && (i < parts.size() || carry != 0); ++i, ++word) {
      const std::uint64_t part = (i < parts.size() ? parts[i] : 0) + carry;
      const std::uint64_t sum = negative ? words_[word] - part : words_[word] + part;
      words_[word] = static_cast<std::uint32_t>(sum);
      carry = negative ? (sum >> 63U) : sum >> 32U;
    }
  }

  std::array<std::uint32_t, size> words_{};
};

int exact(const double* a, const double* b, const double* c) {
  ExactSum sum;
  const double* const p[] = {a, b, c, a};
  for (int i = 0; i < 3; ++i) {
    sum.add(p[i][0], p[i + 1][1]);
    sum.subtract(p[i][1], p[i + 1][0]);
  }
  return sum.sign();
}

}  // namespace

int orient2d(const double* a, const double* b, const double* c) {
  constexpr double rounding = 3.3306690738754716e-16;  // (3 + 16 e) e, e = 2^-53
  constexpr double underflow = 1e-300;  // far above what products lose below the normal doubles
  const double left = (b[0] - a[0]) * (c[1] - a[1]), right = (b[1] - a[1]) * (c[0] - a[0]);
  const double det = left - right, bound = rounding * (std::abs(left) + std::abs(right)) + underflow;
  if (std::isfinite(bound) && std::abs(det) > bound) return det > 0 ? 1 : -1;
  return exact(a, b, c);
}

}  // namespace multimesh
