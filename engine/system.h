// What an integrator needs of a system of differential equations on a flat state y of Reals.
#pragma once

#include "engine/vector.h"

#include <concepts>
#include <cstddef>

namespace cylon::engine {

/// y' = f(t, y).
template <class S>
concept System = requires(S& s, const S& c, Time t, const Real* from, Real* y, Real* rate) {
  { c.size() } -> std::convertible_to<std::size_t>;  // length of y
  s.rates(t, from, rate);                            // rate = f(t, from)
  s.project(y);  // back to where exact motion lives: unit quaternions, closed joints; once per step
};

/// A System may have scales(y, scale) or scales(y, scale, tolerance): what errors of each number are measured by, so that they
/// are within `tolerance` of it, and this of one whose errors do not count.
inline constexpr Real uncontrolled = Real(1e30);

/// One with a splitting in two parts that are each solved exactly (or far better than any
/// integrator composed of them): the drift, free motion without forces, and the kick, forces with the
/// configuration frozen.  With joints the drift ends on them (SHAKE) and project() returns the momenta to
/// them, so that kick(h/2) drift(h) kick(h/2) project() is RATTLE.
template <class S>
concept Split = System<S> && requires(S& s, Time t, Real h, Real* y) {
  s.kick(t, h, y);  // momenta advance by h under the forces at (t, configuration)
  s.drift(h, y);    // configuration advances by h
};

/// Whether forces of a System are smooth in time by pieces only: no step of an integrator may go over a kink.
template <class S>
concept Kinked = requires(S& s, const S& c, Time t) {
  { c.next_kink(t) } -> std::convertible_to<Time>;
  s.start_piece(t);
};

}  // namespace cylon::engine
