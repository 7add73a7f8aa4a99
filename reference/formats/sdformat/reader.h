// A world or a model of SDFormat, as libsdformat reads it, as a foreign model.
#pragma once

#include "harness/imports/model/model.h"

#include <sdf/sdf.hh>

#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace cylon::formats {

class SdfReader {
 public:
  SdfReader(std::string file, std::vector<std::string> roots);

  /// Throws Refused with all errors of the library, each with file and line.
  foreign::Model read();

 private:
  /// All that decides whom a surface touches and how: the outermost model, whether its link touches others of that model
  /// too (`self`), and the rest.
  using Surface = std::tuple<int, bool, int, double, double>;  // model, self, bits, friction, restitution

  void read_file(const sdf::ParserConfig&);
  void read_world(const sdf::World&);
  /// Whose links touch which: the number of the outermost model, and whether they touch each other.
  struct Own {
    int number = 0;
    bool self = false;
  };
  void read_model(const sdf::Model&, const foreign::Pose& frame, const std::string& scope, bool locked, Own);
  void read_link(const sdf::Link&, const foreign::Pose& frame, const std::string& scope, bool locked, Own);
  void read_collision(const sdf::Collision&, const std::string& link, const foreign::Pose& centre, Own,
                      foreign::Body&);
  void read_shape(const sdf::Collision&, foreign::Solid&);
  Surface surface_of(const sdf::Collision&, Own, const foreign::Place&);
  /// What stands in the file and is not read above; `line`: of what is around it.
  void check_elements(const sdf::ElementPtr&, int line);
  /// What the library warns of while it reads the file, which it does again.
  void check_warnings(sdf::ParserConfig);
  void read_joint(const sdf::Joint&, const foreign::Pose& frame, const std::string& scope);
  foreign::Freedom freedom_of(const sdf::JointAxis&, const foreign::Pose& frame, const foreign::Place&);
  void lose_sensor(const sdf::Sensor&);
  void lose_drive(const sdf::JointAxis&, const foreign::Place&);
  /// What an axis says that acts on no coordinate of its joint.
  void lose_axis(const sdf::JointAxis&, const char* which, sdf::JointType, const foreign::Place&);
  void read_plugins(const sdf::ElementPtr&);
  void add_meetings();
  int body_of(const std::string& scope, const std::string& name, const foreign::Place&) const;

  void lose(const char* what, foreign::Place, std::string detail = "");
  foreign::Place place(const char* kind, const std::string& name, const sdf::ElementPtr&) const;
  /// "" for that which is read.
  std::string other_file(const std::string& path) const;

  std::string file_;
  std::vector<std::string> roots_;
  std::map<std::string, int> bodies_;  // by scoped name
  std::map<Surface, int> surfaces_;
  bool windy_ = false;
  foreign::Model model_;
};

}  // namespace cylon::formats
