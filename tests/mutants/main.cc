// mutants [WORD…]: prints the kill matrix, of all or of the subjects with one of the words in their names;
// exits 1 where a mutant lives, a right simulator is accused or deaths.txt is not current.
// mutants --deaths: prints deaths.txt, by what each mutant dies.
// mutants --static: prints static_scenes.txt, the scenes in which nothing moves or no law says whether anything does.
#include "tests/mutants/matrix/deaths.h"
#include "tests/mutants/matrix/matrix.h"
#include "tests/mutants/matrix/shipped.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

namespace {

using cylon::mutants::Subject;

std::vector<Subject> named(std::vector<Subject> subjects, const std::vector<std::string>& words) {
  if (words.empty()) return subjects;
  std::erase_if(subjects, [&](const Subject& subject) {
    return std::none_of(words.begin(), words.end(), [&](const std::string& word) {
      return subject.name.find(word) != std::string::npos;
    });
  });
  return subjects;
}

void print_static_scenes() {
  using namespace cylon::mutants;
  fmt::print(
      "# Shipped scenes in which no body moves a tenth of its size or turns by 0.1 rad.\n"
      "# Generated: ./test mutants --static > tests/mutants/static_scenes.txt\n");
  for (const auto& file : shipped_scenarios()) {
    const auto scenario = cylon::scenario::load(file);
    if (std::ranges::find(undecided(), scenario.name, &Undecided::scenario) != undecided().end()) continue;
    if (!dynamic(scenario, run_shipped(scenario, correct_subjects().front())))
      fmt::print("{}\n", scenario.name);
  }
  fmt::print(
      "# Shipped scenes in which bodies do move, and no law says how far, with the reason "
      "(matrix/shipped.cc):\n"
      "# a simulator that stands still is right.\n");
  for (const Undecided& row : undecided()) fmt::print("{}\t{}\n", row.scenario, row.reason);
}

// Says which of the mutants die by another means than deaths.txt has; whether there are none.
bool as_listed(const std::vector<cylon::mutants::Line>& lines) {
  using namespace cylon::mutants;
  bool all = true;
  const std::vector<Death> listed = listed_deaths();
  for (const Line& line : lines) {
    const auto row = std::ranges::find(listed, line.subject.name, &Death::mutant);
    const std::string before = row == listed.end() ? "" : row->means, now = means_of(line);
    if (before == now) continue;
    all = false;
    fmt::print("{} dies by '{}', and by '{}' in deaths.txt: ./test mutants --deaths writes it\n",
               line.subject.name, now, before);
  }
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace cylon::mutants;
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words == std::vector<std::string>{"--static"}) {
    print_static_scenes();
    return 0;
  }
  if (words == std::vector<std::string>{"--deaths"}) {
    fmt::print("{}", text(deaths(std::max(1, static_cast<int>(std::thread::hardware_concurrency())))));
    return 0;
  }
  const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const std::vector<Line> right = judge_all(named(correct_subjects(), words), threads),
                          wrong = judge_all(named(mutants(), words), threads);
  std::vector<Line> all = right;
  all.insert(all.end(), wrong.begin(), wrong.end());
  fmt::print("{}", print(all));
  for (const NotCounted& row : not_counted())
    fmt::print("erratum {} is not counted: {}\n", row.erratum, row.reason);
  const bool current = as_listed(wrong);
  const std::string last = summary(wrong, right);
  fmt::print("{}\n", last);
  return current && last.ends_with(" 0 alive, 0 false accusations") ? 0 : 1;
}
