// Blows between smooth arcs: exact solutions are enclosed, with the next restitution they are not, and what
// cannot be decided is refused.
#include "harness/scenario/scenario.h"
#include "reference/certified/solve.h"
#include "tests/conformance/accuracy/truth/truth_file.h"
#include "tests/paths.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace cylon::certified {
namespace {

using core::Scene;
using core::Vector3;

core::Body sphere(const char* name, double mass, double radius, const Vector3& position,
                  const Vector3& velocity) {
  core::Body ball;
  ball.name = name;
  ball.shape = core::Sphere{radius};
  ball.mass = mass;
  ball.inertia = 0.4 * mass * radius * radius * core::Matrix3::Identity();
  ball.collide = true;
  ball.initial.position = position;
  ball.initial.velocity = velocity;
  return ball;
}

// Drops by 1 m onto the floor: 0.5 s at 8 m/s^2.
Scene bouncing(double restitution) {
  Scene scene;
  scene.bodies = {sphere("ball", 0.75, 0.5, {0.25, 1.5, -2}, {0.5, 0, -1})};
  scene.bodies[0].initial.angular_velocity = {0, 0.5, 0};
  scene.forces.emplace_back(core::UniformGravity{{0, -8, 0}});
  scene.planes.push_back({"floor", Vector3::UnitY(), 0});
  scene.materials.push_back({{"*", "*"}, restitution, 0});
  return scene;
}

// They meet after 0.5 s at 2.5 m/s.
Scene head_on(double restitution) {
  Scene scene;
  scene.bodies = {sphere("a", 1, 0.25, {-1, 3, 0}, {2, 0, 0}),
                  sphere("b", 3, 0.25, {0.75, 3, 0}, {-0.5, 0, 0})};
  scene.materials.push_back({{"*", "*"}, restitution, 0});
  return scene;
}

Scene against_locked(double restitution) {
  Scene scene = head_on(restitution);
  scene.bodies[1].locked = true;
  return scene;
}

// All numbers of the scene and of the solution are exact in binary.
struct Exact {
  const char* name;
  Scene (*scene)(double restitution);
  double restitution, time;
  std::vector<Vector3> positions, velocities;  // at that time
  std::vector<double> blows;                   // up to then
};
void PrintTo(const Exact& e, std::ostream* out) { *out << e.name; }

const Exact exact[] = {
    // v = 4 -> 2 -> 1 m/s; the second apex.
    {"bouncing", bouncing, 0.5, 1.125, {{0.8125, 0.5625, -3.125}}, {{0.5, 0, -1}}, {0.5, 1}},
    // v_a+ = 2 - 1.25 (3/4) 2.5, v_b+ = -0.5 + 1.25 (1/4) 2.5.
    {"head_on",
     head_on,
     0.25,
     1.5,
     {{-0.34375, 3, 0}, {0.78125, 3, 0}},
     {{-0.34375, 0, 0}, {0.28125, 0, 0}},
     {0.5}},
    {"against_locked",
     against_locked,
     0.25,
     1.625,
     {{-0.25, 3, 0}, {0.75, 3, 0}},
     {{-0.5, 0, 0}, {0, 0, 0}},
     {0.625}},
};

bool encloses(const Certificate& found, const Exact& want) {
  bool all = true;
  for (std::size_t b = 0; b < want.positions.size(); ++b)
    for (std::size_t i = 0; i < 3; ++i) {
      const BodyBalls& body = found.samples.at(0).bodies[b];
      const Ball p(want.positions[b][static_cast<int>(i)]), v(want.velocities[b][static_cast<int>(i)]);
      all = all && arb_contains(body.position[i].get(), p.get()) != 0 &&
            arb_contains(body.velocity[i].get(), v.get()) != 0;
    }
  return all;
}

class Blow : public testing::TestWithParam<Exact> {};

TEST_P(Blow, ExactSolutionIsEnclosed) {
  const Exact& want = GetParam();
  const double times[] = {want.time};
  const Certificate found = certify(want.scene(want.restitution), times);
  EXPECT_TRUE(found.reached) << found.reason;
  EXPECT_TRUE(encloses(found, want));
  ASSERT_EQ(found.impacts.size(), want.blows.size());
  for (std::size_t k = 0; k < want.blows.size(); ++k) {
    const Ball time(want.blows[k]);
    EXPECT_TRUE(arb_contains(found.impacts[k].time.get(), time.get()));
    EXPECT_LT(found.impacts[k].time.radius(), 1e-20);
  }
  EXPECT_TRUE(std::isnan(found.samples[0].conditioning)) << "not computed across impacts";
}

TEST_P(Blow, ExcludesSolutionOfOtherRestitution) {
  const Exact& want = GetParam();
  const double times[] = {want.time};
  EXPECT_FALSE(encloses(certify(want.scene(want.restitution + 1e-9), times), want));
}

INSTANTIATE_TEST_SUITE_P(Scenes, Blow, testing::ValuesIn(exact),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(Blow, KeepsSpin) {
  const double times[] = {1.125};
  const Certificate found = certify(bouncing(0.5), times);
  const Ball want(0.5);
  EXPECT_TRUE(arb_contains(found.samples[0].bodies[0].angular_velocity[1].get(), want.get()));
}

// One scene, its restitutions and their velocities from the file; e = 0 is refused below.
TEST(Blow, AgreesWithTruthFileOfHeadOnImpacts) {
  const accuracy::json file = accuracy::read_truth("two_sphere_head_on");
  int compared = 0;
  for (const accuracy::json& event : file["events"]) {
    const double restitution = accuracy::number(event["restitution"]);
    if (restitution == 0) continue;
    Scene scene;
    for (const accuracy::json& b : file["bodies"])
      scene.bodies.push_back(sphere(b["id"].get<std::string>().c_str(), accuracy::number(b["mass"]),
                                    accuracy::number(b["radius"]), accuracy::vector(b["position0"]),
                                    accuracy::vector(b["velocity0"])));
    scene.materials.push_back({{"*", "*"}, restitution, 0});
    const double times[] = {1.0};
    const Certificate found =
        certify(scene, times, {}, [](double x) { return Ball(fmt::format("{}", x), 256); });
    ASSERT_EQ(found.impacts.size(), 1u);
    const auto same = [&](const Ball& ours, const char* key) {
      const Ball want(event[key].get<std::string>(), 256);
      EXPECT_TRUE(arb_overlaps(ours.get(), want.get())) << key << " at restitution " << restitution;
      EXPECT_LT(ours.radius(), 1e-20);
      ++compared;
    };
    same(found.impacts[0].time, "t");
    same(found.samples[0].bodies[0].velocity[0], "vA_after");
    same(found.samples[0].bodies[1].velocity[0], "vB_after");
  }
  EXPECT_EQ(compared, 12);
}

// Each ball passes on (1 + e)/2 = 0.95 of its speed and keeps 0.05; the scene's numbers are decimals.
TEST(Blow, EnclosesImpactsOfCradle) {
  const scenario::Scenario scenario =
      scenario::load(std::string(source_dir) + "/scenarios/newtons_cradle_gapped.toml");
  const double times[] = {scenario.duration};
  const Certificate found =
      certify(scenario.scene, times, {}, [](double x) { return Ball(fmt::format("{}", x), 256); });
  EXPECT_TRUE(found.reached) << found.reason;
  ASSERT_EQ(found.impacts.size(), 4u);
  const char* const speeds[] = {"0.05", "0.0475", "0.045125", "0.04286875", "0.81450625"};
  for (std::size_t b = 0; b < 5; ++b) {
    const Ball want(speeds[b], 256);
    EXPECT_TRUE(arb_overlaps(found.samples[0].bodies[b].velocity[0].get(), want.get())) << b;
    EXPECT_LT(found.samples[0].bodies[b].velocity[0].radius(), 1e-20);
  }
}

// Two balls on springs between tilted walls, general numbers, elastic: the energy
//     E = sum m v^2/2 - m g.p + k p^2/2
// is kept across every blow, which no equation here says.
Scene between_walls(double restitution) {
  Scene scene;
  scene.bodies = {sphere("a", 0.7, 0.21, {-0.45, 0.62, 0.1}, {1.3, -0.4, 0.2}),
                  sphere("b", 1.9, 0.33, {0.48, 0.57, -0.05}, {-0.9, 0.3, 0.1})};
  scene.forces.emplace_back(core::UniformGravity{{0.3, -2.1, 0.2}});
  for (int body : {0, 1})
    scene.forces.emplace_back(core::Spring{body, {0, 0, 0}, core::world, {0, 0, 0}, 3.7, 0});
  scene.planes.push_back({"floor", Vector3(0.28, 0.96, 0), -0.1});
  scene.planes.push_back({"wall", Vector3(-0.6, 0, 0.8), -1.2});
  scene.materials.push_back({{"*", "*"}, restitution, 0});
  return scene;
}

Ball energy(const Scene& scene, const Sampled& sample) {
  constexpr slong bits = 256;
  Ball sum;
  const Vector3 g = std::get<core::UniformGravity>(scene.forces[0]).acceleration;
  const Ball half(0.5), stiffness(3.7);
  for (std::size_t b = 0; b < 2; ++b) {
    const Ball mass(scene.bodies[b].mass);
    for (std::size_t i = 0; i < 3; ++i) {
      const Ball &p = sample.bodies[b].position[i], &v = sample.bodies[b].velocity[i];
      Ball term, weight(g[static_cast<int>(i)]);
      arb_mul(weight.get(), weight.get(), mass.get(), bits);
      arb_submul(sum.get(), weight.get(), p.get(), bits);
      for (const auto& [x, factor] : {std::pair{&v, &mass}, std::pair{&p, &stiffness}}) {
        arb_mul(term.get(), x->get(), x->get(), bits);
        arb_mul(term.get(), term.get(), half.get(), bits);
        arb_addmul(sum.get(), term.get(), factor->get(), bits);
      }
    }
  }
  return sum;
}

// Whether the energy at the end may be that of the start.
bool keeps_energy(double restitution) {
  const Scene scene = between_walls(restitution);
  const double times[] = {0, 3};
  const Certificate found = certify(scene, times);
  EXPECT_TRUE(found.reached) << found.reason;
  EXPECT_GE(found.impacts.size(), 5u);
  const Ball first = energy(scene, found.samples[0]), last = energy(scene, found.samples[1]);
  EXPECT_LT(last.radius(), 1e-15);
  return arb_overlaps(first.get(), last.get()) != 0;
}

TEST(Blow, ConservesEnergyOnlyIfElastic) {
  EXPECT_TRUE(keeps_energy(1));
  EXPECT_FALSE(keeps_energy(1 - 1e-9));
}

// A coarse solution holds a much finer one.
TEST(Blow, CoarseEnclosureContainsFineOne) {
  const double times[] = {0.7, 1.9, 3};
  const Certificate coarse = certify(between_walls(0.83), times, {.radius = 1e-6, .most_bits = 128}),
                    fine = certify(between_walls(0.83), times, {.radius = 1e-40});
  EXPECT_LT(fine.radius, 1e-9 * coarse.radius);
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t b = 0; b < 2; ++b)
      for (std::size_t i = 0; i < 3; ++i) {
        const BodyBalls &wide = coarse.samples[k].bodies[b], &narrow = fine.samples[k].bodies[b];
        EXPECT_TRUE(arb_contains(wide.position[i].get(), narrow.position[i].get()));
        EXPECT_TRUE(arb_contains(wide.velocity[i].get(), narrow.velocity[i].get()));
      }
}

struct Refused {
  const char* name;
  std::function<void(Scene&)> change;  // of the ball that bounces
  const char* reason;
};
void PrintTo(const Refused& r, std::ostream* out) { *out << r.name; }

const Refused refused[] = {
    {"friction", [](Scene& s) { s.materials[0].friction = 0.3; }, "touch with friction 0.3"},
    {"no_material", [](Scene& s) { s.materials.clear(); }, "no material says how they rebound"},
    {"box", [](Scene& s) { s.bodies[0].shape = core::Box{Vector3(0.5, 0.5, 0.5)}; },
     "only blows between spheres and planes"},
    {"joint",
     [](Scene& s) {
       s.joints.push_back({core::JointType::ball, 0, core::world, {0, 2, 0}});
     },
     "a body with a joint"},
    {"drive",
     [](Scene& s) {
       s.forces.emplace_back(core::Drive{0, {1, 0, 0}, 2});
     },
     "changes with time"},
    {"two_at_one_instant",
     [](Scene& s) {
       s.bodies.push_back(sphere("twin", 2, 0.5, {4, 1.5, 0}, {0, 0, 0}));
     },
     "two impacts cannot be told apart near 0.5 s"},
    {"corner",
     [](Scene& s) {
       s.planes.push_back({"wall", Vector3::UnitX(), -0.5});
       s.bodies[0].initial.velocity.x() = -0.5;
     },
     "two impacts cannot be told apart near 0.5 s"},
    // Passes beside a locked ball at the distance of both radii.
    {"grazing",
     [](Scene& s) {
       s.forces.clear();
       s.bodies[0].initial.velocity = {1, 0, 0};
       s.bodies.push_back(sphere("post", 2, 0.5, {1.25, 2.5, -2}, {0, 0, 0}));
       s.bodies[1].locked = true;
     },
     "near 1 s it cannot be proven whether they touch"},
    {"touching", [](Scene& s) { s.bodies[0].initial.position.y() = 0.5; }, "touch at the start"},
    {"plastic", [](Scene& s) { s.materials[0].restitution = 0; }, "do not part"},
    // Without end at 0.5 + 2 * 0.5 = 1.5 s.
    {"without_end", [](Scene& s) { s.materials[0].restitution = 0.5; }, "near 1.5 s"},
    {"sample_at_the_blow",
     [](Scene& s) {
       s.forces = {core::UniformGravity{{0, -0.5, 0}}};
     },
     "before or after a blow cannot be told"},
};

class RefusedBlows : public testing::TestWithParam<Refused> {};

TEST_P(RefusedBlows, NameTheReason) {
  Scene scene = bouncing(0.75);
  GetParam().change(scene);
  const double times[] = {2.0};
  try {
    certify(scene, times, {.radius = 1e-20, .most_bits = 512});
    FAIL() << "accepted";
  } catch (const core::OutOfDomain& error) {
    EXPECT_NE(std::string(error.what()).find(GetParam().reason), std::string::npos) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, RefusedBlows, testing::ValuesIn(refused),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace cylon::certified
