// What a given error costs: this engine beside Bullet and ODE on the smooth scenes S4 to S8, in one run.
//   engine_bench [WORD…]      only the scenes whose name contains a word
// Error: the largest at T/4, T/2, 3T/4 and T against closed forms.  Cost: thread CPU time of the stepping and
// of those four samples (the workers time their steps alone), the smallest of several runs, references and
// this engine in turn.  `ours`: the scheme and the step that reach the error for the least, chosen knowing
// the truth; the next three steps of the ladder must reach it too.  `default`: scheme auto, told nothing but
// the tolerance, its setting up and its second run included.  References: each engine's adapter with its
// default path, its step halved until the error is reached, then once more by 1/sqrt 2; the cheaper of its
// precisions.
#include "engine/make_stepper.h"
#include "harness/process/client.h"
#include "reference/exact/catalogue.h"
#include "reference/simulators/in_house_model.h"
#include "scenarios/scenario.h"

#include <fmt/format.h>

#include <ctime>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>

namespace {

using namespace cylon;

using Error = std::function<double(const core::State&, const core::State&)>;
using Truth = std::function<core::State(double)>;

constexpr int samples = 4;

double cpu_now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// ---- Scenes -------------------------------------------------------------------------------------------

struct Target {
  double error, bullet, ode;  ///< Ratios; 0: none.
};

struct Case {
  std::string name, unit, text;
  double duration;
  std::string solution;  ///< Of the catalogue; "chain": normal modes.
  Error error;
  std::vector<std::string> bullets;
  std::vector<Target> targets;
  double budget = 2;  ///< CPU of a reference's run [s].
};

double place_error(const core::State& a, const core::State& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = (a[i].position - b[i].position).norm();
    worst = std::isfinite(d) ? std::max(worst, d) : INFINITY;
  }
  return worst;
}
double turn_error(const core::State& a, const core::State& b) {
  return 2 * std::asin(std::min(1.0, (a[0].orientation.conjugate() * b[0].orientation).vec().norm()));
}
double axis_error(const core::State& a, const core::State& b) {
  const core::Vector3 y = core::Vector3::UnitY();
  const core::Vector3 u = a[0].orientation * y, v = b[0].orientation * y;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

constexpr int beads = 10;
constexpr double stiffness = 100, spacing = 1;

// Beads on a line between two walls, springs at rest length: in each the normal modes
//   u_j = sum_n sin(n pi j/(N+1)) (a_n cos w_n t + b_n sin w_n t),  w_n = 2 sqrt(k/m) sin(n pi/(2 (N+1)))
double displaced(int j) { return j == 1 ? 0.1 : j == 4 ? -0.07 : j == 8 ? 0.05 : 0; }
double pushed(int j) { return j == 3 ? 0.5 : j == 9 ? -0.3 : 0; }

core::State chain_state(double t) {
  core::State state(beads);
  const long double pi = std::acos(-1.0L);
  std::vector<long double> u(beads);
  for (int n = 1; n <= beads; ++n) {
    long double a = 0, b = 0;
    const long double w =
        2 * std::sqrt(static_cast<long double>(stiffness)) * std::sin(n * pi / (2 * (beads + 1)));
    for (int j = 1; j <= beads; ++j) {
      const long double s = std::sin(n * j * pi / (beads + 1)) * 2 / (beads + 1);
      a += s * static_cast<long double>(displaced(j));
      b += s * static_cast<long double>(pushed(j)) / w;
    }
    for (int j = 1; j <= beads; ++j)
      u[static_cast<std::size_t>(j - 1)] +=
          std::sin(n * j * pi / (beads + 1)) * (a * std::cos(w * t) + b * std::sin(w * t));
  }
  for (int j = 1; j <= beads; ++j) {
    const auto i = static_cast<std::size_t>(j - 1);
    state[i].position = {spacing * j + static_cast<double>(u[i]), 0, 0};
  }
  return state;
}

std::string chain_text() {
  std::string text;
  for (int j = 1; j <= beads; ++j)
    text += fmt::format("[[body]]\nname = \"b{}\"\nmass = 1\nposition = [{}, 0, 0]\nvelocity = [{}, 0, 0]\n",
                        j, spacing * j + displaced(j), pushed(j));
  for (int j = 0; j <= beads; ++j) {
    const bool first = j == 0, last = j == beads;
    text += fmt::format("[[spring]]\nbody = \"b{}\"\n{}\nstiffness = {}\nrest_length = {}\n", first ? 1 : j,
                        first  ? "pin = [0, 0, 0]"
                        : last ? fmt::format("pin = [{}, 0, 0]", spacing * (beads + 1))
                               : fmt::format("to = \"b{}\"", j + 1),
                        stiffness, spacing);
  }
  return text;
}

std::vector<Case> cases() {
  const char* top = R"(gravity = [0, -9.81, 0]
[[body]]
name = "top"
mass = 1
inertia = [0.02, 0.01, 0.02]
position = [-0.15, 0.25980762113533160, 0]
orientation = [0.96592582628906829, 0, 0, 0.25881904510252074]
angular_velocity = [-30, 51.961524227066320, 0]
[[joint]]
type = "ball"
body = "top"
point = [0, 0, 0]
)";
  const auto spring = [](const char* p, const char* v, double k, double rest) {
    return fmt::format(
        "[[body]]\nname = \"p\"\nmass = 1\nposition = {}\nvelocity = {}\n"
        "[[spring]]\nbody = \"p\"\npin = [0, 0, 0]\nstiffness = {}\nrest_length = {}\n",
        p, v, k, rest);
  };
  const auto spun = [](const char* inertia, const char* w) {
    return fmt::format("[[body]]\nname = \"b\"\nmass = 1\ninertia = {}\nangular_velocity = {}\n", inertia, w);
  };
  const std::vector<std::string> rigid = {"bullet", "bullet-float"};
  return {
      {"1 S4 spring",
       "m",
       spring("[1, 0, 0]", "[0, 2, 3]", 100, 0),
       60,
       "spring_zero_length",
       place_error,
       rigid,
       {{1e-2, 500, 250}, {1e-4, 3500, 1900}, {1e-6, 0, 0}}},
      {"2 S5 spring with rest length",
       "m",
       spring("[1.5, 0, 0]", "[0, 3, 0]", 50, 1),
       20,
       "spring_orbit",
       place_error,
       rigid,
       {{1e-2, 100, 50}, {1e-4, 4000, 1900}, {1e-6, 0, 0}}},
      {"3 chain of 10",
       "m",
       chain_text(),
       60,
       "chain",
       place_error,
       rigid,
       {{1e-2, 500, 270}, {1e-4, 3000, 1500}, {1e-6, 0, 0}}},
      {"4 S6 free symmetric top",
       "rad",
       spun("[1, 1, 2]", "[1, 0, 10]"),
       20,
       "free_symmetric_top",
       turn_error,
       rigid,
       {{1e-2, 8000, 18000}}},
      {"5 S7 Dzhanibekov",
       "rad",
       spun("[1, 2, 3]", "[0.01, 5, 0.01]"),
       60,
       "free_asymmetric_top",
       turn_error,
       rigid,
       {{1e-2, 0, 0}, {1e-6, 0, 0}, {1e-9, 0, 0}}},
      {"6 S8 heavy top",
       "rad",
       top,
       10,
       "heavy_top",
       axis_error,
       {"bullet-multibody", "bullet-multibody-float", "bullet"},
       {{1e-2, 400, 0}, {1e-4, 4500, 0}, {1e-8, 0, 0}},
       2.2},
  };
}

