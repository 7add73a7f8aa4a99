// Every mutant is caught by its claim, and every judge accepts the correct simulators.
#include "tests/mutants/matrix/deaths.h"
#include "tests/mutants/matrix/matrix.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <ostream>
#include <set>

namespace cylon::mutants {

void PrintTo(const Subject& subject, std::ostream* out) { *out << subject.name; }

namespace {

std::string name_of(const testing::TestParamInfo<Subject>& info) {
  std::string name;
  for (const char c : info.param.name) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return std::to_string(info.index) + "_" + name;
}

const std::vector<Death>& listed() {
  static const std::vector<Death> all = listed_deaths();
  return all;
}

// That it dies by no means before the listed one, `./test mutants` alone checks, as it takes every judge.
class Mutant : public testing::TestWithParam<Subject> {};
TEST_P(Mutant, IsCaughtByItsClaimAndByShippedOnes) {
  const Line line = judge_one(GetParam());
  EXPECT_TRUE(line.caught) << GetParam().fault << "\n" << line.subject.judge << ", " << line.seen;
  const auto row = std::ranges::find(listed(), GetParam().name, &Death::mutant);
  ASSERT_NE(row, listed().end()) << "not in deaths.txt: ./test mutants --deaths writes it";
  EXPECT_TRUE(row->judge == GetParam().judge ? means_of(line) == row->means : holds(*row, GetParam()))
      << GetParam().fault << "\n"
      << row->judge << " does not accuse it by '" << row->means << "', as deaths.txt has it";
}
INSTANTIATE_TEST_SUITE_P(All, Mutant, testing::ValuesIn(mutants()), name_of);

class Right : public testing::TestWithParam<Subject> {};
TEST_P(Right, PassesAllJudges) {
  const Line line = judge_all(GetParam());
  const bool asked_by_all = GetParam().name == correct_subjects().front().name;
  for (std::size_t j = 0; j < line.cells.size(); ++j) {
    const MatrixCell& cell = line.cells[j];
    // A judge that asks nothing convicts nobody and is no judge.
    EXPECT_TRUE(cell.asked > 0 || !asked_by_all) << judges()[j].name;
    EXPECT_FALSE(cell.guilty) << judges()[j].name << ", " << cell.worst.claim << ": " << cell.worst.measured
                              << " of " << cell.worst.allowed;
  }
}
INSTANTIATE_TEST_SUITE_P(All, Right, testing::ValuesIn(correct_subjects()), name_of);

TEST(Judges, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const Judge& judge : judges()) EXPECT_TRUE(names.insert(judge.name).second) << judge.name << " twice";
}

TEST(Errata, EachHasAMutantOrAReason) {
  constexpr int last = 67;
  std::multiset<int> numbers;
  for (const Subject& subject : seed_mutants()) numbers.insert(subject.erratum);
  for (const NotCounted& row : not_counted()) numbers.insert(row.erratum);
  for (int n = 1; n <= last; ++n) EXPECT_EQ(numbers.count(n), 1u) << "erratum " << n;
  EXPECT_EQ(numbers.size(), static_cast<std::size_t>(last));
}

// The counts of README.md are of deaths.txt.
TEST(Mutants, AreThoseOfDeathsTxt) {
  std::vector<std::string> have, are;
  for (const Death& death : listed()) have.push_back(death.mutant);
  for (const Subject& subject : mutants()) are.push_back(subject.name);
  EXPECT_EQ(have, are) << "./test mutants --deaths > tests/mutants/deaths.txt";
}

TEST(Mutants, HaveNamesAndJudges) {
  std::set<std::string> names, columns;
  for (const Judge& judge : judges()) columns.insert(judge.name);
  for (const Subject& subject : mutants()) {
    EXPECT_TRUE(names.insert(subject.name).second) << subject.name << " twice";
    EXPECT_TRUE(columns.contains(subject.judge)) << subject.name << ": no judge " << subject.judge;
    EXPECT_FALSE(subject.fault.empty()) << subject.name;
    EXPECT_FALSE(subject.claim.empty()) << subject.name;
  }
}

}  // namespace
}  // namespace cylon::mutants
