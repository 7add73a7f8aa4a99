// Joints of the compiled tree, and the equality constraints that are joints.
#include "harness/imports/losses.h"
#include "harness/imports/mjcf/mjcf.h"

#include <fmt/format.h>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace cylon::imports {
namespace {

using foreign::Freedom;
using foreign::Joint;
using foreign::Matrix3;
using foreign::Vector3;

// The nearest body up the tree that is not just a frame of the world; MuJoCo takes what hangs on the world without a
// joint for the world.
int end_of(const Compiled& m, int body) { return m.integer("body_weldid", body) == 0 ? -1 : body; }

// Whether a spring or a damper of a joint is more than a number times a coordinate.
bool has_curved_spring(const Compiled& m, int joint) {
  return !m.disabled("spring") && m.any("jnt_stiffnesspoly", joint, m.size("njnt"));
}
bool has_curved_damper(const Compiled& m, int motion) {
  return !m.disabled("damper") && m.any("dof_dampingpoly", motion, m.size("nv"));
}

// Q = -k (q - rest) - c q' and what the actuators add.
Freedom freedom_of(const Compiled& m, int joint, const Drive& drive, foreign::Model& model) {
  const auto kind = static_cast<MjJoint>(m.integer("jnt_type", joint));
  const int position = m.integer("jnt_qposadr", joint), motion = m.integer("jnt_dofadr", joint);
  Freedom f;
  f.kind = kind == MjJoint::slide ? "slide" : "turn";
  f.axis = m.start_vector("xaxis", joint).normalized();
  f.start = m.start("qpos", position);
  if (m.integer("jnt_limited", joint) != 0 && !m.disabled("limit") && !m.disabled("constraint")) {
    f.lower = m.number("jnt_range", 2 * joint);
    f.upper = m.number("jnt_range", 2 * joint + 1);
  }
  const double spring = m.disabled("spring") ? 0 : m.number("jnt_stiffness", joint);
  const double rest = m.number("qpos_spring", position);
  f.stiffness = spring + drive.stiffness;
  f.force = drive.force;
  if (f.stiffness != 0) f.rest = spring * rest / f.stiffness;
  f.damping = (m.disabled("damper") ? 0 : m.number("dof_damping", motion)) + drive.damping;
  if (!m.disabled("frictionloss") && !m.disabled("constraint"))
    f.friction = m.number("dof_frictionloss", motion);
  const auto lose = [&](const char* what, std::string detail) {
    model.losses.push_back({what, m.place("joint", joint), std::move(detail)});
  };
  if (has_curved_spring(m, joint)) lose("joint_spring", "not linear");
  if (has_curved_damper(m, motion)) lose("joint_damping", "not linear");
  if (const double margin = m.number("jnt_margin", joint); f.lower && margin != 0)
    lose("limit_margin", fmt::format("{} {}", margin, kind == MjJoint::slide ? "m" : "rad"));
  return f;
}

// What a free or a ball joint has and a scene gives only to single coordinates.
void lose_of_many(const Compiled& m, int joint, const char* detail, foreign::Model& model) {
  const auto lose = [&](const char* what, const char* why) {
    model.losses.push_back({what, m.place("joint", joint), why});
  };
  const int motion = m.integer("jnt_dofadr", joint);
  const bool constrains = !m.disabled("constraint");
  if (constrains && m.integer("jnt_limited", joint) != 0 && !m.disabled("limit")) lose("joint_limit", detail);
  if (m.number("jnt_stiffness", joint) != 0 && !m.disabled("spring")) lose("joint_spring", detail);
  if (constrains && m.number("dof_frictionloss", motion) != 0 && !m.disabled("frictionloss"))
    lose("joint_friction", detail);
  if (has_curved_spring(m, joint)) lose("joint_spring", "not linear");
  if (has_curved_damper(m, motion)) lose("joint_damping", "not linear");
}

// Damping of the six coordinates of a free body: of the velocity of the body's frame and of its spin.
void add_free_joint(const Compiled& m, int joint, foreign::Model& model) {
  lose_of_many(m, joint, "a free joint", model);
  const int motion = m.integer("jnt_dofadr", joint);
  const double damping = m.disabled("damper") ? 0 : m.number("dof_damping", motion);
  if (damping == 0) return;
  const int body = m.integer("jnt_bodyid", joint);
  if (!m.vector("body_ipos", body).isZero(0)) {
    model.losses.push_back({"free_drag", m.place("joint", joint), "its frame is not at the centre of mass"});
    return;
  }
  model.bodies[static_cast<std::size_t>(body)].linear_drag = damping;
  model.bodies[static_cast<std::size_t>(body)].angular_drag = damping;
}

void add_ball_joint(const Compiled& m, int joint, int to, foreign::Model& model) {
  lose_of_many(m, joint, "a ball joint", model);
  const int motion = m.integer("jnt_dofadr", joint);
  const double damping = m.disabled("damper") ? 0 : m.number("dof_damping", motion);
  if (damping == 0) return;
  if (to >= 0) return model.losses.push_back({"joint_damping", m.place("joint", joint), "a ball joint"});
  model.bodies[static_cast<std::size_t>(m.integer("jnt_bodyid", joint))].angular_drag = damping;
}

// Inertia of rotors, which MuJoCo adds to the joint's own: q'^2 armature / 2.  Of a body that turns about an axis of the
// world it is that of an inertia which is the same about all axes: w = q' n, and the others do no work.  So every engine
// has it.  Of a ball and a free body a scene has none.
void add_armature(const Compiled& m, int joint, bool about_world, Joint& made, foreign::Model& model) {
  const auto kind = static_cast<MjJoint>(m.integer("jnt_type", joint));
  const int count = kind == MjJoint::free ? 6 : kind == MjJoint::ball ? 3 : 1;
  for (int i = m.integer("jnt_dofadr", joint), end = i + count; i < end; ++i) {
    const double inertia = m.number("dof_armature", i), whole = m.number("dof_M0", i);
    if (inertia == 0) continue;
    if (about_world && kind == MjJoint::hinge)
      model.bodies[static_cast<std::size_t>(m.integer("jnt_bodyid", joint))].inertia +=
          inertia * foreign::Matrix3::Identity();
    else if (kind == MjJoint::hinge || kind == MjJoint::slide)
      made.freedoms.back().armature = inertia, made.freedoms.back().moved = whole;
    else
      model.losses.push_back(lost_armature(inertia, whole, m.place("joint", joint)));
  }
}

struct Line {
  Vector3 point, direction;  // unit
};
constexpr double meet = 1e-9;  // [m]

// With the least sum of squared distances from the lines, and of those the nearest to the last line's point.
Vector3 nearest_point(const std::vector<Line>& lines) {
  Matrix3 across = Matrix3::Zero();
  Vector3 sum = Vector3::Zero();
  const Vector3& last = lines.back().point;
  for (const Line& line : lines) {
    const Matrix3 square = Matrix3::Identity() - line.direction * line.direction.transpose();
    across += square, sum += square * (line.point - last);
  }
  return last + across.completeOrthogonalDecomposition().solve(sum);
}

// The line square to both meets the first at  p + (a.(q - p)) a  where the axes are square to each other; others no joint of a
// scene has.
void set_apart(const Line& first, const Line& second, Joint& joint) {
  const Vector3 between = second.point - first.point;
  joint.point = first.point + first.direction.dot(between) * first.direction;
  joint.offset = first.direction.cross(second.direction).dot(between);
}

// Of the world with itself it is none.
void add_loop(const Compiled& m, Joint joint, foreign::Model& model) {
  if (end_of(m, joint.body) < 0) {
    if (joint.to < 0) return;
    joint.body = joint.to, joint.to = -1;
  }
  model.joints.push_back(std::move(joint));
}

void add_equality(const Compiled& m, int i, foreign::Model& model) {
  const auto lose = [&](const char* detail) {
    model.losses.push_back({"equality", m.place("equality", i), detail});
  };
  if (m.integer("eq_active", i, m.integer("eq_active0", i)) == 0) return;
  const auto kind = static_cast<MjEquality>(m.integer("eq_type", i));
  if (kind != MjEquality::connect && kind != MjEquality::weld)
    return lose("between joints, tendons or flexes");
  Joint joint;
  joint.place = m.place("equality", i);
  joint.name = m.name("equality", i);
  joint.may_touch = true;
  constexpr double closed = 1e-6;  // [m], [rad]: what the compiler leaves of a loop that closes
  constexpr int of_body = 1;       // mjOBJ_BODY; else mjOBJ_SITE, of frames in bodies that coincide
  const int columns = static_cast<int>(m.length("eq_data")) / m.size("neq");
  // A weld of which the torque scale is zero holds no direction.
  const bool turns = kind == MjEquality::weld && columns > 10 && m.number("eq_data", columns * i + 10) == 0;
  if (m.integer("eq_objtype", i, of_body) != of_body) {
    const int sites[] = {m.integer("eq_obj1id", i), m.integer("eq_obj2id", i)};
    foreign::Pose at[2];
    for (int k = 0; k < 2; ++k) {
      const int on = m.integer("site_bodyid", sites[k]);
      at[k] = foreign::Pose{m.start_vector("xpos", on), m.start_quaternion("xquat", on)} *
              foreign::Pose{m.vector("site_pos", sites[k]), m.quaternion("site_quat", sites[k])};
    }
    joint.body = m.integer("site_bodyid", sites[0]);
    joint.to = end_of(m, m.integer("site_bodyid", sites[1]));
    joint.point = at[0].position;
    if ((at[0].position - at[1].position).norm() > closed) return lose("its points are apart at the start");
    if (kind == MjEquality::connect || turns)
      joint.freedoms = {{.kind = "ball"}};
    else if (at[0].turn.angularDistance(at[1].turn) > closed)
      return lose("its bodies are not as it holds them at the start");
    return add_loop(m, joint, model);
  }
  const int body = m.integer("eq_obj1id", i), to = m.integer("eq_obj2id", i);
  const auto datum = [&](int k) {
    return Vector3(m.number("eq_data", columns * i + k), m.number("eq_data", columns * i + k + 1),
                   m.number("eq_data", columns * i + k + 2));
  };
  const foreign::Pose first = {m.start_vector("xpos", body), m.start_quaternion("xquat", body)};
  const foreign::Pose second = {m.start_vector("xpos", to), m.start_quaternion("xquat", to)};
  // The first three numbers are the anchor on the first body, the next three that on the second; of a weld the other way
  // about, and then the relative orientation and the scale of its torque.
  joint.body = body, joint.to = end_of(m, to);
  if (kind == MjEquality::connect) {
    joint.point = first.position + first.turn * datum(0);
    if ((second.position + second.turn * datum(3) - joint.point).norm() > closed)
      return lose("its points are apart at the start");
    joint.freedoms = {{.kind = "ball"}};
  } else {
    const foreign::Pose relative = first.inverse() * second;
    const int k = columns * i + 6;
    const foreign::Quaternion asked(m.number("eq_data", k), m.number("eq_data", k + 1),
                                    m.number("eq_data", k + 2), m.number("eq_data", k + 3));
    if ((!turns && relative.turn.angularDistance(asked.normalized()) > closed) ||
        (first.position + first.turn * datum(3) - second.position - second.turn * datum(0)).norm() > closed)
      return lose("its bodies are not as it holds them at the start");
    joint.point = second.position;
    if (turns) joint.freedoms = {{.kind = "ball"}}, joint.point += second.turn * datum(0);
  }
  add_loop(m, joint, model);
}

}  // namespace

