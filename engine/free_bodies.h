// Many bodies on which nothing but uniform gravity acts, over fixed steps: eight floats or four doubles side
// by side, each block of them in one place of memory.
#pragma once

#include "engine/integrators/integrator.h"
#include "engine/model.h"
#include "engine/pile/threads.h"
#include "engine/stepper.h"

#include <cstdint>
#include <functional>
#include <span>

namespace cylon::engine {

/// More bodies than this that move freely are stepped side by side, by a chosen integrator.
inline constexpr std::size_t many_free = 64;

/// Translation: every symmetric integrator carries free fall exactly, and each keeps the displacement per
/// step s (the integrators differ in A, the share of a step's own kick that its own drifts see; 1/2 from
/// order 2 on)
///   p' = p + s,  s' = s + h^2 g,  s = h K/m + A h^2 g
/// Rotation: with H = |L|^2 x_1/2 + (x_0 - x_1) l_0^2/2 + (x_2 - x_1) l_2^2/2 of engine/free_rotation.h
///   symmetric bodies:  q' = a q b,  a = exp(h x_1 L),  b = exp(h (x_s - x_1) l_s e_s), both constant: exact
///   others:  q' = a q (a composition of turns about e_0 and e_2): Strang's for integrators of order up to 2,
///   Blanes and Moan's S6 and S10 for order 4 and 6; truncation of that order, L exact.
/// Bodies are independent: blocks may run on any number of threads, with the same bits.
class FreeBodies final : public Stepper {
 public:
  struct Given {
    const Body& body;
    Motion motion;
  };

  /// Why a model or integrator is not one for this, or empty.
  static std::string not_free(const Model&, const Integrator&);

  /// Requires not_free() to be empty.  threads: 0: as many as the machine has.
  FreeBodies(const Model&, const Integrator&, Time dt, int threads = 1);

  /// The same without a Model in memory; `given` is asked twice for each body.
  FreeBodies(std::size_t count, const std::function<Given(std::size_t)>& given, const Vector3& gravity,
             const Integrator&, Time dt, int threads = 1);

  void step() override { advance(1); }
  /// Steps in a row: each block stays in cache for all of them.  The bits of as many step().
  void advance(std::int64_t steps) override;
  void read(std::vector<Motion>&) const override;
  void read_turns(std::vector<Real>& turns) const override { turns.clear(); }
  /// One for each block in each step.
  std::int64_t operations() const override;

  std::size_t size() const { return places_.size(); }
  /// Held for all bodies [bytes].
  std::size_t memory() const;

 private:
  using Lanes = Real __attribute__((vector_size(32)));
  static constexpr std::size_t lanes = 32 / sizeof(Real);

  enum Kind : std::uint32_t { point, symmetric, slow, fast, kinds };  // slow, fast: asymmetric

  struct Place {
    std::uint32_t kind, index;  // within its kind
  };
  struct Flight {
    Lanes p[3], s[3];
  };
  // constants: symmetric: cos and sin of the half angle of b; else h (x_0 - x_1)/2 and h (x_2 - x_1)/2.
  struct Spin {
    Flight flight;
    Lanes q[4];  // w, x, y, z; principal axes to world
    Lanes l[3];  // L, world
    Lanes a[2];  // cos, sin/|L| of the half angle of a
    Lanes constants[2];
  };
  // What a step does not need.
  struct Rest {
    Real mass;
    Quaternion frame;  // spinning: world to where `read` needs it, P^-1; else the orientation
  };

  Kind kind_of(const Body&, const Motion&) const;
  void put(std::size_t body, const Given&);
  void put_spin(Spin&, std::size_t lane, Kind, const Given&, Rest&) const;
  void run(Kind, std::size_t begin, std::size_t end, std::int64_t steps);
  template <bool is_fast>
  void turn(const Spin&, Lanes* q) const;

  Vector3 gravity_;
  Real dt_;
  Real own_share_;  // A
  std::span<const double> parts_;
  Real largest_part_ = 0;
  pile::Threads threads_;
  std::vector<Place> places_;
  std::vector<Rest> rests_;
  std::vector<Flight> points_;
  std::vector<Spin> spins_[kinds];
  std::int64_t steps_ = 0;
};

}  // namespace cylon::engine
