// Jacobi's functions and Legendre's integrals against Boost's and against their defining relations.
#include "reference/exact/elliptic.h"

#include <gtest/gtest.h>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_3.hpp>

#include <numbers>

namespace cylon::exact {
namespace {

constexpr Wide ulp = 1.1e-19L;

// The amplitude of an angle, which may be any number of turns.
Amplitude amplitude(Wide phi) {
  const Wide half_turns = std::round(phi / std::numbers::pi_v<Wide>);
  return {phi, half_turns, std::sin(phi), std::cos(phi), 0};
}

TEST(Elliptic, agrees_with_boost) {
  for (Wide m : {0.0L, 0.1L, 0.5L, 0.9L, 0.999L}) {
    const Elliptic e(m, 1 - m);
    EXPECT_NEAR(static_cast<double>(e.quarter() / boost::math::ellint_1(std::sqrt(m))), 1, 1e-17);
    for (Wide phi : {0.3L, 1.5L, 4.0L, -7.0L, 40.0L}) {
      const Wide f = boost::math::ellint_1(std::sqrt(m), phi);
      EXPECT_LE(std::abs(e.first(phi) - f), 1e-17L * std::abs(f));
      for (Wide n : {-1e6L, -5.0L, -0.3L, 0.4L, 0.95L}) {
        const Wide third = boost::math::ellint_3(std::sqrt(m), n, phi);
        EXPECT_LE(std::abs(e.third(1 - n, amplitude(phi)) - third), 1e-16L * std::abs(third))
            << "n " << n << " phi " << phi;
      }
    }
  }
}

// am is the inverse of F, also next to the separatrix, where only 1 - m says anything.
TEST(Elliptic, amplitude_inverts_the_first_integral) {
  for (Wide m1 : {1.0L, 0.6L, 8e-6L, 1e-12L, 1e-20L}) {
    const Elliptic e(1 - m1, m1);
    for (Wide phi : {0.0L, 0.4L, 1.3L, 2.9L, -11.0L, 100.0L}) {
      const Wide u = e.first(phi);
      const Amplitude a = e.at(u);
      // d(phi)/du = dn <= 1
      EXPECT_LE(std::abs(a.am - phi), 8 * ulp * (1 + std::abs(phi) + std::abs(u)))
          << "m1 " << m1 << " phi " << phi;
      EXPECT_LE(std::abs(a.sn * a.sn + a.cn * a.cn - 1), 4 * ulp);
      EXPECT_LE(std::abs(a.dn * a.dn + (1 - m1) * a.sn * a.sn - 1), 4 * ulp);
    }
    EXPECT_NEAR(static_cast<double>(e.at(e.quarter()).cn), 0, 1e-17);
  }
}

// d(am)/du = dn and d(Pi)/d(phi) = 1/((1 - n sin^2)(1 - m sin^2)^(1/2)), by central differences.
TEST(Elliptic, derivatives) {
  const Wide h = 1e-5L, m1 = 3e-4L, n1 = 1e-3L;
  const Elliptic e(1 - m1, m1);
  for (Wide u : {-3.0L, 0.2L, 5.0L, 9.7L}) {
    EXPECT_NEAR(static_cast<double>((e.at(u + h).am - e.at(u - h).am) / (2 * h)),
                static_cast<double>(e.at(u).dn), 1e-9);
  }
  for (Wide phi : {0.5L, 1.2L, 2.0L, 7.0L}) {
    const Wide s = std::sin(phi), c = std::cos(phi);
    const Wide expected = 1 / ((c * c + n1 * s * s) * std::sqrt(c * c + m1 * s * s));
    EXPECT_NEAR(static_cast<double>((e.third(n1, amplitude(phi + h)) - e.third(n1, amplitude(phi - h))) /
                                    (2 * h) / expected),
                1, 1e-7);
  }
}

// Next to a quarter turn: cn and dn to all digits, and Pi without two large terms that cancel.  With psi = pi/2 - am small,
// u = K - psi/sqrt(m1),  cn = psi,  and Pi = Pi(pi/2) - psi/(n1 sqrt(m1)), to the order of psi^2/m1.
TEST(Elliptic, keeps_its_digits_at_the_quarter_turn) {
  const Wide m1 = 1e-10L, n1 = 1e21L;
  const Elliptic e(1 - m1, m1);
  for (Wide psi : {1e-12L, 1e-14L, 1e-17L, 0.0L}) {
    const Wide du = psi / std::sqrt(m1);
    if (psi > 1e-14L) {
      EXPECT_NEAR(static_cast<double>(e.at(e.quarter() - du).cn / psi), 1, 1e-9);
    }
    const Amplitude near = e.towards(std::cos(psi), std::sin(psi)), quarter = e.towards(1, 0);
    EXPECT_NEAR(static_cast<double>((e.third(n1, quarter) - e.third(n1, near)) * n1 - du), 0,
                1e-10 * static_cast<double>(du + e.third(n1, quarter) * n1 * 1e-8L));
  }
}

}  // namespace
}  // namespace cylon::exact
