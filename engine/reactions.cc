#include "engine/reactions.h"

#include "engine/changing_masses.h"
#include "engine/constraint.h"
#include "engine/joint.h"
#include "engine/loaded.h"

namespace cylon::engine {

namespace {

bool told(const Model& model, const Contact& contact) {
  const int other =
      contact.plane >= 0 ? model.plane_surfaces[index(contact.plane)] : model.surfaces[index(contact.other)];
  const bool rough = model.material(model.surfaces[index(contact.body)], other).friction > 0;
  return contact.impulse && (contact.friction || !rough);
}

// Each contact as the constant force that has its impulse over dt.
void press(const std::vector<Contact>& contacts, Time dt, const std::vector<Motion>& motions,
           std::vector<Load>& loads) {
  const auto push = [&](int body, const Vector3& point, const Vector3& force) {
    if (body == fixed_world) return;
    loads[index(body)].force += force;
    loads[index(body)].torque += (point - motions[index(body)].position).cross(force);
  };
  for (const Contact& c : contacts) {
    const Vector3 impulse = *c.impulse * c.normal + c.friction.value_or(Vector3::Zero());
    push(c.body, c.point, impulse / static_cast<Real>(dt));
    push(c.other, c.point, -impulse / static_cast<Real>(dt));
  }
}

}  // namespace

std::optional<std::vector<Reaction>> reactions(const Model& model, const Snapshot& start, const Snapshot& end,
                                               const std::vector<Contact>& contacts) {
  for (const Contact& contact : contacts)
    if (!told(model, contact)) return std::nullopt;
  for (const CoordinateLaw& law : model.forces.coordinate_laws)
    if (law.is_limited() || law.friction > 0 || law.counts_turns()) return std::nullopt;
  const auto moves = [&](int body) { return body != fixed_world && !model.bodies[index(body)].locked; };
  std::vector<Reaction> result(model.joints.size());
  const Time dt = end.time - start.time;
  const ChangingMasses masses(model.bodies);
  std::vector<Body> bodies = model.bodies;
  for (const Snapshot& now : {start, end}) {
    masses.set(now.time, bodies);
    Loaded all = loaded(model.forces, now.time, bodies, *now.motions);
    press(contacts, dt, *now.motions, all.loads);
    const Motion* motions = now.motions->data();
    Rows rows;
    std::vector<std::size_t> first;  // row of each joint
    for (const Joint& joint : model.joints) {
      first.push_back(rows.rows.size());
      if (moves(joint.body) || moves(joint.to)) add_rows(joint, bodies, motions, rows.rows);
    }
    first.push_back(rows.rows.size());
    add_rotor_rows(model, motions, rows.rows);
    rows.constrain_accelerations(bodies, motions, all.kinematics.data(), all.loads.data());
    for (std::size_t j = 0; j < model.joints.size(); ++j) {
      const Joint& joint = model.joints[j];
      const Motion& body = motions[index(joint.body)];
      const Vector3 arm = body.orientation * joint.anchor;
      Reaction& reaction = result[j];
      reaction.joint = j, reaction.point = body.position + arm;
      for (std::size_t r = first[j]; r < first[j + 1]; ++r) {
        const Row& row = rows.rows[r];
        const Real half = row.lambda * static_cast<Real>(dt) / 2;
        reaction.impulse += half * row.direction;
        reaction.moment += half * (row.lever - arm.cross(row.direction));
      }
    }
  }
  std::erase_if(result, [&](const Reaction& r) {
    const Joint& joint = model.joints[r.joint];
    return !moves(joint.body) && !moves(joint.to);
  });
  return result;
}

}  // namespace cylon::engine
