// What MuJoCo has after its compiler is what the scene says: masses, inertia, places, shapes, joints, options, each
// read from the model and compared with the scene to rounding.
#include "reference/simulators/mujoco/mujoco_model.h"
#include "reference/simulators/mujoco/mujoco_options.h"
#include "reference/simulators/mujoco/mujoco_world.h"
#include "tests/reference/exact/random_scenes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace cylon::simulators {
namespace {

using core::Quaternion;
using core::Scene;
using core::Vector3;

constexpr double unit = 0x1p-53;

MujocoWorld compiled(const Scene& scene, const MujocoSettings& settings = mujoco_as_shipped(),
                     double dt = 1e-3) {
  return mujoco_compile(mujoco_xml(scene, applied::forest_of(scene), mujoco_contacts(scene), settings, dt));
}

int id_of(const MujocoWorld& world, int body) {
  return mj_name2id(world.model.get(), mjOBJ_BODY, mujoco_body_name(body).c_str());
}

Vector3 vector(const mjtNum* v) { return {v[0], v[1], v[2]}; }
Quaternion quaternion(const mjtNum* q) { return {q[0], q[1], q[2], q[3]}; }

// Bodies with full inertia, turned and placed in general.
Scene bodies(unsigned seed, int count) {
  exact::RandomScenes random(seed);
  Scene scene;
  for (int i = 0; i < count; ++i) {
    scene.bodies.push_back(
        random.body({random.between(0.3, 0.5), random.between(0.5, 0.7), random.between(0.7, 0.8)}));
    scene.bodies.back().name = fmt::format("body{}", i);
  }
  return scene;
}

core::Joint joint(core::JointType type, int body, int to, const Vector3& point) {
  return {type, body, to, point, Vector3(1, -2, 3).normalized(), 0};
}

// ---- Bodies -----------------------------------------------------------------------------------------

void expect_bodies(const Scene& scene, const std::string& what) {
  const MujocoWorld world = compiled(scene);
  const mjModel& m = *world.model;
  mj_kinematics(&m, world.data.get());
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const core::Body& body = scene.bodies[i];
    const int id = id_of(world, static_cast<int>(i));
    ASSERT_GT(id, 0) << what;
    const double size = body.initial.position.norm() + 1;
    EXPECT_LE((vector((body.locked ? world.data->xpos : world.data->xipos) + 3 * id) - body.initial.position)
                  .norm(),
              64 * unit * size)
        << what;
    const Quaternion q = quaternion(world.data->xquat + 4 * id);
    const double sign = q.dot(body.initial.orientation) < 0 ? -1 : 1;
    EXPECT_LE((q.coeffs() - sign * body.initial.orientation.coeffs()).norm(), 64 * unit) << what;
    if (body.locked) {
      EXPECT_EQ(m.body_weldid[id], 0) << what;
      continue;
    }
    EXPECT_EQ(m.body_mass[id], body.mass) << what;
    const core::Matrix3 axes = quaternion(m.body_iquat + 4 * id).toRotationMatrix();
    const core::Matrix3 inertia = axes * vector(m.body_inertia + 3 * id).asDiagonal() * axes.transpose();
    EXPECT_LE((inertia - body.inertia).norm(), 32 * unit * body.inertia.norm()) << what;
    EXPECT_EQ(vector(m.body_ipos + 3 * id), Vector3::Zero()) << what;
  }
}

TEST(MujocoModel, HasMassesInertiaAndPlacesOfTheScene) {
  for (unsigned seed = 1; seed <= 8; ++seed) expect_bodies(bodies(seed, 3), fmt::format("free, {}", seed));
  for (unsigned seed = 11; seed <= 14; ++seed) {
    Scene scene = bodies(seed, 5);
    scene.bodies[4].locked = true;
    scene.joints = {joint(core::JointType::ball, 0, core::world, {0.3, 0.1, -0.2}),
                    joint(core::JointType::hinge, 1, 0, {0.5, 0.7, 0.2}),
                    joint(core::JointType::fixed, 2, 1, {0.1, -0.7, 0.3}),
                    joint(core::JointType::ball, 3, 4, {0.1, 0.9, 0.3})};
    expect_bodies(scene, fmt::format("hung, {}", seed));
  }
  Scene far = bodies(21, 3);
  far.bodies[0].mass = 3e-9, far.bodies[0].inertia *= 2e-12;
  far.bodies[1].mass = 7e6, far.bodies[1].inertia *= 4e7;
  far.bodies[2].initial.position *= 1e6;
  expect_bodies(far, "small, large and far");
}

