// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/exact/fractions.hpp"

#include <algorithm>
#include <cmath>

namespace multimesh::exact {

namespace {

/// A double is m 2^e with an integer m of 53 digits.
constexpr int digits = 53;

void set(Homogeneous& h, const Vec3& p) {
  int exponent[3], least = 0;
  double mantissa[3];
  for (std::size_t i = 0; i < 3; ++i) {
    mantissa[i] = std::ldexp(std::frexp(p[i], &exponent[i]), digits);
    if (mantissa[i] == 0) exponent[i] = digits;
    exponent[i] -= digits;
    least = std::min(least, exponent[i]);
  }
  h.w = 1;
  mpz_mul_2exp(h.w.get_mpz_t(), h.w.get_mpz_t(), static_cast<mp_bitcnt_t>(-least));
  for (std::size_t i = 0; i < 3; ++i) {
    h.x[i] = mantissa[i];
    mpz_mul_2exp(h.x[i].get_mpz_t(), h.x[i].get_mpz_t(), static_cast<mp_bitcnt_t>(exponent[i] - least));
  }
}

/// The coordinates of `p`; `space` is where those of a double are written.
const Homogeneous& homogeneous(const Point& p, Homogeneous& space) {
  if (!p.is_double()) return *p.fractions();
  set(space, p.nearest());
  return space;
}

/// x y - z w.
void set_difference(mpz_class& to, const mpz_class& x, const mpz_class& y, const mpz_class& z,
                    const mpz_class& w) {
  mpz_mul(to.get_mpz_t(), x.get_mpz_t(), y.get_mpz_t());
  mpz_submul(to.get_mpz_t(), z.get_mpz_t(), w.get_mpz_t());
}

}  // namespace

RationalPoint rational(const Vec3& p) {
  return {Rational(p[0]), Rational(p[1]), Rational(p[2])};
}

RationalPoint rational(const Point& p) {
  if (p.is_double()) return rational(p.nearest());
  RationalPoint x;
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = Rational(p.fractions()->x[i], p.fractions()->w);
    x[i].canonicalize();
  }
  return x;
}

// The buffers stay allocated.
int sign_of_fractions(const Point& a, const Point& b, const Point& c, const Point& d) {
  thread_local Homogeneous space[4];
  thread_local mpz_class row[3][3], minor, det;
  const Homogeneous& o = homogeneous(a, space[0]);
  const Point* others[3] = {&b, &c, &d};
  for (std::size_t i = 0; i < 3; ++i) {
    const Homogeneous& p = homogeneous(*others[i], space[i + 1]);
    for (std::size_t k = 0; k < 3; ++k) set_difference(row[i][k], p.x[k], o.w, o.x[k], p.w);
  }
  det = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    set_difference(minor, row[1][l], row[2][m], row[1][m], row[2][l]);
    mpz_addmul(det.get_mpz_t(), row[0][k].get_mpz_t(), minor.get_mpz_t());
  }
  return sgn(det);
}

}  // namespace multimesh::exact
