// States of measured bodies as numbers: what a start may err by, and by what two states differ.
#pragma once

#include "reference/measured/experiment.h"

#include <algorithm>
#include <span>

namespace cylon::measured {

/// How many numbers a state is: 12, or two for each hinge of a chain.
Eigen::Index coordinates(const Experiment&);

/// The state whose coordinates are greater by that much.
core::State moved(const Experiment&, const core::State&, const Eigen::VectorXd& by);

/// What is compared in fits, measured less predicted: of a free body the position in lengths of the data [m], the small turn
/// between the orientations, in world axes [rad]; of a chain the angles [rad].  What has no noise stated is left out.
Eigen::VectorXd difference(const Experiment&, const core::State& measured, const core::State& predicted);

/// Standard deviation of the noise of each number of `difference`, in lengths of the data.
Eigen::VectorXd noise(const Experiment&);

/// The model's scene, started there.
core::Scene started(const Experiment&, const core::State&);

/// The measured bodies' part of a scene's state.
core::State measured_of(const Experiment&, const core::State&);

/// Bodies hinged one to the next, the first to the world, about parallel axes: the state of each for absolute angles and rates
/// about the first axis, from where the scene has them [rad, rad/s].
core::State chain_state(const core::Scene&, std::span<const std::size_t> bodies,
                        const Eigen::VectorXd& angles, const Eigen::VectorXd& rates);

/// The angles about the first axis from where the scene has the bodies, each in (-pi, pi], and rates of such a state.
Eigen::VectorXd chain_angles(const core::Scene&, std::span<const std::size_t> bodies, const core::State&);
Eigen::VectorXd chain_rates(const core::Scene&, std::span<const std::size_t> bodies, const core::State&);

/// The joint that holds a body to the one before it; null: none does.
template <class AScene>  // const or not
auto* joint_of(AScene& scene, std::size_t body) {
  const auto found = std::ranges::find(scene.joints, static_cast<int>(body), &core::Joint::body);
  return found == scene.joints.end() ? nullptr : &*found;
}

/// Why the bodies are no such chain; empty where they are one.
std::string no_chain(const core::Scene&, std::span<const std::size_t> bodies);

}  // namespace cylon::measured
