#include "harness/cli/shard.h"

#include "harness/cli/farm.h"
#include "harness/core/content_hash.h"
#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <stdexcept>

namespace cylon::cli {
namespace {

// The variables by which a runner tells a process its part.
struct Runner {
  const char *index, *count;        // of the part, and of all
  const char *first, *last, *step;  // of the indices; nullptr: they count from 0 in steps of 1
  const char* told;                 // a file that says that the parts are heeded; nullptr: there is none
};
constexpr Runner runners[] = {
    {"GTEST_SHARD_INDEX", "GTEST_TOTAL_SHARDS", nullptr, nullptr, nullptr, "GTEST_SHARD_STATUS_FILE"},
    {"TEST_SHARD_INDEX", "TEST_TOTAL_SHARDS", nullptr, nullptr, nullptr, "TEST_SHARD_STATUS_FILE"},
    {"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_MAX",
     "SLURM_ARRAY_TASK_STEP", nullptr}};

constexpr std::size_t most_shards = 1'000'000;

// Empty where it is not set, or set to nothing, as Bazel does without shards.
std::string variable(const char* name) {
  const char* text = name ? std::getenv(name) : nullptr;  // NOLINT(concurrency-mt-unsafe): before any thread
  return text ? text : "";
}

std::optional<std::size_t> whole_number(const std::string& text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number > most_shards) return std::nullopt;
  return number;
}

std::size_t number_in(const char* name, std::size_t otherwise) {
  const std::string text = variable(name);
  if (text.empty()) return otherwise;
  const auto number = whole_number(text);
  if (!number)
    throw core::InputError(fmt::format("{} = '{}': not a whole number of at most {}; give --shard k/n", name,
                                       text, most_shards));
  return *number;
}

// How many parts a runner says that there are; 0 where it does not.  First and last index say it, too.
std::size_t count_of(const Runner& runner, std::size_t first, std::size_t step) {
  if (variable(runner.last).empty() || variable(runner.first).empty()) return number_in(runner.count, 0);
  const std::size_t last = number_in(runner.last, 0);
  const std::size_t all = step > 0 && last >= first ? (last - first) / step + 1 : 0;
  const std::size_t count = number_in(runner.count, all);
  if (count != all)
    throw core::InputError(
        fmt::format("{} = {}, but {} to {} in steps of {} are {}: the array has gaps; give --shard k/n",
                    runner.count, count, first, last, step, all));
  return count;
}

// As GoogleTest does, half of what is needed is taken for a mistake: the whole would be done by each of many.
[[noreturn]] void refuse_half(const Runner& runner) {
  for (const char* name : {runner.index, runner.count, runner.last, runner.first})
    if (const std::string text = variable(name); !text.empty())
      throw core::InputError(
          fmt::format("{} = '{}', but {} is not set; set both, unset {}, or give --shard k/n", name, text,
                      name == runner.index ? runner.count : runner.index, name));
  throw std::logic_error("no variable of a runner is set");
}

std::optional<Shard> shard_of(const Runner& runner) {
  const bool indexed = !variable(runner.index).empty(), counted = !variable(runner.count).empty();
  const bool ranged = !variable(runner.first).empty() && !variable(runner.last).empty();
  if (!indexed && !counted && !ranged) return std::nullopt;
  if (!indexed || !(counted || ranged)) refuse_half(runner);
  const std::size_t id = number_in(runner.index, 0);
  const std::size_t first = number_in(runner.first, 0), step = number_in(runner.step, 1);
  const std::size_t count = count_of(runner, first, step);
  const bool regular = step > 0 && id >= first && (id - first) % step == 0 && (id - first) / step < count;
  if (!regular)
    throw core::InputError(fmt::format(
        "{} = {} is no index of {} = {}{}; give --shard k/n", runner.index, id, runner.count, count,
        runner.first ? fmt::format(" that start at {} in steps of {}: the array has gaps", first, step)
                     : ""));
  if (const std::string file = variable(runner.told); !file.empty()) std::ofstream(file, std::ios::app);
  return Shard{.index = (id - first) / step + 1, .count = count, .said_by = runner.index};
}

std::optional<Shard> shard_of_environment() {
  std::optional<Shard> found;
  for (const Runner& runner : runners) {
    const auto shard = shard_of(runner);
    if (!shard) continue;
    if (found && (found->index != shard->index || found->count != shard->count))
      throw core::InputError(fmt::format("{} says shard {} of {}, and {} says {} of {}; give --shard k/n",
                                         found->said_by, found->index, found->count, shard->said_by,
                                         shard->index, shard->count));
    if (!found) found = shard;
  }
  return found;
}

std::uint64_t hash_of(const std::string& key) {
  core::ContentHash content;
  content.add(key);
  return content.value();
}

// Of each unit, with that of the others in place of what nobody knows.
std::vector<double> durations_of(std::span<const Unit> units, const Durations& known) {
  std::vector<double> there;
  for (const Unit& unit : units)
    if (const auto found = known.find(unit.name); found != known.end()) there.push_back(found->second);
  std::ranges::sort(there);  // so that the sum does not depend on the order of the units
  const double sum = std::accumulate(there.begin(), there.end(), 0.0);
  const double mean = there.empty() ? 1 : sum / static_cast<double>(there.size());
  std::vector<double> seconds;
  for (const Unit& unit : units) {
    const auto found = known.find(unit.name);
    seconds.push_back(found != known.end() ? found->second : mean);
  }
  return seconds;
}

std::vector<bool> by_time(const Shard& shard, std::span<const Unit> units, const Durations& known) {
  const std::vector<double> seconds = durations_of(units, known);
  std::vector<double> load(shard.count, 0.0);
  std::vector<bool> mine(units.size());
  for (const std::size_t i : longest_first(units, known)) {
    const auto least = std::ranges::min_element(load);
    *least += seconds[i];
    mine[i] = static_cast<std::size_t>(least - load.begin()) + 1 == shard.index;
  }
  return mine;
}

}  // namespace

