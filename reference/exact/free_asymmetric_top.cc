// Free rigid body with any moments (Euler, Jacobi).  Principal axes x, y, z with y the intermediate one and z
// the one about which L circles in the body; E2 = 2 E, M = |L|:
//
//     wx = Ax cn, wy = Ay sn, wz = Az dn  of u = lam t + u0
//     Ax^2 = (E2 Iz - M^2)/(Ix (Iz - Ix)),  Ay^2 = (E2 Iz - M^2)/(Iy (Iz - Iy)),  Az^2 = (M^2 - E2 Ix)/(Iz
//     (Iz - Ix)) lam^2 = (Iz - Iy)(M^2 - E2 Ix)/(Ix Iy Iz) m  = (Iy - Ix)(E2 Iz - M^2)/((Iz - Iy)(M^2 - E2
//     Ix)),  1 - m = (Iz - Ix)(M^2 - E2 Iy)/((Iz - Iy)(M^2 - E2 Ix))
//
// z is the axis of the largest moment if M^2 >= E2 Iy, else of the least.  In space L is fixed, and the body
// turns about it by phi' = (E2 - Iz wz^2) M/(M^2 - Iz^2 wz^2):
//
//     q = C rot(L, phi) B(w),  B the rotation that takes L from body axes to the third axis of Euler's angles
//     phi = M t/Iz + (M/lam)(1/Ix - 1/Iz) [Pi(n; am u | m) - Pi(n; am u0 | m)],  1 - n = Iy (Iz - Ix)/(Ix (Iz
//     - Iy))
//
// The differences are formed from products of one sign, so that little cancels.  Domain: every body that is
// not exactly on the separatrix; a body that turns about a principal axis goes on doing so.
#include "reference/exact/domain.h"
#include "reference/exact/elliptic.h"
#include "reference/exact/flight.h"
#include "reference/exact/free_rotation.h"
#include "reference/exact/rounding.h"
#include "reference/exact/solutions.h"

#include <algorithm>
#include <array>
#include <optional>

namespace cylon::exact {
namespace {

constexpr auto name = "free_asymmetric_top";

class AsymmetricTop {
 public:
  AsymmetricTop(const core::Body& body, const core::Vector3& g) : flight_(body.initial, g) {
    const core::PrincipalAxes principal = core::principal_axes(body.inertia);
    const WideQuaternion to_body = widen(principal.rotation);
    const WideVector w = to_body.conjugate() * (flight_.orientation.conjugate() * flight_.angular_velocity);
    const WideVector moments = widen(principal.moments), spin = moments.cwiseProduct(w);
    steady_ = w.cross(spin).norm() <= 1e-18L * w.norm() * spin.norm();
    if (!steady_) label_axes(moments, w, to_body);
  }

  /// 1 - m = 0: the motion never comes back.
  bool on_separatrix() const { return !steady_ && !elliptic_; }

  WideState at(Wide t) const {
    WideState s = flight_.at(t);
    if (steady_) return s;
    const Amplitude f = elliptic_->at(rate_ * t + start_);
    const WideVector w = amplitude_.cwiseProduct(WideVector(f.cn, f.sn, f.dn));
    const Wide phi = momentum_ * (t / moment_.z() + pi_factor_ * (elliptic_->third(n1_, f) - start_pi_));
    s.orientation = space_ * turn(WideVector::UnitZ(), phi) * euler(w) * axes_.conjugate();
    s.angular_velocity = s.orientation * (axes_ * w);
    return s;
  }

 private:
  // x, y, z as above: moments, angular velocity, and the rotation from these axes to the body's.
  void label_axes(const WideVector& moments, const WideVector& w, const WideQuaternion& to_body) {
    std::array<int, 3> order = {0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int i, int j) { return moments[i] < moments[j]; });
    const auto excess = [&](int k) {  // M^2 - E2 I_k = sum_j I_j (I_j - I_k) w_j^2
      Wide sum = 0;
      for (int j = 0; j < 3; ++j) sum += moments[j] * (moments[j] - moments[k]) * w[j] * w[j];
      return sum;
    };
    if (excess(order[1]) < 0) std::swap(order[0], order[2]);
    WideMatrix axes;
    WideVector spin;
    for (int i = 0; i < 3; ++i) {
      axes.col(i) = WideVector::Unit(order[static_cast<std::size_t>(i)]);
      moment_[i] = moments[order[static_cast<std::size_t>(i)]];
      spin[i] = w[order[static_cast<std::size_t>(i)]];
    }
    if (axes.determinant() < 0) axes.col(1) = -axes.col(1), spin.y() = -spin.y();
    axes_ = to_body * WideQuaternion(axes);
    solve(spin, excess(order[0]), excess(order[1]), -excess(order[2]));
  }

