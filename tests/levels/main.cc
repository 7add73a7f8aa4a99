// levels_study CASE SEEDS FILE [LOW HIGH [EXPERIMENT TOSSES]]: an experiment of each seed, a line of FILE each; SEEDS is a number
// N, for 0 to N - 1, or FIRST-LAST.  What FILE has is not done again.  Then how often intervals held the truth and the model was
// refused, with Clopper and Pearson's intervals of 95 %.  Exit code 1 where an interval by the stated uncertainties held it in
// less than LOW or more than HIGH per cent.  EXPERIMENT TOSSES: the case "cube", so many tosses of that file, made and fitted by
// the engine in this program.
#include "harness/tracking/statistics/proportion.h"
#include "tests/levels/in_process.h"
#include "tests/levels/levels.h"

#include <fmt/format.h>

#include <fstream>
#include <iostream>
#include <map>
#include <sstream>

namespace {

using namespace cylon;

// Tosses of the shipped experiment: `count` of them, made by the engine that this program has, and fitted with it.
std::vector<levels::Case> cube_cases(const std::string& file, int count) {
  measured::Experiment e = measured::read(file);
  e.runs.resize(static_cast<std::size_t>(count));
  e.fit.degrees = std::numeric_limits<double>::infinity();  // the noise is all that is wrong
  std::vector<measured::Parameter> wanted;
  std::vector<double> truth;
  for (const measured::Parameter& p : e.parameters)
    if (p.kind == "friction" || p.kind == "restitution" || p.kind == "inertia" || p.kind == "length") {
      wanted.push_back(p);
      truth.push_back(p.kind == "length"        ? 0.98
                      : p.kind == "friction"    ? 0.2
                      : p.kind == "restitution" ? 0.2
                                                : 1.05);
    }
  e.parameters = wanted;
  return {{"cube", e, truth, levels::in_process(), levels::in_process()}};
}

// "1000": 0 to 999; "1000-1999": those.
std::pair<std::uint64_t, std::uint64_t> first_and_end(const std::string& seeds) {
  const std::size_t dash = seeds.find('-');
  if (dash == std::string::npos) return {0, std::stoull(seeds)};
  return {std::stoull(seeds.substr(0, dash)), std::stoull(seeds.substr(dash + 1)) + 1};
}

std::string share(const std::string& what, std::size_t hits, std::size_t trials) {
  const auto i = statistics::proportion_interval(hits, trials, 0.025);
  return fmt::format("{:<28} {:5.1f} % [{:.1f}, {:.1f}]\n", what,
                     100 * static_cast<double>(hits) / static_cast<double>(trials), 100 * i.low,
                     100 * i.high);
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() < 3) {
    std::cerr << "levels_study CASE SEEDS FILE [LOW HIGH [EXPERIMENT TOSSES]]\n";
    return 2;
  }
  const std::string &name = words[0], &file = words[2];
  const std::vector<levels::Case> cases =
      words.size() > 6 ? cube_cases(words[5], std::stoi(words[6])) : levels::ball_cases();
  const levels::Case& what = levels::find(cases, name);
  const std::pair<std::uint64_t, std::uint64_t> seeds = first_and_end(words[1]);
  const std::uint64_t first = seeds.first, end = seeds.second;
  std::map<std::uint64_t, std::string> done;
  {
    std::ifstream in(file);
    std::string line;
    while (std::getline(in, line))
      if (std::istringstream fields(line); !line.empty() && line.back() == ';') {
        std::uint64_t seed = 0;
        std::string bits;
        if (fields >> seed >> bits) done[seed] = bits;
      }
  }
  std::ofstream out(file, std::ios::app);
  for (std::uint64_t seed = first; seed < end; ++seed) {
    if (done.contains(seed)) continue;
    const levels::Trial trial = levels::trial(what, seed);
    std::string bits;
    for (const auto& list : {trial.held, trial.held_between})
      for (const bool held : list) bits += held ? '1' : '0';
    bits += trial.told ? '1' : '0', bits += trial.settled ? '1' : '0';
    out << fmt::format("{} {} ;\n", seed, bits) << std::flush;
    done[seed] = bits;
    std::cerr << fmt::format("\r{} of {}", done.size(), end - first) << std::flush;
  }
  std::erase_if(done, [&](const auto& one) { return one.first < first || one.first >= end; });
  std::cerr << "\r";
  std::cout << fmt::format("{}: {} experiments of {} runs\n", what.name, done.size(), what.like.runs.size());
  const std::size_t k = what.truth.size();
  bool kept = true;  // whether the stated intervals held the truth in LOW to HIGH % of all
  for (std::size_t at = 0; at < 2 * k + 2; ++at) {
    std::size_t hits = 0;
    for (const auto& [seed, bits] : done) hits += bits.at(at) == '1';
    const std::string label =
        at < 2 * k    ? what.like.parameters[at % k].name + (at < k ? ", stated" : ", between runs")
        : at == 2 * k ? "refused"
                      : "settled";
    std::cout << share(label, hits, done.size());
    const double percent = 100 * static_cast<double>(hits) / static_cast<double>(done.size());
    if (at < k && words.size() > 4)
      kept = kept && std::stod(words[3]) <= percent && percent <= std::stod(words[4]);
  }
  return kept ? 0 : 1;
}
