// Scores of predictions and values of fits as plain tables, for a reader of the page without script.
#pragma once

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace cylon::reports {

/// HTML of the documents under "predictions" (`cylon predict --json`) and "fits" (`cylon fit --json`); "" where there are none.
/// What is not as those commands write it stands as "?".
std::string measured_tables(const std::map<std::string, std::vector<nlohmann::ordered_json>>& documents);

}  // namespace cylon::reports