// A flat body has A + B = C, which rounding may break either way.
TEST(MujocoModel, TakesFlatBodies) {
  for (unsigned seed = 31; seed <= 46; ++seed) {
    Scene scene = bodies(seed, 1);
    exact::RandomScenes random(seed);
    const Vector3 moments(random.between(0.1, 0.9), random.between(0.1, 0.9), 0);
    const core::Matrix3 turn = random.rotation().toRotationMatrix();
    const core::Matrix3 inertia =
        turn * Vector3(moments[0], moments[1], moments[0] + moments[1]).asDiagonal() * turn.transpose();
    scene.bodies[0].inertia = (inertia + inertia.transpose()) / 2;
    expect_bodies(scene, fmt::format("flat, {}", seed));
  }
}

// ---- Joints -----------------------------------------------------------------------------------------

struct Mechanism {
  const char* name;
  int bodies;
  std::vector<core::Joint> joints;
  int freedoms, equalities, tendons;
};

const Vector3 place(0.2, 0.4, -0.1);
using Type = core::JointType;
core::Joint rod(int body, int to) { return {Type::distance, body, to, place, Vector3::UnitY(), 0.7}; }

const Mechanism mechanisms[] = {
    {"free", 2, {}, 12, 0, 0},
    {"ball to the world", 1, {joint(Type::ball, 0, core::world, place)}, 3, 0, 0},
    {"hinge to the world", 1, {joint(Type::hinge, 0, core::world, place)}, 1, 0, 0},
    {"fixed to the world", 1, {joint(Type::fixed, 0, core::world, place)}, 0, 0, 0},
    {"afloat", 2, {joint(Type::hinge, 1, 0, place)}, 7, 0, 0},
    {"hung from its far end",
     3,
     {joint(Type::ball, 0, 1, place), joint(Type::hinge, 1, 2, place),
      joint(Type::ball, 2, core::world, place)},
     7,
     0,
     0},
    {"distance to the world", 1, {rod(0, core::world)}, 6, 1, 1},
    {"distance of two", 2, {rod(0, 1)}, 12, 1, 1},
    {"ring of balls",
     3,
     {joint(Type::ball, 0, 1, place), joint(Type::ball, 1, 2, place), joint(Type::ball, 2, 0, place)},
     12,
     1,
     0},
    {"two hinges",
     1,
     {joint(Type::hinge, 0, core::world, place), joint(Type::hinge, 0, core::world, place)},
     1,
     2,
     0},
    {"held twice",
     1,
     {joint(Type::ball, 0, core::world, place), joint(Type::fixed, 0, core::world, place)},
     3,
     1,
     0},
};

TEST(MujocoModel, HasTheFreedomsThatJointsLeave) {
  for (const Mechanism& row : mechanisms) {
    Scene scene = bodies(51, row.bodies);
    scene.joints = row.joints;
    const MujocoWorld world = compiled(scene);
    EXPECT_EQ(world.model->nv, row.freedoms) << row.name;
    EXPECT_EQ(world.model->neq, row.equalities) << row.name;
    EXPECT_EQ(world.model->ntendon, row.tendons) << row.name;
    // A constraint is met where the scene starts; a distance is off by what the scene states.
    mj_forward(world.model.get(), world.data.get());
    for (int i = 0; i < world.data->nefc; ++i) {
      const double off = row.tendons > 0 ? world.data->ten_length[0] - 0.7 : 0;
      EXPECT_NEAR(world.data->efc_pos[i], off, 1e-14) << row.name;
    }
  }
}

// The deepest tree that the adapter takes is one that MuJoCo's reader takes.
TEST(MujocoModel, TakesLongChains) {
  Scene scene = bodies(61, 90);
  for (int i = 0; i < 90; ++i) scene.joints.push_back(joint(Type::ball, i, i - 1, place));
  EXPECT_EQ(compiled(scene).model->nv, 270);
}

// ---- Options ----------------------------------------------------------------------------------------

struct OptionRow {
  const char *option, *value;
  std::function<bool(const mjModel&)> is_set;
};
bool flag(const mjModel& m, int bit) { return (m.opt.disableflags & bit) != 0; }