void add_joints(const Compiled& m, foreign::Model& model) {
  const std::vector<Drive> drives = drives_of(m, model);
  for (int body = 1; body < m.size("nbody"); ++body) {
    if (m.integer("body_weldid", body) == 0) continue;  // of the world
    Joint joint;
    joint.place = m.place("body", body);
    joint.body = body;
    joint.to = end_of(m, m.integer("body_parentid", body));
    const int first = m.integer("body_jntadr", body), count = m.integer("body_jntnum", body);
    joint.one_body = count == 0;
    joint.may_touch = m.disabled("filterparent");
    joint.point = m.start_vector("xipos", body);
    bool is_free = false;
    std::vector<Line> hinges;
    for (int j = first; j < first + count; ++j) {
      const auto kind = static_cast<MjJoint>(m.integer("jnt_type", j));
      if (j == first)
        joint.place = m.place("joint", j), joint.name = m.name("joint", j);
      else if (!m.name("joint", j).empty())
        model.losses.push_back(
            {"name", m.place("joint", j), fmt::format("a motion of {}", joint.place.element)});
      if (kind == MjJoint::free) {
        is_free = true;
        add_free_joint(m, j, model);
      } else if (kind == MjJoint::ball) {
        joint.freedoms.push_back({.kind = "ball"});
        joint.point = m.start_vector("xanchor", j);
        add_ball_joint(m, j, joint.to, model);
      } else {
        joint.freedoms.push_back(freedom_of(m, j, drives[static_cast<std::size_t>(j)], model));
        if (kind == MjJoint::hinge)
          hinges.push_back({m.start_vector("xanchor", j), joint.freedoms.back().axis});
        else if (j == first)
          joint.point = m.start_vector("xanchor", j);
      }
      add_armature(m, j, count == 1 && joint.to < 0, joint, model);
    }
    if (!hinges.empty()) joint.point = nearest_point(hinges);
    const bool apart = std::ranges::any_of(hinges, [&](const Line& line) {
      return line.direction.cross(joint.point - line.point).norm() > meet;
    });
    if (apart && count == 2 && hinges.size() == 2)
      set_apart(hinges[0], hinges[1], joint);
    else if (apart)
      model.losses.push_back({"joint_kind", joint.place, "hinges of one body about axes that do not meet"});
    if (!is_free) model.joints.push_back(joint);
  }
  if (m.disabled("equality") || m.disabled("constraint")) return;
  for (int i = 0; i < m.size("neq"); ++i) add_equality(m, i, model);
}

}  // namespace cylon::imports
