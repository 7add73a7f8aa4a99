#include "harness/cli/union.h"

#include "harness/cli/line_file.h"
#include "harness/core/input_error.h"
#include "harness/input/json.h"
#include "harness/process/last_words.h"
#include "harness/process/sandbox.h"
#include "reports/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>
#include <utility>

namespace cylon::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct File {
  fs::path path;
  std::optional<Part> part;
  std::vector<std::pair<std::string, Result>> results;  // by key, in the order of the file
  std::size_t strange = 0;
  bool sandboxed = false;
};

// Throws std::exception for a line that holds no result.
Result result_of(const json& line) {
  Result result{line, {}};
  if (line.contains("cell")) static_cast<void>(line.at("cell").get_ref<const std::string&>());
  if (!line.contains("verdicts")) return result;
  for (const json& verdict : line.at("verdicts").get_ref<const json::array_t&>())
    result.verdicts.push_back(reports::from_json_line(verdict.get_ref<const std::string&>()));
  return result;
}

// What reads a file line by line, and says how many lines are strange.
using Reader = std::function<std::size_t(const fs::path&, const std::function<void(const json&)>&)>;

File read(const fs::path& path, const Reader& reader) {
  File file{path, {}, {}, 0, false};
  file.strange = reader(path, [&](const json& line) {
    if (LineFile::is_sandbox_mark(line))
      file.sandboxed = true;
    else if (line.contains("part"))
      file.part = part_from(line);
    else if (!line.contains("request")) {
      file.results.emplace_back(line.at("key").get<std::string>(), result_of(line));
    }
  });
  if (file.part && file.part->command == "run")
    file.strange +=
        std::erase_if(file.results, [](const auto& one) { return !one.second.line.contains("verdicts"); });
  return file;
}

File read_own(const fs::path& path) {
  return read(path, [](const fs::path& file, const std::function<void(const json&)>& take) {
    return LineFile(file).read_as_data(take);
  });
}

// In every text of it.
void leave_out_last_words(json& value) {
  if (value.is_string()) value = process::without_last_words(value.get<std::string>());
  if (value.is_structured())
    for (json& part : value) leave_out_last_words(part);
}

// What must come out again: all but times, what workers write to stderr (process ids, addresses), and the command for the
// row, in which the user's path to the file stands.  Verdicts are kept as text, so that their digits stay.
json reproducible(json line) {
  // An advice is chosen by cost, so that all of it follows from times.
  for (const char* time : {"seconds", "load", "step", "advice"}) line.erase(time);
  if (line.contains("ran")) line["ran"].erase("cpu");
  if (line.contains("verdicts"))
    for (json& verdict : line["verdicts"]) {
      verdict = input::parse_json(verdict.get<std::string>());
      for (const char* other : {"cpu_seconds", "cpu_verified", "stderr", "reproduce"}) verdict.erase(other);
    }
  leave_out_last_words(line);
  return line;
}

std::string contradiction(const File& a, const json& first, const File& b, const json& second) {
  const json left = reproducible(first), right = reproducible(second);
  const json patch = json::diff(left, right);
  if (patch.empty()) return "";
  const std::string place = patch[0].at("path");
  const auto shown = [&](const json& whole) {
    const json::json_pointer at(place);
    return whole.contains(at) ? whole.at(at).dump(-1, ' ', true, json::error_handler_t::replace)
                              : std::string("nothing");
  };
  const std::string name = first.value("cell", first.at("key").get<std::string>());
  return fmt::format("{}: {} is {} in {} and {} in {}", name, place, shown(left), a.path.string(),
                     shown(right), b.path.string());
}