const OptionRow option_rows[] = {
    {"cone", "elliptic", [](const mjModel& m) { return m.opt.cone == mjCONE_ELLIPTIC; }},
    {"impratio", "7.5", [](const mjModel& m) { return m.opt.impratio == 7.5; }},
    {"noslip-iterations", "13", [](const mjModel& m) { return m.opt.noslip_iterations == 13; }},
    {"noslip-tolerance", "0.125", [](const mjModel& m) { return m.opt.noslip_tolerance == 0.125; }},
    {"solver", "PGS", [](const mjModel& m) { return m.opt.solver == mjSOL_PGS; }},
    {"iterations", "17", [](const mjModel& m) { return m.opt.iterations == 17; }},
    {"tolerance", "0.25", [](const mjModel& m) { return m.opt.tolerance == 0.25; }},
    {"jacobian", "sparse", [](const mjModel& m) { return m.opt.jacobian == mjJAC_SPARSE; }},
    {"ccd-iterations", "19", [](const mjModel& m) { return m.opt.mpr_iterations == 19; }},
    {"ccd-tolerance", "0.5", [](const mjModel& m) { return m.opt.mpr_tolerance == 0.5; }},
    {"warmstart", "disable", [](const mjModel& m) { return flag(m, mjDSBL_WARMSTART); }},
    {"refsafe", "disable", [](const mjModel& m) { return flag(m, mjDSBL_REFSAFE); }},
    {"multiccd", "enable", [](const mjModel& m) { return (m.opt.enableflags & mjENBL_MULTICCD) != 0; }},
    {"solref-time", "0.375", [](const mjModel& m) { return m.geom_solref[0] == 0.375; }},
    {"solref-damping", "1.5", [](const mjModel& m) { return m.geom_solref[1] == 1.5; }},
    {"solimp-least", "0.625", [](const mjModel& m) { return m.geom_solimp[0] == 0.625; }},
    {"solimp-most", "0.75", [](const mjModel& m) { return m.geom_solimp[1] == 0.75; }},
    {"solimp-width", "0.0625", [](const mjModel& m) { return m.geom_solimp[2] == 0.0625; }},
};

Scene resting() {
  Scene scene = bodies(71, 1);
  scene.bodies[0].shape = core::Sphere{0.3}, scene.bodies[0].collide = true;
  scene.planes = {{"floor", Vector3(1, 2, -3).normalized(), -20}};
  scene.materials = {{{"*", "*"}, 0, 0.4}};
  return scene;
}

// Each option reaches its place, which has another value without it; what is not set is as MuJoCo has it by itself.
TEST(MujocoModel, HasTheOptionsOfTheRun) {
  const Scene scene = resting();
  const MujocoWorld plain = compiled(scene);
  for (const OptionRow& row : option_rows) {
    EXPECT_FALSE(row.is_set(*plain.model)) << row.option;
    MujocoSettings settings = mujoco_as_shipped();
    mujoco_options().set(settings.values, row.option, row.value);
    EXPECT_TRUE(row.is_set(*compiled(scene, settings).model)) << row.option;
  }
  EXPECT_EQ(std::size(option_rows), mujoco_options().rows().size()) << "each option has a row";

  mjOption own;
  mj_defaultOption(&own);
  const mjOption& here = plain.model->opt;
  EXPECT_EQ(here.impratio, own.impratio);
  EXPECT_EQ(here.tolerance, own.tolerance);
  EXPECT_EQ(here.noslip_tolerance, own.noslip_tolerance);
  EXPECT_EQ(here.mpr_tolerance, own.mpr_tolerance);
  EXPECT_EQ(here.integrator, own.integrator);
  EXPECT_EQ(here.cone, own.cone);
  EXPECT_EQ(here.jacobian, own.jacobian);
  EXPECT_EQ(here.solver, own.solver);
  EXPECT_EQ(here.iterations, own.iterations);
  EXPECT_EQ(here.noslip_iterations, own.noslip_iterations);
  EXPECT_EQ(here.mpr_iterations, own.mpr_iterations);
  EXPECT_EQ(here.disableflags, own.disableflags | mjDSBL_FILTERPARENT);
  EXPECT_EQ(here.enableflags, own.enableflags);
  mjtNum reference[mjNREF], impedance[mjNIMP];
  reference[0] = 0.02, reference[1] = 1;
  impedance[0] = 0.9, impedance[1] = 0.95, impedance[2] = 0.001, impedance[3] = 0.5, impedance[4] = 2;
  for (int i = 0; i < mjNREF; ++i) EXPECT_EQ(plain.model->geom_solref[i], reference[i]);
  for (int i = 0; i < mjNIMP; ++i) EXPECT_EQ(plain.model->geom_solimp[i], impedance[i]);
}

