// Translated, rotated, mirrored and rescaled scenes, and scenes with other body axes or body order, must have
// the same motion.  No test here needs an exact solution.
#include "harness/study/restate.h"
#include "tests/conformance/metamorphic/random_scenes.h"

namespace cylon::core {
namespace {

using study::Restatement;

void expect_relation(const Restatement& change, const Ingredients& use, bool to_the_bit = false) {
  for (int seed = 0; seed < scene_count; ++seed) {
    const std::string integrator = to_the_bit && integrator_of(seed) == "auto" ? "rk8" : integrator_of(seed);
    const Scene scene = random_scene(seed, use);
    const State plain = run(scene, with(integrator)),
                changed = run(change(scene), with(integrator, change.time * dt));
    const double apart = distance(changed, change(plain));
    // The stages of a Runge-Kutta step leave the unit quaternions, and what it makes of those depends on the
    // axes: a turn is kept to the truncation of both runs, which half the step shows.
    const bool turns = !change.turn.isDiagonal() || !change.own.isDiagonal();  // a mirror turns no axis
    const bool stages = turns && (integrator == "rk4" || integrator == "rk8");
    const auto halved = [&](const Scene& of, double step) {
      return run(of, with(integrator, step / 2), 2 * steps);
    };
    const double truncation =
        stages ? 2 * (distance(plain, halved(scene, dt)) + distance(changed, halved(change(scene), dt))) : 0;
    EXPECT_LE(apart, to_the_bit ? 0 : bound(integrator) * change.length + truncation)
        << "seed " << seed << ", " << integrator;
  }
}

// Impacts are located to rounding, and what they change is changed at times that differ by as much.
const Ingredients smooth = {}, bouncing = {.contacts = true}, rough = {.contacts = true, .friction = 0.3};

TEST(Relation1, TranslatedSceneHasTranslatedMotion) {
  const Vector3 a = {0.7, -1.3, 0.4};
  Restatement change;
  change.move = a;
  for (const Ingredients& use : {smooth, bouncing, rough}) expect_relation(change, use);
}

TEST(Relation2, RotatedSceneHasRotatedMotion) {
  const Quaternion s = Quaternion(0.7, -0.2, 0.5, 0.3).normalized();
  Restatement change;
  change.turn = s.toRotationMatrix();
  for (const Ingredients& use : {smooth, bouncing, rough}) expect_relation(change, use);
}

// M = diag(-1, 1, 1) in the world and in body axes: w -> -M w, (w, x, y, z) -> (w, x, -y, -z).
TEST(Relation4, MirroredSceneHasMirroredMotion) {
  Restatement change;
  change.turn = change.own = Vector3(-1, 1, 1).asDiagonal();
  for (const Ingredients& use : {smooth, bouncing, rough}) expect_relation(change, use);
}

// Units of powers of two only move exponents.
TEST(Relation6, ScalingByPowersOfTwoIsExactToTheBit) {
  Restatement change;
  change.length = 4, change.mass = 0.5, change.time = 2;
  expect_relation(change, {.joints = false}, true);
}

TEST(Relation6, ScalingByAnyUnit) {
  Restatement change;
  change.length = 1.7, change.mass = 0.3, change.time = 1.3;
  for (const Ingredients& use : {smooth, bouncing, rough}) expect_relation(change, use);
}

TEST(Relation7, CommonMassFactorHasNoEffect) {
  Restatement change;
  change.mass = 3.7;
  for (const Ingredients& use : {smooth, bouncing, rough}) expect_relation(change, use);
}

// Other axes in the body: q' = q c, I' = C^T I C, a' = C^T a.  Errata 40, 42.
TEST(Relation8, BodyAxesHaveNoEffect) {
  const Quaternion c = Quaternion(0.4, 0.6, -0.3, 0.5).normalized();
  Restatement change;
  change.own = c.conjugate().toRotationMatrix();
  for (const Ingredients& use : {smooth, bouncing, rough}) expect_relation(change, use);
}

// Errata 66: the order of the bodies is no part of the physics.
TEST(Relation10, BodyOrderHasNoEffect) {
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
      State reversed = run(other, with(integrator_of(seed)));
      std::reverse(reversed.begin(), reversed.end());
      EXPECT_LE(distance(reversed, run(scene, with(integrator_of(seed)))), bound(integrator_of(seed)))
          << "seed " << seed << ", " << integrator_of(seed);
    }
  }
}

// The relations can fail: half a change is none.
TEST(NegativeControl, DetectsIncompleteMirror) {
  Restatement change;
  change.turn = Vector3(-1, 1, 1).asDiagonal();  // and not the bodies
  const Scene scene = random_scene(3, smooth);
  EXPECT_GT(distance(run(change(scene), with("rk8")), change(run(scene, with("rk8")))), 1e-3);
}

}  // namespace
}  // namespace cylon::core
