// Fixed steps of a System by a row of the table.
#pragma once

#include "engine/integrators/combination.h"
#include "engine/integrators/table.h"
#include "engine/system.h"

#include <array>
#include <cassert>
#include <utility>
#include <vector>

namespace cylon::engine {

/// Whether joints are kept as constraints now.  A System that can have any says so by `constrained()`; its
/// steps are then compositions of RATTLE.
template <System S>
bool constrained(const S& s) {
  if constexpr (requires {
                  { s.constrained() } -> std::convertible_to<bool>;
                })
    return s.constrained();
  else
    return false;
}

/// Length of the state; a constant of the compiler where S::fixed_size is one.
template <System S>
std::size_t length(const S& s) {
  if constexpr (requires { S::fixed_size; })
    return S::fixed_size;
  else
    return static_cast<std::size_t>(s.size());
}

/// Small systems whose length the compiler knows are written into each integrator whole.
template <System S>
inline constexpr bool is_small = requires {
  S::fixed_size;
};

/// Row `Row` of the table, as a type.
template <std::size_t Row>
struct TableRow {
  static constexpr const Integrator& integrator = integrator_table[Row];
};

/// Steps by the integrator `Row::integrator`.  Each is written out by the compiler with its coefficients as
/// constants.
template <System S, class Row>
struct Steps {
  static constexpr const Integrator& row = Row::integrator;

  static constexpr Coefficient part(std::size_t i) { return row.splitting.coefficients[i]; }
  static constexpr bool is_kick(std::size_t i) { return (i % 2 == 0) == (row.splitting.first == Part::kick); }

  /// Sum of the drifts before part i: where time stands, in steps.
  static constexpr Coefficient reached(std::size_t i) {
    Coefficient sum = 0;
    for (std::size_t j = 0; j < i; ++j) sum += is_kick(j) ? 0 : part(j);
    return sum;
  }

  template <std::size_t I>
  static void apply(S& s, Time t, Time h, Real* y) {
    if constexpr (is_kick(I))
      s.kick(t + h * reached(I), static_cast<Real>(h * part(I)), y);
    else
      s.drift(static_cast<Real>(h * part(I)), y);
  }

  /// A run of steps.  Where a step ends with the part that the next begins with, the two are one.
  static void splitting(S& s, Time t, Time h, Real* y, std::size_t steps, Real*) {
    constexpr std::size_t parts = row.splitting.coefficients.size(), last = parts - 1;
    constexpr bool meet = parts % 2 == 1;
    if (meet) apply<0>(s, t, h, y);
    for (std::size_t n = 0; n < steps; ++n) {
      const Time now = t + static_cast<Time>(n) * h;
      [&]<std::size_t... I>(std::index_sequence<I...>) { (apply<I + (meet ? 1 : 0)>(s, now, h, y), ...); }
      (std::make_index_sequence < meet ? parts - 2 : parts > {});
      if constexpr (meet) {
        const Coefficient end = n + 1 < steps ? part(last) + part(0) : part(last);
        if constexpr (is_kick(0))
          s.kick(now + h, static_cast<Real>(h * end), y);
        else
          s.drift(static_cast<Real>(h * end), y);
      }
      s.project(y);
    }
  }

  /// The same with constraints: one RATTLE step after another, each over its weight.
  ///   kick(w h/2) drift(w h) kick(w h/2) project,  or  drift(w h/2) project kick(w h) drift(w h/2) project
  /// H. C. Andersen, J. Comput. Phys. 52 (1983) 24; B. Leimkuhler, R. Skeel, J. Comput. Phys. 112 (1994) 117.
  static void rattle(S& s, Time t, Time h, Real* y, std::size_t steps, Real*) {
    assert(row.constraints);
    for (std::size_t n = 0; n < steps; ++n) {
      Time now = t + static_cast<Time>(n) * h;
      for (const Coefficient weight : row.splitting.weights) {
        const Time dt = weight * h;
        const Real whole = static_cast<Real>(dt), half = static_cast<Real>(dt / 2);
        if constexpr (row.splitting.coefficients.size() == 2) {
          s.kick(now, whole, y);
          s.drift(whole, y);
        } else if constexpr (row.splitting.first == Part::kick) {
          s.kick(now, half, y);
          s.drift(whole, y);
          s.kick(now + dt, half, y);
        } else {
          s.drift(half, y);
          s.project(y);
          s.kick(now + dt / 2, whole, y);
          s.drift(half, y);
        }
        s.project(y);
        now += dt;
      }
    }
  }

