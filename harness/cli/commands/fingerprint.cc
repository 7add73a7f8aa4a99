#include "harness/cli/commands/fingerprint.h"

#include "harness/cli/command_line.h"
#include "harness/process/client.h"
#include "harness/process/interruption.h"
#include "harness/process/session.h"
#include "harness/scenario/glob.h"
#include "harness/study/probes.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>

namespace cylon::cli {
namespace {

using nlohmann::ordered_json;

std::string text(const std::string& id, const std::vector<study::Finding>& findings) {
  std::string out = id + ", measured behaviour:\n";
  for (std::size_t i = 0; i < findings.size(); ++i)
    out += fmt::format("  {:<18} {}\n  {:<18}   {}\n", study::probes()[i].name, findings[i].answer, "",
                       findings[i].evidence);
  return out + '\n';
}

ordered_json to_json(const std::string& id, const std::vector<study::Finding>& findings) {
  ordered_json rows = ordered_json::array();
  for (std::size_t i = 0; i < findings.size(); ++i)
    rows.push_back({{"probe", study::probes()[i].name},
                    {"asks", study::probes()[i].asks},
                    {"answer", findings[i].answer},
                    {"evidence", findings[i].evidence}});
  return {{"id", id}, {"findings", rows}};
}

}  // namespace

int fingerprint(const std::vector<process::EngineRow>& engines, const std::vector<std::string>& asked,
                bool json) {
  std::vector<process::EngineChoice> choices;
  for (const process::EngineRow& row : engines)
    if ((asked.empty() && !row.optional()) ||
        std::any_of(asked.begin(), asked.end(),
                    [&](const std::string& glob) { return scenario::glob_match(glob, row.id); }))
      choices.push_back(process::parse_engine(row.id, engines));
  for (const std::string& id : asked)  // variants, and names that are none: an error with the nearest
    if (std::none_of(choices.begin(), choices.end(), [&](const process::EngineChoice& choice) {
          return scenario::glob_match(id, choice.id);
        }))
      choices.push_back(process::parse_engine(id, engines));
  for (const process::EngineChoice& choice : choices) process::require_possible(choice);
  const process::Interruptible until_told;
  ordered_json rows = ordered_json::array();
  bool whole = true;
  try {
    for (const process::EngineChoice& choice : choices) {
      const process::KeptWorkers kept;  // those in Node take longer to start than to answer
      const auto findings = study::find_out(study::worker_runner(choice, {}));
      if (json)
        rows.push_back(to_json(choice.id, findings));
      else
        std::cout << plain(text(choice.id, findings)) << std::flush;
    }
  } catch (const process::Interrupted&) {
    whole = false;
  }
  if (json) std::cout << rows.dump(2, ' ', true) << '\n';
  if (whole) return ok;
  std::cerr << "interrupted: what is printed is of the engines that are done\n";
  return interrupted;
}

}  // namespace cylon::cli
