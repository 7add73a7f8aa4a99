#include "reference/measured/claim_truth.h"

#include "harness/core/input_error.h"
#include "harness/core/joint_coordinates.h"
#include "harness/scenario/measured_truth.h"
#include "reference/measured/coordinates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace cylon::measured {
namespace {

using core::BodyState, core::InputError, core::Scene, core::State, Eigen::VectorXd;

// A run in a scene of its own, whose bodies need not stand where the experiment's model has them.
class Motion {
 public:
  Motion(const Experiment& e, const Run& run, const Scene& scene) : e_(e), run_(run), scene_(scene) {
    e_.runs.clear();  // the other runs are nobody's here
    for (const std::size_t i : e.bodies) bodies_.push_back(named(e.model.scene.bodies[i].name));
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
      if (!scene.bodies[i].locked && std::ranges::find(bodies_, i) == bodies_.end())
        throw InputError(fmt::format("'{}' moves, and was not measured", scene.bodies[i].name));
    if (chain()) {
      if (const std::string why = no_chain(scene, bodies_); !why.empty())
        throw InputError(fmt::format("the measured bodies are no chain of hinges: {}", why));
      first_angles_ = chain_angles(e.model.scene, e.bodies, run.states.front());
    } else if (joint_of(scene, bodies_[0])) {
      throw InputError(fmt::format("'{}' was measured as a free body, and a joint holds it",
                                   scene.bodies[bodies_[0]].name));
    }
    require_start();
  }

  double rate() const { return e_.rate; }
  std::size_t frames() const { return run_.states.size(); }

  // What was measured in a frame, with errors of its coordinates.
  State seen(std::size_t frame, const VectorXd& by) const {
    const State& state = run_.states[frame];
    if (!chain()) return whole(moved(e_, state, by));
    const Eigen::Index n = by.size() / 2;
    return whole(chain_state(scene_, bodies_,
                             chain_angles(e_.model.scene, e_.bodies, state) - first_angles_ + by.head(n),
                             chain_rates(e_.model.scene, e_.bodies, state) + by.tail(n)));
  }

  // The scene, started with errors of its coordinates.
  Scene started(const VectorXd& by) const {
    Scene made = scene_;
    const State start = core::initial_state(scene_);
    State state;
    if (chain()) {
      const Eigen::Index n = by.size() / 2;
      state = whole(chain_state(scene_, bodies_, by.head(n),
                                chain_rates(scene_, bodies_, measured_part(start)) + by.tail(n)));
    } else {
      state = whole(moved(e_, measured_part(start), by));
    }
    for (std::size_t i = 0; i < state.size(); ++i) made.bodies[i].initial = state[i];
    for (core::Joint& joint : made.joints) joint = core::joint_at(core::held_joint(scene_, joint), state);
    return made;
  }

  const Scene& scene() const { return scene_; }

 private:
  bool chain() const { return e_.coordinates == Coordinates::chain; }

