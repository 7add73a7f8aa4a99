// The same scene in other words must move the same: moved, turned, mirrored, in other units, with other axes,
// in another order.  Nothing here knows a solution.
#include "tests/metamorphic/random_scenes.h"

#include <functional>

namespace cylon::core {
namespace {

// Applies to every number of a scene what a change of description does to its kind.
struct Change {
  std::function<Vector3(const Vector3&)> place = same, direction = same;  // of the world
  std::function<Vector3(const Vector3&)> turning = same;                  // angular velocities
  std::function<Vector3(const Vector3&)> own = same;                      // body axes
  std::function<Quaternion(const Quaternion&)> orientation = [](const Quaternion& q) { return q; };
  std::function<Matrix3(const Matrix3&)> inertia = [](const Matrix3& i) { return i; };
  double length = 1, mass = 1, time = 1;  // units
  bool turns = false;                     // whether orientations change

  static Vector3 same(const Vector3& v) { return v; }
  Vector3 end(int body, const Vector3& anchor) const {
    return body == world ? place(Vector3(length * anchor)) : own(Vector3(length * anchor));
  }

  BodyState operator()(const BodyState& s) const {
    return {place(length * s.position), orientation(s.orientation), direction(length / time * s.velocity),
            turning(s.angular_velocity / time)};
  }
  State operator()(State s) const {
    for (BodyState& b : s) b = (*this)(b);
    return s;
  }
  Scene operator()(Scene s) const {
    for (Body& b : s.bodies) {
      b.initial = (*this)(b.initial);
      b.mass *= mass;
      b.inertia = inertia(mass * length * length * b.inertia);
      if (auto* sphere = std::get_if<Sphere>(&b.shape)) sphere->radius *= length;
    }
    const double force = mass * length / (time * time);
    for (Force& f : s.forces) {
      if (auto* g = std::get_if<UniformGravity>(&f))
        g->acceleration = direction(length / (time * time) * g->acceleration);
      if (auto* k = std::get_if<Spring>(&f)) {
        k->anchor = end(k->body, k->anchor);
        k->to_anchor = end(k->to, k->to_anchor);
        k->stiffness *= mass / (time * time);
        k->rest_length *= length;
        k->damping *= mass / time;
      }
      if (auto* d = std::get_if<Drag>(&f)) {
        d->linear *= mass / time;
        d->angular *= mass * length * length / time;
        d->momentum /= time;
      }
      if (auto* d = std::get_if<Drive>(&f)) {
        d->force = direction(force * d->force);
        d->frequency /= time;
      }
    }
    for (Joint& j : s.joints) {
      j.point = place(length * j.point);
      j.axis = direction(j.axis);
      j.length *= length;
    }
    for (Plane& p : s.planes) {
      const Vector3 on = place(length * p.offset * p.normal);
      p.normal = direction(p.normal);
      p.offset = p.normal.dot(on);
    }
    return s;
  }
};

void expect_relation(const Change& change, const Ingredients& use, bool to_the_bit = false) {
  for (int seed = 0; seed < scene_count; ++seed) {
    const std::string scheme = to_the_bit && scheme_of(seed) == "auto" ? "rk8" : scheme_of(seed);
    const Scene scene = random_scene(seed, use);
    const State plain = run(scene, with(scheme)),
                changed = run(change(scene), with(scheme, change.time * dt));
    const double apart = distance(changed, change(plain));
    // The stages of a Runge-Kutta step leave the unit quaternions, and what it makes of those depends on the
    // axes: a turn is kept to the truncation of both runs, which half the step shows.
    const bool stages = change.turns && (scheme == "rk4" || scheme == "rk8");
    const auto halved = [&](const Scene& of, double step) {
      return run(of, with(scheme, step / 2), 2 * steps);
    };
    const double truncation =
        stages ? 2 * (distance(plain, halved(scene, dt)) + distance(changed, halved(change(scene), dt))) : 0;
    EXPECT_LE(apart, to_the_bit ? 0 : bound(scheme) * change.length + truncation)
        << "seed " << seed << ", " << scheme;
  }
}

// Impacts are located to rounding, and what they change is changed at times that differ by as much.
const Ingredients smooth = {}, bouncing = {.contacts = true}, rough = {.contacts = true, .friction = 0.3};

TEST(Relation1, TranslationMovesTheMotion) {
  const Vector3 a = {0.7, -1.3, 0.4};
  Change change;
  change.place = [=](const Vector3& p) -> Vector3 { return p + a; };
  for (const Ingredients& use : {smooth, bouncing, rough}) expect_relation(change, use);
}

TEST(Relation2, RotationTurnsTheMotion) {
  const Quaternion s = Quaternion(0.7, -0.2, 0.5, 0.3).normalized();
  Change change;
  change.place = change.direction = change.turning = [=](const Vector3& p) -> Vector3 { return s * p; };
  change.orientation = [=](const Quaternion& q) { return s * q; };
  change.turns = true;
  for (const Ingredients& use : {smooth, bouncing, rough}) expect_relation(change, use);
}

// M = diag(-1, 1, 1) in the world and in body axes: w -> -M w, (w, x, y, z) -> (w, x, -y, -z).
TEST(Relation4, AMirrorShowsAPossibleMotion) {
  const auto mirror = [](const Vector3& p) -> Vector3 { return {-p.x(), p.y(), p.z()}; };
  Change change;
  change.place = change.direction = change.own = mirror;
  change.turning = [](const Vector3& w) -> Vector3 { return {w.x(), -w.y(), -w.z()}; };
  change.orientation = [](const Quaternion& q) { return Quaternion(q.w(), q.x(), -q.y(), -q.z()); };
  change.inertia = [](const Matrix3& i) -> Matrix3 {
    const Matrix3 m = Vector3(-1, 1, 1).asDiagonal();
    return m * i * m;
  };
  for (const Ingredients& use : {smooth, bouncing, rough}) expect_relation(change, use);
}

// Units of powers of two only move exponents.
TEST(Relation6, ScalingByPowersOfTwoIsExactToTheBit) {
  Change change;
  change.length = 4, change.mass = 0.5, change.time = 2;
  expect_relation(change, {.joints = false}, true);
}

TEST(Relation6, ScalingByAnyUnit) {
  Change change;
  change.length = 1.7, change.mass = 0.3, change.time = 1.3;
  for (const Ingredients& use : {smooth, bouncing, rough}) expect_relation(change, use);
}

TEST(Relation7, MassAloneChangesNothing) {
  Change change;
  change.mass = 3.7;
  for (const Ingredients& use : {smooth, bouncing, rough}) expect_relation(change, use);
}

// Other axes in the body: q' = q c, I' = C^T I C, a' = C^T a.  Errata 40, 42.
TEST(Relation8, BodyAxesAreANameOnly) {
  const Quaternion c = Quaternion(0.4, 0.6, -0.3, 0.5).normalized();
  Change change;
  change.own = [=](const Vector3& a) -> Vector3 { return c.conjugate() * a; };
  change.orientation = [=](const Quaternion& q) { return q * c; };
  change.turns = true;
  change.inertia = [=](const Matrix3& i) -> Matrix3 {
    const Matrix3 r = c.toRotationMatrix(), turned = r.transpose() * i * r;
    return (turned + turned.transpose()) / 2;
  };
  for (const Ingredients& use : {smooth, bouncing, rough}) expect_relation(change, use);
}

// Errata 66: the order of the bodies is no part of the physics.
TEST(Relation10, TheOrderOfBodiesDoesNotMatter) {
  for (const Ingredients& use : {smooth, bouncing}) {
    for (int seed = 0; seed < scene_count; ++seed) {
      const Scene scene = random_scene(seed, use);
      Scene other = scene;
      const int n = static_cast<int>(scene.bodies.size());
      std::reverse(other.bodies.begin(), other.bodies.end());
      const auto move = [&](int& body) { body = body == world ? world : n - 1 - body; };
      for (Force& f : other.forces) {
        if (auto* k = std::get_if<Spring>(&f)) move(k->body), move(k->to);
        if (auto* d = std::get_if<Drag>(&f)) move(d->body);
        if (auto* d = std::get_if<Drive>(&f)) move(d->body);
      }
      for (Joint& j : other.joints) move(j.body), move(j.to);
      State reversed = run(other, with(scheme_of(seed)));
      std::reverse(reversed.begin(), reversed.end());
      EXPECT_LE(distance(reversed, run(scene, with(scheme_of(seed)))), bound(scheme_of(seed)))
          << "seed " << seed << ", " << scheme_of(seed);
    }
  }
}

// The relations can fail: half a change is none.
TEST(NegativeControl, AHalfHeartedMirrorIsFoundOut) {
  Change change;
  change.place = change.direction = [](const Vector3& p) -> Vector3 { return {-p.x(), p.y(), p.z()}; };
  const Scene scene = random_scene(3, smooth);
  EXPECT_GT(distance(run(change(scene), with("rk8")), change(run(scene, with("rk8")))), 1e-3);
}

}  // namespace
}  // namespace cylon::core
