#include "harness/cli/identity_of.h"

#include "harness/cli/content_of.h"
#include "harness/core/content_hash.h"
#include "harness/process/client.h"
#include "harness/study/parallel.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <string_view>
#include <thread>

namespace cylon::cli {
namespace {

constexpr std::string_view between("\0", 1);

std::string said_by(const process::EngineRow& row) {
  try {
    const core::Engine engine = process::describe({row.id, row, row.path, "", {}});
    return engine.name + std::string(between) + engine.version;
  } catch (const process::Interrupted&) {
    throw;
  } catch (const std::exception&) {  // why will be a verdict
    return "says nothing";
  }
}

// What engines said, by command; several threads may ask.
class Said {
 public:
  std::string of(const process::EngineRow& row) {
    {
      const std::scoped_lock lock(guard_);
      if (const auto found = known_.find(row.command); found != known_.end()) return found->second;
    }
    std::string said = said_by(row);
    const std::scoped_lock lock(guard_);
    return known_.emplace(row.command, std::move(said)).first->second;
  }

 private:
  std::mutex guard_;
  std::map<std::vector<std::string>, std::string> known_;
};

Said& said() {
  static Said all;
  return all;
}

}  // namespace

std::string identity_of(const process::EngineRow& row) {
  core::ContentHash content;
  content.add(content_of(row.command));
  content.add(between);
  content.add(said().of(row));
  return content.hex();
}

void identify(std::span<const process::EngineRow> rows) {
  std::vector<const process::EngineRow*> engines;
  for (const process::EngineRow& row : rows)
    if (std::ranges::none_of(engines, [&](const auto* other) { return other->command == row.command; }))
      engines.push_back(&row);
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  study::in_parallel(engines.size(), cores, [&](std::size_t i) { said().of(*engines[i]); });
}

}  // namespace cylon::cli
