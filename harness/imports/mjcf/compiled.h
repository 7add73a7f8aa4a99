// A compiled model of MuJoCo as cylon-import-mjcf prints it: arrays by the names of mjModel, whatever release wrote them.
#pragma once

#include "harness/imports/model/model.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::imports {

// The numbers of MuJoCo's enumerations, which no release has changed (mujoco/mjmodel.h).
enum class MjGeom { plane, hfield, sphere, capsule, ellipsoid, cylinder, box, mesh, sdf };
enum class MjJoint { free, ball, slide, hinge };
enum class MjEquality { connect, weld, joint, tendon };
enum class MjTransmission { joint, joint_in_parent, slider_crank, tendon, site, body };

/// A number of the compiled model that is NaN or infinite; what() names element and array.
struct NotFinite : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Compiled {
 public:
  explicit Compiled(const nlohmann::json& json) : json_(json) {}

  std::string library() const { return json_.at("library").get<std::string>(); }
  int version() const { return json_.at("version").get<int>(); }
  /// Of mjModel: "nbody"; 0 where the release has no such size.
  int size(const char* name) const { return json_.at("sizes").value(name, 0); }
  double option(const char* name) const { return finite(json_.at("option").at(name), name); }
  /// Of one that the other library may not tell.
  double option(const char* name, double otherwise) const {
    return json_.at("option").contains(name) ? option(name) : otherwise;
  }
  foreign::Vector3 gravity() const { return vector("option", "gravity", 0); }
  bool disabled(const char* what) const;
  /// Whether `actuatorgroupdisable` names this group of actuators.
  bool disabled_group(int group) const;
  /// The friction of every contact in place of that of its geoms, and their margin; nothing where the option
  /// `override` is off.
  std::optional<double> friction_of_all() const;
  std::optional<double> margin_of_all() const;
  /// Whether `override` gives the two tangents different frictions.
  bool is_override_anisotropic() const;
  /// Pictures that the file names and that are not there; nothing in a scene follows from them.
  std::vector<std::string> absent() const { return json_.value("absent", std::vector<std::string>()); }
  /// What the library warned of.
  std::vector<std::string> warnings() const { return json_.value("warnings", std::vector<std::string>()); }
  /// Options and flags of the solver that are not MuJoCo's own, by their names.
  std::vector<std::string> solver_options() const {
    return json_.at("option").value("solver", std::vector<std::string>());
  }
  /// Which pairs of geoms touch: "predefined" those of <pair> alone, "dynamic" all others alone, "all".
  std::string collision() const { return json_.at("option").value("collision", "all"); }

  /// Entry of an array; `otherwise` where the release has no such array.  All of these throw NotFinite.
  double number(const char* array, int i, double otherwise = 0) const;
  int integer(const char* array, int i, int otherwise = 0) const;
  std::size_t length(const char* array) const;  ///< 0 where there is none.
  /// Whether a row of an array of `rows` rows has an entry that is not zero.
  bool any(const char* array, int row, int rows) const;
  foreign::Vector3 vector(const char* array, int row) const { return vector("arrays", array, row); }
  foreign::Quaternion quaternion(const char* array, int row) const {
    return quaternion("arrays", array, row);
  }
  /// The same of mjData at the start; `started`: how many numbers.
  double start(const char* array, int i) const { return entry("start", array, at(i)); }
  std::size_t started(const char* array) const { return json_.at("start").at(array).size(); }
  foreign::Vector3 start_vector(const char* array, int row) const { return vector("start", array, row); }
  foreign::Quaternion start_quaternion(const char* array, int row) const {
    return quaternion("start", array, row);
  }

  /// "" where it has none.
  std::string name(const char* kind, int i) const;
  /// "geom 'foot'", "geom 3" where it has no name.
  foreign::Place place(const char* kind, int i) const;
  /// How many of a kind it has.
  int count(const char* kind) const;

 private:
  const nlohmann::json& override_of_contacts() const;
  static double finite(const nlohmann::json& number, const std::string& where);
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  double entry(const char* group, const char* array, std::size_t i) const;
  foreign::Vector3 vector(const char* group, const char* array, int row) const;
  foreign::Quaternion quaternion(const char* group, const char* array, int row) const;
  std::string owner(std::string_view array, std::size_t i, std::size_t length) const;

  const nlohmann::json& json_;
};

}  // namespace cylon::imports
