#include "harness/cli/commands/drawing_json.h"

#include "harness/cli/commands/estimates.h"
#include "harness/process/scene_json.h"
#include "harness/validation/curves.h"
#include "harness/validation/kinematics.h"
#include "harness/validation/length_scale.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace cylon::cli {
namespace {

using nlohmann::ordered_json;
using validation::Drawing;

constexpr std::size_t most_frames = 300;

std::size_t every_of(std::size_t frames) { return (frames + most_frames - 1) / most_frames; }

ordered_json rounded(double x) { return number(std::round(x * 1e7) / 1e7); }

// A list for each column.
ordered_json columns(const Eigen::MatrixXd& values) {
  const std::size_t frames = static_cast<std::size_t>(values.rows()), every = every_of(frames);
  ordered_json all = ordered_json::array();
  for (Eigen::Index k = 0; k < values.cols(); ++k) {
    ordered_json& column = all.emplace_back(ordered_json::array());
    for (std::size_t i = 0; i < frames; i += every)
      column.push_back(rounded(values(static_cast<Eigen::Index>(i), k)));
  }
  return all;
}

ordered_json list(std::span<const double> values, std::size_t every) {
  ordered_json all = ordered_json::array();
  for (std::size_t i = 0; i < values.size(); i += every) all.push_back(rounded(values[i]));
  return all;
}

// Frame after frame, body after body: x, y, z and w, x, y, z.
ordered_json motion(const std::vector<core::State>& states) {
  ordered_json position = ordered_json::array(), orientation = ordered_json::array();
  for (std::size_t i = 0; i < states.size(); i += every_of(states.size()))
    for (const core::BodyState& s : states[i]) {
      for (const double x : s.position) position.push_back(rounded(x));
      for (const double x : {s.orientation.w(), s.orientation.x(), s.orientation.y(), s.orientation.z()})
        orientation.push_back(rounded(x));
    }
  return {{"position", position}, {"orientation", orientation}};
}

}  // namespace

ordered_json measured_json(const measured::Experiment& e, std::span<const std::size_t> runs) {
  ordered_json all = ordered_json::array();
  for (const std::size_t i : runs) {
    const std::vector<core::State>& states = e.runs[i].states;
    std::vector<double> time;
    for (std::size_t k = 0; k < states.size(); ++k) time.push_back(static_cast<double>(k) / e.rate);
    const std::size_t every = every_of(states.size());
    ordered_json one = {{"run", e.runs[i].name},
                        {"every", every},
                        {"time", list(time, every)},
                        {"measured", columns(validation::curves(e, states, states.front()))}};
    if (e.coordinates == measured::Coordinates::free)
      one["off_the_fall"] = list(validation::off_the_fall(e, i), every);
    all.push_back(one);
  }
  return {{"names", validation::curve_names(e)}, {"unit", validation::curve_unit(e)}, {"runs", all}};
}

ordered_json to_json(const Drawing& d) {
  ordered_json one = {{"run", d.run}, {"failure", d.failure}};
  if (!d.failure.empty()) return one;
  one["predicted"] = columns(d.predicted);
  one["low"] = columns(d.band.low), one["high"] = columns(d.band.high);
  one["turn"] = list(d.turn, every_of(d.turn.size()));
  one["scene"] = process::to_json(d.scene);
  one["predicted_motion"] = motion(d.poses), one["measured_motion"] = motion(d.seen);
  return one;
}

ordered_json kinematics_json(const measured::Experiment& e) {
  const validation::Kinematics of = validation::kinematics(e);
  const auto one = [](const validation::Estimate& slope) {
    ordered_json all = to_json(slope);
    all["goes_together"] = validation::name(validation::goes_together(slope));
    return all;
  };
  return {{"velocity", one(of.velocity)}, {"spin", one(of.spin)}};
}

ordered_json lengths_json(const measured::Experiment& e) {
  const validation::LengthScale lengths = validation::length_scale(e);
  ordered_json each = ordered_json::array();
  for (const validation::RunLengths& run : lengths.each)
    each.push_back({{"run", run.run},
                    {"flight", number(run.flight)},
                    {"roughness", number(run.roughness)},
                    {"height", number(run.height)},
                    {"half", number(run.half)},
                    {"tilt", number(run.tilt)},
                    {"side", run.side}});
  return {{"flight", to_json(lengths.flight)}, {"rest", to_json(lengths.rest)},
          {"height", to_json(lengths.height)}, {"tilt", number(lengths.tilt)},
          {"gravity", lengths.gravity},        {"each", each}};
}

}  // namespace cylon::cli