TEST(MujocoModel, HasStepGravityAndIntegrator) {
  Scene scene = bodies(72, 1);
  scene.forces = {core::UniformGravity{{1.1, -2.3, 0.7}}, core::UniformGravity{{0.1, 0.2, 0.3}}};
  for (const auto& [name, code] :
       {std::pair{"euler", mjINT_EULER}, {"rk4", mjINT_RK4}, {"implicit", mjINT_IMPLICIT}}) {
    MujocoSettings settings = mujoco_as_shipped();
    settings.integrator = name;
    const MujocoWorld world = compiled(scene, settings, 1.0 / 3);
    EXPECT_EQ(world.model->opt.integrator, code);
    EXPECT_EQ(world.model->opt.timestep, 1.0 / 3);
    EXPECT_LE((vector(world.model->opt.gravity) - Vector3(1.2, -2.1, 1)).norm(), 16 * unit);
  }
}

// ---- Contacts ---------------------------------------------------------------------------------------

// Four bodies that all touch a floor, and a neighbour on a joint.
Scene crowd(std::vector<core::Material> materials) {
  Scene scene = bodies(81, 4);
  for (core::Body& body : scene.bodies) body.shape = core::Sphere{0.3}, body.collide = true;
  scene.bodies[3].collide = false;
  scene.planes = {{"floor", Vector3::UnitY(), -20}};
  scene.joints = {joint(Type::ball, 0, 1, place)};
  scene.materials = std::move(materials);
  return scene;
}

// Normals all round, and those along an axis in exactly its direction.
TEST(MujocoModel, HasThePlanesOfTheScene) {
  exact::RandomScenes random(91);
  std::vector<Vector3> normals = {Vector3::UnitX(),
                                  Vector3::UnitY(),
                                  Vector3::UnitZ(),
                                  -Vector3::UnitX(),
                                  -Vector3::UnitY(),
                                  -Vector3::UnitZ(),
                                  Vector3(1e-9, -2e-9, -1).normalized()};
  for (int i = 0; i < 30; ++i) normals.push_back(random.vector(1).normalized());
  for (const Vector3& normal : normals) {
    Scene scene = resting();
    scene.planes = {{"floor", normal, 1.7}};
    const MujocoWorld world = compiled(scene);
    mj_kinematics(world.model.get(), world.data.get());
    const mjtNum* const axes = world.data->geom_xmat;
    const Vector3 got(axes[2], axes[5], axes[8]);
    EXPECT_LE((got - normal).norm(), 8 * unit) << normal.transpose();
    const bool along_axis = normal.cwiseAbs().maxCoeff() == 1;
    EXPECT_LE(got.cross(normal).norm(), along_axis ? 0 : 8 * unit) << normal.transpose();
    EXPECT_LE((vector(world.data->geom_xpos) - 1.7 * normal).norm(), 4 * unit) << normal.transpose();
  }
}

TEST(MujocoModel, HasTheFrictionOfEachPair) {
  const MujocoWorld one = compiled(crowd({{{"*", "*"}, 0, 0.35}}));
  EXPECT_EQ(one.model->opt.collision, mjCOL_DYNAMIC);
  EXPECT_EQ(one.model->npair, 0);
  EXPECT_EQ(one.model->nexclude, 1);
  for (int g = 0; g < one.model->ngeom; ++g) {
    EXPECT_EQ(one.model->geom_friction[3 * g], 0.35);
    EXPECT_EQ(one.model->geom_condim[g], 3);
  }
  const MujocoWorld none = compiled(crowd({{{"*", "*"}, 0, 0}}));
  for (int g = 0; g < none.model->ngeom; ++g) EXPECT_EQ(none.model->geom_condim[g], 1);

  // body0 and body1 hang on each other, body3 touches nothing: (0,2), (1,2), and three with the floor.
  const MujocoWorld many =
      compiled(crowd({{{"*", "*"}, 0, 0.35}, {{"body2", "floor"}, 0, 0.7}, {{"body0", "body2"}, 0, 0}}));
  const mjModel& m = *many.model;
  EXPECT_EQ(m.opt.collision, mjCOL_PAIR);
  ASSERT_EQ(m.npair, 5);
  int rough = 0, smooth = 0;
  for (int i = 0; i < m.npair; ++i) {
    const double mu = m.pair_friction[5 * i];
    EXPECT_EQ(m.pair_friction[5 * i + 1], mu) << "the same in both directions";
    EXPECT_EQ(m.pair_dim[i], mu > 0 ? 3 : 1);
    rough += mu == 0.7, smooth += mu == 0;
  }
  EXPECT_EQ(rough, 1);
  EXPECT_EQ(smooth, 1);
}

}  // namespace
}  // namespace cylon::simulators
