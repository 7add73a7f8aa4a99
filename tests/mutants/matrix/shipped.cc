#include "tests/mutants/matrix/shipped.h"

#include "harness/core/measure.h"
#include "harness/core/recording.h"
#include "harness/core/size.h"
#include "tests/mutants/matrix/record.h"
#include "tests/paths.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace cylon::mutants {
namespace {

constexpr double moved = 0.1;   // of a body's size
constexpr double turned = 0.1;  // [rad]

bool apart(const core::Body& body, const core::BodyState& a, const core::BodyState& b) {
  return (a.position - b.position).norm() > moved * core::size(body) ||
         a.orientation.angularDistance(b.orientation) > turned;
}

bool apart(const core::Scene& scene, const core::State& a, const core::State& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (apart(scene.bodies[i], a[i], b[i])) return true;
  return false;
}

constexpr int truth_samples = 256;

std::vector<core::State> states_of(const core::Truth& truth, double until) {
  std::vector<core::State> states;
  for (const double t : truth.times)
    if (t <= until) states.push_back(truth.state(t));
  if (truth.times.empty())
    for (int i = 0; i <= truth_samples; ++i) states.push_back(truth.state(until * i / truth_samples));
  return states;
}

}  // namespace

std::vector<std::filesystem::path> shipped_scenarios() {
  std::vector<std::filesystem::path> files;
  const std::filesystem::path root = std::filesystem::path(source_dir) / "scenarios";
  for (const auto& folder : {root, root / "extremes"})
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".toml" && entry.path().filename() != "expected.toml")
        files.push_back(entry.path());
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.stem() < b.stem(); });
  return files;
}

bool ShippedRun::passes() const {
  return std::all_of(findings.begin(), findings.end(),
                     [](const ShippedFinding& f) { return f.status == results::Status::pass; });
}

bool ShippedRun::accused() const {
  return std::any_of(findings.begin(), findings.end(), [](const ShippedFinding& f) {
    return f.status != results::Status::pass && f.status != results::Status::unsupported;
  });
}

results::Status status_of(const core::Measured& m) {
  return m.unanswered ? results::Status::unsupported
         : m.broken   ? results::Status::fail
                      : results::judge(m.value, m.allowed);
}

std::optional<ShippedRun> run_shipped(const scenario::Scenario& scenario, const Subject& subject) {
  core::Setup setup = subject.setup;
  setup.dt = scenario.step;
  const auto simulator = subject.make();
  if (simulator->unsupported(scenario.scene, setup)) return std::nullopt;
  int runs = 1;
  for (const core::Claim& claim : scenario.claims) runs = std::max(runs, core::runs_needed(claim));
  std::vector<core::Recording> recordings;
  for (int i = 0; i < runs; ++i) {
    setup.dt = std::ldexp(scenario.step, -i);
    recordings.push_back(record(*simulator, scenario.scene, setup, study::sampling(scenario, setup.dt)));
  }
  ShippedRun result;
  for (const core::Claim& claim : scenario.claims) {
    const core::Measured m = core::measure(claim, scenario.scene, recordings, scenario.duration);
    const results::Status status = status_of(m);
    result.findings.push_back({claim.label, status, m.value, m.allowed});
  }
  result.recording = std::move(recordings.front());
  return result;
}

ShippedFile::ShippedFile(const std::filesystem::path& path) : path_(path), scenario_(scenario::load(path)) {}

ShippedFile& ShippedFile::of(const std::filesystem::path& path) {
  static std::unique_ptr<ShippedFile> last;
  if (!last || last->path_ != path) last.reset(new ShippedFile(path));
  return *last;
}

const std::optional<ShippedRun>& ShippedFile::run(const Subject& subject) {
  const auto known = runs_.find(subject.name);
  if (known != runs_.end()) return known->second;
  return runs_.emplace(subject.name, run_shipped(scenario_, subject)).first->second;
}

bool moves(const core::Scene& scene, const std::vector<core::State>& states) {
  const core::State start = core::initial_state(scene);
  return std::any_of(states.begin(), states.end(),
                     [&](const core::State& state) { return apart(scene, start, state); });
}

bool moves_apart(const core::Scene& scene, const std::vector<core::State>& a,
                 const std::vector<core::State>& b) {
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    if (apart(scene, a[i], b[i])) return true;
  return false;
}

const std::vector<Undecided>& undecided() {
  static const std::vector<Undecided> rows = {
      {"crowd_of_boxes", "no force acts, and how far overlapping bodies come apart no law says"},
  };
  return rows;
}

bool dynamic(const scenario::Scenario& scenario, const std::optional<ShippedRun>& in_house) {
  for (const Undecided& row : undecided())
    if (scenario.name == row.scenario) return false;
  bool known = in_house.has_value();
  if (in_house && moves(scenario.scene, in_house->recording.states)) return true;
  for (const core::Claim& claim : scenario.claims) {
    if (!claim.truth) continue;
    known = true;
    if (moves(scenario.scene, states_of(*claim.truth, std::min(claim.until, scenario.duration)))) return true;
  }
  if (known) return false;
  throw std::logic_error(scenario.name + ": neither a truth nor the in-house engine says whether it moves");
}

}  // namespace cylon::mutants
