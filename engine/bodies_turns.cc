// The angles of joints of which the turns count, as part of the state of Bodies: an orientation does not tell them.
#include "engine/bodies.h"

#include <algorithm>
#include <cmath>

namespace cylon::engine {

// The angles of y are what the coordinates of the model are near to.
void Bodies::set_turns(const Real* y) {
  for (std::size_t k = 0; k < turning_.size(); ++k)
    model_.forces.coordinate_laws[turning_[k]].at.near = y[angles_ + k];
}

void Bodies::read_turns(const Real* y, std::vector<Real>& turns) const {
  model_.forces.read_turns(turns);
  for (std::size_t k = 0; k < turning_.size(); ++k) turns[turning_[k]] = y[angles_ + k];
}

Real Bodies::most_turned(const Real* from, const Real* to) const {
  Real most = 0;
  for (std::size_t k = 0; k < turning_.size(); ++k)
    if (model_.forces.coordinate_laws[turning_[k]].is_limited())
      most = std::max(most, std::abs(to[angles_ + k] - from[angles_ + k]));
  return most;
}

// The rates of the angles that are counted.
std::vector<Real> Bodies::turn_rates(const Real* y) {
  std::vector<Real> rates;
  for (const std::size_t k : turning_) {
    const Motion* motion = upright(y, false);
    rates.push_back(
        speed_of(row_of(model_.forces.coordinate_laws[k].at, model_.bodies, motion), model_.bodies, motion));
  }
  return rates;
}

// Angles that are known to less than half a turn become those that the orientations allow.
void Bodies::count_turns(Real* y) const {
  for (std::size_t k = 0; k < turning_.size(); ++k) {
    Coordinate at = model_.forces.coordinate_laws[turning_[k]].at;
    at.near = y[angles_ + k];
    const auto end = [&](int body) {
      const bool moves = body != fixed_world && static_cast<std::size_t>(body) < count_;
      const Motion* motion = moves ? motions(y) : model_.motions.data();
      return end_of(body, Vector3::Zero(), model_.bodies, motion);
    };
    y[angles_ + k] = row_of(at, end(at.body), end(at.to)).offset;
  }
}

}  // namespace cylon::engine