  std::size_t named(const std::string& name) const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
      if (scene_.bodies[i].name == name) return i;
      names.push_back(scene_.bodies[i].name);
    }
    throw InputError(
        fmt::format("the measured body '{}' is not in the scene{}", name, core::did_you_mean(name, names)));
  }

  State measured_part(const State& all) const {
    State part;
    for (const std::size_t i : bodies_) part.push_back(all[i]);
    return part;
  }

  State whole(const State& part) const {
    State all = core::initial_state(scene_);
    for (std::size_t i = 0; i < bodies_.size(); ++i) all[bodies_[i]] = part[i];
    return all;
  }

  // By how much the start that was measured is more than the scene's, in its coordinates.
  VectorXd off() const {
    const State part = measured_part(core::initial_state(scene_)), first = run_.states.front();
    if (chain()) {
      VectorXd all(2 * first_angles_.size());
      const VectorXd turned = first_angles_ - chain_angles(e_.model.scene, e_.bodies, part);
      all << turned.unaryExpr([](double angle) { return std::remainder(angle, 2 * std::numbers::pi); }),
          chain_rates(e_.model.scene, e_.bodies, first) - chain_rates(scene_, bodies_, part);
      return all;
    }
    VectorXd all(12);
    const Eigen::AngleAxisd turn(first[0].orientation * part[0].orientation.conjugate());
    all << first[0].position - part[0].position,
        std::remainder(turn.angle(), 2 * std::numbers::pi) * turn.axis(),
        first[0].velocity - part[0].velocity, first[0].angular_velocity - part[0].angular_velocity;
    return all;
  }

  // That velocities go with the hinges: those of angles and rates alone.
  double against_hinges() const {
    if (!chain()) return 0;
    const State part = measured_part(core::initial_state(scene_));
    const State held = chain_state(scene_, bodies_, VectorXd::Zero(first_angles_.size()),
                                   chain_rates(scene_, bodies_, part));
    double most = 0;
    for (std::size_t i = 0; i < part.size(); ++i)
      most = std::max({most, (part[i].velocity - held[i].velocity).norm() / (1 + held[i].velocity.norm()),
                       (part[i].angular_velocity - held[i].angular_velocity).norm() /
                           (1 + held[i].angular_velocity.norm())});
    return most;
  }

  void require_start() const {
    const VectorXd by = off(), deviation = e_.start.rowwise().norm();
    const bool near = (by.array().abs() <= (deviation.array() / 100).max(1e-9)).all();
    if (near && against_hinges() <= 1e-6) return;
    const Scene needed = started(by);
    std::string text = fmt::format("the scene does not start as run {} does; it needs", run_.name);
    const auto vector = [](const core::Vector3& v) {
      return fmt::format("[{:.10g}, {:.10g}, {:.10g}]", v.x(), v.y(), v.z());
    };
    for (const std::size_t i : bodies_) {
      const BodyState& s = needed.bodies[i].initial;
      text += fmt::format(
          " '{}' position = {}, orientation = [{:.12g}, {:.12g}, {:.12g}, {:.12g}], velocity = {}, "
          "angular_velocity = {}",
          needed.bodies[i].name, vector(s.position), s.orientation.w(), s.orientation.x(), s.orientation.y(),
          s.orientation.z(), vector(s.velocity), vector(s.angular_velocity));
      if (chain()) text += fmt::format(", its hinge point = {}", vector(joint_of(needed, i)->point));
      text += ";";
    }
    text.pop_back();
    throw InputError(text);
  }

  Experiment e_;
  Run run_;
  Scene scene_;
  std::vector<std::size_t> bodies_;  // of the scene
  VectorXd first_angles_;            // of a chain
};

// Standard deviations of what was measured of a state, and for which coordinates.
VectorXd seen_deviations(const Experiment& e) {
  VectorXd all = VectorXd::Zero(coordinates(e));
  if (e.coordinates == Coordinates::chain) {
    all.head(all.size() / 2).setConstant(e.angle_noise);
  } else {
    all.head<3>().setConstant(e.noise);
    all.segment<3>(3).setConstant(e.angle_noise);
  }
  return all;
}

// A pair for each error of the start, and each of a surface.
std::vector<std::pair<Scene, Scene>> errors_of_start(const Experiment& e, const Motion& motion) {
  std::vector<std::pair<Scene, Scene>> all;
  for (Eigen::Index i = 0; i < e.start.cols(); ++i)
    if (const VectorXd by = e.start.col(i); !by.isZero(0))
      all.emplace_back(motion.started(by), motion.started(-by));
  const auto surface = [&](const char* what, double core::Material::*number, double deviation, double most) {
    for (std::size_t m = 0; deviation > 0 && m < motion.scene().materials.size(); ++m) {
      const core::Material& material = motion.scene().materials[m];
      const double up = material.*number + deviation, down = material.*number - deviation;
      if (down < 0 || up > most)
        throw InputError(
            fmt::format("the {} of '{}' and '{}' is {}, and may be off by {}: more than there is", what,
                        material.between[0], material.between[1], material.*number, deviation));
      auto& [above, below] = all.emplace_back(motion.scene(), motion.scene());
      above.materials[m].*number = up, below.materials[m].*number = down;
    }
  };
  surface("friction", &core::Material::friction, e.material.friction,
          std::numeric_limits<double>::infinity());
  surface("restitution", &core::Material::restitution, e.material.restitution, 1);
  return all;
}

