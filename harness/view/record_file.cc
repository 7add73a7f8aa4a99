#include "harness/view/record_file.h"

#include "harness/core/input_error.h"
#include "harness/process/vector_json.h"
#include "harness/view/scenario_text.h"
#include "harness/view/toml.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <string>

namespace cylon::view {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Json = nlohmann::ordered_json;

// Of distances and angles that any motion has: far more than the same engine's repetition is off, far less
// than the eye sees.
constexpr double part = 1e-6;

json rows(const std::vector<core::State>& states, std::size_t body, json (*row)(const core::BodyState&)) {
  json result = json::array();
  for (const core::State& state : states) result.push_back(row(state[body]));
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
    trajectory[name] = {
        {"position",
         rows(states, i, [](const core::BodyState& s) { return process::vector_json(s.position); })},
        {"velocity",
         rows(states, i, [](const core::BodyState& s) { return process::vector_json(s.velocity); })},
        {"angular_velocity",
         rows(states, i, [](const core::BodyState& s) { return process::vector_json(s.angular_velocity); })},
        {"orientation",
         rows(states, i, [](const core::BodyState& s) { return process::quaternion_json(s.orientation); })}};
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

Json claim(const char* observable, const std::string& data, double absolute, const LaneSpec& spec) {
  const std::string integrator =
      spec.integrator.empty() ? spec.engine : fmt::format("{} ({})", spec.engine, spec.integrator);
  const std::string reason = fmt::format(
      "convention: {:g} of what moves; {} at a step of {} s repeats its own motion to rounding, and another "
      "engine shows here where it departs",
      part, integrator, spec.dt_text);
  return {{"follows", {{"file", data}}},
          {"observable", observable},
          {"tolerance", {{"absolute", absolute}, {"reason", reason}}}};
}

std::string scenario_text(const Recorder& recorder, const scenario::Scenario& from, const std::string& data) {
  const LaneSpec& spec = recorder.spec();
  Json document = {{"title", from.title + " (recorded)"},
                   {"story", fmt::format("{} Recorded in the live viewer with {}.", from.story, spec.engine)},
                   {"tags", {"recorded"}},
                   {"duration", static_cast<double>(recorder.last_step()) * recorder.dt()},
                   {"step", spec.dt_text}};
  document.update(scene_keys(recorder.scene()));
  document["claim"] = {claim("position", data, part * std::max(1.0, farthest(recorder)), spec),
                       claim("orientation", data, part, spec)};
  return to_toml(document);
}

void write(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw core::InputError(fmt::format("{}: cannot be written", path.string()));
}

// The name itself, or with the first number that is free.
fs::path free_name(const fs::path& file) {
  fs::path path = file;
  std::error_code ignored;
  for (int i = 2; fs::exists(path, ignored); ++i) {
    path = file;
    path.replace_filename(fmt::format("{}-{}.toml", file.stem().string(), i));
  }
  return path;
}

}  // namespace

fs::path save_recording(const Recorder& recorder, const scenario::Scenario& from, const fs::path& file) {
  const fs::path path = free_name(file);
  fs::path data = path;
  data.replace_extension(".json");
  write(data, motion(recorder).dump());
  try {
    const std::string text = scenario_text(recorder, from, data.filename().string());
    scenario::parse(text, path.string());
    write(path, text);
  } catch (const core::InputError& error) {
    std::error_code ignored;
    fs::remove(data, ignored);
    throw core::InputError(fmt::format("not recorded: {}", error.what()));
  }
  return path;
}

}  // namespace cylon::view
