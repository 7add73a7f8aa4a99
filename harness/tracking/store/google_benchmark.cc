#include "harness/tracking/store/google_benchmark.h"

#include "harness/core/input_error.h"
#include "harness/tracking/store/json_object.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <ostream>
#include <utility>

namespace cylon::store {
namespace {

using nlohmann::json;
using Ordered = nlohmann::ordered_json;

struct Unit {
  std::string_view name;
  double seconds;
};
constexpr std::array units = {Unit{"ns", 1e-9}, Unit{"us", 1e-6}, Unit{"ms", 1e-3}, Unit{"s", 1}};

// What is no counter of the user's (Google Benchmark 1.7, src/json_reporter.cc).
const std::set<std::string>& own_keys() {
  static const std::set<std::string> keys = {"name",
                                             "family_index",
                                             "per_family_instance_index",
                                             "run_name",
                                             "run_type",
                                             "repetitions",
                                             "repetition_index",
                                             "threads",
                                             "iterations",
                                             "real_time",
                                             "cpu_time",
                                             "time_unit",
                                             "error_occurred",
                                             "error_message",
                                             "label",
                                             "aggregate_name",
                                             "aggregate_unit",
                                             "big_o",
                                             "rms",
                                             "cpu_coefficient",
                                             "real_coefficient"};
  return keys;
}

std::string machine(JsonObject& context) {
  const auto number = [&](const char* key) { return context.has(key) ? context.integer(key, 0) : 0; };
  return fmt::format("{}, {} logical CPUs, {} MHz",
                     context.has("host_name") ? context.text("host_name") : "unknown host",
                     number("num_cpus"), number("mhz_per_cpu"));
}

double seconds_per_unit(JsonObject& object) {
  const std::string word = object.text("time_unit");
  for (const Unit& unit : units)
    if (unit.name == word) return unit.seconds;
  object.refuse("time_unit", fmt::format("'{}' is none of ns, us, ms, s", clean(word)));
}

void add_samples(Result& result, JsonObject& object, const json& row) {
  const std::int64_t repetition =
      row.contains("repetition_index") ? object.integer("repetition_index", 0) : 0;
  if (row.contains("error_occurred") && object.boolean("error_occurred")) {
    Judgement failed{
        .claim = fmt::format("runs, repetition {}", repetition), .status = "fail", .expected = "pass"};
    failed.detail = object.text("error_message");
    result.judgements.push_back(std::move(failed));
    return;
  }
  const double scale = seconds_per_unit(object);
  for (const char* key : {"real_time", "cpu_time"})
    result.samples.push_back({{key, Kind::time, "s"}, repetition, scale * object.number(key), ""});
  for (const auto& [key, value] : row.items())
    if (!own_keys().contains(key) && value.is_number())
      result.samples.push_back({{key, Kind::info, ""}, repetition, value.get<double>(), ""});
}

std::vector<Result> results_from(const json& benchmarks, const std::string& program, const Place& place) {
  std::vector<Result> results;
  std::map<std::string, std::size_t> at;
  for (std::size_t i = 0; i < benchmarks.size(); ++i) {
    const json& row = benchmarks[i];
    JsonObject object(row, place, fmt::format("benchmark {}", i + 1));
    if (row.contains("run_type") && object.text("run_type") == "aggregate") continue;
    const std::string name = row.contains("run_name") ? object.text("run_name") : object.text("name");
    const auto [found, fresh] = at.try_emplace(name, results.size());
    if (fresh) {
      Result result;
      result.cell.scenario = name;
      result.cell.engine = program;
      results.push_back(std::move(result));
    }
    add_samples(results[found->second], object, row);
  }
  if (results.empty())
    place.refuse(benchmarks.empty() ? "\"benchmarks\" is empty"
                                    : "\"benchmarks\" holds aggregates alone; run it without "
                                      "--benchmark_report_aggregates_only");
  return results;
}

// Cylon's own cells have `cpu_seconds`, imported benchmarks what they came with.
double time_of(const Result& result, std::int64_t repetition, std::initializer_list<std::string_view> names) {
  for (const std::string_view wanted : names)
    for (const Sample& s : result.samples)
      if (s.metric.name == wanted && s.metric.kind == Kind::time && s.metric.unit == "s" &&
          s.repetition == repetition)
        return s.value;
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

Imported read_google_benchmark(Store& store, std::string_view document, const std::string& file,
                               const RunInfo& given) {
  const Place place{file, 1};
  const json root = parse_json(document, place);
  JsonObject object(root, place, "the document");
  JsonObject described(object.value("context"), place, "\"context\"");
  RunInfo run = given;
  run.date = described.text("date");
  run.machine = machine(described);
  run.complete = true;
  run.uid = run_uid(run, 0);
  const std::string program = std::filesystem::path(described.text("executable")).filename().string();
  const std::vector<Result> results = results_from(object.array("benchmarks"), program, place);
  Imported imported;
  store.in_one_transaction([&] {
    std::int64_t id = 0;
    imported.runs = store.import_run(run, id) ? 1 : 0;
    for (const Result& result : results) {
      if (const std::string word = twice(result); !word.empty())
        place.refuse(fmt::format("{}: {} stands twice", result.cell.scenario, word));
      const std::string stored = store.stored_digest(id, cell_hash(result.cell));
      if (!stored.empty() && stored != digest(result))
        place.refuse(fmt::format("{} of this run is in the store with other values", result.cell.name()));
      if (stored.empty()) store.add(id, result);
      ++(stored.empty() ? imported.results : imported.here_already);
    }
  });
  return imported;
}

void write_google_benchmark(const Store& store, const RunInfo& run, std::ostream& out) {
  const Ordered context = {{"date", run.date},
                           {"host_name", run.machine},
                           {"executable", "cylon"},
                           {"library_build_type", "release"},
                           {"cylon_revision", run.revision},
                           {"cylon_run", run.uid}};
  out << "{\n\"context\": " << context.dump(-1, ' ', true) << ",\n\"benchmarks\": [";
  const char* separator = "\n";
  for (const Result& result : store.results(run.id))
    for (std::int64_t i = 0;; ++i) {
      const double cpu = time_of(result, i, {"cpu_time", "cpu_seconds"});
      if (std::isnan(cpu)) break;
      const double real = time_of(result, i, {"real_time"});
      const std::string name = result.cell.dt_text.empty() ? result.cell.scenario : result.cell.name();
      Ordered row = {
          {"name", name},          {"run_name", name}, {"run_type", "iteration"},
          {"repetition_index", i}, {"iterations", 1},  {"real_time", 1e9 * (std::isnan(real) ? cpu : real)},
          {"cpu_time", 1e9 * cpu}, {"time_unit", "ns"}};
      for (const Sample& s : result.samples)
        if (s.repetition == i && s.text.empty() && s.metric.kind != Kind::time && !std::isnan(s.value))
          row[s.metric.name] = s.value;
      out << separator << row.dump(-1, ' ', true);
      separator = ",\n";
    }
  out << "\n]\n}\n";
}

}  // namespace cylon::store