void require_uncertainty(const Experiment& e) {
  const bool chain = e.coordinates == Coordinates::chain;
  if (!((chain ? e.angle_noise : e.noise) > 0))
    throw InputError(fmt::format("{}: [uncertainty] states no {}, and what was measured is not exact", e.file,
                                 chain ? "angle_noise" : "noise"));
  if (e.start.isZero(0))
    throw InputError(fmt::format(
        "{}: [uncertainty] states no error of the start, and a run from a measured start is not exact",
        e.file));
}

}  // namespace

core::MeasuredTruth truth(const Experiment& e, const Run& run, const Scene& scene) {
  require_uncertainty(e);
  const auto motion = std::make_shared<const Motion>(e, run, scene);
  const auto frame = [motion](double t) {
    const auto k = static_cast<std::size_t>(std::llround(t * motion->rate()));
    if (k >= motion->frames() || std::abs(static_cast<double>(k) / motion->rate() - t) > 1e-9 * (1 + t))
      throw std::invalid_argument(fmt::format("nothing was measured at {} s", t));
    return k;
  };
  auto uncertainty = std::make_shared<core::Uncertainty>();
  uncertainty->scenes = errors_of_start(e, *motion);
  uncertainty->measured = [=, deviations = seen_deviations(e)](double t) {
    std::vector<std::pair<State, State>> all;
    for (Eigen::Index i = 0; i < deviations.size(); ++i) {
      if (!(deviations[i] > 0)) continue;
      const VectorXd by = deviations[i] * VectorXd::Unit(deviations.size(), i);
      all.emplace_back(motion->seen(frame(t), by), motion->seen(frame(t), -by));
    }
    return all;
  };
  core::Truth made;
  made.state = [=, none = VectorXd(VectorXd::Zero(coordinates(e)))](double t) {
    return motion->seen(frame(t), none);
  };
  made.source = e.source;
  for (std::size_t k = 1; k < run.states.size(); ++k) made.times.push_back(static_cast<double>(k) / e.rate);
  made.horizon = made.times.back();
  made.events_until = 0;
  made.knows_velocity = made.knows_angular_velocity = false;  // no noise of rates is stated
  made.knows_orientation = e.angle_noise > 0;
  return {std::move(made), std::move(uncertainty)};
}

void serve_scenarios() {
  scenario::measured_reader() = [](const scenario::Table& follows, const std::filesystem::path& folder,
                                   const Scene& scene, core::ContentHash& content) {
    thread_local bool reading = false;  // the model of an experiment is a scenario, too
    if (reading) follows.fail("measured", "measured: the model of an experiment follows no measured motion");
    const struct Reading {
      Reading() { reading = true; }
      ~Reading() { reading = false; }
    } now;
    std::optional<Experiment> e;
    try {
      e = read(folder / follows.text("measured"));
    } catch (const InputError& error) {
      follows.fail("measured", error.what());
    }
    content.add(e->hash);
    std::vector<std::string> names;
    for (const Run& run : e->runs) names.push_back(run.name);
    const std::string name = follows.text("run");
    const auto run = std::ranges::find(e->runs, name, &Run::name);
    if (run == e->runs.end())
      follows.fail(
          "run", fmt::format("run = '{}': there is none in {}{}; valid: {} of them, {} to {}", name, e->file,
                             core::did_you_mean(name, names), names.size(), names.front(), names.back()));
    try {
      return truth(*e, *run, scene);
    } catch (const InputError& error) {
      follows.fail("measured", fmt::format("measured: {}", error.what()));
    }
  };
}

}  // namespace cylon::measured
