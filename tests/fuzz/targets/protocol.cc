#include "harness/process/failure.h"
#include "harness/process/json_fields.h"
#include "harness/process/message_reader.h"
#include "harness/process/messages.h"
#include "harness/process/opening.h"
#include "harness/process/run_messages.h"
#include "tests/fuzz/targets/targets.h"

#include <nlohmann/json.hpp>

#include <variant>

namespace cylon::fuzz {
namespace {

using namespace process;

constexpr std::size_t bodies = 2;

const core::Scene& scene() {
  static const core::Scene two = [] {
    core::Scene scene;
    scene.bodies.resize(bodies), scene.planes.resize(1), scene.joints.resize(1);
    return scene;
  }();
  return two;
}

// Every message that an engine may send, told apart by its keys as the harness does.
void take(const nlohmann::json& line, MessageReader& reader) {
  if (line.contains("event")) return void(event_from_json(line));
  if (line.contains("contacts")) return void(constraint_forces_from_json(line, scene()));
  for (const char* key : {"unsupported", "error"})
    if (text_of(line, key)) return;
  const auto ok = line.find("ok");
  if (ok != line.end() && *ok == "hello") return void(hello_from_json(line));
  if (ok != line.end() && *ok == "load") {
    terms_from_json(line);
    reader.expect_bodies(bodies);
    return;
  }
  require_ok(line, "run");
  done_from_json(line);
}

void take(const Frame& frame) {
  if (frame.payload.size() != frame.header.states * bodies * bytes_per_body)
    throw Broken("a frame holds the states that it says");
  core::State state(bodies);
  for (std::size_t at = 0; at < frame.payload.size(); at += bodies * bytes_per_body)
    unpack_state(frame.payload.data() + at, state);
}

}  // namespace

void protocol(std::string_view bytes) {
  MessageReader reader;
  try {
    while (const std::optional<Message> message = reader.read(bytes)) {
      if (const auto* line = std::get_if<nlohmann::json>(&*message))
        take(*line, reader);
      else
        take(std::get<Frame>(*message));
      const std::size_t taken = reader.taken();
      if (taken == 0 || taken > bytes.size()) throw Broken("a message takes bytes of those that came");
      bytes.remove_prefix(taken);
    }
  } catch (const Failure&) {
  } catch (const MalformedMessage&) {
  }
}

}  // namespace cylon::fuzz
