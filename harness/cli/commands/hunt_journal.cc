#include "harness/cli/commands/hunt_journal.h"

#include "harness/cli/content_of.h"
#include "harness/cli/identity_of.h"
#include "harness/scenario/scenario.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace cylon::cli {
namespace {

using nlohmann::json;

json to_json(const hunt::Hit& hit) {
  json broken = json::array();
  for (const hunt::Broken& one : hit.broken)
    broken.push_back({one.oracle, hunt::name(one.kind), one.by_time});
  return {{"number", hit.number}, {"family", hit.family}, {"broken", broken}, {"refused", hit.refused}};
}

hunt::Hit hit_from(const json& j) {
  hunt::Hit hit{j.at("number"), j.at("family"), {}, j.at("refused")};
  for (const json& one : j.at("broken")) {
    const auto kind = hunt::kind_from(one.at(1).get<std::string>());
    if (!kind) throw std::invalid_argument("kind");
    hit.broken.push_back({one.at(0), *kind, one.at(2)});
  }
  return hit;
}

hunt::Trial trial_from(const std::string& toml) {
  const scenario::Scenario scenario = scenario::parse(toml, "journal");
  return {scenario.scene, scenario.step, std::llround(scenario.duration / scenario.step)};
}

}  // namespace

// Each line has a key, by which `cylon merge` knows it.
class HuntJournal::Answers final : public hunt::Memory {
 public:
  Answers(LineFile& file, std::mutex& writing, std::string question)
      : file_(file), writing_(writing), question_(std::move(question)) {}

  void take(const json& line) {
    if (line.contains("least"))
      least_[line.at("group")] = line.at("least");
    else
      hits_[line.at("number")] = hit_from(line);
  }

  std::optional<hunt::Hit> asked(std::uint64_t number) override {
    const auto at = hits_.find(number);
    return at == hits_.end() ? std::nullopt : std::optional(at->second);
  }
  void note(const hunt::Hit& hit) override {
    json line = to_json(hit);
    line["key"] = fmt::format("{} #{}", question_, hit.number), line["hunt"] = question_;
    const std::scoped_lock lock(writing_);
    file_.add(line);
  }
  std::optional<hunt::Trial> least(const std::string& group) override {
    const auto at = least_.find(group);
    return at == least_.end() ? std::nullopt : std::optional(trial_from(at->second));
  }
  void note(const std::string& group, const hunt::Trial& least) override {
    const std::scoped_lock lock(writing_);
    file_.add({{"key", question_ + " " + group},
               {"hunt", question_},
               {"group", group},
               {"least", hunt::to_toml(least, "")}});
  }

 private:
  LineFile& file_;
  std::mutex& writing_;
  std::string question_;
  std::map<std::uint64_t, hunt::Hit> hits_;
  std::map<std::string, std::string> least_;
};

HuntJournal::HuntJournal(const std::filesystem::path& file, bool resume) : file_(file) {
  if (resume)
    file_.read([&](const json& line) {
      if (line.contains("hunt")) {
        const std::string question = line.at("hunt");
        auto& answers = answers_[question];
        if (!answers) answers = std::make_unique<Answers>(file_, writing_, question);
        answers->take(line);
      } else if (line.contains("cell")) {
        done_.insert(line.at("key"));
      }
    });
  file_.open(resume);
}

HuntJournal::~HuntJournal() = default;

void HuntJournal::done(const Unit& unit, double seconds) {
  const std::scoped_lock lock(writing_);
  if (done_.insert(unit.key).second)
    file_.add({{"key", unit.key}, {"cell", unit.name}, {"seconds", seconds}});
}

hunt::Memory& HuntJournal::of(const std::string& question) {
  auto& answers = answers_[question];
  if (!answers) answers = std::make_unique<Answers>(file_, writing_, question);
  return *answers;
}

std::string question_of(const process::EngineChoice& engine, const hunt::Source& source, double timeout) {
  return fmt::format("{} {} {} {} {}", engine.id, identity_of(engine.row), content_of({"/proc/self/exe"}),
                     source.name(), timeout);
}

}  // namespace cylon::cli