// ---- This engine ----------------------------------------------------------------------------------------

struct Run {
  std::string how;
  double steps = 0, error = INFINITY, cpu = INFINITY;  // [s]
};

core::State state_of(const engine::Model& model, const std::vector<engine::Motion>& motions) {
  core::State state(motions.size());
  for (std::size_t i = 0; i < motions.size(); ++i) {
    state[i].position = motions[i].position.cast<double>();
    state[i].orientation = motions[i].orientation.cast<double>();
    state[i].velocity = engine::velocity(model.bodies[i], motions[i]).cast<double>();
  }
  return state;
}

struct Subject {
  engine::Model model;
  double duration;
  Truth truth;
  Error error;
  std::vector<core::State> truths;

  std::unique_ptr<engine::Stepper> make(const engine::Options& options) const {
    return engine::make_stepper(model, options, engine::make_plan(model, options));
  }
  engine::Options options(const std::string& scheme, std::int64_t steps, double tolerance = 0) const {
    engine::Options o;
    o.scheme = scheme, o.dt = duration / static_cast<double>(steps);
    o.tolerance = static_cast<engine::Real>(tolerance);
    return o;
  }
  double error_of(const engine::Options& options, std::int64_t steps) const {
    const auto stepper = make(options);
    std::vector<engine::Motion> motions;
    double worst = 0;
    for (std::size_t k = 0; k < samples; ++k) {
      stepper->advance(steps / samples);
      stepper->read(motions);
      const double e = error(state_of(model, motions), truths[k]);
      worst = std::isfinite(e) ? std::max(worst, e) : INFINITY;
    }
    return worst;
  }
  // The smallest of `repeats` batches; a batch takes 0.2 ms and more.
  double cost(const engine::Options& options, std::int64_t steps, bool with_making, int repeats) const {
    double best = 1e30;
    std::size_t batch = 1;
    for (int r = 0; r < repeats; ++r) {
      std::vector<std::unique_ptr<engine::Stepper>> steppers(batch);
      std::vector<engine::Motion> motions(model.bodies.size());
      if (!with_making)
        for (auto& s : steppers) s = make(options);
      const double start = cpu_now();
      for (auto& s : steppers) {
        if (with_making) s = make(options);
        for (int k = 0; k < samples; ++k) {
          s->advance(steps / samples);
          s->read(motions);
        }
      }
      const double whole = cpu_now() - start;
      best = std::min(best, whole / static_cast<double>(batch));
      if (whole < 2e-4 && batch < 4096) batch *= 2, --r;
    }
    return best;
  }
};

