#include "harness/view/command.h"

#include "harness/process/json_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace cylon::view {
namespace {

using nlohmann::json;
using process::Fields;

constexpr double largest = 1e9;                  // of any number
constexpr double slowest = 0.01, fastest = 100;  // speeds
constexpr std::size_t longest_text = 200;        // [bytes]

double number(Fields& f, const char* key) {
  const double x = f.number(key);
  if (!(std::abs(x) <= largest))
    f.fail(key, fmt::format("{} must be a number of at most {:g} in size", x, largest));
  return x;
}

core::Vector3 vector(Fields& f, const char* key) {
  const core::Vector3 v = f.vector(key);
  if (!(v.cwiseAbs().maxCoeff() <= largest))
    f.fail(key, fmt::format("[{}, {}, {}] must be three numbers of at most {:g} in size", v.x(), v.y(), v.z(),
                            largest));
  return v;
}

std::string text(Fields& f, const char* key) {
  std::string s = f.text(key);
  if (s.size() > longest_text) f.fail(key, fmt::format("must have at most {} bytes", longest_text));
  return s;
}

Command speed(Fields& f) {
  const double value = number(f, "value");
  if (!(value >= slowest && value <= fastest))
    f.fail("value", fmt::format("{} must be a speed between {} and {}", value, slowest, fastest));
  return Speed{value};
}

Command pull(Fields& f) {
  const double stiffness = number(f, "stiffness");
  if (!(stiffness > 0)) f.fail("stiffness", fmt::format("{} must be positive", stiffness));
  return Pull{f.index("body"), vector(f, "anchor"), vector(f, "pin"), stiffness};
}

Command lanes(Fields& f) {
  Lanes result;
  f.each("lanes", [&](const json& row, const std::string& place) {
    Fields lane(row, place);
    result.lanes.push_back({text(lane, "engine"), text(lane, "integrator"), text(lane, "dt_text")});
    lane.finish();
  });
  if (result.lanes.empty() || result.lanes.size() > most_lanes)
    f.fail("lanes",
           fmt::format("{} must be a number of lanes between 1 and {}", result.lanes.size(), most_lanes));
  return result;
}

Command set(Fields& f) {
  Set result{text(f, "key"), 0.0};
  if (f.at("value").is_array())
    result.value = vector(f, "value");
  else
    result.value = number(f, "value");
  return result;
}

// Named constructors in place of lambdas: a row each.
Command play(Fields&) { return Play{}; }
Command pause(Fields&) { return Pause{}; }
Command step(Fields&) { return StepOnce{}; }
Command reset(Fields&) { return Reset{}; }
Command kick(Fields& f) {
  Kick result{f.index("body"), vector(f, "impulse")};
  if (f.find("angular_impulse")) result.angular_impulse = vector(f, "angular_impulse");
  return result;
}
Command release(Fields&) { return Release{}; }

}  // namespace

Command parse_command(std::string_view line) {
  static const std::map<std::string, Command (*)(Fields&), std::less<>> rows = {
      {"play", play}, {"pause", pause}, {"step", step},       {"reset", reset}, {"speed", speed},
      {"kick", kick}, {"pull", pull},   {"release", release}, {"lanes", lanes}, {"set", set}};
  try {
    const json value = process::parse_object(line);
    Fields f(value, "");
    const std::string what = text(f, "do");
    const auto row = rows.find(what);
    if (row == rows.end()) f.fail("do", fmt::format("'{}' is no command", what));
    Command command = row->second(f);
    f.finish();
    return command;
  } catch (const process::MalformedMessage& error) {
    throw BadCommand(error.what());
  }
}

}  // namespace cylon::view
