// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace multimesh::detail {

/// The sign of a sum of products of `factors` finite doubles each, without rounding: a fixed-point number
/// in two's complement with room for the least and the largest of them. For a few hundred products at
/// most.
template <std::size_t factors>
class ExactSum {
 public:
  using Product = std::array<double, factors>;

  void add(const Product& p) { add(p, false); }
  void subtract(const Product& p) { add(p, true); }
  int sign() const {
    if (words_.back() >> 31U != 0) return -1;
    for (const std::uint32_t w : words_)
      if (w != 0) return 1;
    return 0;
  }

 private:
  /// Products are multiples of the least double to the power of `factors`, and less than 2^1024 to that.
  static constexpr int bits = 32, lowest = -1074 * static_cast<int>(factors);
  static constexpr std::size_t size = (2098 * factors + 32) / bits + 1;

  /// A double as an integer of 53 bits, in two words, times 2^exponent.
  struct Parts {
    explicit Parts(double x) {
      int e = 0;
      const double fraction = std::frexp(std::abs(x), &e);
      // A subnormal number has fewer digits in its fraction: the exponent stays at the minimum.
      const int digits = e < -1021 ? e + 1074 : 53;
      const auto whole = static_cast<std::uint64_t>(std::ldexp(fraction, digits));
      exponent = e - digits;
      words = {whole & 0xffffffffU, whole >> 32U};
    }
    int exponent = 0;
    std::array<std::uint64_t, 2> words{};
  };

  void add(const Product& p, bool negative) {
    std::array<std::uint64_t, 2 * factors> digits{1};
    std::size_t used = 1;
    int exponent = 0;
    for (const double x : p) {
      if (x == 0) return;
      negative ^= x < 0;
      const Parts parts(x);
      exponent += parts.exponent;
      multiply(digits, used, parts.words);
    }
    add_at(exponent - lowest, digits, used, negative);
  }

  /// Schoolbook multiplication; digits are words of 32 bits.
  static void multiply(std::array<std::uint64_t, 2 * factors>& digits, std::size_t& used,
                       const std::array<std::uint64_t, 2>& by) {
    std::array<std::uint64_t, 2 * factors> product{};
    for (std::size_t i = 0; i < used; ++i) {
      std::uint64_t carry = 0;
      for (std::size_t j = 0; j < 2; ++j) {
        if (i + j == digits.size()) break;  // the first factor is 1, of one word
        const std::uint64_t sum = digits[i] * by[j] + product[i + j] + carry;
        product[i + j] = sum & 0xffffffffU;
        carry = sum >> 32U;
      }
      if (i + 2 < product.size()) product[i + 2] += carry;
    }
    used = used + 2 < digits.size() ? used + 2 : digits.size();
    digits = product;
  }

  void add_at(int position, const std::array<std::uint64_t, 2 * factors>& digits, std::size_t used,
              bool negative) {
    auto word = static_cast<std::size_t>(position / bits);
    const int shift = position % bits;
    std::uint64_t carry = 0, pushed_out = 0;
    for (std::size_t i = 0; word < size && (i <= used || carry != 0); ++i, ++word) {
      const std::uint64_t digit = i < used ? digits[i] : 0;
      const std::uint64_t shifted = (digit << shift | pushed_out) & 0xffffffffU;
      pushed_out = shift == 0 ? 0 : digit >> (bits - shift);
      const std::uint64_t part = shifted + carry;
      const std::uint64_t sum = negative ? words_[word] - part : words_[word] + part;
      words_[word] = static_cast<std::uint32_t>(sum);
      carry = negative ? sum >> 63U : sum >> 32U;
    }
  }

  std::array<std::uint32_t, size> words_{};
};

}  // namespace multimesh::detail
