// Which step each engine needs, as plain tables, for a reader of the page without script.
#pragma once

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace cylon::reports {

/// HTML of the documents under "trades" (`cylon matrix --json`, `cylon trade --json`): for each scenario a row per engine; "" where
/// there are none.  What is not as those commands write it stands as "?".
std::string steps_tables(const std::map<std::string, std::vector<nlohmann::ordered_json>>& documents);

}  // namespace cylon::reports
