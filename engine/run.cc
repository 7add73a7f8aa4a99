#include "engine/run.h"

#include "engine/ballistic/ballistic.h"
#include "engine/make_stepper.h"
#include "engine/methods.h"

#include <cassert>
#include <sstream>
#include <utility>

namespace cylon::engine {

namespace {

// "events by dop853", "closed form".
IslandName island_of(const Plan& plan) {
  IslandName island;
  island.method = name_of(plan.path);
  if (plan.integrator) island.method += " by " + std::string(plan.integrator->name);
  island.order = plan.path == Path::stepping || plan.integrator ? plan.order : 0;
  return island;
}

Features late(std::int64_t first) { return first > 0 ? Features{Feature::late_start} : Features{}; }

}  // namespace

Run::Run(std::shared_ptr<const Model> model, const Options& options, std::int64_t first)
    : model_(std::move(model)),
      options_(options),
      plan_(make_plan(*model_, options_, late(first))),
      start_(static_cast<Time>(first) * options.dt),
      now_(island_of(plan_)),
      gimbals_(*model_),
      motions_(model_->motions),
      steps_(first),
      stepped_(plan_.path == Path::stepping) {
  assert(options_.dt > 0 && unsupported(*model_, options_).empty());
  stepper_ = make_stepper(*model_, options_, plan_, start_);
  if (plan_.path == Path::ballistic) {
    ballistic_ = static_cast<Ballistic*>(stepper_.get());
    if (ballistic_->handover()) hand_over();
  }
}

Run::~Run() = default;

void Run::step() {
  stepper_->step();
  take_impacts();
  if (ballistic_ && ballistic_->handover()) {
    hand_over();
    stepper_->step();
    impacts_.insert(impacts_.end(), stepper_->impacts().begin(), stepper_->impacts().end());
  }
  ++steps_;
  stepper_->read(motions_);
  watch_gimbals();
}

// Adaptive integrators shorten their steps near parallel axes.
void Run::watch_gimbals() {
  if (!gimbals_.sees_any()) return;
  const Real change = gimbals_.look(motions_);
  if (const auto lost = gimbals_.lost())
    log_.note(DiagnosticKind::gimbal_parallel, time(), {}, static_cast<double>(*lost));
  if (plan_.integrator && plan_.integrator->kind == Kind::adaptive) return;
  if (change > 0) log_.note(DiagnosticKind::gimbal_passed, time(), {}, static_cast<double>(change));
}

void Run::advance(std::int64_t n) {
  // Any step may hand over, or pass parallel axes of a gimbal.
  for (; (ballistic_ || gimbals_.sees_any()) && n > 0; --n) step();
  if (n == 0) return;
  // Integrators make one of kicks that meet in a run of steps, and other last bits with it: only free
  // bodies run.
  if (plan_.path == Path::free)
    stepper_->advance(n);
  else
    for (std::int64_t i = 0; i < n; ++i) stepper_->step();
  take_impacts();
  steps_ += n;
  stepper_->read(motions_);
}

// The times of free flight count from its own start.
void Run::take_impacts() {
  impacts_ = stepper_->impacts();
  if (!ballistic_ || start_ == 0) return;
  for (Impact& impact : impacts_) impact.time += start_;
}

// What spheres in free flight cannot express goes on event by event, from the instant at which it begins;
// where many may touch, in fixed steps, from the step in which it begins.
void Run::hand_over() {
  const Handover from = *ballistic_->handover();
  spent_ += ballistic_->operations();
  for (const Diagnostic& d : diagnostics_of_stepper()) log_.take(d);
  ballistic_ = nullptr;
  const Plan plan = make_plan(*model_, options_, Features{Feature::lasting_contact} | late(steps_));
  const bool by_events = plan.path == Path::events;
  const Time start = by_events ? start_ + from.time : time();
  Model model = *model_;
  model.motions = by_events ? from.motions : motions_;
  stepper_ = make_stepper(model, options_, plan, start);
  stepper_->keep_contacts(keep_contacts_);
  stepped_ = plan.path == Path::stepping;
  log_.note(DiagnosticKind::handed_over, start, {}, {},
            (by_events ? "by events: " : "in fixed steps: ") + from.reason);
  now_ = island_of(plan);
  if (!by_events) impacts_.clear();  // the whole step again
}

// As take_impacts().
std::vector<Diagnostic> Run::diagnostics_of_stepper() const {
  std::vector<Diagnostic> all = stepper_->diagnostics();
  for (Diagnostic& d : all)
    if (ballistic_) d.since += start_;
  return all;
}

std::vector<Diagnostic> Run::diagnostics() const {
  DiagnosticLog log = log_;
  IslandName island = now_;
  if (const std::optional<int> order = stepper_->order_so_far()) island.order = *order;
  if (!options_.path.empty() && !can_touch(*model_))
    log.note(DiagnosticKind::path_not_taken, start_, {}, {}, options_.path);
  if (plan_.path == Path::stepping && options_.integrator == "auto") {
    std::ostringstream how;
    how << "fixed steps of order " << island.order << " in dt = " << options_.dt << " s";
    if (options_.tolerance > 0)
      log.note(DiagnosticKind::tolerance_not_kept, start_, static_cast<double>(options_.tolerance), {},
               how.str());
    else
      log.note(DiagnosticKind::error_not_controlled, start_, {}, {}, how.str());
  }
  std::vector<Diagnostic> all = log.all();
  for (Diagnostic& d : diagnostics_of_stepper()) all.push_back(std::move(d));
  for (Diagnostic& d : all) d.island = island;
  return all;
}

}  // namespace cylon::engine
