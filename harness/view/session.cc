#include "harness/view/session.h"

#include "harness/core/input_error.h"
#include "harness/process/client.h"
#include "harness/process/resume.h"
#include "harness/scenario/input.h"
#include "harness/view/command.h"
#include "harness/view/parameters.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cylon::view {
namespace {

constexpr double longest_tick = 0.1;  // more wall time than this at once is not caught up with [s]
constexpr double budget = 0.03;       // CPU time of a lane in one tick [s]
constexpr double longest_step = 10;   // [s]

}  // namespace

EngineInfo ask(const process::EngineRow& row, const process::Limits& limits) {
  const core::Engine engine = process::describe({row.id, row, row.path, "", {}}, limits);
  EngineInfo info{row.id, engine.version, {}};
  for (const core::Integrator& integrator : engine.integrators) info.integrators.push_back(integrator.name);
  return info;
}

Session::Session(scenario::Scenario scenario, SessionOptions options)
    : scenario_(std::move(scenario)),
      options_(std::move(options)),
      given_(scenario_.scene),
      joints_(core::held_joints(given_)),
      playing_(options_.playing),
      speed_(options_.speed) {
  lanes_.push_back(make_lane(options_.lane));
  lanes_.front()->begin_at(given_, 0);
  load_due();
}

Lane* Session::first_running() const {
  const auto first =
      std::find_if(lanes_.begin(), lanes_.end(), [](const auto& lane) { return lane->running(); });
  return first == lanes_.end() ? nullptr : first->get();
}

double Session::time() const {
  const Lane* const first = first_running();
  return first ? first->time() : target_;
}

std::optional<PullNow> Session::pull() const {
  if (!pull_) return std::nullopt;
  return PullNow{pull_->body, pull_->to_anchor};
}

// ---- Time ------------------------------------------------------------------------------------------

// How much simulated time all lanes can be carried through within the budget, but a step at least [s]; before
// one has run, that step.
double Session::affordable() const {
  double least = HUGE_VAL;
  for (const auto& lane : lanes_) {
    if (!lane->running()) continue;
    const std::optional<double> cost = lane->cost();
    const double within = !cost ? 0 : *cost > 0 ? budget / *cost : HUGE_VAL;
    least = std::min(least, std::max(lane->dt(), within));
  }
  return least;
}

bool Session::advance(double seconds) {
  const Lane* const first = first_running();
  if (!first) return false;
  if (std::exchange(step_, false)) {
    playing_ = false;
    return run(first->time() + first->dt());
  }
  if (!playing_) return false;
  // What is left of a step is carried on; what could not be afforded is not.
  return run(target_ + std::min(speed_ * std::clamp(seconds, 0.0, longest_tick), affordable()));
}

bool Session::run(double target) {
  target_ = target;
  bool any = false;
  for (const auto& lane : lanes_) {
    const double steps = std::floor((target - lane->time()) / lane->dt() + 1e-6);
    if (steps >= 1) lane->start(static_cast<std::int64_t>(std::min(steps, 1e9)));
  }
  for (const auto& lane : lanes_) any = lane->finish() || any;
  recorder_.observe(*lanes_.front());
  return any;
}

// So that a lane that cannot run says so at once.
void Session::load_due() {
  for (const auto& lane : lanes_) lane->start(0);
  for (const auto& lane : lanes_) lane->finish();
}

// ---- Beginning anew ----------------------------------------------------------------------------------

core::Scene Session::with_pull() const {
  core::Scene scene = given_;
  if (pull_) scene.forces.emplace_back(*pull_);
  return scene;
}

void Session::begin_anew(Lane& lane, core::State state, double t) {
  lane.begin_at(process::resumed(with_pull(), joints_, std::move(state), t), t);
}

// An engine that could not express the scene as it was may be able to now; it joins the first that runs.
void Session::begin_all_anew() {
  const Lane* const first = first_running();
  for (const auto& lane : lanes_) {
    if (lane->running())
      begin_anew(*lane, lane->state(), lane->time());
    else if (first && lane->status() == Lane::Status::unsupported)
      begin_anew(*lane, first->state(), first->time());
  }
}

void Session::check_resumable(const char* what) const {
  if (time() == 0) return;
  if (const auto reason = process::not_resumable(given_))
    throw BadCommand(fmt::format("{}: {}; reset first", what, *reason));
}

void Session::check_body(int body, const char* what) const {
  const auto count = given_.bodies.size();
  if (body < 0 || static_cast<std::size_t>(body) >= count)
    throw BadCommand(fmt::format("{}: body {} is outside 0 … {}", what, body, static_cast<long>(count) - 1));
  if (given_.bodies[static_cast<std::size_t>(body)].locked)
    throw BadCommand(fmt::format("{}: body {} is locked and cannot move", what, body));
}

