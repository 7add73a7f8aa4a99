// hunted --list: the names of all mutants, and of the right simulators behind "--", one a line.
// hunted NAME --seed S --first N --scenes N --seconds T --jobs J: looks for the mutant's fault as `cylon hunt` does, until a
//   scene has one, and prints a line of JSON: how many scenes were asked and, where one has a fault, its number and the
//   oracles that it breaks and the simulator without its fault does not.  Exits 2 for an unknown name.
// hunted --worker NAME: the mutant as a worker.
#include "harness/hunt/examine.h"
#include "harness/hunt/hunt.h"
#include "harness/process/worker_loop.h"
#include "tests/mutants/matrix/subject.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace {

using namespace cylon;

std::vector<mutants::Subject> subjects() {
  std::vector<mutants::Subject> all = mutants::mutants();
  for (mutants::Subject& right : mutants::correct_subjects()) all.push_back(std::move(right));
  return all;
}

int serve(const mutants::Subject& subject) {
  const int out = dup(STDOUT_FILENO);
  if (out < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) return 1;
  return process::serve(*subject.make(), STDIN_FILENO, out);
}

process::EngineChoice choice_of(const mutants::Subject& subject) {
  process::EngineChoice choice;
  choice.id = subject.name;
  choice.row = {subject.name, {"/proc/self/exe", "--worker", subject.name}, ""};
  choice.integrator = subject.setup.integrator;
  choice.options = subject.setup.options;
  return choice;
}

// What the mutant is without its fault; nothing for a right simulator.
std::optional<mutants::Subject> right_of(const mutants::Subject& subject) {
  if (subject.fault.empty()) return std::nullopt;
  const auto named = [&](const mutants::Subject& one) { return one.name == subject.name; };
  const bool of_the_seed = std::ranges::any_of(mutants::seed_mutants(), named);
  for (mutants::Subject& right : mutants::correct_subjects())
    if (right.name == (of_the_seed ? "the seed's engine, put right" : "in-house, auto"))
      return std::move(right);
  return std::nullopt;
}

// What a right simulator is known to do wrong, and is not counted again.
struct Known {
  std::string_view simulator, oracle, why;
};
constexpr Known known[] = {
    {"the seed's engine, put right", "penetration", "a ball that rests on a slope sinks: docs/hunt.md"}};

bool is_known(const std::string& simulator, const std::string& oracle) {
  return std::ranges::any_of(
      known, [&](const Known& one) { return one.simulator == simulator && one.oracle == oracle; });
}

// Stops handing out scenes once one has a fault that the right simulator does not have there.
class First final : public hunt::Memory {
 public:
  First(const std::string& subject, const hunt::Source& source, const std::optional<mutants::Subject>& right,
        const process::Limits& limits)
      : subject_(subject), source_(source), right_(right), limits_(limits) {}

  std::optional<hunt::Hit> asked(std::uint64_t) override { return std::nullopt; }
  void note(const hunt::Hit& hit) override {
    if (hit.broken.empty() || found) return;
    hunt::Hit own = hit;
    if (right_) {
      const std::vector<hunt::Fault> also =
          hunt::examine(source_.scene(hit.number).trial, choice_of(*right_), limits_).faults;
      std::erase_if(own.broken, [&](const hunt::Broken& broken) {
        return std::ranges::any_of(also, [&](const hunt::Fault& f) { return f.oracle == broken.oracle; });
      });
    }
    // What was stopped by the clock says how fast this machine is.
    std::erase_if(own.broken,
                  [&](const hunt::Broken& one) { return one.by_time || is_known(subject_, one.oracle); });
    if (!own.broken.empty()) found = std::move(own);
  }
  std::optional<hunt::Trial> least(const std::string&) override { return std::nullopt; }
  void note(const std::string&, const hunt::Trial&) override {}
  std::optional<hunt::Hit> found;

 private:
  const std::string& subject_;
  const hunt::Source& source_;
  const std::optional<mutants::Subject>& right_;
  const process::Limits& limits_;
};

int hunt_for(const mutants::Subject& subject, std::map<std::string, double> asked) {
  hunt::Quarry quarry;
  quarry.engine = choice_of(subject);
  quarry.limits.run_seconds = 20, quarry.jobs = static_cast<int>(asked["--jobs"]);
  const hunt::Source source(static_cast<std::uint64_t>(asked["--seed"]));
  const std::optional<mutants::Subject> right = right_of(subject);
  First first(subject.name, source, right, quarry.limits);
  quarry.memory = &first;
  const auto start = std::chrono::steady_clock::now();
  const auto more = [&](std::uint64_t begun) {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return !first.found && static_cast<double>(begun) < asked["--scenes"] && seconds < asked["--seconds"];
  };
  const hunt::Found found = hunt::search(source, static_cast<std::uint64_t>(asked["--first"]), quarry, more);
  nlohmann::ordered_json line = {
      {"name", subject.name}, {"scenes", found.scenes}, {"refused", found.refused}};
  if (first.found) {
    const hunt::Hit& hit = *first.found;
    line["number"] = hit.number, line["family"] = hit.family;
    for (const hunt::Broken& broken : hit.broken)
      line["broken"].push_back(fmt::format("{} {}", broken.oracle, hunt::name(broken.kind)));
  }
  fmt::print("{}\n", line.dump());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words == std::vector<std::string>{"--list"}) {
    for (const mutants::Subject& mutant : mutants::mutants()) fmt::print("{}\n", mutant.name);
    fmt::print("--\n");
    for (const mutants::Subject& right : mutants::correct_subjects()) fmt::print("{}\n", right.name);
    return 0;
  }
  const bool worker = words.size() == 2 && words[0] == "--worker";
  const std::string name = words.empty() ? "" : words[worker ? 1 : 0];
  const auto all = subjects();
  const auto subject = std::ranges::find(all, name, &mutants::Subject::name);
  if (subject == all.end()) {
    fmt::print(stderr, "no mutant '{}'; see --list\n", name);
    return 2;
  }
  if (worker) return serve(*subject);
  std::map<std::string, double> asked{
      {"--seed", 1}, {"--first", 0}, {"--scenes", 5000}, {"--seconds", 120}, {"--jobs", 2}};
  for (std::size_t i = 1; i + 1 < words.size(); i += 2) {
    if (!asked.contains(words[i])) {
      fmt::print(stderr, "no option '{}'\n", words[i]);
      return 2;
    }
    asked[words[i]] = std::strtod(words[i + 1].c_str(), nullptr);
  }
  return hunt_for(*subject, asked);
}