  // over_x = M^2 - E2 Ix, over_y = M^2 - E2 Iy, under_z = E2 Iz - M^2; all of the sign of Iz - Ix.
  void solve(const WideVector& w, Wide over_x, Wide over_y, Wide under_z) {
    const Wide ix = moment_.x(), iy = moment_.y(), iz = moment_.z();
    const Wide m1 = (iz - ix) * over_y / ((iz - iy) * over_x);
    if (!(m1 > 1e-24L)) return;
    elliptic_.emplace((iy - ix) * under_z / ((iz - iy) * over_x), m1);
    rate_ = std::sqrt((iz - iy) * over_x / (ix * iy * iz));
    // Euler's equations tie the signs: Ax lam Ix = (Iz - Iy) Ay Az, with Ay > 0 and dn > 0.
    const Wide sign_z = w.z() < 0 ? -1 : 1, sign_x = iz > iy ? sign_z : -sign_z;
    amplitude_ = {sign_x * std::sqrt(under_z / (ix * (iz - ix))), std::sqrt(under_z / (iy * (iz - iy))),
                  sign_z * std::sqrt(over_x / (iz * (iz - ix)))};
    const Amplitude am = elliptic_->towards(w.y() / amplitude_.y(), w.x() / amplitude_.x());
    start_ = elliptic_->first(am);
    momentum_ = moment_.cwiseProduct(w).norm();
    n1_ = iy * (iz - ix) / (ix * (iz - iy));
    pi_factor_ = (1 / ix - 1 / iz) / rate_;
    start_pi_ = elliptic_->third(n1_, am);
    space_ = flight_.orientation * axes_ * euler(w).conjugate();
  }

  // Rx(theta) Rz(psi) with L = M (sin theta sin psi, sin theta cos psi, cos theta) taken to M z.
  WideQuaternion euler(const WideVector& w) const {
    const WideVector l = moment_.cwiseProduct(w);
    return turn(WideVector::UnitX(), std::atan2(std::hypot(l.x(), l.y()), l.z())) *
           turn(WideVector::UnitZ(), std::atan2(l.x(), l.y()));
  }

  Flight flight_;
  bool steady_ = false;
  WideVector moment_, amplitude_;
  WideQuaternion axes_, space_;
  Wide rate_ = 0, start_ = 0, momentum_ = 0, n1_ = 1, pi_factor_ = 0, start_pi_ = 0;
  std::optional<Elliptic> elliptic_;
};

}  // namespace

void check_free_rotation(std::string_view solution, const core::Scene& scene, std::size_t index) {
  const core::Body& body = scene.bodies[index];
  const std::string of = named(scene, static_cast<int>(index));
  if (!(core::principal_axes(body.inertia).moments.minCoeff() > 0)) {
    refuse(solution, of + " has a moment of inertia that is not positive");
  }
  if (AsymmetricTop(body, gravity(scene, index)).on_separatrix()) {
    refuse(solution, of + " is on the separatrix, |L|^2 = 2 E I2: it flips once, for ever");
  }
}

std::function<WideState(Wide)> free_rotation(const core::Scene& scene, std::size_t index) {
  return [top = AsymmetricTop(scene.bodies[index], gravity(scene, index))](Wide t) { return top.at(t); };
}

namespace {

std::function<core::State(double)> solve_scene(const core::Scene& scene) {
  std::vector<AsymmetricTop> tops;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) tops.emplace_back(scene.bodies[i], gravity(scene, i));
  return together(std::move(tops));
}

}  // namespace

core::Truth free_asymmetric_top(const core::Scene& scene, double horizon) {
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity"});
  check_no_joints(name, scene);
  check_no_contacts(name, scene);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) check_free_rotation(name, scene, i);
  return {
      .state = solve_scene(scene),
      .error = rounding_error(scene, solve_scene, horizon),
      .source = "Landau & Lifshitz, Mechanics, section 37; the angle about L by Legendre's third integral",
      .horizon = horizon};
}

}  // namespace cylon::exact
