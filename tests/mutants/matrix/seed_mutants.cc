// The errata of the seed document, each as the single fault of an engine of its structure.
#include "tests/mutants/matrix/seed/engine.h"
#include "tests/mutants/matrix/subject.h"

namespace cylon::mutants {
namespace {

struct Row {
  int erratum;
  const char *name, *fault, *judge, *claim;
};

constexpr Row rows[] = {
    {1, "v' = p - w", "a moving frame subtracts its velocity from positions", "moving frame", "motion"},
    {2, "dK/dt = F", "mass enters and leaves at rest", "rocket", "velocity follows"},
    {3, "g = 9.8", "and not 9.81", "projectile", "position follows"},
    {5, "q - p_q", "a spring pulls along an unset vector", "spring_orbit", "position follows"},
    {6, "det R = 1", "rotations are kept at unit determinant, not orthogonal", "symmetric_top",
     "orientation follows"},
    {7, "R(theta t)", "each step turns by w dt times t", "constant_spin", "orientation follows"},
    {8, "w x p", "anchors move as if the body were not turned", "body axes", "motion"},
    {9, "L = m r^2 w", "inertia is a number", "symmetric_top", "orientation follows"},
    {10, "tau = L", "angular momentum is the torque", "two_body_spring", "orientation follows"},
    {11, "no sum over i", "inertia of the last part alone", "hammer", "orientation follows"},
    {12, "R = R(w dt) R", "the orientation is not advanced", "constant_spin", "orientation follows"},
    {13, "explicit Euler", "positions move with the old momentum", "spring_zero", "energy conserved"},
    {14, "w x r + v", "contact points on planes move as if unturned", "turned box", "motion"},
    {15, "I_i unrotated", "parts' inertia is added without turning", "hammer", "orientation follows"},
    {16, "eq. 74 (0,0)", "t1^2 in place of t3^2", "constant_spin", "read back"},
    {17, "eq. 74 (0,2)", "- in place of +", "two_body_spring", "orientation follows"},
    {18, "eq. 74 (2,0)", "t0 t3 in place of t0 t2", "two_body_spring", "orientation follows"},
    {19, "eq. 76 exact", "the first order for finite turns", "constant_spin", "orientation follows"},
    {20, "eq. 77 order", "components in the order (w, x, y, z)", "constant_spin", "orientation follows"},
    {21, "eq. 78", "quaternions grow", "constant_spin", "orientation follows"},
    {22, "sum F = 0", "what acts from outside is taken off", "projectile", "position follows"},
    {23, "I w^2 / 2", "rotational energy with a number I is kept", "hammer", "orientation follows"},
    {24, "v_sep = -c v", "restitution of the whole velocity", "oblique", "velocity follows"},
    {25, "K + J/m", "an impulse is divided by the mass", "head_on", "velocity follows"},
    {26, "lim m_A", "planes do not push back", "bouncing", "position follows"},
    {27, "eq. 92 sign", "bodies are pulled together", "rod_hit", "velocity follows"},
    {28, "eq. 92 bracket", "inverse inertia of the wrong product", "box_edge", "angular_velocity follows"},
    {29, "w x r_A + v_A", "contact points of bodies move as if unturned", "turned rod", "motion"},
    {30, "t", "friction across the slip", "rough_ball", "velocity follows"},
    {31, "c_f", "restitution along the slip, without limit", "rough_ball", "velocity follows"},
    {32, "J_n and J_t apart", "the friction's pull on the normal is left out", "rough edge", "bounce speed"},
    {33, "tau + r x J", "an impulse turns for dt", "rod_hit", "angular_velocity follows"},
    {34, "<=", "half a face, and no tolerance", "rod_hit", "velocity follows"},
    {35, "far behind", "faces count for all that is behind", "rod_hit", "position follows"},
    {36, "p - q", "depth from the centre", "rod_hit", "position follows"},
    {38, "m = 1", "the constructor forgets the mass", "rocket", "position follows"},
    {39, "I = m", "inertia without lengths", "slide_to_roll", "angular_velocity follows"},
    {40, "1/Matrix (Z,Y)", "a wrong entry of the inverse", "hammer", "orientation follows"},
    {41, "dI", "no -r_j^2 on the diagonal", "hammer", "orientation follows"},
    {42, "inv_I", "inverse inertia is not turned", "symmetric_top", "orientation follows"},
    {43, "integrator", "all of the step with its start", "spring_zero", "position follows"},
    {44, "stale v", "forces see the velocities of the step before", "projectile_drag", "position follows"},
    {45, "theta < 1e-5", "small turns are none", "slow_spin", "orientation follows"},
    {46, "float R", "orientation in single precision, not normalised", "constant_spin",
     "theory: order of orientation"},
    {47, "vertex - pin", "a pinned spring pushes", "spring_zero", "position follows"},
    {48, "no guard", "a spring of no length divides by it", "driven_spring", "finite"},
    {49, "gamma v dt", "drag times dt", "projectile_drag", "position follows"},
    {50, "water dt", "lift and drag of water times dt", "cork", "position follows"},
    {51, "water constants", "lift 1 and drag 2 for everyone", "cork", "position follows"},
    {52, "K - K_ortho", "a number becomes (K_ortho, 0, 0)", "rough_ball", "angular_velocity follows"},
    {53, "L = -r n x K", "planes set the spin of a rolling hoop", "rough_ball", "angular_velocity follows"},
    {54, "no 1 + c", "impulse -c m v", "head_on", "velocity follows"},
    {55, "v_closing", "the blow along the velocity", "oblique", "velocity follows"},
    {56, "twice", "each pair is hit twice", "head_on", "velocity follows"},
    {57, "locked", "locked bodies move", "locked_post", "position"},
    {58, "v_cB - v_cB", "no impulse at all", "rod_hit", "velocity follows"},
    {59, "b.m + b.p", "a wrong centre of mass", "hammer", "linear_momentum"},
    {60, "c.L", "spins are lost in merging", "hammer", "read back"},
    {61, "inv_m, inv_I", "not updated in merging", "hammer", "orientation follows"},
    {62, "cube.p = theta", "parts sit at their rotation vectors", "hammer", "orientation follows"},
    {64, "K = R (0,0,5)", "momentum is set, not pushed", "airplane", "velocity follows"},
    {65, "evolve", "impacts at the end of the step", "oblique", "*"},
    {66, "set<Body*>", "contacts in the order of addresses", "same again", "motion"},
    {67, "stale vertices", "the first step's anchors", "two_body_spring", "position follows"},
};

}  // namespace

std::vector<Subject> seed_mutants() {
  std::vector<Subject> result;
  for (const Row& row : rows) {
    Subject subject;
    subject.name = row.name;
    subject.fault = row.fault;
    subject.erratum = row.erratum;
    subject.make = [n = row.erratum] { return seed::make_engine({n}); };
    subject.judge = row.judge;
    subject.claim = row.claim;
    result.push_back(std::move(subject));
  }
  return result;
}

const std::vector<NotCounted>& not_counted() {
  static const std::vector<NotCounted> list = {
      {4, "a wrong name for the superposition of forces; no formula"},
      {37, "a wrong definition of convex; no code tests it"},
      {63, "a missing comma: the listing does not compile"},
  };
  return list;
}

}  // namespace cylon::mutants
