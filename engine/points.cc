#include "engine/points.h"

#include "engine/methods.h"

namespace cylon::engine {

std::string not_points(const Model& model) { return missing(Method::points, model); }

}  // namespace cylon::engine