  template <std::size_t Stage>
  struct Matrix {
    static constexpr Coefficient at(std::size_t j) { return row.tableau.matrix[Stage * (Stage - 1) / 2 + j]; }
  };
  struct Weights {
    static constexpr Coefficient at(std::size_t j) { return row.tableau.weights[j]; }
  };

  template <std::size_t I>
  static void stage(S& s, Time t, Time h, const Real* y, std::size_t n, Real* k, Real* __restrict z) {
    if constexpr (I == 0) {
      s.rates(t, y, k);
    } else {
      const Real dt = static_cast<Real>(h);
      for (std::size_t i = 0; i < n; ++i) z[i] = y[i] + dt * combination<Matrix<I>, I>(k, n, i);
      s.rates(t + row.tableau.nodes[I] * h, z, k + I * n);
    }
  }

  static void runge_kutta(S& s, Time t, Time h, Real* y, std::size_t steps, Real* work) {
    constexpr std::size_t stages = row.tableau.weights.size();
    const std::size_t n = length(s);
    Real* const k = work + n;
    const Real dt = static_cast<Real>(h);
    for (std::size_t step = 0; step < steps; ++step) {
      const Time now = t + static_cast<Time>(step) * h;
      [&]<std::size_t... I>(std::index_sequence<I...>) { (stage<I>(s, now, h, y, n, k, work), ...); }
      (std::make_index_sequence<stages>{});
      for (std::size_t i = 0; i < n; ++i) y[i] += dt * combination<Weights, stages>(k, n, i);
      s.project(y);
    }
  }
};

// Not under a sanitizer, whose checks, written out in every integrator, take a compiler minutes.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define CYLON_FLATTEN
#else
#define CYLON_FLATTEN [[gnu::flatten]]
#endif

/// `function` with all that it calls written out in one, so that a small state stays in registers.
template <class S, auto function>
CYLON_FLATTEN void flat(S& s, Time t, Time h, Real* y, std::size_t steps, Real* work) {
  function(s, t, h, y, steps, work);
}
#undef CYLON_FLATTEN

/// Carries the state of a System over fixed steps.  Holds the memory that its integrator needs.
template <System S>
class Advance {
 public:
  /// Requires a row of integrators() that is not adaptive, and one that can keep constraints where the
  /// System has any; `size` is the length of the state.
  Advance(const Integrator& integrator, std::size_t size) {
    assert(integrator.kind != Kind::adaptive);
    const std::size_t row = index(integrator.name);
    free_ = functions[row].free;
    constrained_ = functions[row].constrained;
    if (integrator.kind == Kind::runge_kutta) work_.resize((integrator.tableau.weights.size() + 1) * size);
  }

  /// One step, from t to t + h; h may be negative.
  void operator()(S& s, Time t, Time h, Real* y) { run(s, t, h, y, 1); }

  /// Steps in a row, t_n = t + n h.  Cheaper than one by one: kicks (or drifts) that meet are made one.
  void run(S& s, Time t, Time h, Real* y, std::size_t steps) {
    (constrained(s) ? constrained_ : free_)(s, t, h, y, steps, work_.data());
  }

 private:
  using Function = void (*)(S&, Time, Time, Real*, std::size_t, Real*);
  struct Pair {
    Function free = nullptr, constrained = nullptr;
  };

  template <auto function>
  static constexpr Function chosen = is_small<S> ? &flat<S, function> : function;

  template <std::size_t Row>
  static constexpr Pair pair() {
    using Step = Steps<S, TableRow<Row>>;
    if constexpr (integrator_table[Row].kind == Kind::runge_kutta)
      return {chosen<&Step::runge_kutta>, chosen<&Step::runge_kutta>};
    else if constexpr (integrator_table[Row].kind == Kind::splitting && Split<S>)
      return {chosen<&Step::splitting>, &Step::rattle};
    else
      return {};
  }

  static constexpr auto functions = []<std::size_t... Row>(std::index_sequence<Row...>) {
    return std::array{pair<Row>()...};
  }
  (std::make_index_sequence<integrator_table.size()>{});

  static std::size_t index(std::string_view name) {
    for (std::size_t i = 0; i < integrator_table.size(); ++i) {
      if (integrator_table[i].name == name) return i;
    }
    assert(false && "not a row of the table");
    return 0;
  }

  Function free_ = nullptr, constrained_ = nullptr;
  std::vector<Real> work_;
};

}  // namespace cylon::engine
