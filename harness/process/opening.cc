#include "harness/process/opening.h"

#include "harness/core/input_error.h"
#include "harness/core/later_parts.h"
#include "harness/process/json_fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace cylon::process {
namespace {

using nlohmann::json;

[[noreturn]] void broken(const std::string& reason) { throw Failure(results::Status::protocol, reason); }

core::Setup merged(const EngineChoice& choice, core::Setup setup) {
  if (!choice.path.empty()) setup.path = choice.path;
  if (!choice.integrator.empty()) setup.integrator = choice.integrator;
  for (const auto& [name, value] : choice.options) setup.options[name] = value;
  return setup;
}

/// A worker that knows no tolerance would run without one and say nothing.
void require_adaptive(const core::Engine& engine, const std::string& id, const core::Setup& setup) {
  if (setup.tolerance == 0) return;
  std::vector<std::string> adaptive;
  for (const core::Integrator& integrator : engine.integrators) {
    if (!integrator.adaptive) continue;
    const bool is_default = setup.integrator.empty() && &integrator == &engine.integrators.front();
    if (is_default || integrator.name == setup.integrator) return;
    adaptive.push_back(integrator.name);
  }
  if (adaptive.empty())
    throw core::InputError(fmt::format(
        "engine '{}' has no integrator with error control, so it takes a step and no tolerance", id));
  throw core::InputError(fmt::format(
      "engine '{}': {} does not control its error, so it takes a step and no tolerance (integrators that do: "
      "{})",
      id,
      setup.integrator.empty() ? "its default integrator" : fmt::format("integrator '{}'", setup.integrator),
      fmt::join(adaptive, ", ")));
}

// A worker that cannot start is unsupported: of an optional engine, by a library that was there when it was built.
json answer_to_hello(Conversation& worker, const EngineRow& row, double seconds) try {
  worker.ask({{"cmd", "hello"}, {"protocol", protocol_version}}, seconds);
  return worker.next_line();
} catch (const Failure& failure) {
  if (failure.status != results::Status::unsupported || !row.optional()) throw;
  throw Failure(failure.status, fmt::format("{}; `{}` brings what it needs", failure.what(), row.brought_by));
}

}  // namespace

std::optional<std::string> text_of(const json& answer, const char* key) {
  if (!answer.contains(key)) return std::nullopt;
  Fields fields(answer, "");
  std::string text = fields.text(key);
  fields.finish();
  constexpr std::size_t most = 1000;  // [bytes]; it stands in every row of the cell
  if (text.size() > most) text = text.substr(0, most) + "…";
  return text;
}

void require_ok(const json& answer, const char* what) {
  const auto ok = answer.find("ok");
  if (ok == answer.end() || *ok != what) broken(fmt::format("expected {{\"ok\":\"{}\"}}", what));
}

std::vector<std::string> command_of(const EngineRow& row) {
  if (const auto reason = missing(row)) throw Failure(results::Status::unsupported, *reason);
  std::vector<std::string> command = row.started_by;
  command.insert(command.end(), row.command.begin(), row.command.end());
  return command;
}

Hello introduce(Conversation& worker, const EngineRow& row, double seconds) {
  const json answer = answer_to_hello(worker, row, seconds);
  if (const auto reason = text_of(answer, "unsupported"))
    throw Failure(results::Status::unsupported, *reason);
  if (const auto reason = text_of(answer, "error")) broken("hello was refused: " + *reason);
  require_ok(answer, "hello");
  return hello_from_json(answer);
}

core::Terms open_scene(Conversation& worker, const EngineChoice& choice, const core::Scene& scene,
                       const core::Setup& asked, const core::Engine& engine, double seconds) {
  const core::Setup setup = merged(choice, asked);
  require_adaptive(engine, choice.id, setup);
  if (const auto reason = core::not_known(engine, scene)) throw Refused(*reason);
  worker.ask(load_request(scene, setup), seconds);
  const json answer = worker.next_line();
  if (const auto reason = text_of(answer, "unsupported")) throw Refused(*reason);
  if (const auto reason = text_of(answer, "error"))
    throw core::InputError(fmt::format("engine '{}': {}", choice.id, *reason));
  require_ok(answer, "load");
  worker.expect_bodies(scene.bodies.size());
  return terms_from_json(answer);
}

core::State read_start(Conversation& worker, std::size_t bodies) {
  const Frame frame = worker.next_frame();
  if (frame.header.states != 1 || frame.header.first_step != 0)
    broken("the first frame must hold step 0 alone");
  core::State state(bodies);
  unpack_state(frame.payload.data(), state);
  return state;
}

}  // namespace cylon::process
