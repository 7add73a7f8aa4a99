#include "harness/hunt/shrink.h"

#include "harness/core/fields.h"
#include "harness/core/solid.h"
#include "harness/hunt/dice.h"
#include "harness/hunt/scene_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <type_traits>
#include <vector>

namespace cylon::hunt {
namespace {

using core::Body;
using core::Scene;
using core::Vector3;

// ---- Fewer parts ----------------------------------------------------------------------------------------

template <class List>
List without(List list, std::size_t i) {
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
  return list;
}

// ---- Simpler parts ------------------------------------------------------------------------------------------

// Those with fewer parameters first.
std::vector<core::Shape> simpler(const core::Shape& shape) {
  const double r = rounded(core::bounding_radius(shape), 1);
  std::vector<core::Shape> list;
  if (!std::holds_alternative<core::Sphere>(shape) && r > 0) list.emplace_back(core::Sphere{r});
  const auto* box = std::get_if<core::Box>(&shape);
  const auto cube = [&](double half) { list.emplace_back(core::Box{Vector3::Constant(half)}); };
  if (!box && !std::holds_alternative<core::Sphere>(shape)) cube(r / 2);
  if (box && box->half_extents != Vector3::Constant(box->half_extents.x()))
    for (int c = 0; c < 3; ++c) cube(box->half_extents[c]);
  return list;
}

// Of one element: no turn, no shape, and each number by zero, one, and fewer digits.
class Numbers {
 public:
  /// Calls visit(x) for each number that may be a simpler one, x a reference into the trial.
  template <class Visit>
  static void each(Trial& trial, const Visit& visit) {
    core::for_each_element(trial.scene, [&](auto& element) { of(element, visit); });
  }

 private:
  template <class Element, class Visit>
  static void of(Element& element, const Visit& visit) {
    core::for_each_field(element, [&]<class Value>(const auto& field, Value& value) {
      if (field.applies && !field.applies(element)) return;
      if constexpr (std::is_same_v<Value, double>) {
        visit(value);
      } else if constexpr (std::is_same_v<Value, Vector3>) {
        for (int c = 0; c < 3; ++c) visit(value[c]);
      } else if constexpr (std::is_same_v<Value, core::BodyState>) {
        for (Vector3* v : {&value.position, &value.velocity, &value.angular_velocity})
          for (int c = 0; c < 3; ++c) visit((*v)[c]);
      }
    });
  }
};

class Shrinking {
 public:
  Shrinking(Trial trial, const Faulty& faulty) : trial_(std::move(trial)), faulty_(faulty) {}

  Trial least() {
    while (round()) {
    }
    return std::move(trial_);
  }
  int asked() const { return asked_; }

 private:
  bool take(Trial candidate) {
    ++asked_;
    if (!faulty_(candidate)) return false;
    trial_ = std::move(candidate);
    return true;
  }
  bool take(Scene scene) { return take(Trial{std::move(scene), trial_.step, trial_.steps}); }

  // From the largest edits to the smallest; whether any of them was taken.
  bool round() {
    bool any = shorter();
    any |= no_frame();
    any |= the_first_few();
    any |= fewer(
        [](Scene & s) -> auto& { return s.bodies; },
        [](const Scene& s, std::size_t i) { return without_body(s, i); });
    any |= fewer_of(&Scene::joints);
    any |= fewer_laws();
    any |= fewer_of(&Scene::forces);
    any |= fewer_of(&Scene::planes);
    any |= fewer_of(&Scene::materials);
    any |= plainer_bodies();
    any |= rounder_numbers();
    return any;
  }

  bool shorter() {
    bool any = false;
    while (trial_.steps > 1 && take(Trial{trial_.scene, trial_.step, trial_.steps / 2})) any = true;
    for (const double step : {0.1, 0.01, 0.001})
      if (trial_.step < step && take(Trial{trial_.scene, step, trial_.steps})) any = true;
    return any;
  }

  bool no_frame() {
    if (!trial_.scene.frame) return false;
    Scene scene = trial_.scene;
    scene.frame.reset();
    return take(std::move(scene));
  }

