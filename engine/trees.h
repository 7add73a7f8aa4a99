// Bodies that joints make trees of, in the coordinates that the joints leave free: no joint can open.
#pragma once

#include "engine/integrators/integrator.h"
#include "engine/model.h"
#include "engine/system.h"

#include <array>
#include <vector>

namespace cylon::engine {

struct Options;

/// The articulated-body algorithm, of which the work is linear in the number of bodies: R. Featherstone, Rigid Body
/// Dynamics Algorithms (2008), section 7.3.  Here with axes of the world, about centres of mass and with their plain
/// accelerations,
///   A_i = X_i A_p + g_i + S_i q'',   I_i A_i + b_i = what the joints exert,
/// with  A = (alpha, a),  X_i the shift from the parent's centre,  S_i the motion that the joint leaves free and g_i what its
/// change and the spins add.  A rotor on a coordinate of the joint adds its inertia to S_i^T I_i S_i, as in section 9.6.
/// y: of each body that can move, parents first, the displacements of its joint, its angles or, where it turns freely, its
/// orientation, and the rates of both (a free spin is that of the body, not against its parent).  Of a tree that hangs from
/// nothing the first three are the centre of mass of the whole, which only forces from outside change.
class Trees {
 public:
  /// Whether a model is some that this integrator carries: joints between bodies that close no loop, bodies with inertia
  /// about every axis, and nothing that the method does not support.
  static bool applies(const Model&, const Options&, const Integrator&);

  /// Requires applies() and that locked bodies come last.
  explicit Trees(Model);

  std::size_t size() const { return size_; }
  std::vector<Real> initial() const;

  void rates(Time, const Real* y, Real* rate);
  void project(Real* y) const;
  /// As of Bodies; there is no water here.
  bool may_be_reached() const { return !model_.forces.user_forces.empty(); }
  /// For error control: the largest size so far of each component's kind over all bodies.
  void scales(const Real* y, Real* scale);
  Time next_kink(Time t) const { return model_.forces.next_kink(t); }
  void start_piece(Time t) { model_.forces.start_piece(t); }

  /// The motions of all bodies in a state, then that of the world.
  void read(const Real* y, std::vector<Motion>& motions) const;
  void read_turns(const Real* y, std::vector<Real>& turns) const;

  const Model& model() const { return model_; }

 private:
  using Vector6 = Eigen::Matrix<Real, 6, 1>;
  using Matrix6 = Eigen::Matrix<Real, 6, 6>;
  enum class Turns { never, about_one, about_two, about_three, freely };

  // A body and the joint by which it hangs from its parent.
  struct Node {
    int body = 0, parent = fixed_world;  // the parent may be locked
    std::size_t above = 0;               // where the parent's motion is; the world's is the last
    Vector3 anchor, parent_anchor;       // axes of the body and of the parent, or the world
    bool child_slides = false;           // whether the body carries the directions, not the parent
    std::vector<Vector3> directions;     // of displacements, axes of who carries them
    Turns turns = Turns::never;
    Vector3 first, second;  // axes of turns in those of the parent, at angles 0
    Vector3 third;          // the same, of a turn between the two
    Vector3 second_axis;    // the same as second, in those of the body
    Quaternion relative;    // body to parent, at angles 0
    Vector3 offset =
        Vector3::Zero();      // what the first turn carries: from its point to the body's, at angles 0
    std::size_t at = 0;       // in y
    std::size_t members = 0;  // of the tree that begins here and hangs from nothing; else 0
    Real mass = 0;            // of that tree
    int slides = 0, angles = 0, freedoms = 0;
    bool drives = false;              // rotors, of
    Matrix3 rotor = Matrix3::Zero();  // their inertia in terms of the rates
    std::size_t rates_at() const { return at + coordinates(); }
    std::size_t coordinates() const {
      const int count = slides + (turns == Turns::freely ? 4 : angles);
      return static_cast<std::size_t>(count);
    }
  };
  // Of one evaluation.
  struct Articulated {
    Matrix6 inertia, space, force;             // I_i, then S_i and I_i S_i in the first columns
    Matrix6 inverse;                           // (S^T I S)^-1
    Vector6 bias, change, push, acceleration;  // of what hangs from what stands still, push is q''
    Vector3 shift;                             // from the parent's centre
  };

  void hang(int body, const Joint*, int parent);
  void count_turns();
  void add_rotors();
  void place(const Node&, const Real* y, Motion*, Kinematics*) const;
  struct Sums {
    Vector3 places = Vector3::Zero(), momentum = Vector3::Zero();
  };
  Vector3 direction(const Node&, int, const Kinematics*) const;
  Vector3 axis_between(const Node&, const Real* angles, const Kinematics*) const;
  Vector3 offset(const Node&, const Real* angles, const Kinematics*) const;
  int angle_of(const Node&, const CoordinateLaw&) const;
  Sums sums_of(const Node& root, const Motion*) const;
  void move_to_centre(const Node& root, const Real* y, Motion*, Kinematics*) const;
  void place_all(const Real* y, Motion*, Kinematics*) const;
  void find_space(const Node&, const Real* y);
  void find_offset_space(const Node&, const Real* y);
  template <int N>
  void lean(const Node&, Articulated&);
  template <int N>
  void accelerate(const Node&, Articulated&, const Vector6& parent, const Real* y, Real* rate) const;

  Model model_;
  std::vector<Node> nodes_;
  std::size_t size_ = 0, count_ = 0;
  std::vector<Articulated> articulated_;  // by body
  std::vector<Motion> motions_;
  std::vector<Kinematics> kinematics_;
  std::vector<Load> loads_;
  // The angle of a law of which the turns count, in terms of one of y.
  struct Counted {
    std::size_t law, at;
    Real sign, start;
  };
  std::vector<Counted> counted_;
  Real length_ = 0, speed_ = 0, turn_ = 0, pull_ = 0;  // the largest so far; of |F|/m [m/s^2]
  Real arm_ = 0;                                       // from a centre of mass to a joint, the longest [m]
};

static_assert(System<Trees>);

}  // namespace cylon::engine
