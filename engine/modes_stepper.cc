#include "engine/modes_stepper.h"

#include "engine/operations.h"

#include <cmath>

namespace cylon::engine {

namespace {

// sin(x t)/x and cos(x t).
struct Swing {
  double over = 0, cosine = 1;
};

Swing swing(double x, double t) { return {x == 0 ? t : std::sin(x * t) / x, std::cos(x * t)}; }

}  // namespace

ModesStepper::ModesStepper(const Model& model, Time dt)
    : bodies_(model.bodies), start_(model.motions), groups_(normal_modes(model).groups), dt_(dt) {}

std::int64_t ModesStepper::operations() const {
  std::int64_t sample = 0;
  for (const ModeGroup& group : groups_) {
    const auto modes = static_cast<std::int64_t>(group.frequencies.size());
    sample += modes * (static_cast<std::int64_t>(group.forces.size()) + row_operations(6 * modes));
  }
  return steps_ * sample;
}

// Displacements and changes of momentum, so that the start is kept to the bit:
//   q     = v S_w(t)           + f S_c S_d/2
//   q' - v = v (cos w t - 1)   + f (cos(c t) S_d + S_c cos(d t))/2,   cos w t - 1 = -(w S_(w/2))^2/2
void ModesStepper::read(std::vector<Motion>& motions) const {
  motions = start_;
  const Time t = static_cast<Time>(steps_) * dt_;
  for (const ModeGroup& group : groups_) {
    const Eigen::Index n = group.frequencies.size();
    for (Eigen::Index k = 0; k < n; ++k) {
      const double w = group.frequencies[k];
      const Swing half = swing(w / 2, t);
      Eigen::Vector3d place = Eigen::Vector3d::Zero(), speed = Eigen::Vector3d::Zero();
      const auto add = [&](const std::array<Eigen::VectorXd, 3>& shares, double x, double v) {
        for (int c = 0; c < 3; ++c) {
          const double share = shares[static_cast<std::size_t>(c)][k];
          place[c] += share * x, speed[c] += share * v;
        }
      };
      add(group.pushes, half.over * half.cosine, -(w * half.over) * (w * half.over) / 2);
      for (const ModalForce& force : group.forces) {
        const bool steady = force.frequency == 0;
        const Swing c = steady ? half : swing((w + force.frequency) / 2, t);
        const Swing d = steady ? half : swing((w - force.frequency) / 2, t);
        add(force.shares, c.over * d.over / 2, (c.cosine * d.over + c.over * d.cosine) / 2);
      }
      for (Eigen::Index i = 0; i < n; ++i) {
        const std::size_t body = group.bodies[static_cast<std::size_t>(i)];
        const double u = group.shapes(i, k);
        motions[body].position += (u * place).cast<Real>();
        motions[body].momentum += (static_cast<double>(bodies_[body].mass) * u * speed).cast<Real>();
      }
    }
  }
}

}  // namespace cylon::engine
