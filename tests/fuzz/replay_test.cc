// Every fuzz target over its seeds, each cut off at 16 places, and over mutants of them: what can be asked
// without libFuzzer, in seconds.  tests/fuzz/corpus/ holds small files that reach far, and all that ever
// failed.
#include "tests/fuzz/targets/targets.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_seed = 20'000;  // [bytes]
constexpr int mutants = 600;                  // of each target

struct Seed {
  std::string name, bytes;
};

void add_files(const fs::path& folder, const std::string& ending, std::vector<Seed>& all) {
  if (!fs::is_directory(folder)) return;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (!entry.is_regular_file() || !entry.path().string().ends_with(ending)) continue;
    std::ifstream in(entry.path(), std::ios::binary);
    Seed seed{entry.path().string(), std::string(std::istreambuf_iterator<char>(in), {})};
    if (seed.bytes.size() <= longest_seed) all.push_back(std::move(seed));
  }
}

// In the order of their names, so that every machine makes the same mutants.
std::vector<Seed> seeds(const Target& target) {
  std::vector<Seed> all;
  add_files(fs::path(source_dir) / "tests/fuzz/corpus" / target.name, "", all);
  const std::string_view glob = target.seeds;
  if (const std::size_t star = glob.find('*'); star != std::string_view::npos)
    add_files(fs::path(source_dir) / glob.substr(0, star), std::string(glob.substr(star + 1)), all);
  std::ranges::sort(all, {}, &Seed::name);
  return all;
}

std::size_t below(std::mt19937_64& random, std::size_t n) { return n == 0 ? 0 : random() % n; }

// One to four changes: of a byte, a number, a piece of syntax, a part doubled or cut.
std::string mutated(std::string text, std::mt19937_64& random) {
  using std::string_view_literals::operator""sv;
  static constexpr std::array numbers = {"1e308"sv,   "-1"sv,     "1e999"sv,
                                         "null"sv,    "nan"sv,    "0"sv,
                                         "-0.0"sv,    "5e-324"sv, "9223372036854775808"sv,
                                         "1000000"sv, "\"x\""sv};
  static constexpr std::array pieces = {"\0"sv, "\xff"sv, "\""sv,   "{"sv,       "["sv,       "]"sv,
                                        "}"sv,  ","sv,    "\n"sv,   "\\u0000"sv, "\\ud800"sv, ":"sv,
                                        "="sv,  "."sv,    "\r\n"sv, "\"\"\""sv};
  for (std::size_t i = 0, n = 1 + below(random, 4); i < n; ++i) {
    const std::size_t at = below(random, text.size() + 1), length = below(random, 40);
    switch (below(random, 6)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(random());
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(below(random, text.size() + 1), length));
        break;
      case 3:
        text.insert(at, pieces[below(random, pieces.size())]);
        break;
      default: {
        const std::size_t start = text.find_first_of("0123456789", at);
        if (start == std::string::npos) break;
        const std::size_t end = std::min(text.find_first_not_of("0123456789.e-+", start), text.size());
        text.replace(start, end - start, numbers[below(random, numbers.size())]);
      }
    }
  }
  return text;
}

// The first input that a target does not take as it promises, with what was thrown; "" where there is none.
std::string finding(const Target& target, const std::vector<Seed>& all) {
  const auto thrown = [&](const std::string& what, std::string_view bytes) -> std::string {
    try {
      target.feed(bytes);
      return "";
    } catch (const std::exception& error) {
      return what + ": " + error.what() + "\n" + std::string(bytes);
    }
  };
  for (const Seed& seed : all) {
    if (std::string found = thrown(seed.name, seed.bytes); !found.empty()) return found;
    for (std::size_t length = 0; length < seed.bytes.size(); length += 1 + seed.bytes.size() / 16)
      if (std::string found = thrown(seed.name + " cut off", std::string_view(seed.bytes).substr(0, length));
          !found.empty())
        return found;
  }
  std::mt19937_64 random(20261123);
  for (int i = 0; i < mutants; ++i) {
    const Seed& seed = all[static_cast<std::size_t>(i) % all.size()];
    if (std::string found = thrown(seed.name + ", mutant " + std::to_string(i), mutated(seed.bytes, random));
        !found.empty())
      return found;
  }
  return "";
}

class Replay : public testing::TestWithParam<Target> {};

TEST_P(Replay, TakesOrRefusesSeedsAndTheirMutants) {
  const std::vector<Seed> all = seeds(GetParam());
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(finding(GetParam(), all), "");
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Replay, testing::ValuesIn(targets().begin(), targets().end()),
                         [](const auto& one) { return std::string(one.param.name); });

// Negative control: a reader that stumbles over one number of one mutant.
TEST(ReplayControl, FindsAMutantThatIsNotTaken) {
  const Target stumbles = {"stumbles",
                           [](std::string_view bytes) {
                             if (bytes.find("1e999") != std::string_view::npos) throw Broken("stumbled");
                           },
                           "-"};
  EXPECT_NE(finding(stumbles, {{"seed", "mass = 3"}}).find("stumbled"), std::string::npos);
}

}  // namespace
}  // namespace cylon::fuzz