std::string Shard::label() const { return fmt::format("{}{}-of-{}", farm ? "rank-" : "", index, count); }

std::vector<std::size_t> longest_first(std::span<const Unit> units, const Durations& known) {
  const std::vector<double> seconds = durations_of(units, known);
  std::vector<std::size_t> order(units.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    return seconds[a] != seconds[b] ? seconds[a] > seconds[b] : units[a].key < units[b].key;
  });
  return order;
}

void add_shard_options(App& app, ShardOptions& options, const std::string& units) {
  app.add_option(
         "--shard", options.shard,
         fmt::format("Do part k of n of the {0}, each of which belongs to one part; `cylon merge` joins "
                     "the parts. Default: the part that GTEST_SHARD_INDEX, TEST_SHARD_INDEX or "
                     "SLURM_ARRAY_TASK_ID says, else all {0}",
                     units))
      ->type_name("k/n");
  app.add_choice(
         "--shard-by", {"hash", "time"},
         [&options](const std::string& word) { options.by_time = word == "time"; },
         "How they are shared out: hash, by content, or time, by the durations of the last whole or merged "
         "run "
         "in this folder")
      ->type_name("hash|time")
      ->default_str("hash");
}

std::optional<Shard> shard_asked(const ShardOptions& options, Farm* farm) {
  if (farm && (!options.shard.empty() || options.by_time))
    throw core::InputError("--shard, --shard-by: a farm hands out the work itself");
  if (farm) return farm->shard();
  std::optional<Shard> shard;
  if (options.shard.empty()) {
    shard = shard_of_environment();
  } else {
    const std::size_t slash = options.shard.find('/');
    const auto index = whole_number(options.shard.substr(0, slash));
    const auto count =
        slash == std::string::npos ? std::nullopt : whole_number(options.shard.substr(slash + 1));
    if (!index || !count || *index < 1 || *index > *count)
      throw core::InputError(fmt::format("--shard '{}': not k/n with whole numbers 1 <= k <= n <= {}",
                                         options.shard, most_shards));
    shard = Shard{.index = *index, .count = *count, .said_by = "--shard"};
  }
  if (shard) shard->by_time = options.by_time;
  if (!shard && options.by_time)
    throw core::InputError("--shard-by time: there is nothing to share out without --shard k/n");
  return shard;
}

std::vector<bool> part_of(const Shard& shard, std::span<const Unit> units, const Durations& known) {
  if (shard.by_time) return by_time(shard, units, known);
  std::vector<bool> mine;
  for (const Unit& unit : units) mine.push_back(hash_of(unit.key) % shard.count + 1 == shard.index);
  return mine;
}

}  // namespace cylon::cli
