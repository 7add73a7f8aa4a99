// A scene as Simbody has it: a tree of mobilized bodies, constraints for what closes loops, gravity, and a force whose
// law the caller gives.  Included by the adapter's own sources and their tests only.
#pragma once

#include "harness/core/scene.h"
#include "reference/applied/forest.h"
#include "reference/simulators/simbody/simbody_headers.h"

#include <functional>
#include <memory>
#include <vector>

namespace cylon::simulators {

/// Adds what acts on bodies, by index of Simbody's, torque first, world axes, at the centres of mass.
using SimbodyLaw = std::function<void(const SimTK::State&, SimTK::Vector_<SimTK::SpatialVec>&)>;

class SimbodyWorld {
 public:
  /// No law: nothing but gravity acts.
  SimbodyWorld(const core::Scene&, const applied::Forest&, SimbodyLaw law);

  /// The motion at t = 0, in a state that is realized to its model.
  SimTK::State start(const core::Scene&, const applied::Forest&);

  /// Gives a body another mass and the same inertia.  A state of before is none any more: `moved` takes it over.
  void set_mass(std::size_t body, double mass);
  SimTK::State moved(const SimTK::State& before);

  const SimTK::MultibodySystem& system() const { return system_; }
  const SimTK::SimbodyMatterSubsystem& matter() const { return matter_; }

  /// The ground for a locked body.
  const SimTK::MobilizedBody& mobilized(std::size_t body) const {
    return matter_.getMobilizedBody(indices_[body]);
  }

 private:
  void hang(const core::Scene&, const applied::Forest&, int body);
  void close(const core::Scene&, const core::Joint&);

  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::GeneralForceSubsystem forces_{system_};
  std::vector<SimTK::MobilizedBodyIndex> indices_;
};

inline SimTK::Vec3 to_simbody(const core::Vector3& v) { return {v.x(), v.y(), v.z()}; }
inline core::Vector3 from_simbody(const SimTK::Vec3& v) { return {v[0], v[1], v[2]}; }

}  // namespace cylon::simulators
