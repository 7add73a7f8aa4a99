// Jolt's API in Node.
#include "harness/hunt/program/dialect.h"

namespace cylon::hunt::program {
namespace {

using core::JointType;
using Where = SettingRow::Where;

constexpr std::string_view functions = R"(
const J = await init();
const vec = (v) => new J.Vec3(...v), real = (v) => new J.RVec3(...v), quat = ([w, x, y, z]) => new J.Quat(x, y, z, w);
const xyz = (v) => [v.GetX(), v.GetY(), v.GetZ()];
const fixed = 0, free = 1, ghost = 2;  // layers
let jolt, system, filter, id, shape, convex_radius = 0.05;

function enter(settings, i) {
  settings.mRestitution = ${restitution}, settings.mFriction = ${friction};
  settings.mCollisionGroup.SetGroupFilter(filter), settings.mCollisionGroup.SetGroupID(0), settings.mCollisionGroup.SetSubGroupID(i);
  const bodies = system.GetBodyInterface(), made = bodies.CreateBody(settings);
  bodies.AddBody(made.GetID(), J.EActivation_Activate);
  return made;
}

function build(take) {
  const table = new J.JoltSettings(), pairs = new J.ObjectLayerPairFilterTable(3), broad = new J.BroadPhaseLayerInterfaceTable(3, 3);
  pairs.EnableCollision(fixed, free), pairs.EnableCollision(free, free);
  for (const layer of [fixed, free, ghost]) broad.MapObjectToBroadPhaseLayer(layer, new J.BroadPhaseLayer(layer));
  table.mObjectLayerPairFilter = pairs, table.mBroadPhaseLayerInterface = broad;
  table.mObjectVsBroadPhaseLayerFilter = new J.ObjectVsBroadPhaseLayerFilterTable(broad, 3, pairs, 3);
  jolt = new J.JoltInterface(table), system = jolt.GetPhysicsSystem();
  system.SetGravity(vec(gravity[take]));
  const physics = system.GetPhysicsSettings();
${world_settings}  system.SetPhysicsSettings(physics);
  filter = new J.GroupFilterTable(count + 1), shape = [];
${planes}${shapes}  id = body.map(({m, I}, i) => {
    const {x, q, v, w} = start[take][i];
    const settings = new J.BodyCreationSettings(
      shape[i] ?? new J.SphereShape(1), real(x), quat(q), J.EMotionType_Dynamic, shape[i] ? free : ghost);
    settings.mOverrideMassProperties = J.EOverrideMassProperties_MassAndInertiaProvided;
    settings.mMassPropertiesOverride.mMass = m;
    settings.mMassPropertiesOverride.mInertia = J.Mat44.prototype.sScaleVec3(vec(I));
${body_settings}    const made = enter(settings, i);
${shape_settings}    made.SetLinearVelocity(vec(v)), made.SetAngularVelocity(vec(w));
    return made;
  });
${joints}  system.OptimizeBroadPhase();
}

function plane(normal, foot) {
  const made = new J.PlaneShape(new J.Plane(vec(normal), 0), null, 1e4);
  enter(new J.BodyCreationSettings(made, real(foot), quat([1, 0, 0, 0]), J.EMotionType_Static, fixed), count);
}

function join(settings, numbers, a, b) {
  Object.assign(settings, numbers);
  system.AddConstraint(settings.Create(id[a], b < 0 ? J.JoltInterface.prototype.sGetFixedToWorldBody() : id[b]));
  if (b >= 0) filter.DisableCollision(a, b);
}

const hinge = (p, a) => ({mPoint1: real(p), mPoint2: real(p), mHingeAxis1: vec(a), mHingeAxis2: vec(a), mNormalAxis1: vec(across(a)),
  mNormalAxis2: vec(across(a))});

function push(i, F, T) { id[i].AddForce(vec(F)), id[i].AddTorque(vec(T)); }
function step() { jolt.Step(dt, 1); }

function states() {
  return id.map((b) => {
    const q = b.GetRotation();
    return {x: xyz(b.GetCenterOfMassPosition()), q: [q.GetW(), q.GetX(), q.GetY(), q.GetZ()], v: xyz(b.GetLinearVelocity()),
      w: xyz(b.GetAngularVelocity())};
  });
}
)";

constexpr ShapeRow shapes[] = {
    {"sphere", "new J.SphereShape(${radius})"},
    {"box", "new J.BoxShape(vec([${x}, ${y}, ${z}]), convex_radius)"},
    {"capsule", "new J.CapsuleShape(${length} / 2, ${radius})"},
    {"cylinder", "new J.CylinderShape(${length} / 2, ${radius}, convex_radius)"},
};

constexpr JointRow joints[] = {
    {JointType::ball,
     "  join(new J.PointConstraintSettings(), {mPoint1: real(${point_vector}), mPoint2: "
     "real(${point_vector})}, ${a}, -1);\n",
     "  join(new J.PointConstraintSettings(), {mPoint1: real(${point_vector}), mPoint2: "
     "real(${point_vector})}, ${a}, ${b});\n"},
    {JointType::hinge,
     "  join(new J.HingeConstraintSettings(), hinge(${point_vector}, ${axis_vector}), ${a}, -1);\n",
     "  join(new J.HingeConstraintSettings(), hinge(${point_vector}, ${axis_vector}), ${a}, ${b});\n"},
};

constexpr SettingRow settings[] = {
    {"build", "", Where::program, ""},
    {"mass, inertia", "", Where::program, ""},
    {"mCombinedRestitution, mCombinedFriction", "", Where::program, ""},
    {"collision steps", "", Where::program, ""},
    {"collision filter", "", Where::program, ""},
    {"springs, drag*", "", Where::program, ""},
    {"mApplyGyroscopicForce", "on", Where::body, "    settings.mApplyGyroscopicForce = true;\n"},
    {"way of the inertia", "principal", Where::shape,
     "    made.GetMotionProperties().SetInverseMass(1 / m);\n"
     "    made.GetMotionProperties().SetInverseInertia(vec(I.map((one) => 1 / one)), quat([1, 0, 0, 0]));\n"},
    {"mConvexRadius", "", Where::world, "  convex_radius = ${value};\n"},
    {"mLinearDamping", "", Where::body, "    settings.mLinearDamping = ${value};\n"},
    {"mAngularDamping", "", Where::body, "    settings.mAngularDamping = ${value};\n"},
    {"mMaxLinearVelocity", "", Where::body, "    settings.mMaxLinearVelocity = ${value};\n"},
    {"mMaxAngularVelocity", "", Where::body, "    settings.mMaxAngularVelocity = ${value};\n"},
    {"mAllowSleeping", "off", Where::world, "  physics.mAllowSleeping = false;\n"},
    {"mMinVelocityForRestitution", "", Where::world, "  physics.mMinVelocityForRestitution = ${value};\n"},
    {"mSpeculativeContactDistance", "", Where::world, "  physics.mSpeculativeContactDistance = ${value};\n"},
    {"mPenetrationSlop", "", Where::world, "  physics.mPenetrationSlop = ${value};\n"},
    {"mBaumgarte", "", Where::world, "  physics.mBaumgarte = ${value};\n"},
    {"mNumVelocitySteps", "", Where::world, "  physics.mNumVelocitySteps = ${value};\n"},
    {"mNumPositionSteps", "", Where::world, "  physics.mNumPositionSteps = ${value};\n"},
    {"mUseBodyPairContactCache", "off", Where::world, "  physics.mUseBodyPairContactCache = false;\n"},
    {"mConstraintWarmStart", "off", Where::world, "  physics.mConstraintWarmStart = false;\n"},
};

}  // namespace

extern const Dialect jolt;
const Dialect jolt = {"jolt",
                      "Jolt",
                      &javascript,
                      "npm install jolt-physics",
                      "node ${file}",
                      "import init from 'jolt-physics/wasm';\n",
                      functions,
                      "  shape[${i}] = ${shape};\n",
                      "",
                      "  plane(${normal_vector}, ${foot});\n",
                      shapes,
                      joints,
                      settings};

}  // namespace cylon::hunt::program
