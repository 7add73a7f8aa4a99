#include "harness/scenario/scenario.h"

#include "harness/core/recording.h"
#include "harness/scenario/budget.h"
#include "harness/scenario/claims.h"
#include "harness/scenario/draft.h"
#include "harness/scenario/foreign.h"
#include "harness/scenario/key_rows.h"
#include "harness/scenario/read_element.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace cylon::scenario {
namespace {

double read_step(const Table& root) {
  return root.is_text("step") ? parse_step(root.text("step")) : root.number("step");
}

void require_whole_steps(const Table& t, const char* key, double time, double step) {
  try {
    core::whole_steps(time, step);
  } catch (const std::invalid_argument& error) {
    t.fail(key, fmt::format("{} = {}: {}", key, time, error.what()));
  }
}

// A duration of few digits ends where its last step does: truths are not known beyond it.
double end_of_steps(double duration, double step) {
  const double end = static_cast<double>(core::whole_steps(duration, step)) * step;
  return std::abs(end - duration) > 1e-12 * duration ? end : duration;
}

std::optional<Theory> read_theory(const Table& root, double duration, double step) {
  const auto t = root.table("theory");
  if (!t) return std::nullopt;
  Theory theory{.rate = t->number("rate"),
                .magnification = t->number("magnification", 1),
                .forces = t->choice("forces", forces_of_theory(), Theory::Forces::smooth),
                .until = t->number("until", duration),
                .reason = t->text("reason")};
  if (theory.until > duration)
    t->fail("until",
            fmt::format("until = {}, but must be in (0, {}] s, the duration", theory.until, duration));
  require_whole_steps(*t, "until", theory.until, step);
  return theory;
}

}  // namespace

Scenario read(std::string_view text, const std::string& file_name) {
  const std::filesystem::path path(file_name);
  const auto document = std::make_shared<const Document>(text, file_name, scenario_keys());
  const Table root = document->root();

  Scenario scenario;
  scenario.name = path.stem().string();
  scenario.file = file_name;
  scenario.title = root.text("title", scenario.name);
  scenario.story = root.text("story");
  scenario.tags = root.texts("tags");
  scenario.sources = root.texts("sources");
  scenario.duration = root.number("duration");
  scenario.step = read_step(root);
  scenario.step_text = document->written(root, "step");
  require_whole_steps(root, "duration", scenario.duration, scenario.step);
  scenario.duration = end_of_steps(scenario.duration, scenario.step);
  scenario.theory = read_theory(root, scenario.duration, scenario.step);

  Draft draft;
  draft.folder = path.parent_path();
  draft.content.add(text);
  const auto& rules = core::Words<core::Impacts>::list;
  draft.scene.impacts = root.choice("impacts", {rules.begin(), rules.end()}, draft.scene.impacts);
  if (const auto frame = root.table("frame")) {
    draft.scene.frame = read_element<core::Frame>(*frame, draft);
    if (frame->has("frequency") && !frame->has("acceleration"))
      frame->fail("frequency", "frequency: how often 'acceleration' changes, of which there is none");
  }
  read_planes(root, draft);  // before the bodies: clouds keep clear of them
  read_bodies(root, draft);
  read_forces(root, draft);
  read_joints(root, draft);
  check_collision_groups(root, draft);
  read_materials(root, draft);
  refuse_overlaps(draft);
  ReadClaims claims = read_claims(root, draft, scenario.duration, scenario.step);
  scenario.claims = std::move(claims.claims);
  if (!claims.certified.empty())
    scenario.unsolved = std::make_shared<const CertifiedClaims>(document, std::move(claims.certified));

  scenario.scene = std::move(draft.scene);
  scenario.hash = draft.content.hex();
  return scenario;
}

std::function<std::string(const std::filesystem::path&)>& foreign_reader() {
  static std::function<std::string(const std::filesystem::path&)> reader;
  return reader;
}

Scenario read(const std::filesystem::path& path) {
  if (foreign_format(path).empty()) return read(read_file(path), path.string());
  if (!foreign_reader())
    throw core::InputError(path.string(), 0, 0,
                           "this program reads only scenario files (.toml); `cylon import` makes one");
  const std::string text = foreign_reader()(path);
  try {
    return read(text, path.string());
  } catch (const core::InputError& error) {  // its lines are those of a text that nobody has
    std::string_view what = error.what();
    const std::string place = fmt::format("{}:{}:{}: ", path.string(), error.line, error.column);
    if (what.starts_with(place)) what.remove_prefix(place.size());
    throw core::InputError(path.string(), 0, 0, fmt::format("as a scenario: {}", what));
  }
}

void prepare(Scenario& scenario) {
  if (!scenario.unsolved) return;
  scenario.claims = scenario.unsolved->solved(scenario, budget::truth_work);
  scenario.unsolved = nullptr;
}

bool prepare_soon(Scenario& scenario) {
  if (!scenario.unsolved) return true;
  try {
    scenario.claims = scenario.unsolved->solved(scenario, budget::soon);
  } catch (const certified::TooMuchWork&) {
    return false;
  }
  scenario.unsolved = nullptr;
  return true;
}

void require_prepared(const Scenario& scenario) {
  if (scenario.unsolved)
    throw std::logic_error(fmt::format("{}: the certified truths are not solved", scenario.name));
}

Scenario load(const std::filesystem::path& path) {
  Scenario scenario = read(path);
  prepare(scenario);
  return scenario;
}

Scenario parse(std::string_view text, const std::string& file_name) {
  Scenario scenario = read(text, file_name);
  prepare(scenario);
  return scenario;
}

}  // namespace cylon::scenario
