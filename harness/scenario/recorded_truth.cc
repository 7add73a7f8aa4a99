#include "harness/scenario/recorded_truth.h"

#include "harness/core/input_error.h"
#include "harness/input/json.h"
#include "harness/scenario/budget.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <tuple>
#include <unordered_map>

namespace cylon::scenario {
namespace {

using Json = nlohmann::json;

struct Reader {
  const std::string& file;

  [[noreturn]] void fail(const std::string& message) const {
    throw core::InputError(fmt::format("{}: {}", file, message));
  }

  double number(const Json& value, const std::string& where) const {
    double x = std::nan("");
    if (value.is_number()) x = value.get<double>();
    if (value.is_string()) {
      const auto& text = value.get_ref<const std::string&>();
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
      // Beyond double's smallest number from_chars reports a range error; such a decimal is zero here.
      if (error == std::errc::result_out_of_range)
        x = text.find("e-") != std::string::npos ? 0.0 : std::nan("");
      if (end != text.data() + text.size() || error == std::errc::invalid_argument) x = std::nan("");
    }
    if (!std::isfinite(x))
      fail(fmt::format("{} holds {}, which is no finite number", where, input::shown(value)));
    return x;
  }

  const Json& member(const Json& object, const char* key, const std::string& where) const {
    if (!object.is_object() || !object.contains(key)) fail(fmt::format("{} needs '{}'", where, key));
    return object[key];
  }

  std::vector<double> numbers(const Json& array, std::size_t size, const std::string& where) const {
    if (!array.is_array() || array.size() != size) fail(fmt::format("{} must hold {} numbers", where, size));
    std::vector<double> result;
    for (const Json& value : array) result.push_back(number(value, where));
    return result;
  }

  // A key that is misspelt would be ignored, and with it what it says.
  void only(const Json& object, const std::string& where, std::span<const char* const> read,
            std::span<const char* const> told = {}) const {
    if (!object.is_object()) return;  // whoever reads it says so
    for (const auto& [key, value] : object.items()) {
      const std::string& found = key;  // a binding is not captured
      const auto is_key = [&](const char* one) { return found == one; };
      if (std::ranges::any_of(read, is_key) || std::ranges::any_of(told, is_key)) continue;
      fail(fmt::format("unknown key '{}{}' = {}{}; valid: {}", where, key, input::shown(value),
                       core::did_you_mean(key, std::vector<std::string>(read.begin(), read.end())),
                       fmt::join(read, ", ")));
    }
  }

  // One column of a trajectory, a row of `width` numbers per time; empty where the file has none.
  std::vector<std::vector<double>> column(const Json& body, const char* key, std::size_t times,
                                          std::size_t width, const std::string& where) const {
    if (!body.contains(key)) return {};
    const std::string name = where + "." + key;
    if (!body[key].is_array() || body[key].size() != times)
      fail(fmt::format("{} must hold {} rows, one per time", name, times));
    std::vector<std::vector<double>> rows;
    for (const Json& row : body[key])
      rows.push_back(numbers(row, width, fmt::format("{}[{}]", name, rows.size())));
    return rows;
  }
};

// What is read, and what files say of themselves beside it.
constexpr const char* root_read[] = {"schema", "t", "bodies", "trajectory", "events", "agreement"};
constexpr const char* root_told[] = {
    "name",     "source",       "note",        "set",      "kind",           "model",
    "frame",    "params",       "methods",     "horizon",  "forces",         "system",
    "rigorous", "conditioning", "constraints", "contacts", "characteristic", "bounces_so_far"};
constexpr const char* agreement_read[] = {"max_abs_diff"};
constexpr const char* agreement_told[] = {"digits"};
constexpr const char* body_read[] = {"position", "velocity", "orientation", "angular_velocity"};
constexpr const char* body_told[] = {"linear_momentum", "angular_momentum", "kinetic_energy", "mass"};
constexpr const char* event_read[] = {"kind",  "body",   "to",       "plane", "time",
                                      "speed", "height", "distance", "angle", "azimuth"};

Json parsed(std::string_view text, const Reader& reader) {
  try {
    Json root = input::parse_json(text);
    input::require_unique_keys(text);
    return root;
  } catch (const input::BadJson& error) {
    reader.fail(error.what());
  }
}

std::vector<double> read_times(const Reader& reader, const Json& root) {
  const Json& t = reader.member(root, "t", "the file");
  if (!t.is_array() || t.empty()) reader.fail("'t' must be an array of times");
  std::vector<double> times;
  for (const Json& value : t) {
    times.push_back(reader.number(value, "t"));
    if (times.back() < 0 || (times.size() > 1 && times.back() <= times[times.size() - 2]))
      reader.fail(fmt::format("t = {}: times must ascend from 0 or later", times.back()));
  }
  return times;
}

// Indices by name of the scene's bodies or planes.
class Names {
 public:
  explicit Names(const auto& elements) {
    for (const auto& element : elements) {
      index_.emplace(element.name, static_cast<int>(names_.size()));
      names_.push_back(element.name);
    }
  }

