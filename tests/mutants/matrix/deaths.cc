#include "tests/mutants/matrix/deaths.h"

#include "tests/paths.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <thread>

namespace cylon::mutants {
namespace {

constexpr std::array<const char*, 3> all_means = {"own", "theory",
                                                  "relations"};  // the first that kills counts

// Its place in all_means; past the end where nobody is accused.
std::size_t means_of(const std::vector<Finding>& findings) {
  std::size_t found = all_means.size();
  for (const Finding& finding : findings)
    if (finding.guilty())
      found = std::min<std::size_t>(found, finding.of_relation() ? 2 : finding.of_file() ? 0 : 1);
  return found;
}

}  // namespace

std::optional<Death> death_of(const Subject& subject) {
  std::vector<const Judge*> order;
  for (const Judge& judge : judges())
    if (judge.shipped) order.push_back(&judge);
  std::ranges::stable_partition(order, [&](const Judge* judge) { return judge->name == subject.judge; });
  std::size_t best = all_means.size();
  std::string by;
  for (const Judge* judge : order) {
    const auto findings = judge->findings(subject);
    if (const std::size_t means = findings ? means_of(*findings) : best; means < best)
      best = means, by = judge->name;
    if (best == 0) break;
  }
  if (best == all_means.size()) return std::nullopt;
  return Death{all_means[best], by, subject.name};
}

std::vector<Death> deaths(int threads) {
  judges();  // made once, before there are threads
  const std::vector<Subject> subjects = mutants();
  std::vector<std::optional<Death>> found(subjects.size());
  std::atomic<std::size_t> next = 0;
  {
    std::vector<std::jthread> pool;
    for (int i = 0; i < threads; ++i)
      pool.emplace_back([&] {
        for (std::size_t k = 0; (k = next++) < subjects.size();) found[k] = death_of(subjects[k]);
      });
  }
  std::vector<Death> all;
  for (const auto& death : found)
    if (death) all.push_back(*death);
  return all;
}

bool holds(const Death& death, const Subject& subject) {
  const auto judge = std::ranges::find(judges(), death.judge, &Judge::name);
  if (judge == judges().end() || !judge->shipped) return false;
  const auto findings = judge->findings(subject);
  const std::size_t means = findings ? means_of(*findings) : all_means.size();
  return means < all_means.size() && death.means == all_means[means];
}

std::string means_of(const Line& line) {
  return line.dies_of_own()      ? "own"
         : line.dies_of_claims() ? "theory"
         : line.dies_shipped()   ? "relations"
                                 : "";
}

std::vector<Death> listed_deaths() {
  std::ifstream file(std::filesystem::path(source_dir) / "tests/mutants/deaths.txt");
  std::vector<Death> all;
  for (std::string line; std::getline(file, line);) {
    const std::size_t first = line.find('\t'), second = line.find('\t', first + 1);
    if (line.starts_with('#') || second == std::string::npos) continue;
    all.push_back(
        {line.substr(0, first), line.substr(first + 1, second - first - 1), line.substr(second + 1)});
  }
  return all;
}

std::string text(const std::vector<Death>& deaths) {
  std::string out =
      "# By what each mutant dies: own (a claim as it stands in its file), theory, relations; by which "
      "judge; its name.\n"
      "# Generated: ./test mutants --deaths > tests/mutants/deaths.txt\n";
  for (const Death& death : deaths)
    out += fmt::format("{}\t{}\t{}\n", death.means, death.judge, death.mutant);
  return out;
}

}  // namespace cylon::mutants
