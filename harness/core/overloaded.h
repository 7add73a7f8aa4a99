// One function object out of several, for std::visit.
#pragma once

namespace cylon::core {

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;  // clang before 17 does not deduce it for aggregates

}  // namespace cylon::core