  std::size_t size() const { return names_.size(); }
  std::optional<int> find(const std::string& name) const {
    const auto found = index_.find(name);
    return found == index_.end() ? std::nullopt : std::optional(found->second);
  }
  std::string did_you_mean(const std::string& name) const { return core::did_you_mean(name, names_); }

 private:
  std::vector<std::string> names_;
  std::unordered_map<std::string, int> index_;
};

struct SceneNames {
  Names bodies, planes;
};

// Index of the scene's body that an id of the file means.
std::size_t find_body(const Reader& reader, const Names& bodies, const std::string& id, std::size_t ids) {
  if (bodies.size() == 1 && ids == 1) return 0;
  if (const auto found = bodies.find(id)) return static_cast<std::size_t>(*found);
  reader.fail(fmt::format("body '{}' is not in the scene{}", id, bodies.did_you_mean(id)));
}

void read_body(const Reader& reader, const Json& rows, const std::string& where, std::size_t body,
               std::vector<core::State>& states, core::Truth& truth) {
  const std::size_t n = states.size();
  reader.only(rows, where + ".", body_read, body_told);
  const auto p = reader.column(rows, "position", n, 3, where),
             v = reader.column(rows, "velocity", n, 3, where);
  const auto q = reader.column(rows, "orientation", n, 4, where),
             w = reader.column(rows, "angular_velocity", n, 3, where);
  if (p.empty()) reader.fail(where + " needs 'position'");
  truth.knows_velocity &= !v.empty();
  truth.knows_orientation &= !q.empty();
  truth.knows_angular_velocity &= !w.empty();
  for (std::size_t i = 0; i < n; ++i) {
    core::BodyState& s = states[i][body];
    s.position = {p[i][0], p[i][1], p[i][2]};
    if (!v.empty()) s.velocity = {v[i][0], v[i][1], v[i][2]};
    if (!w.empty()) s.angular_velocity = {w[i][0], w[i][1], w[i][2]};
    if (q.empty()) continue;
    s.orientation = {q[i][0], q[i][1], q[i][2], q[i][3]};
    if (!(std::abs(s.orientation.norm() - 1) < 1e-6))
      reader.fail(fmt::format("{}.orientation: row {} is no unit quaternion", where, i));
    s.orientation.normalize();
  }
}

// Index of the body or plane that a word of an event names.
int find_named(const Reader& reader, const Names& names, const Json& word, const std::string& where) {
  if (!word.is_string()) reader.fail(where + " must name a body");
  const std::string name = word.get<std::string>();
  if (const auto found = names.find(name)) return *found;
  reader.fail(fmt::format("{} = '{}' is not in the scene{}", where, name, names.did_you_mean(name)));
}

core::Event read_event(const Reader& reader, const Json& row, const SceneNames& names) {
  const auto types = core::event_types();
  const Json& kind = reader.member(row, "kind", "each of 'events'");
  const auto type = std::find_if(types.begin(), types.end(),
                                 [&](const core::EventType& one) { return kind == std::string(one.name); });
  if (type == types.end()) {
    std::vector<std::string> valid;
    for (const core::EventType& one : types) valid.emplace_back(one.name);
    reader.fail(fmt::format("events: kind = {}, valid: {}", input::shown(kind), fmt::join(valid, ", ")));
  }
  core::Event event;
  event.kind = type->kind;
  event.pair.body =
      find_named(reader, names.bodies, reader.member(row, "body", "each of 'events'"), "events.body");
  if (row.contains("to")) event.pair.other = find_named(reader, names.bodies, row["to"], "events.to");
  if (row.contains("plane"))
    event.pair.plane = find_named(reader, names.planes, row["plane"], "events.plane");
  event.time = reader.number(reader.member(row, "time", "each of 'events'"), "events.time");
  const auto optional = [&](const char* key) {
    return row.contains(key) ? reader.number(row[key], fmt::format("events.{}", key)) : std::nan("");
  };
  event.speed = optional("speed"), event.height = optional("height"), event.distance = optional("distance");
  event.angle = optional("angle"), event.azimuth = optional("azimuth");
  return event;
}

// Counted per kind and pair, in order of time.
std::vector<core::Event> read_events(const Reader& reader, const Json& root, const SceneNames& names,
                                     double until) {
  std::vector<core::Event> events;
  if (!root.contains("events")) return events;
  if (!root["events"].is_array()) reader.fail("'events' must be an array");
  if (root["events"].size() > budget::data_events)
    reader.fail(fmt::format("'events' has {} rows, but at most {} are read", root["events"].size(),
                            budget::data_events));
  std::map<std::tuple<core::EventKind, int, int, int>, int> counts;
  for (const Json& row : root["events"]) {
    if (!row.contains("kind") && row.contains("t"))
      continue;  // a note in words of its own, {"type": …, "t": …}
    reader.only(row, "events.", event_read);
    core::Event event = read_event(reader, row, names);
    if (!(event.time >= 0 && event.time <= until * (1 + 1e-9)))
      reader.fail(
          fmt::format("events: time = {} is not within [0, {}] s, the times of the file", event.time, until));
    if (!events.empty() && event.time < events.back().time)
      reader.fail(fmt::format("events: time = {} comes after {}", event.time, events.back().time));
    int& count = counts[{event.kind, event.pair.body, event.pair.other, event.pair.plane}];
    event.index = core::event_type(event.kind).first_index + count++;
    events.push_back(event);
  }
  return events;
}

// The bound on every component that the file states; 0 where it states none.
double read_difference(const Reader& reader, const Json& root) {
  if (!root.contains("agreement")) return 0;
  const Json& agreement = root["agreement"];
  if (!agreement.is_object())
    reader.fail(fmt::format("agreement = {} must be an object", input::shown(agreement)));
  reader.only(agreement, "agreement.", agreement_read, agreement_told);
  if (!agreement.contains("max_abs_diff")) return 0;
  const Json& bound = agreement["max_abs_diff"];
  const double difference = reader.number(bound, "agreement.max_abs_diff");
  if (difference < 0)
    reader.fail(fmt::format("agreement.max_abs_diff = {} must be >= 0", input::shown(bound)));
  return difference;
}

// Each component is off by at most `difference` plus double's rounding; a vector has three, a quaternion
// four, and an orientation's angle is twice its quaternion's distance.
core::StateError error_of(const std::vector<core::State>& states, double difference) {
  core::Vector3 largest = core::Vector3::Zero();  // position, velocity, angular velocity
  for (const core::State& state : states)
    for (const core::BodyState& s : state)
      largest =
          largest.cwiseMax(core::Vector3(s.position.norm(), s.velocity.norm(), s.angular_velocity.norm()));
  constexpr double half_ulp = 0x1p-53;
  const auto vector = [&](double size) { return std::sqrt(3.0) * difference + half_ulp * size; };
  return {vector(largest[0]), vector(largest[1]), 2 * (2 * difference + 4 * half_ulp), vector(largest[2]), 0};
}

}  // namespace

core::Truth parse_truth(std::string_view json, const std::string& file, const core::Scene& scene) {
  const Reader reader{file};
  const Json root = parsed(json, reader);
  const Json& schema = reader.member(root, "schema", "the file");
  if (schema != "truth/1") reader.fail(fmt::format("schema = {}, valid: \"truth/1\"", input::shown(schema)));
  reader.only(root, "", root_read, root_told);

  const SceneNames names{Names(scene.bodies), Names(scene.planes)};
  auto times = std::make_shared<std::vector<double>>(read_times(reader, root));
  if (times->size() * scene.bodies.size() > budget::data_states)
    reader.fail(fmt::format("'t' has {} times, and the scene {} bodies, but at most {} states are kept",
                            times->size(), scene.bodies.size(), budget::data_states));
  auto states = std::make_shared<std::vector<core::State>>(times->size(), core::initial_state(scene));
  const Json& bodies = reader.member(root, "bodies", "the file");
  const Json& trajectory = reader.member(root, "trajectory", "the file");
  if (!bodies.is_array()) reader.fail("'bodies' must be an array");
  core::Truth truth;
  std::vector<bool> known(scene.bodies.size(), false);
  std::set<std::string> ids;
  for (const Json& entry : bodies) {
    const Json& id = reader.member(entry, "id", "each of 'bodies'");
    if (!id.is_string()) reader.fail("each 'id' must be a string");
    const std::string name = id.get<std::string>();
    const std::size_t body = find_body(reader, names.bodies, name, bodies.size());
    if (known[body]) reader.fail(fmt::format("'bodies' has {} twice", input::shown(id)));
    read_body(reader, reader.member(trajectory, name.c_str(), "trajectory"), "trajectory." + name, body,
              *states, truth);
    known[body] = true;
    ids.insert(name);
  }
  if (!trajectory.is_object()) reader.fail("'trajectory' must be an object");
  for (const auto& [id, rows] : trajectory.items())
    if (!ids.contains(id))
      reader.fail(fmt::format("unknown key 'trajectory.{}': 'bodies' has no such id", id));
  for (std::size_t i = 0; i < known.size(); ++i)
    if (!known[i] && !scene.bodies[i].locked)
      reader.fail(fmt::format("has no trajectory of body '{}'", scene.bodies[i].name));

  const double difference = read_difference(reader, root);
  truth.times = *times;
  truth.horizon = times->back();
  if (!root.contains("events")) truth.events_until = 0;
  truth.error = error_of(*states, difference);
  truth.source = "recorded: " + file;
  truth.events = read_events(reader, root, names, times->back());
  truth.error.time = difference + 0x1p-53 * truth.horizon;
  truth.state = [times, states](double t) {
    const auto next = std::lower_bound(times->begin(), times->end(), t - 1e-9 * (1 + std::abs(t)));
    if (next == times->end() || std::abs(*next - t) > 1e-9 * (1 + std::abs(t)))
      throw std::invalid_argument(fmt::format("the recorded truth is not known at t = {} s", t));
    return (*states)[static_cast<std::size_t>(next - times->begin())];
  };
  return truth;
}

}  // namespace cylon::scenario
