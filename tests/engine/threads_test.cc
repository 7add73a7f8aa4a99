// Options::threads was in no option: piles and free bodies had threads in tests alone.
#include "engine/world.h"
#include "tests/engine/pile/pile_fixtures.h"
#include "tests/engine/same_bits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <thread>

namespace cylon::engine {
namespace {

Model boxes_in_a_box() {
  Model model = ball_pile(5, 4, 0, Real(0.5));
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    model.bodies[i] = make_body(1, Matrix3::Identity() / 6);
    model.shapes[i] = Box{Vector3::Constant(Real(0.5))};
  }
  return model;
}

// More than Direct takes at once, on joints, so that substeps sweep them in colours.
Model chains() {
  Model model = pile_model(0, Real(0.5));
  for (int i = 0; i < 140; ++i) {
    const int link = i % 10, chain = i / 10;
    add_box(model, 1, Vector3(Real(0.3), Real(0.2), Real(0.25)),
            {Real(0.8) * static_cast<Real>(link), Real(0.2) + Real(0.41) * static_cast<Real>(chain),
             Real(0.01) * static_cast<Real>(i % 7)});
    if (i % 10 == 0) continue;
    Joint joint;
    joint.type.place = Joint::Place::at_length;
    joint.body = i, joint.to = i - 1, joint.length = Real(0.8);
    model.joints.push_back(joint);
  }
  return model;
}

Model spinning_field() {
  Model model;
  model.forces.gravity = {Real(0.4), Real(-9.81), Real(0.7)};
  for (int i = 0; i < 3000; ++i) {
    const auto part = [&](int a, int b) { return Real(0.1) * static_cast<Real>(i * a % b + 1); };
    const Vector3 moments(part(1, 3), part(1, 3) + Real(0.1), Real(0.35));
    add_body(model, make_body(part(3, 7), moments.asDiagonal()), Shape{},
             {part(2, 5), part(3, 5), part(4, 7)}, {part(1, 5), part(5, 7), part(3, 11)},
             {part(9, 11), part(7, 13), part(5, 17)});
    model.surfaces.back() = no_surface;
  }
  model.surface_count = 0, model.materials.clear();
  return model;
}

std::ptrdiff_t threads_of_this_process() {
  return std::distance(std::filesystem::directory_iterator("/proc/self/task"), {});
}

TEST(ThreadsOption, ChangesNoBit) {
  const struct {
    const char* name;
    Model model;
    const char *integrator, *path;
    Path taken;
    int steps;
  } rows[] = {{"balls", ball_pile(12, 16, 0, Real(0.5)), "auto", "stepping", Path::stepping, 20},
              {"boxes", boxes_in_a_box(), "auto", "", Path::stepping, 40},
              {"boxes on joints", chains(), "auto", "", Path::stepping, 10},
              {"free bodies", spinning_field(), "velocity-verlet", "", Path::free, 40}};
  for (const auto& row : rows) {
    Options options;
    options.integrator = row.integrator, options.path = row.path, options.dt = 1. / 60;
    ASSERT_EQ(unsupported(row.model, options), "") << row.name;
    std::vector<std::vector<Motion>> ends;
    for (const int threads : {1, 4}) {
      options.threads = threads;
      World world(row.model, options);
      ASSERT_EQ(world.plan().path, row.taken) << row.name;
      world.advance(row.steps);
      ends.push_back(world.motions());
    }
    EXPECT_TRUE(same_bits(ends[0], ends[1])) << row.name;
    EXPECT_FALSE(same_bits(ends[0], row.model.motions)) << row.name << ": nothing moved";
  }
}

// With one there is none to wait for; with four there are others, if the machine has more than one.
TEST(ThreadsOption, ReachesPilesAndFreeBodies) {
  if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "one core: none is started";
  const auto run = [](const Model& model, const char* integrator, int threads) {
    Options options;
    options.integrator = integrator, options.dt = 1. / 60, options.threads = threads;
    options.path = model.planes.empty() ? "" : "stepping";
    World world(model, options);
    world.advance(3);
  };
  for (const bool pile : {true, false}) {
    const Model model = pile ? ball_pile(12, 16, 0, Real(0.5)) : spinning_field();
    const auto before = threads_of_this_process();
    run(model, pile ? "auto" : "velocity-verlet", 1);
    EXPECT_EQ(threads_of_this_process(), before) << pile;
    run(model, pile ? "auto" : "velocity-verlet", 4);
    EXPECT_GT(threads_of_this_process(), 1) << pile;
  }
}

}  // namespace
}  // namespace cylon::engine
