// Mass properties of shapes and meshes, generators, materials of pairs.
#include "harness/core/input_error.h"
#include "harness/core/polyhedron.h"
#include "harness/core/solid.h"
#include "harness/scenario/scenario.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace {

using namespace cylon;
using core::Vector3;
using scenario::parse;

const std::string data = std::string(source_dir) + "/tests/data/";
const std::string head = "duration = 1\nstep = 0.1\n";

Vector3 moments(const core::Shape& shape, double mass) {
  return core::mass_properties(shape, mass).inertia.diagonal();
}

TEST(Inertia, LimitsAndTextbookValues) {
  EXPECT_TRUE(moments(core::Box{{1, 2, 3}}, 6).isApprox(Vector3(2 * 13, 2 * 10, 2 * 5)));
  EXPECT_TRUE(moments(core::Cylinder{2, 6}, 1).isApprox(Vector3(4, 2, 4)));
  EXPECT_TRUE(moments(core::Rod{6}, 2).isApprox(Vector3(6, 0, 6)));
  EXPECT_TRUE(moments(core::Disc{2}, 3).isApprox(Vector3(3, 6, 3)));
  EXPECT_TRUE(moments(core::Cone{2, 4}, 10).isApprox(Vector3(12, 12, 12)));
  EXPECT_TRUE(moments(core::Capsule{2, 1e-12}, 1).isApprox(moments(core::Sphere{2}, 1), 1e-10));
  EXPECT_TRUE(moments(core::Capsule{1e-9, 3}, 1).isApprox(moments(core::Cylinder{1e-9, 3}, 1), 1e-8));
}

// A polyhedron of many faces approaches the smooth solid; error of a regular n-gon: O(1/n^2).
TEST(Inertia, CapsuleAndConeAgreeWithPolyhedra) {
  const auto turned = [](auto profile) {
    core::Hull hull;
    constexpr int around = 32, along = 33;
    for (int i = 0; i <= along; ++i)
      for (int j = 0; j < around; ++j) {
        const auto [r, y] = profile(static_cast<double>(i) / along);
        const double a = 2 * std::numbers::pi * j / around;
        hull.vertices.emplace_back(r * std::cos(a), y, r * std::sin(a));
      }
    return hull;
  };
  const auto capsule = turned([](double s) {
    const double a = std::numbers::pi * (s - 0.5);
    return std::pair(0.5 * std::cos(a), 0.5 * std::sin(a) + (s < 0.5 ? -1.0 : 1.0) * 0.7);
  });
  EXPECT_TRUE(moments(capsule, 2).isApprox(moments(core::Capsule{0.5, 1.4}, 2), 1e-2));
  const auto cone = turned([](double s) { return std::pair((1 - s) * 0.8, 1.2 * s - 0.3); });
  EXPECT_TRUE(moments(cone, 2).isApprox(moments(core::Cone{0.8, 1.2}, 2), 1e-2));
  EXPECT_LT(core::mass_properties(cone, 2).centre.norm(), 1e-3);
}

TEST(Polyhedron, ShiftedTetrahedronIsExact) {
  const std::vector<Vector3> p = {{10, 0, 0}, {11, 0, 0}, {10, 1, 0}, {10, 0, 1}};
  const auto solid = core::solid(p, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  EXPECT_NEAR(solid.volume, 1.0 / 6, 1e-15);
  EXPECT_TRUE(solid.centre.isApprox(Vector3(10.25, 0.25, 0.25), 1e-14));
  EXPECT_NEAR(solid.inertia(0, 0), 1.0 / 80, 1e-15);  // m (3/40), m = 1/6, about the centre
  EXPECT_NEAR(solid.inertia(0, 1), 1.0 / 480, 1e-15);
  EXPECT_EQ(core::convex_hull(p).size(), 4u);
  EXPECT_THROW(core::solid(p, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}),
               std::invalid_argument);  // inside out
}

std::string mesh_body(const std::string& file) {
  return head +
         "[[body]]\nname = \"m\"\nmass = 6\nposition = [1, 2, 3]\nshape = { type = \"mesh\", file = \"" +
         file + "\" }\n";
}

TEST(Mesh, CubeFromObjIsCentredAndHasTheCubesInertia) {
  const auto s = parse(mesh_body("cube.obj"), data + "meshes/x.toml");
  const core::Body& body = s.scene.bodies[0];
  const auto& mesh = std::get<core::Mesh>(body.shape);
  EXPECT_EQ(mesh.vertices.size(), 8u);
  EXPECT_EQ(mesh.faces.size(), 12u);
  EXPECT_NEAR(core::solid(mesh.vertices, mesh.faces).volume, 8, 1e-14);
  for (const Vector3& v : mesh.vertices) EXPECT_TRUE(v.cwiseAbs().isApprox(Vector3::Ones(), 1e-14));
  EXPECT_TRUE(body.inertia.isApprox(4 * core::Matrix3::Identity(), 1e-14));  // m a^2/6
  EXPECT_EQ(body.initial.position, Vector3(1, 2, 3));
  // The mesh is part of the content.
  EXPECT_NE(s.hash, parse(mesh_body("./cube.obj"), data + "meshes/x.toml").hash);
}

TEST(Mesh, OpenOrForeignFilesAreRefused) {
  for (const auto& [file, why] :
       {std::pair("open_cube.obj", "the mesh is not closed"), std::pair("no_mesh.obj", "holds no face")}) {
    try {
      parse(mesh_body(file), data + "meshes/x.toml");
      ADD_FAILURE() << file;
    } catch (const core::InputError& error) {
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("x.toml:7:"), std::string::npos) << error.what();
    }
  }
}

