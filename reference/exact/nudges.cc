#include "reference/exact/nudges.h"

#include "harness/core/fields.h"

#include <type_traits>
#include <utility>

namespace cylon::exact {
namespace {

class Nudges {
 public:
  Nudges(const core::Scene& scene, double step) : scene_(scene), step_(step) {
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) body(b);
    for (std::size_t f = 0; f < scene.forces.size(); ++f) force(f);
    for (std::size_t j = 0; j < scene.joints.size(); ++j) {
      vector([j](core::Scene & s) -> auto& { return s.joints[j].point; });
      switch (scene.joints[j].type) {
        case core::JointType::hinge:
          vector([j](core::Scene & s) -> auto& { return s.joints[j].axis; });
          break;
        case core::JointType::distance:
          number([j](core::Scene & s) -> auto& { return s.joints[j].length; });
          break;
        case core::JointType::ball:
        case core::JointType::fixed:
          break;
      }
    }
    for (std::size_t p = 0; p < scene.planes.size(); ++p) {
      vector([p](core::Scene & s) -> auto& { return s.planes[p].normal; });
      number([p](core::Scene & s) -> auto& { return s.planes[p].offset; });
    }
    if (scene.frame) {
      vector([](core::Scene & s) -> auto& { return s.frame->velocity; });
      vector([](core::Scene & s) -> auto& { return s.frame->angular_velocity; });
    }
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
      number([m](core::Scene & s) -> auto& { return s.materials[m].restitution; });
      number([m](core::Scene & s) -> auto& { return s.materials[m].friction; });
    }
  }

  std::vector<core::Scene> scenes;

 private:
  template <class Access>
  void number(Access access) {
    core::Scene moved = scene_;
    double& x = access(moved);
    if (x == 0) return;
    x += step_ * x;
    scenes.push_back(std::move(moved));
  }

  template <class Access>
  void vector(Access access) {
    for (int i = 0; i < 3; ++i) number([=](core::Scene & s) -> auto& { return access(s)[i]; });
  }

  void body(std::size_t b) {
    vector([b](core::Scene & s) -> auto& { return s.bodies[b].initial.position; });
    vector([b](core::Scene & s) -> auto& { return s.bodies[b].initial.velocity; });
    vector([b](core::Scene & s) -> auto& { return s.bodies[b].initial.angular_velocity; });
    for (int i = 0; i < 4; ++i) {
      number([=](core::Scene & s) -> auto& { return s.bodies[b].initial.orientation.coeffs()[i]; });
    }
    number([b](core::Scene & s) -> auto& { return s.bodies[b].mass; });
    inertia(b);
    if (!scene_.bodies[b].collide) return;
    if (std::holds_alternative<core::Sphere>(scene_.bodies[b].shape)) {
      number([b](core::Scene & s) -> auto& { return std::get<core::Sphere>(s.bodies[b].shape).radius; });
    } else if (std::holds_alternative<core::Box>(scene_.bodies[b].shape)) {
      vector([b](core::Scene & s) -> auto& { return std::get<core::Box>(s.bodies[b].shape).half_extents; });
    }
  }

  // A full tensor goes through an eigenvalue solver, whose error is one of the tensor as a whole.
  void inertia(std::size_t b) {
    const core::Matrix3& tensor = scene_.bodies[b].inertia;
    for (int i = 0; i < 3; ++i) {
      for (int j = tensor.isDiagonal(0.0) ? i : 0; j <= i; ++j) {
        core::Scene moved = scene_;
        const double amount = step_ * (tensor.isDiagonal(0.0) ? tensor(i, j) : tensor.cwiseAbs().maxCoeff());
        moved.bodies[b].inertia(i, j) += amount;
        if (i != j) moved.bodies[b].inertia(j, i) += amount;
        if (amount != 0) scenes.push_back(std::move(moved));
      }
    }
  }

  // Every number and every vector's coordinates, in the order of the table; words and bodies stay.
  void force(std::size_t f) {
    std::visit(
        [&]<class Force>(const Force& own) {
          core::for_each_field(own, [&](const auto& field, const auto& value) {
            using Value = std::remove_cvref_t<decltype(value)>;
            const auto member = [ f, at = field.member ](core::Scene & s) -> auto& {
              return std::get<Force>(s.forces[f]).*at;
            };
            if constexpr (std::is_same_v<Value, double>) {
              number(member);
            } else if constexpr (std::is_same_v<Value, core::Vector3>) {
              vector(member);
            } else if constexpr (std::is_same_v<Value, std::optional<core::Vector3>>) {
              if (value) vector([member](core::Scene & s) -> auto& { return *member(s); });
            }
          });
        },
        scene_.forces[f]);
  }

  const core::Scene& scene_;
  const double step_;
};

}  // namespace

std::vector<core::Scene> nudged(const core::Scene& scene, double step) { return Nudges(scene, step).scenes; }

}  // namespace cylon::exact
