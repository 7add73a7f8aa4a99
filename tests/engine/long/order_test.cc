// The observed order of every integrator, within a tenth.  In double the integrators of order 6 and 8 have
// a factor of two of steps between the first regular one and rounding; with the 64 bits of x87 the errors
// below span seven decades.  The integrators are templates over the number type: what runs here is what the
// engine runs, its coefficients with three more digits.
#define CYLON_ENGINE_LONG  // of all that is included; nothing of the engine is linked

#include "engine/integrators/advance.h"
#include "tests/engine/order_fit.h"
#include "tests/engine/scheme_systems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <string>

namespace cylon::engine {
namespace {

static_assert(std::numeric_limits<Real>::digits >= 64, "a long double of 64 bits or more");

// How far the fitted order may be from the declared one.  Measured: at most 0.074 (rk8 on the orbit), 0.063
// of order 6, 0.044 of order 4, 1e-4 below.
constexpr double reach = 0.1;

// Errors below this part of the motion's size (1) are not used: a hundred times what rounding leaves of the
// reference, so that it is a hundredth of the last error.
constexpr double rounding = 1e-16;
constexpr double coarse = 3e-2;  // an error above this is not small against the motion
constexpr double decades = 1e7;  // between the first error that is used and the last
constexpr int reference = 500;   // steps of rk8: truncation 1e-21, and few enough to round little

template <System S>
using Stepping = void (*)(S&, Time, Time, Real*, std::size_t, Real*);

template <System S>
std::vector<Real> run(Stepping<S> stepping, S system, double duration, int steps) {
  std::vector<Real> y = S::start(), work(17 * y.size());
  const Time h = static_cast<Time>(duration) / static_cast<Time>(steps);
  stepping(system, 0, h, y.data(), static_cast<std::size_t>(steps), work.data());
  return y;
}

// The engine's own way for a row, chosen by the compiler.
template <System S, class Row>
constexpr Stepping<S> stepping_of(bool joints) {
  if constexpr (Row::integrator.kind == Kind::runge_kutta)
    return &Steps<S, Row>::runge_kutta;
  else
    return joints ? &Steps<S, Row>::rattle : &Steps<S, Row>::splitting;
}

// A row with one coefficient off by a ten-thousandth of itself: the last stage's last, or the second part's.
// (The first stage's would not do: rk8 is made so that its early stages are heard of in high orders alone.)
template <std::size_t Row>
struct Spoiled {
  static constexpr const Integrator& original = integrator_table[Row];

  template <std::size_t N>
  static constexpr std::array<Coefficient, N> copy(std::span<const Coefficient> from, std::size_t spoiled) {
    std::array<Coefficient, N> all{};
    for (std::size_t i = 0; i < N; ++i) all[i] = i == spoiled ? from[i] * Coefficient(1.0001L) : from[i];
    return all;
  }
  static constexpr bool splits = original.kind == Kind::splitting;
  static constexpr std::size_t entries = original.tableau.matrix.size(),
                               parts = original.splitting.coefficients.size();
  static constexpr auto matrix = copy<entries>(original.tableau.matrix, entries - 1);
  static constexpr auto weights =
      copy<original.tableau.weights.size()>(original.tableau.weights, entries == 0 ? 0 : 99);
  static constexpr auto coefficients = copy<parts>(original.splitting.coefficients, 1);
  static constexpr Integrator integrator = [] {
    Integrator changed = original;
    changed.splitting.coefficients = coefficients;
    changed.tableau.matrix = matrix;
    changed.tableau.weights = weights;
    return changed;
  }();
};

struct Seen {
  double order = 0, first = 0, last = 0;  // the fit, and the errors at its ends
};

template <System S>
Seen observed(Stepping<S> stepping, const S& system, int order, bool reversible, double duration) {
  const bool joints = constrained(system);
  const std::vector<Real> exact = run(stepping_of<S, TableRow<2>>(joints), system, duration, reference);
  const int last = order == 1 ? 16384 : 4096;
  std::vector<double> step, error;
  for (const int n : fine_ladder(last / 512, last)) {
    const auto e = static_cast<double>(distance(run(stepping, system, duration, n), exact));
    if (!(e > rounding)) break;
    step.push_back(duration / n), error.push_back(e);
  }
  if (error.empty()) return {};
  const double most = std::min(coarse, decades * error.back());
  const auto regular = std::find_if(error.begin(), error.end(), [&](double e) { return e <= most; });
  step.erase(step.begin(), step.begin() + (regular - error.begin()));
  error.erase(error.begin(), regular);
  if (error.size() < 6) return {};
  return {fitted_order(step, error, reversible), error.front(), error.back()};
}

template <System S>
struct Case {
  const char* name;
  S system;
  bool drags;
  double duration;
};

SpringPoint dragged() {
  SpringPoint system;
  system.drag = Real(1.9);
  return system;
}

template <std::size_t Row, System S>
void expect_order(const Case<S>& c) {
  constexpr const Integrator& row = integrator_table[Row];
  if constexpr (row.kind != Kind::adaptive) {
    const bool joints = constrained(c.system);
    if (joints && row.kind == Kind::splitting && !row.constraints) return;
    const int order = c.drags ? row.drag_order : row.order;
    const Seen seen =
        observed<S>(stepping_of<S, TableRow<Row>>(joints), c.system, order, row.reversible, c.duration);
    std::printf("%-8s %-17s order %.4f of %d, errors %.1e to %.1e\n", c.name, std::string(row.name).c_str(),
                seen.order, order, seen.first, seen.last);
    EXPECT_NEAR(seen.order, order, reach) << row.name;
  }
}

template <System S>
void expect_all(const Case<S>& c) {
  [&]<std::size_t... Row>(std::index_sequence<Row...>) { (expect_order<Row>(c), ...); }
  (std::make_index_sequence<integrator_table.size()>{});
}

TEST(LongOrder, OnADrivenSpring) { expect_all(Case<SpringPoint>{"spring", {}, false, 1.5}); }
TEST(LongOrder, OnADrivenSpringWithDrag) { expect_all(Case<SpringPoint>{"drag", dragged(), true, 1.5}); }
TEST(LongOrder, OnAnOrbit) { expect_all(Case<Orbit>{"orbit", {}, false, 2}); }
TEST(LongOrder, OnARod) { expect_all(Case<Pendulum>{"rod", {}, false, 0.7}); }

TEST(LongOrder, TheReferenceIsRk8) { EXPECT_EQ(integrator_table[2].name, "rk8"); }

template <std::size_t Row>
void expect_seen() {
  constexpr const Integrator& row = integrator_table[Row];
  if constexpr (row.kind != Kind::adaptive) {
    const Seen seen = observed<SpringPoint>(stepping_of<SpringPoint, Spoiled<Row>>(false), {}, row.order,
                                            row.reversible, 1.5);
    std::printf("spoiled  %-17s order %.4f of %d, errors %.1e to %.1e\n", std::string(row.name).c_str(),
                seen.order, row.order, seen.first, seen.last);
    EXPECT_GT(std::abs(seen.order - row.order), 2 * reach) << row.name;
  }
}

// The measure itself: one coefficient off by 1e-4 of itself is found out in every integrator.
TEST(LongOrder, DetectsWrongCoefficient) {
  []<std::size_t... Row>(std::index_sequence<Row...>) { (expect_seen<Row>(), ...); }
  (std::make_index_sequence<integrator_table.size()>{});
}

}  // namespace
}  // namespace cylon::engine
