// hunted --list: the names of all mutants, and of the right simulators behind "--", one a line.
// hunted NAME --seed S --first N --scenes N --seconds T --jobs J: looks for the mutant's fault as `cylon hunt` does, until a
//   scene has one, and prints a line of JSON: how many scenes were asked and, where one has a fault, its number and the
//   oracles that it breaks.  Exits 2 for an unknown name.
// hunted --worker NAME: the mutant as a worker.
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

// Stops handing out scenes once one has a fault.
class First final : public hunt::Memory {
 public:
  std::optional<hunt::Hit> asked(std::uint64_t) override { return std::nullopt; }
  void note(const hunt::Hit& hit) override { found = found || !hit.broken.empty(); }
  std::optional<hunt::Trial> least(const std::string&) override { return std::nullopt; }
  void note(const std::string&, const hunt::Trial&) override {}
  bool found = false;
};

int hunt_for(const mutants::Subject& subject, std::map<std::string, double> asked) {
  hunt::Quarry quarry;
  quarry.engine.id = subject.name;
  quarry.engine.row = {subject.name, {"/proc/self/exe", "--worker", subject.name}, ""};
  quarry.engine.integrator = subject.setup.integrator;
  quarry.engine.options = subject.setup.options;
  quarry.limits.run_seconds = 20, quarry.jobs = static_cast<int>(asked["--jobs"]);
  First first;
  quarry.memory = &first;
  const auto start = std::chrono::steady_clock::now();
  const auto more = [&](std::uint64_t begun) {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return !first.found && static_cast<double>(begun) < asked["--scenes"] && seconds < asked["--seconds"];
  };
  const hunt::Source source(static_cast<std::uint64_t>(asked["--seed"]));
  const hunt::Found found = hunt::search(source, static_cast<std::uint64_t>(asked["--first"]), quarry, more);
  nlohmann::ordered_json line = {{"name", subject.name}, {"scenes", found.scenes}};
  if (!found.hits.empty()) {
    const hunt::Hit& hit = found.hits.front();
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
