// What is built of blocks stands: ten seconds at 1/60 s, and nothing moves by a micrometre.
#include "engine/geometry/hull.h"
#include "tests/engine/pile/pile_fixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

namespace cylon::engine {
namespace {

struct Structure {
  const char* name;
  Model (*make)();
  int steps = 600;
};
void PrintTo(const Structure& structure, std::ostream* out) { *out << structure.name; }

constexpr Real half_cube = Real(0.5);

void add_cube(Model& model, const Vector3& place, Real mass = 1) {
  add_box(model, mass, Vector3::Constant(half_cube), place);
}

// Of twelve cubes each, in a square.
template <int count>
Model columns_of_twelve() {
  Model model = pile_model(0, Real(0.5));
  const int side = static_cast<int>(std::ceil(std::sqrt(count)));
  for (int i = 0; i < count; ++i) {
    const int column = i % side, row = i / side;
    for (int k = 0; k < 12; ++k)
      add_cube(model, {Real(1.5) * static_cast<Real>(column), half_cube + static_cast<Real>(k),
                       Real(1.5) * static_cast<Real>(row)});
  }
  return model;
}

// Ten cubes under a thousand times the mass of one, beside 120 that lie alone.
Model load_with_bystanders() {
  Model model = pile_model(0, Real(0.5));
  for (int k = 0; k < 11; ++k) add_cube(model, {0, half_cube + static_cast<Real>(k), 0}, k < 10 ? 1 : 1000);
  for (int i = 0; i < 120; ++i) add_cube(model, {Real(1.5) * static_cast<Real>(i), half_cube, 5});
  return model;
}

// Twelve rows in running bond, each block on the halves of two; every other row has half a block at each end.
Model wall() {
  Model model = pile_model(0, Real(0.5));
  const Real joint = Real(0.02), pitch = 1 + joint, quarter = half_cube / 2;
  for (int row = 0; row < 12; ++row) {
    const bool shifted = row % 2 == 1;
    const Real height = half_cube + static_cast<Real>(row);
    for (int k = 0; k < (shifted ? 11 : 12); ++k)
      add_cube(model, {pitch * (static_cast<Real>(k) + (shifted ? half_cube : 0)), height, 0});
    for (const Real x : {-quarter, 11 * pitch + quarter})
      if (shifted) add_box(model, half_cube, Vector3(quarter, half_cube, half_cube), {x, height, 0});
  }
  return model;
}

// Fourteen squares on each other, of 14^2, 13^2, … 1 cubes: 1015.
Model pyramid_of_a_thousand() {
  Model model = pile_model(0, Real(0.5));
  for (int side = 14; side > 0; --side)
    for (int i = 0; i < side * side; ++i) {
      const Real from = Real(-0.55) * static_cast<Real>(side - 1);
      const int column = i % side, row = i / side;
      add_cube(model, {from + Real(1.1) * static_cast<Real>(column), half_cube + static_cast<Real>(14 - side),
                       from + Real(1.1) * static_cast<Real>(row)});
    }
  return model;
}

// A wedge of an arch between two angles, radii 1 and 1.5 m, 1 m deep, about its centre of mass.
void add_voussoir(Model& model, double from, double to) {
  std::vector<Vector3> points;
  Vector3 middle = Vector3::Zero();
  for (const double angle : {from, to})
    for (const double radius : {1.0, 1.5})
      for (const double z : {-0.5, 0.5}) {
        points.emplace_back(static_cast<Real>(radius * std::cos(angle)),
                            static_cast<Real>(radius * std::sin(angle)), static_cast<Real>(z));
        middle += points.back() / 8;
      }
  for (Vector3& point : points) point -= middle;
  // The corners stand in for the mass: what rests feels no inertia.
  const Matrix3 inertia = Vector3(Real(0.12), Real(0.1), Real(0.06)).asDiagonal().toDenseMatrix();
  add_body(model, make_body(1, inertia), make_hull(points), middle);
}

// Eleven wedges over half a circle, thicker than the tenth of its radius below which none stands (Heyman 1969).
Model arch() {
  Model model = pile_model(0, Real(0.7));
  constexpr int count = 11;
  for (int i = 0; i < count; ++i)
    add_voussoir(model, std::numbers::pi * i / count, std::numbers::pi * (i + 1) / count);
  return model;
}

class Structures : public testing::TestWithParam<Structure> {};

TEST_P(Structures, StandForTenSeconds) {
  const Model model = GetParam().make();
  const auto stepper = make_pile(model, 1. / 60);
  const auto end = after(*stepper, GetParam().steps);
  Real farthest = 0;
  for (std::size_t i = 0; i < end.size(); ++i)
    farthest = std::max({farthest, (end[i].position - model.motions[i].position).norm(),
                         2 * end[i].orientation.vec().norm()});
  RecordProperty("farthest", std::to_string(static_cast<double>(farthest)));
  EXPECT_LT(farthest, Real(1e-6));
}

INSTANTIATE_TEST_SUITE_P(
    All, Structures,
    testing::Values(Structure{"column", columns_of_twelve<1>}, Structure{"columns_13", columns_of_twelve<13>},
                    Structure{"columns_100", columns_of_twelve<100>},
                    Structure{"columns_1000", columns_of_twelve<1000>},
                    Structure{"load_with_bystanders", load_with_bystanders}, Structure{"wall", wall},
                    Structure{"pyramid_of_a_thousand", pyramid_of_a_thousand}, Structure{"arch", arch}),
    [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace cylon::engine
