#include "harness/study/restate.h"

#include "harness/core/fields.h"
#include "harness/core/joint_coordinates.h"

#include <cmath>
#include <type_traits>
#include <utility>

namespace cylon::study {
namespace {

using core::Expressed;
using core::Matrix3;
using core::Vector3;

// Of an orthogonal M: pseudovectors go with det(M) M.
Matrix3 pseudo(const Matrix3& m) { return m.determinant() * m; }

double power(double base, int exponent) {
  double result = 1;
  for (int i = 0; i < std::abs(exponent); ++i) result *= base;
  return exponent < 0 ? 1 / result : result;
}

// Every member of an element by its unit and frame.  With c the factor of the new units:
//   scalar x' = c x, place x' = c (turn x + move), world vector c turn x, pseudovector c det(turn) turn x,
//   in body axes c own x, tensor c own I own^T.
class Rule {
 public:
  explicit Rule(const Restatement& change) : c_(change) {}

  template <class T>
  void element(T& of) const {
    // normal' . x' = length (normal . x + normal' . move)
    if constexpr (std::is_same_v<T, core::Plane>) of.offset += Vector3(c_.turn * of.normal).dot(c_.move);
    core::for_each_field(of, [&](const auto& field, auto& value) { member(of, field.about, value); });
    if constexpr (std::is_same_v<T, core::Joint>) mirror(of);
    if constexpr (std::is_same_v<T, core::Mesh>)
      if (c_.own.determinant() < 0)
        for (auto& face : of.faces) std::swap(face[1], face[2]);  // counter-clockwise from outside again
  }

  // Its numbers have two dimensions; see restate.h.
  static void element(core::Water&) {}

  // Nobody knows its units: such scenes are not restated (core::Broken::restatement).
  static void element(core::PluginForce&) {}

 private:
  double factor(const core::About& about) const {
    const core::Dimension d = core::dimension(about.unit);
    return power(c_.mass, d.mass) * power(c_.length, d.length) * power(c_.time, d.time);
  }

  template <class T, class Value>
  void member(const T& of, const core::About& about, Value& value) const {
    if constexpr (std::is_same_v<Value, double>) {
      value *= factor(about);
    } else if constexpr (std::is_same_v<Value, Vector3>) {
      value = factor(about) * coordinates(of, about.in, value);
    } else if constexpr (std::is_same_v<Value, std::optional<Vector3>> ||
                         std::is_same_v<Value, std::optional<double>>) {
      if (value) member(of, about, *value);
    } else if constexpr (std::is_same_v<Value, std::vector<Vector3>> ||
                         std::is_same_v<Value, std::vector<double>>) {
      for (auto& v : value) member(of, about, v);
    } else if constexpr (std::is_same_v<Value, Matrix3>) {
      const Matrix3 turned = factor(about) * (c_.own * value * c_.own.transpose());
      value = (turned + turned.transpose()) / 2;
    } else if constexpr (std::is_same_v<Value, core::Quaternion>) {
      // R' = turn R own^T, and own R own^T of a part.  From quaternions where both are rotations (to
      // rounding), from matrices where both are mirrors.
      const Matrix3& left = about.in == Expressed::body_axes ? c_.own : c_.turn;
      value = core::Quaternion(pseudo(left)) * value * core::Quaternion(Matrix3(pseudo(c_.own).transpose()));
    } else if constexpr (std::is_same_v<Value, core::BodyState>) {
      element(value);
    } else if constexpr (std::is_same_v<Value, core::Shape> || std::is_same_v<Value, core::Primitive>) {
      std::visit(
          [&]<class Kind>(Kind& kind) {
            if constexpr (!std::is_same_v<Kind, std::monostate>) element(kind);
          },
          value);
    } else if constexpr (std::is_same_v<Value, std::vector<core::Part>> ||
                         std::is_same_v<Value, std::vector<core::JointDisplacement>> ||
                         std::is_same_v<Value, std::vector<core::JointAngle>>) {
      for (auto& inside : value) element(inside);
    } else {
      static_assert(core::is_word<Value>, "say how a value of this type is restated");
    }
  }

  // A mirror keeps axes as vectors, about which turns then go the other way; so does what the product of two axes points
  // along, so that the angle between two axes stays.
  void mirror(core::Joint& joint) const {
    if (c_.turn.determinant() > 0) return;
    const core::JointKind& kind = core::kind_of(joint.type);
    if (kind.screws) joint.pitch = -joint.pitch;
    // An offset is towards the product of the axes: of one of which the other direction is taken.
    const bool turned = kind.place == core::JointPlace::along_normal;
    if (turned) joint.axis = -joint.axis;
    for (core::JointAngle& angle : joint.angles)
      if (angle.which != core::Ordinal::third && !(turned && angle.which == core::Ordinal::first))
        core::reverse(angle);
    for (core::JointDisplacement& displacement : joint.displacements)
      if (displacement.which == core::Ordinal::second) core::reverse(displacement);
  }

  template <class T>
  Vector3 coordinates(const T& of, Expressed in, const Vector3& v) const {
    switch (in) {
      case Expressed::plain:
        return v;
      case Expressed::world_point:
        return c_.turn * v + c_.move;
      case Expressed::world_vector:
        return c_.turn * v;
      case Expressed::world_axial:
        return pseudo(c_.turn) * v;
      case Expressed::body_axes:
        return c_.own * v;
      case Expressed::other_end:
        if constexpr (requires { of.to; })
          if (of.to != core::world) return c_.own * v;
        return c_.turn * v + c_.move;
    }
    return v;
  }

  const Restatement& c_;
};

}  // namespace

core::BodyState Restatement::operator()(core::BodyState state) const {
  Rule(*this).element(state);
  return state;
}

core::State Restatement::operator()(core::State state) const {
  for (core::BodyState& s : state) s = (*this)(s);
  return state;
}

core::Scene Restatement::operator()(core::Scene scene) const {
  const Rule rule(*this);
  core::for_each_element(scene, [&](auto& element) { rule.element(element); });
  return scene;
}

}  // namespace cylon::study