TEST(Compound, DumbbellByParallelAxes) {
  const auto s = parse(head +
                           "[[body]]\nname = \"d\"\nshape = { type = \"compound\", parts = [\n"
                           "{ type = \"sphere\", radius = 1, mass = 1, position = [0, 0, 0] },\n"
                           "{ type = \"sphere\", radius = 1, mass = 3, position = [4, 0, 0] }] }\n",
                       "d.toml");
  const core::Body& body = s.scene.bodies[0];
  EXPECT_EQ(body.mass, 4);
  EXPECT_TRUE(
      body.inertia.diagonal().isApprox(Vector3(1.6, 1.6 + 12, 1.6 + 12), 1e-14));  // reduced mass 3/4, 16 m^2
  EXPECT_EQ(std::get<core::Compound>(body.shape).parts[0].position, Vector3(-3, 0, 0));
}

// R I R^T in floating point is not; what is written with all digits and read again must be the same body.
TEST(Compound, InertiaIsSymmetricToTheLastBit) {
  const core::Quaternion turn(Eigen::AngleAxisd(0.3, Vector3(2, 3, 0).normalized()));
  const core::Compound hammer{{{core::Box{{0.08, 0.05, 0.05}}, 2, {0, 0.06, 0}, turn},
                               {core::Cylinder{0.02, 0.5}, 0.5, {0, -0.24, 0}, turn.conjugate()}}};
  const core::Matrix3 inertia = core::mass_properties(hammer, 2.5).inertia;
  EXPECT_EQ(inertia, core::Matrix3(inertia.transpose()));
  EXPECT_GT(std::abs(inertia(1, 2)), 1e-6);  // not because there is nothing there
}

TEST(Generators, LatticeCountsXFastest) {
  const auto s = parse(head +
                           "[[lattice]]\nname = \"b\"\nmass = 1\nposition = [1, 2, 3]\nvelocity = [0, 1, "
                           "0]\ncount = [2, 3, 2]\nspacing = [10, 20, 30]\n",
                       "l.toml");
  ASSERT_EQ(s.scene.bodies.size(), 12u);
  EXPECT_EQ(s.scene.bodies[0].name, "b[0]");
  EXPECT_EQ(s.scene.bodies[11].name, "b[11]");
  EXPECT_EQ(s.scene.bodies[1].initial.position, Vector3(11, 2, 3));
  EXPECT_EQ(s.scene.bodies[2].initial.position, Vector3(1, 22, 3));
  EXPECT_EQ(s.scene.bodies[11].initial.position, Vector3(11, 42, 33));
  EXPECT_EQ(s.scene.bodies[7].initial.velocity, Vector3(0, 1, 0));
}

std::string cloud(int seed) {
  return head +
         "[[cloud]]\nname = \"c\"\nmass = 1\ncount = 200\nlow = [-1, 0.1, -1]\nhigh = [1, 2, 1]\nspeed = "
         "2\nseed = " +
         std::to_string(seed) +
         "\nshape = { type = \"sphere\", radius = 0.1 }\n[[plane]]\nname = \"floor\"\n" +
         "[[material]]\nbetween = [\"*\", \"*\"]\nrestitution = 1\nfriction = 0\n";
}

TEST(Generators, CloudKeepsApartInsideItsBoxAndRepeats) {
  const auto bodies = parse(cloud(7), "c.toml").scene.bodies;
  ASSERT_EQ(bodies.size(), 200u);
  Vector3 mean = Vector3::Zero();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Vector3& p = bodies[i].initial.position;
    EXPECT_TRUE((p.array() >= Vector3(-1, 0.1, -1).array()).all() &&
                (p.array() <= Vector3(1, 2, 1).array()).all());
    EXPECT_NEAR(bodies[i].initial.velocity.norm(), 2, 1e-14);
    mean += bodies[i].initial.velocity / 200;
    for (std::size_t j = 0; j < i; ++j) EXPECT_GE((p - bodies[j].initial.position).norm(), 0.2);
  }
  EXPECT_LT(mean.norm(), 4 * 2 / std::sqrt(200.0));  // isotropic: 4 standard deviations of the mean
  const auto again = parse(cloud(7), "c.toml").scene.bodies, other = parse(cloud(8), "c.toml").scene.bodies;
  EXPECT_EQ(again[199].initial.position, bodies[199].initial.position);
  EXPECT_NE(other[0].initial.position, bodies[0].initial.position);
}

// SplitMix64 from seed 0 begins e220a8397b1dcdaf (Vigna's reference): the same cloud on every platform.
TEST(Generators, CloudIsTheSameEverywhere) {
  const auto s = parse(
      head + "[[cloud]]\nname = \"c\"\nmass = 1\ncount = 1\nlow = [0, 0, 0]\nhigh = [1, 1, 1]\n", "c.toml");
  EXPECT_EQ(s.scene.bodies[0].initial.position.x(), static_cast<double>(0xe220a8397b1dcdafu >> 11) * 0x1p-53);
}

TEST(Materials, GeneratorNameMeansAllItsBodies) {
  const auto s = parse(head +
                           "[[lattice]]\nname = \"b\"\nmass = 1\nposition = [0, 5, 0]\ncount = [3, 1, "
                           "1]\nspacing = [2, 0, 0]\n"
                           "shape = { type = \"sphere\", radius = 0.5 }\n[[plane]]\nname = \"floor\"\n"
                           "[[material]]\nbetween = [\"b\", \"floor\"]\nrestitution = 0.25\nfriction = 0\n"
                           "[[material]]\nbetween = [\"b\", \"b\"]\nrestitution = 0.5\nfriction = 0.1\n",
                       "m.toml");
  for (const core::Pair& pair : core::touching_pairs(s.scene))
    EXPECT_EQ(core::material_of(s.scene, pair)->restitution, pair.plane >= 0 ? 0.25 : 0.5);
}

}  // namespace
