// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace multimesh::oracle {

/// An integer of any size, for exact arithmetic on doubles: sign and digits in base 2^32, lowest first.
class BigInteger {
 public:
  BigInteger() = default;
  /// x 2^exponent. \pre that is an integer
  BigInteger(double x, int exponent) : negative_(x < 0) {
    int e = 0;
    const double fraction = std::frexp(std::abs(x), &e);
    auto mantissa = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
    int shift = e - 53 + exponent;
    for (; shift < 0 && mantissa != 0; ++shift) mantissa /= 2;  // zeros only
    if (mantissa == 0) return;
    digits_.assign(static_cast<std::size_t>(shift / 32), 0);
    const int within = shift % 32;
    const std::uint64_t low = mantissa << within, high = within == 0 ? 0 : mantissa >> (64 - within);
    for (const std::uint64_t d : {low & 0xffffffffU, low >> 32U, high})
      digits_.push_back(static_cast<std::uint32_t>(d));
    trim();
  }

  int sign() const { return digits_.empty() ? 0 : negative_ ? -1 : 1; }

  friend BigInteger operator-(BigInteger a) {
    a.negative_ = !a.negative_;
    return a;
  }
  friend BigInteger operator+(const BigInteger& a, const BigInteger& b) {
    BigInteger sum;
    if (a.negative_ == b.negative_) {
      sum.digits_ = added(a.digits_, b.digits_);
      sum.negative_ = a.negative_;
    } else {
      const bool a_is_less = less(a.digits_, b.digits_);
      sum.digits_ = a_is_less ? subtracted(b.digits_, a.digits_) : subtracted(a.digits_, b.digits_);
      sum.negative_ = a_is_less ? b.negative_ : a.negative_;
    }
    sum.trim();
    return sum;
  }
  friend BigInteger operator-(const BigInteger& a, const BigInteger& b) { return a + (-b); }
  friend BigInteger operator*(const BigInteger& a, const BigInteger& b) {
    BigInteger product;
    product.digits_.assign(a.digits_.size() + b.digits_.size(), 0);
    for (std::size_t i = 0; i < a.digits_.size(); ++i) {
      std::uint64_t carry = 0;
      for (std::size_t j = 0; j < b.digits_.size(); ++j) {
        carry += std::uint64_t{a.digits_[i]} * b.digits_[j] + product.digits_[i + j];
        product.digits_[i + j] = static_cast<std::uint32_t>(carry);
        carry >>= 32U;
      }
      product.digits_[i + b.digits_.size()] = static_cast<std::uint32_t>(carry);
    }
    product.negative_ = a.negative_ != b.negative_;
    product.trim();
    return product;
  }

 private:
  using Digits = std::vector<std::uint32_t>;
  void trim() {
    while (!digits_.empty() && digits_.back() == 0) digits_.pop_back();
  }
  static bool less(const Digits& a, const Digits& b) {
    if (a.size() != b.size()) return a.size() < b.size();
    return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
  }
  static Digits added(const Digits& a, const Digits& b) {
    Digits sum;
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < std::max(a.size(), b.size()) || carry > 0; ++i) {
      carry += (i < a.size() ? a[i] : 0ULL) + (i < b.size() ? b[i] : 0ULL);
      sum.push_back(static_cast<std::uint32_t>(carry));
      carry >>= 32U;
    }
    return sum;
  }
  static Digits subtracted(const Digits& a, const Digits& b) {
    Digits difference;
    std::int64_t borrow = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      borrow += std::int64_t{a[i]} - (i < b.size() ? std::int64_t{b[i]} : 0);
      difference.push_back(static_cast<std::uint32_t>(borrow & 0xffffffff));
      borrow >>= 32;
    }
    return difference;
  }

  bool negative_ = false;
  Digits digits_;
};

/// The sign of det(b-a, c-a, d-a) of four points, or of det(b-a, c-a, d) if d is a direction; by integers.
inline int exact_orientation(const std::array<std::array<double, 3>, 4>& p, bool d_is_direction = false) {
  int lowest = 2000;
  for (const auto& q : p)
    for (const double x : q)
      if (x != 0) lowest = std::min(lowest, std::max(std::ilogb(x) - 52, -1074));
  std::array<std::array<BigInteger, 3>, 3> row;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      row[i][k] = BigInteger(p[i + 1][k], -lowest);
      if (i < 2 || !d_is_direction) row[i][k] = row[i][k] - BigInteger(p[0][k], -lowest);
    }
  BigInteger sum;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    sum = sum + row[0][k] * (row[1][l] * row[2][m] - row[1][m] * row[2][l]);
  }
  return sum.sign();
}

}  // namespace multimesh::oracle
