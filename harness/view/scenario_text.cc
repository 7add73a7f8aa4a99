#include "harness/view/scenario_text.h"

#include "harness/process/scene_json.h"

#include <string>

namespace cylon::view {
namespace {

using Json = nlohmann::ordered_json;

// A worker gets a part's shape beside its mass; a file has both in one table.
void flatten(Json& shape) {
  if (!shape.contains("parts")) return;
  for (Json& part : shape["parts"]) {
    Json flat = part["shape"];
    part.erase("shape");
    flat.update(part);
    part = flat;
  }
}

// No file may state a body that nothing turns about one of its axes; only a shape has such an inertia (a
// rod).
bool stated(const core::Matrix3& inertia) { return core::principal_axes(inertia).moments.minCoeff() > 0; }

void fit_body(Json& row, const core::Body& body) {
  if (!stated(body.inertia)) row.erase("inertia");
  if (row.contains("shape")) flatten(row["shape"]);
  if (body.color.empty()) row.erase("color");
}

// Either a force, or a rate with a velocity of the mass.
void fit_thrust(Json& row) {
  const bool rate = row.contains("exhaust_velocity") || row.contains("exchanged_velocity");
  row.erase(rate ? "force" : "mass_rate");
}

void fit_joint(Json& row) {
  if (row["type"] != "hinge") row.erase("axis");
  if (row["type"] != "distance")
    row.erase("length");
  else if (row.contains("to"))
    row.erase("point");
}

}  // namespace

Json scene_keys(const core::Scene& scene) {
  Json result = process::to_ordered_json(scene);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) fit_body(result["body"][i], scene.bodies[i]);
  for (Json& row : result["thrust"]) fit_thrust(row);
  for (Json& row : result["joint"]) fit_joint(row);
  if (result["gravity"] == Json({0.0, 0.0, 0.0})) result.erase("gravity");
  return result;
}

}  // namespace cylon::view
