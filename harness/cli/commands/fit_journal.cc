#include "harness/cli/commands/fit_journal.h"

#include <nlohmann/json.hpp>

namespace cylon::cli {

FitJournal::FitJournal(const std::filesystem::path& file, bool resume) : file_(file) {
  if (resume)
    file_.read([&](const nlohmann::json& line) {
      deviances_[{line.at("key"), line.at("round"), line.at("values")}] = line.at("deviance");
    });
  file_.open(resume);
}

validation::Memory FitJournal::memory(const std::string& key) {
  return {.find = [this, key](int round, std::span<const double> values) -> std::optional<double> {
            const auto found = deviances_.find({key, round, {values.begin(), values.end()}});
            return found == deviances_.end() ? std::nullopt : std::optional(found->second);
          },
          .found =
              [this, key](const validation::Evaluation& one) {
                file_.add(
                    {{"key", key}, {"round", one.round}, {"values", one.values}, {"deviance", one.deviance}});
              }};
}

}  // namespace cylon::cli