constexpr const char* schemes[] = {"velocity-verlet", "bm4", "rkn4", "bm6", "rkn6", "rk4", "rk8"};

// The fewest steps of a ladder by which a scheme reaches an error, and keeps it.
std::optional<std::int64_t> fewest(const Subject& s, const char* scheme, double target) {
  const engine::Scheme& row = *engine::find_scheme(scheme);
  std::int64_t found = 0;
  int kept = 0;
  for (double n = 4 * samples; n < 4e6; n = std::max(n * 1.1, n + samples)) {
    const std::int64_t steps = samples * static_cast<std::int64_t>(n / samples);
    const double error = s.error_of(s.options(scheme, steps), steps);
    if (error <= target) {
      if (kept == 0) found = steps;
      if (++kept == 4) return found;
    } else {
      kept = 0;
      // a part of what the order says is missing
      n *= std::clamp(std::pow(error / target, 0.5 / row.order) / 1.1, 1.0, 2.0);
    }
    if (n * row.evaluations > 4e5) break;
  }
  return std::nullopt;
}

Run tuned(const Subject& s, double target) {
  Run best;
  for (const char* scheme : schemes) {
    const auto steps = fewest(s, scheme, target);
    if (!steps) continue;
    const auto o = s.options(scheme, *steps);
    const double cpu = s.cost(o, *steps, false, 15);
    if (cpu < best.cpu) best = {scheme, static_cast<double>(*steps), s.error_of(o, *steps), cpu};
  }
  return best;
}

// ---- References -----------------------------------------------------------------------------------------

struct References {
  const core::Scene& scene;
  double duration;
  const Subject& subject;
  double budget;
  mutable std::map<std::pair<std::string, std::int64_t>, Run> seen;

  Run run(const process::EngineChoice& choice, std::int64_t steps) const {
    process::RunRequest request;
    request.scene = &scene;
    request.setup.dt = duration / static_cast<double>(steps);
    request.steps = steps;
    request.every = steps / samples;
    const auto outcome = process::run(choice, request);
    if (!outcome.recording) return {outcome.reason, static_cast<double>(steps)};
    Run r{choice.id, static_cast<double>(steps), 0, outcome.recording->cpu_seconds};
    for (std::size_t k = 0; k < samples; ++k) {
      const double e = subject.error(outcome.recording->states[k + 1], subject.truths[k]);
      r.error = std::isfinite(e) ? std::max(r.error, e) : INFINITY;
    }
    return r;
  }

