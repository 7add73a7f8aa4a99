#include "engine/make_stepper.h"

#include "engine/adaptive_stepper.h"
#include "engine/ballistic/ballistic.h"
#include "engine/bodies.h"
#include "engine/event_stepper.h"
#include "engine/free_bodies.h"
#include "engine/free_stepper.h"
#include "engine/modes_stepper.h"
#include "engine/parted_steps.h"
#include "engine/pile/pile.h"
#include "engine/points.h"
#include "engine/reduce.h"
#include "engine/smooth_stepper.h"
#include "engine/tops.h"
#include "engine/trees.h"
#include "engine/verified_stepper.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <thread>
#include <utility>

namespace cylon::engine {

namespace {

std::int64_t step_at(Time start, const Options& options) { return std::llround(start / options.dt); }

Real bound(const Options& options) { return options.tolerance > 0 ? options.tolerance : default_tolerance(); }

// Smooth motion of a System by an integrator, fixed or adaptive with a local tolerance.
template <class S, class Read>
std::unique_ptr<Stepper> smooth(const S& system, const std::vector<Real>& initial, const Plan& plan,
                                const Options& options, Read read, const Model& model, std::int64_t first) {
  if (plan.integrator->kind != Kind::adaptive)
    return std::make_unique<SmoothStepper<S, Read>>(system, initial, *plan.integrator, options.dt, read,
                                                    first);
  const auto reserve = std::make_shared<std::int64_t>(AdaptiveStepper<S, Read>::first_operations);
  const auto run = [=](Real tolerance) -> std::unique_ptr<Stepper> {
    return std::make_unique<AdaptiveStepper<S, Read>>(system, initial, tolerance, options.dt, read, first,
                                                      reserve);
  };
  if (!plan.verified) return run(bound(options));
  return std::make_unique<VerifiedStepper>(run, bound(options), options.dt, model.bodies, first);
}

template <std::size_t N>
std::unique_ptr<Stepper> make_points(const Model& model, const Plan& plan, const Options& options,
                                     std::int64_t first) {
  const Points<N> system(model);
  const auto read = [start = model.motions](const Points<N>& s, const Real* y, std::vector<Motion>& motions) {
    motions = start;
    s.read(y, motions);
  };
  return smooth(system, system.initial(model.motions), plan, options, read, model, first);
}

std::unique_ptr<Stepper> make_bodies(const Model& model, const Plan& plan, const Options& options,
                                     std::int64_t first) {
  if (Trees::applies(model, options, *plan.integrator)) {
    Model whole = model;
    whole.reduce_joints = false;
    Reduced ordered = reduce(std::move(whole));
    const Trees system(std::move(ordered.model));
    const auto read = [readings = std::move(ordered.readings)](const Trees& trees, const Real* y,
                                                               std::vector<Motion>& motions) {
      std::vector<Motion> all;
      trees.read(y, all);
      engine::read(trees.model().bodies, readings, all.data(), motions);
    };
    return smooth(system, system.initial(), plan, options, read, model, first);
  }
  Reduced reduced = reduce(model);
  const bool asks_more = !(required(reduced.model, options) - supports(Method::top)).empty();
  if (!asks_more && Top::applies(reduced.model)) {
    const Top top(reduced.model);
    const auto read = [bodies = reduced.model.bodies, readings = reduced.readings](
                          const Top& t, const Real* y, std::vector<Motion>& motions) {
      const Motion motion = t.motion(y);
      engine::read(bodies, readings, &motion, motions);
    };
    return smooth(top, top.initial(), plan, options, read, model, first);
  }
  const Bodies system(std::move(reduced.model), options.account);
  const auto read = [readings = std::move(reduced.readings)](const Bodies& s, const Real* y,
                                                             std::vector<Motion>& motions) {
    engine::read(s.model().bodies, readings, s.motions(y), motions);
  };
  return smooth(system, system.initial(static_cast<Time>(first) * options.dt), plan, options, read, model,
                first);
}

std::unique_ptr<Stepper> make_events(const Model& model, const Plan& plan, const Options& options,
                                     Time start) {
  const bool adaptive = plan.integrator->kind == Kind::adaptive;
  const std::int64_t parts = adaptive ? parts_of_step(model, options.dt) : 1;
  // All runs of one motion share what they may spend: of several bodies, what two runs need.
  const auto moving = std::ranges::count_if(model.bodies, [](const Body& body) { return !body.locked; });
  const auto reserve = std::make_shared<std::int64_t>((moving > 1 ? 2 : 1) * EventStepper::first_operations);
  const auto run = [=, integrator = plan.integrator](Real tolerance) -> std::unique_ptr<Stepper> {
    auto events = std::make_unique<EventStepper>(model, *integrator, options.dt / static_cast<Time>(parts),
                                                 tolerance, options.account, start, reserve);
    if (parts == 1) return events;
    return std::make_unique<PartedSteps>(std::move(events), parts, options.dt, start);
  };
  if (!plan.verified) return run(bound(options));
  return std::make_unique<VerifiedStepper>(run, bound(options), options.dt, model.bodies,
                                           step_at(start, options), reserve);
}

// More than the machine has change nothing, and oneTBB complains of them on stderr.
int threads_of(const Options& options) {
  return std::min(options.threads, static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
}

PileSettings pile_settings(const Options& options) {
  PileSettings settings;
  if (options.sweeps > 0) settings.substeps = options.sweeps;
  settings.threads = threads_of(options);
  settings.rest = options.sleeping;
  return settings;
}

}  // namespace

std::unique_ptr<Stepper> make_stepper(const Model& model, const Options& options, const Plan& plan,
                                      Time start) {
  const std::int64_t first = step_at(start, options);
  switch (plan.path) {
    case Path::exact:
      return std::make_unique<FreeStepper>(model, options.dt);
    case Path::free:
      return std::make_unique<FreeBodies>(model, *plan.integrator, options.dt, threads_of(options));
    case Path::modes:
      return std::make_unique<ModesStepper>(model, options.dt);
    case Path::points:
      return model.bodies.size() == 1 ? make_points<1>(model, plan, options, first)
                                      : make_points<0>(model, plan, options, first);
    case Path::bodies:
      return make_bodies(model, plan, options, first);
    case Path::ballistic:
      return make_ballistic(model, options.dt);
    case Path::events:
      return make_events(model, plan, options, start);
    case Path::stepping:
      return make_pile(model, options.dt, pile_settings(options), first);
  }
  return nullptr;
}

}  // namespace cylon::engine