  // The first bodies alone, which of a pile are its foot: a pile may show a fault at some heights and not at those between.
  bool the_first_few() {
    constexpr std::size_t few = 4;
    const std::size_t count = trial_.scene.bodies.size();
    for (std::size_t left = 1; left <= few && left + 1 < count; ++left) {
      Scene scene = trial_.scene;
      for (std::size_t last = count; last-- > left;) scene = without_body(std::move(scene), last);
      if (take(std::move(scene))) return true;
    }
    return false;
  }

  template <class List, class Without>
  bool fewer(const List& list, const Without& removed) {
    bool any = false;
    for (std::size_t i = list(trial_.scene).size(); i-- > 0;)
      if (i < list(trial_.scene).size()) any |= take(removed(trial_.scene, i));
    return any;
  }

  template <class Element>
  bool fewer_of(std::vector<Element> Scene::*member) {
    return fewer(
        [=](Scene & s) -> auto& { return s.*member; },
        [=](Scene s, std::size_t i) {
          s.*member = without(s.*member, i);
          return s;
        });
  }

  // Of joints: what acts along a coordinate.
  bool fewer_laws() {
    bool any = false;
    for (std::size_t j = trial_.scene.joints.size(); j-- > 0;) {
      const auto each = [&](auto core::Joint::*laws) {
        for (std::size_t i = (trial_.scene.joints[j].*laws).size(); i-- > 0;) {
          Scene scene = trial_.scene;
          scene.joints[j].*laws = without(scene.joints[j].*laws, i);
          any |= take(std::move(scene));
        }
      };
      each(&core::Joint::displacements), each(&core::Joint::angles);
    }
    return any;
  }

  bool plainer_bodies() {
    bool any = false;
    for (std::size_t i = 0; i < trial_.scene.bodies.size(); ++i) {
      for (const core::Shape& shape : simpler(trial_.scene.bodies[i].shape)) {
        Scene scene = trial_.scene;
        Body& body = scene.bodies[i];
        body.shape = shape, body.inertia = core::mass_properties(shape, body.mass).inertia;
        if (take(std::move(scene))) {
          any = true;
          break;
        }
      }
      const auto edit = [&](auto change) {
        Scene scene = trial_.scene;
        if (change(scene.bodies[i])) any |= take(std::move(scene));
      };
      edit([](Body& b) {
        return !b.initial.orientation.vec().isZero(0) && (b.initial.orientation.setIdentity(), true);
      });
      edit([](Body& b) { return b.locked && (b.locked = false, true); });
      edit([](Body& b) { return b.collide && (b.collide = false, true); });
      // Another mass keeps the inertia of the shape.
      edit([](Body& b) {
        if (b.mass == 1) return false;
        b.inertia /= b.mass, b.mass = 1;
        return true;
      });
      edit([](Body& b) {
        const core::Matrix3 plain = core::mass_properties(b.shape, b.mass).inertia;
        return b.inertia != plain && (b.inertia = plain, true);
      });
    }
    return any;
  }

  bool rounder_numbers() {
    bool any = false;
    std::size_t count = 0;
    Numbers::each(trial_, [&](double&) { ++count; });
    for (std::size_t i = 0; i < count; ++i) {
      double now = 0;
      at(trial_, i, [&](double& x) { now = x; });
      for (const double simple : {0.0, 1.0, std::copysign(1.0, now), rounded(now, 1), rounded(now, 2)}) {
        if (simple == now) break;
        Trial candidate = trial_;
        at(candidate, i, [&](double& x) { x = simple; });
        if (take(std::move(candidate))) {
          any = true;
          break;
        }
      }
    }
    return any;
  }

  template <class Use>
  static void at(Trial& trial, std::size_t which, const Use& use) {
    std::size_t i = 0;
    Numbers::each(trial, [&](double& x) {
      if (i++ == which) use(x);
    });
  }

  Trial trial_;
  const Faulty& faulty_;
  int asked_ = 0;
};

}  // namespace

Trial shrink(Trial trial, const Faulty& faulty, int* asked) {
  Shrinking shrinking(std::move(trial), faulty);
  Trial least = shrinking.least();
  if (asked) *asked = shrinking.asked();
  return least;
}

}  // namespace cylon::hunt