// Why two journals are not of one question.
void require_same(const File& a, const File& b) {
  if (a.part->command != b.part->command)
    throw core::InputError(fmt::format("{} is of `cylon {}`, {} of `cylon {}`", a.path.string(),
                                       a.part->command, b.path.string(), b.part->command));
  if (a.part->suite != b.part->suite)
    throw core::InputError(
        fmt::format("{} is of the suite '{}', {} of '{}': they are not parts of one question",
                    a.path.string(), a.part->suite, b.path.string(), b.part->suite));
  if (a.part->units == b.part->units) return;
  const auto by_name = [](const Part& part) {
    std::map<std::string, std::string> keys;
    for (const Unit& unit : part.units) keys[unit.name] = unit.key;
    return keys;
  };
  const auto left = by_name(*a.part), right = by_name(*b.part);
  for (const auto& [name, key] : left) {
    const auto found = right.find(name);
    if (found == right.end())
      throw core::InputError(fmt::format("{} asks for '{}', {} does not: they are not parts of one question",
                                         a.path.string(), name, b.path.string()));
    if (found->second != key)
      throw core::InputError(
          fmt::format("'{}' is another scenario, engine, build of cylon or list of expectations in {} than "
                      "in {}: {} and {}",
                      name, a.path.string(), b.path.string(), key, found->second));
  }
  if (left.size() < right.size()) return require_same(b, a);
  throw core::InputError(
      fmt::format("{} and {} ask for the same cells in another order", a.path.string(), b.path.string()));
}

Union union_of(std::vector<File> files, Part part) {
  Union all;
  std::map<std::string, std::size_t> source;  // of each line
  for (std::size_t f = 0; f < files.size(); ++f) {
    all.strange += files[f].strange;
    all.sandboxed = all.sandboxed || files[f].sandboxed;
    for (auto& [key, result] : files[f].results) {
      const auto [there, is_new] =
          all.results.try_emplace(key, std::move(result));  // stays where it is not new
      if (is_new) {
        source[key] = f;
        continue;
      }
      std::string why = contradiction(files[source[key]], there->second.line, files[f], result.line);
      if (!why.empty()) all.contradictions.push_back(std::move(why));
    }
  }
  all.part = std::move(part);
  all.part.index = all.part.count = 1;
  std::ranges::copy_if(all.part.units, std::back_inserter(all.missing),
                       [&](const Unit& unit) { return !all.results.contains(unit.key); });
  return all;
}

}  // namespace

Union unite(std::span<const fs::path> paths) {
  std::vector<File> files;
  Room room;
  for (const fs::path& path : paths) {
    files.push_back(read(path, [&](const fs::path& file, const auto& take) {
      return LineFile::read_of_others(file, room, take);
    }));
    if (!files.back().part)
      throw core::InputError(fmt::format("{}: no journal that can be merged; {} write them into .cylon",
                                         path.string(), sharing_commands()));
    require_same(files.front(), files.back());
  }
  const Part part = *files.front().part;
  const fs::path own = journal_file(part.command);
  std::error_code ignored;
  if (fs::exists(own, ignored) &&
      std::ranges::none_of(paths, [&](const fs::path& path) { return fs::equivalent(path, own, ignored); }))
    files.push_back(read_own(own));
  return union_of(std::move(files), part);
}

Union unite_own(const Part& part, std::span<const fs::path> paths) {
  std::vector<File> files;
  std::ranges::transform(paths, std::back_inserter(files), read_own);
  Union all = union_of(std::move(files), part);
  if (all.sandboxed) process::require_sandbox_again("what this folder holds was written");
  return all;
}

void write(const Union& all, const fs::path& place) {
  LineFile lock(place);
  lock.open(true);  // nobody runs here meanwhile
  const fs::path fresh = place.string() + ".merging";
  {
    LineFile file(fresh, place);
    file.open(false);
    if (all.sandboxed && !process::sandboxing()) file.add(LineFile::sandbox_mark(), LineFile::Disk::later);
    file.add(to_json(all.part), LineFile::Disk::later);
    std::set<std::string> written;
    const auto add = [&](const std::string& key, const json& line) {
      if (written.insert(key).second) file.add(line, LineFile::Disk::later);
    };
    for (const Unit& unit : all.part.units)
      if (const auto found = all.results.find(unit.key); found != all.results.end())
        add(unit.key, found->second.line);
    for (const auto& [key, result] : all.results) add(key, result.line);
    file.synchronise();
    if (!lock.is_open() || !file.is_open())
      throw core::InputError(fmt::format("{}: cannot be written", place.string()));
  }
  std::error_code error;
  fs::rename(fresh, place, error);
  if (error) throw core::InputError(fmt::format("{}: {}", place.string(), error.message()));
}

}  // namespace cylon::cli
