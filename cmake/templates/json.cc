#include "cmake/templates/json.h"

#define CYLON_NOTHING
CYLON_JSON_TEMPLATES(CYLON_NOTHING, nlohmann::json)
CYLON_JSON_TEMPLATES(CYLON_NOTHING, nlohmann::ordered_json)
