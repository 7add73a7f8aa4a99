// A contact point is found again in the next step by its name, and what the step before left there is carried on.
//
// Two crossing edges that the search for nearest points had found were called by the number that the first corner over a
// face of the second body had, whether rounding gave that search or the axes the word.  A box that struck another with a
// face next to where their edges had been near then passed as one that touched it already: the impact had no restitution
// and no stop, and in the other order of the bodies it had.
#include "engine/geometry/manifold.h"
#include "engine/pile/body_pile.h"
#include "tests/engine/geometry/geometry_shapes.h"
#include "tests/engine/pile/pile_fixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace cylon::engine {
namespace {

using geometry_test::Sequence;

Matrix3 turn(const Vector3& by) { return exponential(by).toRotationMatrix(); }

struct Place {
  Vector3 on_a, on_b;  // in the axes of each
};

// Name -> place of all points of a pair.
std::map<PointName, Place> places(const Shape& a, const Pose& p, const Shape& b, const Pose& q, Real margin) {
  std::map<PointName, Place> result;
  const Manifold m = manifold(a, p, b, q, margin);
  for (int k = 0; k < m.count; ++k) {
    const ContactPoint& point = m.points[static_cast<std::size_t>(k)];
    const auto own = [&](const Pose& of) -> Vector3 {
      return of.rotation.transpose() * (point.position - of.position);
    };
    EXPECT_TRUE(result.emplace(point.feature, Place{own(p), own(q)}).second) << "a name of two points";
  }
  return result;
}

// Whether edges of two boxes are nearly parallel to edges or faces of the other: they soon cross elsewhere.
bool are_nearly_parallel(const Matrix3& p, const Matrix3& q) {
  Real least = 1;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      least = std::min({least, p.col(i).cross(q.col(k)).norm(), std::abs(p.col(i).dot(q.col(k)))});
  return least < Real(0.1);
}

// Whatever the two have turned by between two steps, faces for edges or other faces: what has one name is near where it was
// on one of them.
TEST(PointNames, ArePlacesOfOneKind) {
  const Shape a = Box{{Real(0.15), Real(0.05), Real(0.1)}}, b = Box{{Real(0.2), Real(0.07), Real(0.11)}};
  Sequence random(3);
  int kept = 0;
  for (int k = 0; k < 4000; ++k) {
    const Pose q{random.vector(), random.rotation()};
    Pose p{q.position + Real(0.2) * random.vector(), random.rotation()};
    p.position += Real(0.9) * std::max(Real(0), separation(a, p, b, q).gap) *
                  -separation(a, p, b, q).normal;  // nearly touching
    const auto before = places(a, p, b, q, Real(0.02));
    if (are_nearly_parallel(p.rotation, q.rotation)) continue;
    p.rotation = turn(Real(0.01) * random.vector()) * p.rotation;
    for (const auto& [name, now] : places(a, p, b, q, Real(0.02))) {
      const auto old = before.find(name);
      if (old == before.end()) continue;
      ++kept;
      const Real moved = std::min((now.on_a - old->second.on_a).norm(), (now.on_b - old->second.on_b).norm());
      EXPECT_LT(moved, Real(0.05)) << k;
    }
  }
  EXPECT_GT(kept, 1000);
}

// Edges that cross have one name, whether the axes give the word (nearer than about 1e-8 of their size, or overlapping) or
// the search for nearest points.
TEST(PointNames, DoNotDependOnHowThePointWasFound) {
  const Shape box = Box{{Real(0.5), Real(0.4), Real(0.6)}};
  const Real quarter = Real(3.14159265358979323846) / 4;
  const Matrix3 up = turn({0, 0, quarter}), down = turn({0, Real(1.4), 0}) * turn({0, 0, quarter});
  const Real height = 2 * (Real(0.5) + Real(0.4)) * std::sqrt(Real(0.5));
  const Matrix3 tilt = turn({Real(0.3), Real(-0.7), Real(0.4)});
  std::map<PointName, int> names;
  for (const Real gap : {Real(-0.02), Real(0), Real(1e-9), Real(1e-6), Real(0.002)}) {
    const Pose p{tilt * Vector3(0, height + gap, 0), tilt * down}, q{Vector3::Zero(), tilt * up};
    for (const auto& [name, place] : places(box, p, box, q, Real(0.01))) ++names[name];
  }
  ASSERT_EQ(names.size(), 1U);
  EXPECT_EQ(names.begin()->second, 5);
}

// A box that lies and one that falls on it, turning, in either order.
std::vector<Motion> fallen(Sequence random, bool reversed, int steps) {
  Model model = pile_model(0, 1);
  const Vector3 low(Real(0.15), Real(0.05), Real(0.1)), high(Real(0.1), Real(0.06), Real(0.13));
  const Vector3 place = Vector3(0, Real(0.35), 0) + Real(0.08) * random.vector(), spin = 3 * random.vector();
  const Quaternion orientation(random.rotation());
  const auto lying = [&] { add_box(model, 6, low, Vector3(0, Real(0.05), 0)); };
  const auto falling = [&] { add_box(model, 4, high, place, Vector3(0, -1, 0), spin, orientation); };
  if (reversed)
    falling(), lying();
  else
    lying(), falling();
  auto motions = after(*make_pile(model, 2e-3), steps);
  if (reversed) std::reverse(motions.begin(), motions.end());
  return motions;
}

TEST(PointNames, ImpactsDoNotDependOnBodyOrder) {
  for (std::uint64_t seed = 0; seed < 64; ++seed) {
    const auto one = fallen(Sequence(seed), false, 150), other = fallen(Sequence(seed), true, 150);
    for (std::size_t i = 0; i < one.size(); ++i)
      EXPECT_LT((one[i].position - other[i].position).norm(), std::max(Real(1e-6), 4096 * eps))
          << seed << " " << i;
  }
}

}  // namespace
}  // namespace cylon::engine