  // Halves the step until the error is reached; `nearest` is the best that was seen.
  std::optional<Run> reach(const process::EngineChoice& choice, double target, Run& nearest) const {
    for (std::int64_t steps = samples * 64; steps < 200'000'000; steps *= 2) {
      const auto [place, is_new] = seen.try_emplace({choice.id, steps});
      if (is_new) place->second = run(choice, steps);
      const Run& r = place->second;
      if (!std::isfinite(r.cpu)) {  // an engine may not survive a step that is far too long
        if (nearest.how.empty()) nearest = r;
        if (steps < 10'000) continue;
        break;
      }
      if (r.error < nearest.error) nearest = r;
      if (r.error <= target) {
        const Run between =
            run(choice, samples * static_cast<std::int64_t>(r.steps / samples / std::sqrt(2.0)));
        return between.error <= target ? between : r;
      }
      if (2 * r.cpu > budget) break;
    }
    return std::nullopt;
  }
};

void show(const char* who, const Run& r, double duration) {
  fmt::print("    {:<9} {:<22} h = {:<10.4g} {:>9.2g} {:>13.2f}\n", who, r.how, duration / r.steps, r.error,
             1e6 * r.cpu);
}

void verdict(const char* whom, double theirs, double ours, double untuned, double target) {
  fmt::print("    vs {:<6} {:>9.0f}x", whom, theirs / ours);
  if (target > 0) fmt::print("  target {:>6.0f}x  {}", target, theirs / ours >= target ? "met" : "NOT MET");
  if (std::isfinite(untuned)) fmt::print("  (default: {:.0f}x)", theirs / untuned);
  fmt::print("\n");
}

void compare(const Case& c, const std::vector<process::EngineRow>& rows) {
  const auto scenario = scenarios::parse(
      fmt::format(
          "title = \"Bench\"\nstory = \"Bench\"\nduration = {}\nstep = 0.001\n{}[[claim]]\nconserves = "
          "\"energy\"\ntolerance = {{ relative = 1, reason = \"rounding\" }}\n",
          c.duration, c.text),
      "bench.toml");
  Truth truth = chain_state;
  for (const exact::Solution& s : exact::catalogue())
    if (s.name == c.solution) truth = s.make(scenario.scene, c.duration).state;
  Subject subject{simulators::in_house_model(scenario.scene).model, c.duration, truth, c.error, {}};
  for (int k = 1; k <= samples; ++k) subject.truths.push_back(truth(c.duration * k / samples));
  const References references{scenario.scene, c.duration, subject, c.budget, {}};

  fmt::print("\n{}, {:g} s\n", c.name, c.duration);
  fmt::print("    {:<9} {:<22} {:<14} {:>9} {:>13}\n", "", "method", "step [s]", "error [" + c.unit + "]",
             "cost [us]");
  for (const Target& target : c.targets) {
    fmt::print("  error <= {:g} {}\n", target.error, c.unit);
    Run ours = tuned(subject, target.error);
    const auto exact_options = subject.options("auto", samples, target.error);
    Run untuned{fmt::format("auto, tolerance {:g}", target.error), samples};
    untuned.error = subject.error_of(exact_options, samples);
    untuned.cpu = subject.cost(exact_options, samples, true, 9);
    if (ours.how.empty()) {
      fmt::print("    no scheme reaches it\n");
      continue;
    }
    const bool closed = !engine::make_plan(subject.model, exact_options).scheme;
    if (closed) {
      untuned.how = "closed form (auto)";
      if (untuned.cpu < ours.cpu) show("splitting", ours, c.duration), ours = untuned;
    }
    struct Found {
      const char* name;
      std::optional<Run> run;
      process::EngineChoice choice;
      Run nearest;
      double target;
    };
    std::vector<Found> found = {{"Bullet", {}, {}, {}, target.bullet}, {"ODE", {}, {}, {}, target.ode}};
    const auto look = [&](Found& f, const std::string& id) {
      const auto choice = process::parse_engine(id, rows);
      const auto r = references.reach(choice, target.error, f.nearest);
      if (r && (!f.run || r->cpu < f.run->cpu)) f.run = r, f.choice = choice;
    };
    for (const std::string& id : c.bullets) look(found[0], id);
    for (const char* id : {"ode", "ode-quick"}) look(found[1], id);
    // in turn, so that all see the same machine
    for (int i = 0; i < 4; ++i) {
      for (Found& f : found)
        if (f.run)
          f.run->cpu =
              std::min(f.run->cpu, references.run(f.choice, static_cast<std::int64_t>(f.run->steps)).cpu);
      const bool is_closed = closed && ours.steps == samples;
      const auto o =
          subject.options(is_closed ? "auto" : ours.how, static_cast<std::int64_t>(ours.steps), target.error);
      ours.cpu = std::min(ours.cpu, subject.cost(o, static_cast<std::int64_t>(ours.steps), is_closed, 15));
      untuned.cpu = std::min(untuned.cpu, subject.cost(exact_options, samples, true, 5));
    }
    show("ours", ours, c.duration);
    show("default", untuned, c.duration);
    for (const Found& f : found) {
      if (f.run) {
        show(f.name, *f.run, c.duration);
      } else {
        fmt::print("    {:<9} not reached; best ", f.name);
        fmt::print("{:.2g} {} with {}, h = {:.2g} s, {:.3g} s of CPU\n", f.nearest.error, c.unit,
                   f.nearest.how, c.duration / f.nearest.steps, f.nearest.cpu);
      }
    }
    for (const Found& f : found)
      if (f.run)
        verdict(f.name, f.run->cpu, ours.cpu, untuned.error <= target.error ? untuned.cpu : INFINITY,
                f.target);
    if (ours.error > target.error) fmt::print("    NOT REACHED\n");
  }
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const auto rows = process::default_engines(std::filesystem::absolute(argv[0]).parent_path());
  for (const Case& c : cases()) {
    bool wanted = argc == 1;
    for (int i = 1; i < argc; ++i) wanted = wanted || c.name.find(argv[i]) != std::string::npos;
    if (wanted) compare(c, rows);
  }
  fmt::print(
      "\nS8: Bullet is the cheaper of btMultiBody and of a btRigidBody on a ball joint, as the adapter runs "
      "them; "
      "btMultiBody's own RK4 is no path of the adapter and is not measured.\n");
}
