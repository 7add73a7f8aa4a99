#include "harness/view/viewer_messages.h"

#include "harness/core/observable.h"
#include "harness/process/scene_json.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace cylon::view {
namespace {

using nlohmann::json;

static_assert(std::endian::native == std::endian::little, "numbers are copied, not converted");

constexpr std::size_t most_contacts = 1000;  // of a lane: more than a picture shows

template <class T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string framed(const std::string& header, const std::string& payload) {
  std::string frame;
  frame.reserve(8 + header.size() + payload.size());
  append(frame, static_cast<std::uint32_t>(header.size()));
  append(frame, static_cast<std::uint32_t>(payload.size()));
  return frame + header + payload;
}

std::string text_of(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

json lane_json(const LaneSpec& spec) {
  return {{"engine", spec.engine}, {"integrator", spec.integrator}, {"dt_text", spec.dt_text}};
}

// JSON has no NaN.
std::string number(double x) { return std::isfinite(x) ? fmt::format("{}", x) : "null"; }
// Of what is only drawn: seven digits, as float32 has.
std::string short_vector(const core::Vector3& v) {
  return fmt::format("[{:.7g},{:.7g},{:.7g}]", v.x(), v.y(), v.z());
}

Eigen::Vector4d total(core::Quantity quantity, const Lane& lane) {
  core::Values values;
  core::evaluate({.quantity = quantity}, lane.scene(), lane.state(), values);
  return values.empty() ? Eigen::Vector4d(Eigen::Vector4d::Zero()) : values.front();
}

std::string vector(const Eigen::Vector4d& v) {
  return fmt::format("[{},{},{}]", number(v[0]), number(v[1]), number(v[2]));
}

std::string contacts(const Lane& lane) {
  std::string text = "[";
  std::size_t count = 0;
  for (const core::Contact& c : lane.contacts()) {
    if (count == most_contacts) break;
    const std::string impulse =
        c.impulse && std::isfinite(*c.impulse) ? fmt::format("{:.7g}", *c.impulse) : "null";
    fmt::format_to(std::back_inserter(text),
                   R"({}{{"body":{},"other":{},"point":{},"normal":{},"impulse":{}}})",
                   count++ == 0 ? "" : ",", c.pair.body, c.pair.other, short_vector(c.point),
                   short_vector(c.normal), impulse);
  }
  return text + "]";
}

std::string lane_state(const Lane& lane) {
  constexpr const char* words[] = {"running", "failed", "unsupported"};  // in the order of Lane::Status
  return fmt::format(
      R"({{"status":"{}","reason":{},"energy":{},"momentum":{},"angular_momentum":{},"contacts":{},"cpu_per_second":{}}})",
      words[static_cast<std::size_t>(lane.status())], text_of(lane.reason()),
      number(total(core::Quantity::energy, lane)[0]), vector(total(core::Quantity::linear_momentum, lane)),
      vector(total(core::Quantity::angular_momentum, lane)), contacts(lane),
      lane.cost() ? number(*lane.cost()) : "null");
}

void append_state(std::string& payload, const core::State& state) {
  for (const core::BodyState& s : state) {
    const core::Vector3 &p = s.position, &v = s.velocity, &w = s.angular_velocity;
    const core::Quaternion& q = s.orientation;
    for (const double x :
         {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z(), v.x(), v.y(), v.z(), w.x(), w.y(), w.z()})
      append(payload, static_cast<float>(x));
  }
}

}  // namespace

json session_json(const Session& session) {
  json engines = json::array(), lanes = json::array();
  for (const EngineInfo& e : session.options().engines)
    engines.push_back({{"id", e.id}, {"version", e.version}, {"integrators", e.integrators}});
  for (const auto& lane : session.lanes()) lanes.push_back(lane_json(lane->spec()));
  const scenario::Scenario& about = session.scenario();
  return {{"scenario", about.name},
          {"title", about.title},
          {"story", about.story},
          {"duration", about.duration},
          {"scene", process::to_json(session.scene())},
          {"engines", std::move(engines)},
          {"lanes", std::move(lanes)},
          {"playing", session.playing()},
          {"speed", session.speed()},
          {"recording", session.options().recording}};
}

std::string session_message(const Session& session) {
  return framed(text_of({{"type", "session"}, {"session", session_json(session)}}), "");
}

std::string state_message(const Session& session) {
  std::string lanes, payload;
  for (const auto& lane : session.lanes()) {
    lanes += (lanes.empty() ? "" : ",") + lane_state(*lane);
    append_state(payload, lane->state());
  }
  std::string pulls;
  if (const auto pull = session.pull())
    pulls = fmt::format(R"({{"body":{},"pin":[{},{},{}]}})", pull->body, number(pull->pin.x()),
                        number(pull->pin.y()), number(pull->pin.z()));
  return framed(fmt::format(R"({{"type":"state","t":{},"playing":{},"speed":{},"lanes":[{}],"pulls":[{}]}})",
                            number(session.time()), session.playing(), number(session.speed()), lanes, pulls),
                payload);
}

}  // namespace cylon::view
