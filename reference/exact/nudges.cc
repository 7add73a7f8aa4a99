#include "reference/exact/nudges.h"

#include "harness/core/fields.h"
#include "harness/core/truth.h"

#include <type_traits>

namespace cylon::exact {
namespace {

class Nudges {
 public:
  Nudges(const core::Scene& scene, double step) : moved_(scene), step_(step) {
    core::for_each_element(moved_, [&](auto& element) { nudge(element); });
  }

  std::vector<core::Scene> scenes;

 private:
  // Every number of an element that matters, in the order of the table; words, flags and bodies stay.
  template <class T>
  void nudge(T& element) {
    core::for_each_field(element, [&](const auto& field, auto& value) {
      if (!field.applies || field.applies(element)) member(element, value);
    });
  }

  template <class T, class Value>
  void member(const T& of, Value& value) {
    if constexpr (std::is_same_v<Value, double>) {
      number(value);
    } else if constexpr (std::is_same_v<Value, core::Vector3>) {
      for (double& x : value) number(x);
    } else if constexpr (std::is_same_v<Value, std::optional<core::Vector3>> ||
                         std::is_same_v<Value, std::optional<double>>) {
      if (value) member(of, *value);
    } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
      for (double& x : value) number(x);
    } else if constexpr (std::is_same_v<Value, core::NamedNumbers>) {
      for (auto& [name, x] : value) number(x);
    } else if constexpr (std::is_same_v<Value, std::vector<core::JointDisplacement>> ||
                         std::is_same_v<Value, std::vector<core::JointAngle>>) {
      for (auto& coordinate : value) nudge(coordinate);
    } else if constexpr (std::is_same_v<Value, core::Quaternion>) {
      for (double& x : value.coeffs()) number(x);
    } else if constexpr (std::is_same_v<Value, core::Matrix3>) {
      tensor(value);
    } else if constexpr (std::is_same_v<Value, core::BodyState>) {
      nudge(value);
    } else if constexpr (std::is_same_v<Value, core::Shape>) {
      if (of.collide) std::visit([&](auto& shape) { of_shape(shape); }, value);
    } else {
      // Points of hulls and meshes and the parts of compounds are in no solution's domain.
      static_assert(core::is_word<Value> || std::is_same_v<Value, std::vector<core::Vector3>> ||
                        std::is_same_v<Value, std::vector<core::Part>>,
                    "say how a value of this type is nudged");
    }
  }

  void of_shape(std::monostate&) {}
  template <class Shape>
  void of_shape(Shape& shape) {
    nudge(shape);
  }

  void number(double& x) { entry(x, x, step_ * x); }

  // A full tensor goes through an eigenvalue solver, whose error is one of the tensor as a whole.
  void tensor(core::Matrix3& m) {
    const bool diagonal = m.isDiagonal(0.0);
    const double largest = m.cwiseAbs().maxCoeff();
    for (int i = 0; i < 3; ++i)
      for (int j = diagonal ? i : 0; j <= i; ++j)
        entry(m(i, j), m(j, i), step_ * (diagonal ? m(i, j) : largest));
  }

  // One number, or the two equal ones of a symmetric tensor, for one scene.
  void entry(double& x, double& same, double amount) {
    if (amount == 0) return;
    const double was = x, other = same;
    x += amount;
    if (&same != &x) same += amount;
    // A copy of the scene for each number of each body.
    constexpr std::size_t most_copies = 400'000;  // of bodies
    if ((scenes.size() + 1) * moved_.bodies.size() > most_copies)
      throw core::OutOfDomain(
          "it bounds its error by moving each number of the scene, and this scene has too "
          "many bodies for that");
    scenes.push_back(moved_);
    x = was, same = other;
  }

  core::Scene moved_;
  const double step_;
};

}  // namespace

std::vector<core::Scene> nudged(const core::Scene& scene, double step) { return Nudges(scene, step).scenes; }

}  // namespace cylon::exact
