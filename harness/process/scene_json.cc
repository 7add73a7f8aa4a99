#include "harness/process/scene_json.h"

#include "harness/process/element_json.h"

#include <fmt/format.h>

#include <stdexcept>
#include <unordered_set>

namespace cylon::process {
namespace {

using core::Scene;
using core::Vector3;
using nlohmann::json;

class Reader {
 public:
  explicit Reader(const json& value) : top_(value, "") {}

  Scene read() {
    each<core::Body>([&](Fields& fields, core::Body& body) {
      element_.name_body(fields, body.name);
      scene_.bodies.push_back(std::move(body));
    });
    core::for_each_force([&]<class Kind>() {
      if constexpr (std::is_same_v<Kind, core::UniformGravity>)
        gravity();
      else if (!core::comes_later<Kind> || top_.find(core::Element<Kind>::name.data()))
        each<Kind>([&](Fields&, Kind& force) { scene_.forces.emplace_back(std::move(force)); });
    });
    each<core::Joint>([&](Fields&, core::Joint& joint) { scene_.joints.push_back(joint); });
    each<core::Plane>([&](Fields&, core::Plane& plane) { scene_.planes.push_back(std::move(plane)); });
    each<core::Material>([&](Fields&, core::Material& m) { scene_.materials.push_back(std::move(m)); });
    if (const json* value = top_.find("frame")) {
      Fields fields(*value, "frame");
      element_(fields, scene_.frame.emplace());
      fields.finish();
    }
    scene_.impacts = static_cast<core::Impacts>(word(top_, "impacts", core::Words<core::Impacts>::list));
    top_.finish();
    return std::move(scene_);
  }

 private:
  void gravity() {
    if (const Vector3 g = top_.vector("gravity"); g != Vector3::Zero())
      scene_.forces.emplace_back(core::UniformGravity{g});
  }

  // Every element of an array as an object whose keys are all read.
  template <class T, class Take>
  void each(Take take) {
    top_.each(core::Element<T>::name.data(), [&](const json& value, const std::string& place) {
      Fields fields(value, place);
      T element;
      element_(fields, element);
      take(fields, element);
      fields.finish();
    });
  }

  Fields top_;
  Scene scene_;
  ElementReader element_;
};

}  // namespace

json to_json(const Scene& scene) {
  std::unordered_set<std::string> names;
  for (const core::Body& body : scene.bodies)
    if (!names.insert(body.name).second)
      throw std::invalid_argument(fmt::format("two bodies are named '{}'", body.name));

  const ElementWriter element(scene);
  json out = json::object();
  const auto rows = [&]<class T>(const std::vector<T>& elements) {
    json& array = out[core::Element<T>::name] = json::array();
    for (const T& e : elements) array.push_back(element(e));
  };
  rows(scene.bodies);
  core::for_each_force([&]<class Kind>() {
    if (!core::comes_later<Kind>) out[core::Element<Kind>::name] = json::array();
  });
  std::optional<Vector3> gravity;  // no sum with zero: -0 stays -0
  for (const core::Force& force : scene.forces)
    std::visit(
        [&]<class Kind>(const Kind& f) {
          if constexpr (std::is_same_v<Kind, core::UniformGravity>)
            gravity = gravity ? Vector3(*gravity + f.acceleration) : f.acceleration;
          else
            out[core::Element<Kind>::name].push_back(element(f));
        },
        force);
  out[core::Element<core::UniformGravity>::name] = vector_json(gravity.value_or(Vector3::Zero()));
  rows(scene.joints);
  rows(scene.planes);
  rows(scene.materials);
  if (scene.frame) out[core::Element<core::Frame>::name] = element(*scene.frame);
  out["impacts"] = core::Words<core::Impacts>::list[static_cast<std::size_t>(scene.impacts)];
  return out;
}

Scene scene_from_json(const json& value) { return Reader(value).read(); }

}  // namespace cylon::process
