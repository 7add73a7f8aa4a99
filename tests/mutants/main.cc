// mutants [WORD…]: prints the kill matrix, of all or of the subjects with one of the words in their names;
// exits 1 where a mutant lives or a right simulator is accused.
#include "tests/mutants/matrix/matrix.h"

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

}  // namespace

int main(int argc, char** argv) {
  using namespace cylon::mutants;
  const std::vector<std::string> words(argv + 1, argv + argc);
  const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const std::vector<Line> right = judge_all(named(correct_subjects(), words), threads),
                          wrong = judge_all(named(mutants(), words), threads);
  std::vector<Line> all = right;
  all.insert(all.end(), wrong.begin(), wrong.end());
  fmt::print("{}", print(all));
  for (const NotCounted& row : not_counted())
    fmt::print("erratum {} is not counted: {}\n", row.erratum, row.reason);
  const std::string last = summary(wrong, right);
  fmt::print("{}\n", last);
  return last.ends_with(" 0 alive, 0 false accusations") ? 0 : 1;
}
