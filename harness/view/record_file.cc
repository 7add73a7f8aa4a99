#include "harness/view/record_file.h"

#include "harness/core/fields.h"
#include "harness/core/input_error.h"
#include "harness/process/vector_json.h"
#include "harness/scenario/writer.h"
#include "harness/view/whole_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace cylon::view {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using scenario::toml_number, scenario::toml_text;

// Of distances and angles that any motion has: far more than the same engine's repetition is off, far less
// than the eye sees.
constexpr double part = 1e-6;

json row(const core::Vector3& v) { return process::vector_json(v); }
json row(const core::Quaternion& q) { return process::quaternion_json(q); }

// One body's motion: an array over time for each of its variables.
json trajectory_of(std::size_t body, const std::vector<core::State>& states) {
  json result;
  for (const core::State& state : states)
    core::for_each_field(
        state[body], [&](const auto& field, const auto& value) { result[field.key].push_back(row(value)); });
  return result;
}

json motion(const Recorder& recorder) {
  std::vector<core::State> states = recorder.states();
  json times = json::array();
  for (const std::int64_t step : recorder.steps()) times.push_back(static_cast<double>(step) * recorder.dt());
  if (recorder.steps().back() != recorder.last_step()) {
    times.push_back(static_cast<double>(recorder.last_step()) * recorder.dt());
    states.push_back(recorder.last_state());
  }
  json bodies = json::array(), trajectory = json::object();
  for (std::size_t i = 0; i < recorder.scene().bodies.size(); ++i) {
    const std::string& name = recorder.scene().bodies[i].name;
    bodies.push_back({{"id", name}});
    trajectory[name] = trajectory_of(i, states);
  }
  return {{"schema", "truth/1"},
          {"t", std::move(times)},
          {"bodies", std::move(bodies)},
          {"trajectory", std::move(trajectory)}};
}

double farthest(const Recorder& recorder) {
  double most = 0;
  for (const core::State& state : recorder.states())
    for (const core::BodyState& s : state) most = std::max(most, s.position.norm());
  return most;
}

std::string claim(const char* observable, const std::string& data, double absolute, const LaneSpec& spec) {
  const std::string engine =
      spec.integrator.empty() ? spec.engine : fmt::format("{} ({})", spec.engine, spec.integrator);
  const std::string reason = fmt::format(
      "convention: {:g} of what moves; {} at a step of {} s repeats its own motion to rounding, and another "
      "engine shows here where it departs",
      part, engine, spec.dt_text);
  return fmt::format(
      "\n[[claim]]\nfollows = {{file = {}}}\nobservable = \"{}\"\ntolerance = {{absolute = {}, reason = "
      "{}}}\n",
      toml_text(data), observable, toml_number(absolute), toml_text(reason));
}

std::string scenario_text(const Recorder& recorder, const scenario::Scenario& from, const std::string& data) {
  const LaneSpec& spec = recorder.spec();
  const std::string story = fmt::format("{} Recorded in the live viewer with {}.", from.story, spec.engine);
  return fmt::format("title = {}\nstory = {}\ntags = [\"recorded\"]\nduration = {}\nstep = {}\n",
                     toml_text(from.title + " (recorded)"), toml_text(story),
                     toml_number(static_cast<double>(recorder.last_step()) * recorder.dt()),
                     toml_text(spec.dt_text)) +
         scenario::to_toml(recorder.scene()) +
         claim("position", data, part * std::max(1.0, farthest(recorder)), spec) +
         claim("orientation", data, part, spec);
}

// Also of a link that leads nowhere.
bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

fs::path data_of(fs::path scenario) { return scenario.replace_extension(".json"); }

// The name itself, or with the first number that is free.
fs::path free_name(const fs::path& file) {
  fs::path path = file;
  for (int i = 2; is_there(path) || is_there(data_of(path)); ++i) {
    path = file;
    path.replace_filename(fmt::format("{}-{}.toml", file.stem().string(), i));
  }
  return path;
}

}  // namespace

fs::path save_recording(const Recorder& recorder, const scenario::Scenario& from, const fs::path& file) {
  const fs::path path = free_name(file);
  const fs::path data = data_of(path);
  write_whole_file(data, motion(recorder).dump());
  try {
    const std::string text = scenario_text(recorder, from, data.filename().string());
    scenario::parse(text, path.string());
    write_whole_file(path, text);
  } catch (const core::InputError& error) {
    std::error_code ignored;
    fs::remove(data, ignored);
    throw core::InputError(fmt::format("not recorded: {}", error.what()));
  }
  return path;
}

}  // namespace cylon::view
