// What locked bodies cost, and what a scene costs beside the sum of its parts: a spinning top, a brick, a bob on a spring, a bouncing ball
// and a stack of five boxes, each alone and all together 50 m and more apart.  It prints whether all
// motions at the end have the bits that they have alone.  Cost: thread CPU time of setting
// up and 2 s in steps of 1 ms, the smallest of `repeats`, parts and whole in turn.
#include "bench/cpu_time.h"
#include "engine/world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace cylon::bench {
namespace {

using namespace engine;

constexpr int steps = 2000, repeats = 5;
constexpr Time dt = 1e-3;

Model scene() {
  Model model;
  model.forces.gravity = {0, Real(-9.81), 0};
  model.planes = {{Vector3::UnitY(), 0}};
  model.plane_surfaces = {0};
  model.surface_count = 1;
  model.materials = {{Real(0.8), Real(0.3)}};
  return model;
}

void add(Model& model, const Body& body, const Vector3& position, const Vector3& velocity,
         const Vector3& spin, const Quaternion& turn = Quaternion::Identity(), const Shape& shape = {}) {
  model.bodies.push_back(body);
  model.motions.push_back(make_motion(body, position, turn, velocity, spin));
  model.shapes.push_back(shape);
  model.surfaces.push_back(std::holds_alternative<std::monostate>(shape) ? no_surface : 0);
}

void add_top(Model& model) {
  const Vector3 tip = {0, 100, 0}, anchor = {0, Real(-0.3), 0};
  const Quaternion turn = exponential({0, 0, Real(-0.5)});
  const Vector3 spin = turn * Vector3(0, 60, 0);
  model.joints.push_back({.body = static_cast<int>(model.bodies.size()), .anchor = anchor, .to_anchor = tip});
  const Vector3 arm = turn * -anchor;
  add(model, make_body(1, Vector3(Real(0.01), Real(0.005), Real(0.01)).asDiagonal()), tip + arm,
      spin.cross(arm), spin, turn);
}

void add_brick(Model& model) {
  add(model, make_body(1, Vector3(1, 2, 3).asDiagonal()), {200, 100, 0}, {0, 0, 0},
      {Real(0.01), 5, Real(0.02)});
}

void add_bob(Model& model) {
  model.forces.springs.push_back({.body = static_cast<int>(model.bodies.size()),
                                  .to_anchor = {-100, 100, 0},
                                  .stiffness = 20,
                                  .rest_length = Real(0.5)});
  add(model, make_body(1, Matrix3::Identity()), {-101, 100, 0}, {0, 0, 2}, {0, 0, 0});
}

void add_ball(Model& model) {
  add(model, make_body(1, Matrix3::Identity() * Real(0.1)), {0, 2, 50}, {0, 0, 0}, {0, 0, 0},
      Quaternion::Identity(), Sphere{Real(0.5)});
}

void add_boxes(Model& model) {
  for (int i = 0; i < 5; ++i)
    add(model, make_body(1, Matrix3::Identity() / 6), {60, Real(0.5) + static_cast<Real>(i), 0}, {0, 0, 0},
        {0, 0, 0}, Quaternion::Identity(), Box{Vector3::Constant(Real(0.5))});
}

struct Part {
  const char* name;
  void (*add)(Model&);
};

constexpr Part parts[] = {
    {"top", add_top}, {"brick", add_brick}, {"bob", add_bob}, {"ball", add_ball}, {"five boxes", add_boxes}};

struct Ran {
  double cpu = 1e30;  // [s]
  std::vector<Motion> end;
};

void run(const Model& model, Ran& ran) {
  const double start = cpu_now();
  World world(model, {.dt = dt});
  for (int n = 0; n < steps; ++n) world.step();
  ran.cpu = std::min(ran.cpu, cpu_now() - start);
  ran.end = world.motions();
}

// A ball that falls on a floor of n x n locked cubes with flush tops, bounces and rolls.
Model ball_on_cubes(int n) {
  Model model = scene();
  model.planes.clear(), model.plane_surfaces.clear();
  model.materials = {{Real(0.3), Real(0.5)}};
  for (int x = 0; x < n; ++x)
    for (int z = 0; z < n; ++z)
      add(model, make_body(1, Matrix3::Identity() / 6, true), {Real(x), 0, Real(z)}, {0, 0, 0}, {0, 0, 0},
          Quaternion::Identity(), Box{Vector3::Constant(Real(0.5))});
  const int middle = n / 2;
  add(model, make_body(1, Matrix3::Identity() * Real(0.4 * 0.3 * 0.3)), {Real(middle), 2, Real(middle)},
      {1, 0, Real(0.3)}, {0, 0, 0}, Quaternion::Identity(), Sphere{Real(0.3)});
  return model;
}

void print_locked() {
  for (const int n : {5, 30}) {
    Ran ran;
    const Model model = ball_on_cubes(n);
    for (int r = 0; r < repeats; ++r) run(model, ran);
    fmt::print("a ball on {:>3} locked cubes: {:.3f} s for {} steps{}\n", n * n, ran.cpu, steps,
               n == 30 ? (ran.cpu <= 0.05 ? ", target 0.05: met" : ", target 0.05: NOT MET") : "");
  }
}

int compare() {
  std::vector<Model> alone;
  Model whole = scene();
  for (const Part& part : parts) {
    alone.push_back(scene());
    part.add(alone.back());
    part.add(whole);
  }
  std::vector<Ran> ran(alone.size());
  Ran together;
  for (int r = 0; r < repeats; ++r) {
    for (std::size_t k = 0; k < alone.size(); ++k) run(alone[k], ran[k]);
    run(whole, together);
  }
  double sum = 0;
  std::vector<Motion> expected;
  fmt::print("{:<12} {:>10}\n", "part", "ms");
  for (std::size_t k = 0; k < alone.size(); ++k) {
    fmt::print("{:<12} {:>10.3f}\n", parts[k].name, 1e3 * ran[k].cpu);
    sum += ran[k].cpu;
    expected.insert(expected.end(), ran[k].end.begin(), ran[k].end.end());
  }
  const bool same = expected.size() == together.end.size() &&
                    std::memcmp(expected.data(), together.end.data(), expected.size() * sizeof(Motion)) == 0;
  const double ratio = together.cpu / sum;
  fmt::print("{:<12} {:>10.3f}\n{:<12} {:>10.3f}\n", "sum", 1e3 * sum, "together", 1e3 * together.cpu);
  fmt::print("together over the sum: {:.2f}, target 1.2: {}; bits: {}\n", ratio,
             ratio <= 1.2 ? "met" : "NOT MET", same ? "the same" : "NOT THE SAME");
  return same ? 0 : 1;
}

}  // namespace
}  // namespace cylon::bench

int main() {
  cylon::bench::print_locked();
  return cylon::bench::compare();
}
