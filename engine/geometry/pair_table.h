// A table over the pairs of shapes, made row by row from their types.
#pragma once

#include "engine/shape.h"

#include <array>

namespace cylon::engine {

/// make.operator()<A, B>() for every pair, rows and columns in the order of Shape.
template <class Make>
constexpr auto pair_table(Make make) {
  return [&]<class... S>(std::variant<S...>*) {
    const auto row = [&]<class A>(A*) { return std::array{make.template operator()<A, S>()...}; };
    return std::array{row(static_cast<S*>(nullptr))...};
  }(static_cast<Shape*>(nullptr));
}

/// The place of a shape in Shape.
template <class A>
constexpr std::size_t index_of() {
  return []<class... S>(std::variant<S...>*) {
    std::size_t index = 0;
    (void)((std::is_same_v<A, S> || (++index, false)) || ...);
    return index;
  }(static_cast<Shape*>(nullptr));
}

}  // namespace cylon::engine
