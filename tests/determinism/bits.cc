// Prints a hash of the last state of generated piles and fields of bodies, each with 1, 2 and 4 threads: the
// lines are the same from every compiler, and those of one model but for the number of threads.  For
// tests/determinism.sh.
#include "engine/free_bodies.h"
#include "tests/engine/pile/pile_fixtures.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <span>

namespace cylon::engine {
namespace {

// FNV-1a, 64 bits: http://www.isthe.com/chongo/tech/comp/fnv.
std::uint64_t hash(const std::vector<Motion>& motions) {
  std::uint64_t value = 0xcbf29ce484222325;
  for (const std::byte byte : std::as_bytes(std::span(motions)))
    value = (value ^ std::to_integer<std::uint64_t>(byte)) * 0x100000001b3;
  return value;
}

// Boxes of general proportions and tilts, in crooked columns that fall over.
Model box_pile(int columns, int layers) {
  Model model = pile_model(0, Real(0.4));
  for (int i = 0; i < columns * columns * layers; ++i) {
    const int x = i % columns, z = i / columns % columns, y = i / columns / columns;
    const auto wobble = [&](int a, int b) { return Real(0.02) * static_cast<Real>(i * a % b); };
    add_box(model, 1 + wobble(3, 7), {Real(0.4) + wobble(5, 7), Real(0.3), Real(0.5) - wobble(2, 5)},
            {Real(1.3) * static_cast<Real>(x) + wobble(7, 11), Real(0.5) + Real(0.8) * static_cast<Real>(y),
             Real(1.3) * static_cast<Real>(z) + wobble(5, 13)},
            Vector3::Zero(), {wobble(3, 5), wobble(2, 7), wobble(5, 3)},
            exponential({wobble(2, 3), wobble(4, 5), wobble(3, 11)}));
  }
  return model;
}

Model free_field(int count) {
  Model model;
  model.forces.gravity = {Real(0.3), -g, Real(0.7)};
  for (int i = 0; i < count; ++i) {
    const auto part = [&](int a, int b) { return Real(0.1) * static_cast<Real>(i * a % b + 1); };
    const Matrix3 r = exponential({part(3, 7), part(5, 11), part(2, 13)}).toRotationMatrix();
    const Matrix3 tensor =
        r * Vector3(part(1, 3), part(1, 3) + Real(0.1), part(1, 3) + Real(0.15)).asDiagonal() * r.transpose();
    const Body body = make_body(part(7, 5), (tensor + tensor.transpose()) / 2);
    model.bodies.push_back(body);
    model.motions.push_back(make_motion(
        body, {part(2, 5), part(3, 5), part(4, 7)}, exponential({part(2, 9), part(4, 9), part(5, 9)}),
        {part(1, 5), part(5, 7), part(3, 11)}, {part(9, 11), part(7, 13), part(5, 17)}));
    model.shapes.emplace_back();
    model.surfaces.push_back(no_surface);
  }
  return model;
}

void piles() {
  const struct {
    const char* name;
    Model model;
  } table[] = {{"balls", ball_pile(12, 16, 0, Real(0.5))},
               {"bouncing-balls", ball_pile(9, 9, Real(0.6), Real(0.2))},
               {"boxes", box_pile(3, 4)},
               {"many-boxes", box_pile(7, 5)}};
  for (const auto& [name, model] : table) {
    for (const int threads : {1, 2, 4}) {
      PileSettings settings;
      settings.threads = threads;
      std::printf("%s %d %016llx\n", name, threads,
                  static_cast<unsigned long long>(hash(after(*make_pile(model, 1. / 60, settings), 60))));
    }
  }
}

void fields() {
  const Model model = free_field(1500);
  for (const Integrator& integrator : integrators()) {
    if (!FreeBodies::not_free(model, integrator).empty()) continue;
    for (const int threads : {1, 2, 4}) {
      FreeBodies field(model, integrator, 1. / 60, threads);
      std::printf("free-%s %d %016llx\n", std::string(integrator.name).c_str(), threads,
                  static_cast<unsigned long long>(hash(after(field, 60))));
    }
  }
}

}  // namespace
}  // namespace cylon::engine

int main() {
  cylon::engine::piles();
  cylon::engine::fields();
}
