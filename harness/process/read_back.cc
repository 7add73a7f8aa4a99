#include "harness/process/read_back.h"

#include <fmt/format.h>

#include <algorithm>

namespace cylon::process {
namespace {

using core::BodyState;
using core::Vector3;

std::string text(const Vector3& v) { return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z()); }
std::string text(const core::Quaternion& q) {
  return fmt::format("[{}, {}, {}, {}]", q.w(), q.x(), q.y(), q.z());
}

}  // namespace

std::optional<std::string> read_back_difference(const core::Scene& scene, const core::State& read_back,
                                                const std::string& precision) {
  const double epsilon = precision == "float" ? 1e-6 : 1e-12,
               of_momenta = precision == "float" ? 4e-6 : 1e-12;
  const core::State start = core::initial_state(scene);
  struct Row {
    const char* name;
    Vector3 BodyState::*value;
    double epsilon;
  };
  for (const Row& row :
       {Row{"position", &BodyState::position, epsilon}, Row{"velocity", &BodyState::velocity, epsilon},
        Row{"angular velocity", &BodyState::angular_velocity, of_momenta}}) {
    double scale = 1;
    for (const BodyState& body : start) scale = std::max(scale, (body.*row.value).norm());
    for (std::size_t i = 0; i < start.size(); ++i) {
      const Vector3 &asked = start[i].*row.value, &got = read_back[i].*row.value;
      if (!((got - asked).norm() <= row.epsilon * scale))
        return fmt::format("body '{}' {} {} where the scene says {}", scene.bodies[i].name, row.name,
                           text(got), text(asked));
    }
  }
  for (std::size_t i = 0; i < start.size(); ++i) {
    const core::Quaternion &asked = start[i].orientation, &got = read_back[i].orientation;
    const double apart =
        std::min((got.coeffs() - asked.coeffs()).norm(), (got.coeffs() + asked.coeffs()).norm());
    if (!(apart <= epsilon))
      return fmt::format("body '{}' orientation {} where the scene says {}", scene.bodies[i].name, text(got),
                         text(asked));
  }
  return std::nullopt;
}

}  // namespace cylon::process