// Listed as the rows are.
void Session::offer(EngineInfo info) {
  std::vector<EngineInfo>& engines = options_.engines;
  const auto place = [&](const std::string& id) {
    return std::ranges::find(options_.rows, id, &process::EngineRow::id) - options_.rows.begin();
  };
  if (std::ranges::find(engines, info.id, &EngineInfo::id) != engines.end()) return;
  const auto after = std::ranges::find_if(
      engines, [&](const EngineInfo& other) { return place(other.id) > place(info.id); });
  engines.insert(after, std::move(info));
  ++changes_;
}

const EngineInfo& Session::known(const process::EngineRow& row) {
  const auto find = [&] { return std::ranges::find(options_.engines, row.id, &EngineInfo::id); };
  if (find() == options_.engines.end()) offer(ask(row, options_.limits));
  return *find();
}

std::unique_ptr<Lane> Session::make_lane(const LaneSpec& spec) {
  try {
    process::EngineChoice choice = process::parse_engine(spec.engine, options_.rows);
    const auto& known = this->known(choice.row).integrators;
    if (!spec.integrator.empty() && std::find(known.begin(), known.end(), spec.integrator) == known.end())
      throw BadCommand(fmt::format("integrator '{}' is not one of {}{} (valid: {})", spec.integrator,
                                   spec.engine, core::did_you_mean(spec.integrator, known),
                                   fmt::join(known, ", ")));
    const double dt = scenario::parse_step(spec.dt_text);
    if (!(dt <= longest_step))
      throw BadCommand(fmt::format("dt_text '{}': a step is at most {} s", spec.dt_text, longest_step));
    return std::make_unique<Lane>(spec, dt, std::move(choice), options_.limits);
  } catch (const process::Failure&) {
    throw BadCommand(fmt::format("engine '{}' is not installed", spec.engine));
  } catch (const core::InputError& error) {
    throw BadCommand(error.what());
  }
}

// ---- Commands ------------------------------------------------------------------------------------------

void Session::apply(const Command& command) {
  std::visit([this](const auto& c) { obey(c); }, command);
}

void Session::obey(const Play&) { playing_ = true; }
void Session::obey(const Pause&) { playing_ = false; }
void Session::obey(const StepOnce&) { step_ = true; }
void Session::obey(const Speed& speed) { speed_ = speed.value; }

void Session::obey(const Reset&) {
  pull_.reset();
  target_ = 0;
  for (const auto& lane : lanes_) lane->begin_at(given_, 0);
  load_due();
}

void Session::obey(const Kick& kick) {
  check_body(kick.body, "kick");
  check_resumable("kick");
  for (const auto& lane : lanes_) {
    if (!lane->running()) continue;
    core::State state = lane->state();
    process::kick(lane->scene(), joints_, state, kick.body, kick.impulse, kick.angular_impulse);
    begin_anew(*lane, std::move(state), lane->time());
  }
}

void Session::obey(const Pull& pull) {
  check_body(pull.body, "pull");
  check_resumable("pull");
  const double mass = given_.bodies[static_cast<std::size_t>(pull.body)].mass;
  pull_ = core::Spring{.body = pull.body,
                       .anchor = pull.anchor,
                       .to = core::world,
                       .to_anchor = pull.pin,
                       .stiffness = pull.stiffness,
                       .rest_length = 0,
                       .damping = std::sqrt(pull.stiffness * mass)};
  begin_all_anew();
}

void Session::obey(const Release&) {
  if (!pull_) return;
  pull_.reset();
  begin_all_anew();
}

void Session::obey(const Set& set) {
  check_resumable(set.key.c_str());
  core::Scene changed = given_;
  set_parameter(changed, set.key, set.value);
  given_ = std::move(changed);
  begin_all_anew();
  ++changes_;
}

// A lane that was there goes on as it is; a new one takes the state of the first that runs.
void Session::obey(const Lanes& wanted) {
  std::vector<std::unique_ptr<Lane>> next(wanted.lanes.size());
  std::vector<std::size_t> from(wanted.lanes.size(), lanes_.size());
  std::vector<bool> taken(lanes_.size(), false);
  for (std::size_t i = 0; i < next.size(); ++i)
    for (std::size_t k = 0; k < lanes_.size() && from[i] == lanes_.size(); ++k)
      if (!taken[k] && lanes_[k]->spec() == wanted.lanes[i]) from[i] = k, taken[k] = true;
  for (std::size_t i = 0; i < next.size(); ++i)
    if (from[i] == lanes_.size()) next[i] = make_lane(wanted.lanes[i]);
  const bool new_ones =
      std::any_of(next.begin(), next.end(), [](const auto& lane) { return lane != nullptr; });
  if (new_ones) check_resumable("lanes");

  const Lane* const first = first_running();
  const core::State state = first ? first->state() : core::initial_state(given_);
  const double t = first ? first->time() : 0;
  for (std::size_t i = 0; i < next.size(); ++i) {
    if (next[i])
      t == 0 && !pull_ ? next[i]->begin_at(given_, 0) : begin_anew(*next[i], state, t);
    else
      next[i] = std::move(lanes_[from[i]]);
  }
  lanes_ = std::move(next);
  recorder_.forget();
  load_due();
  ++changes_;
}

}  // namespace cylon::view
