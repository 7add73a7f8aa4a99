// Jolt 1.1.0 (WebAssembly in Node 20.20.2), slide: 1 body, box, friction, gravity, plane.
// What should happen: a box that slides is braked by the coefficient of friction times its weight.
// It prints 0.00921 m.
// npm install jolt-physics && node jolt-slide-52fcf9.mjs
import init from 'jolt-physics/wasm';
const {abs, asin, ceil, cos, max, min, sin, sqrt} = Math;
// Vectors [x, y, z] in world axes, quaternions [w, x, y, z] from body to world axes.
const add = (a, b) => a.map((x, i) => x + b[i]);
const sub = (a, b) => a.map((x, i) => x - b[i]);
const mul = (s, a) => a.map((x) => s * x);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const norm = (a) => sqrt(dot(a, a));
const across = (a) => { const k = a.map(abs).indexOf(min(...a.map(abs))), c = cross(a, [0, 1, 2].map((i) => (i === k ? 1 : 0))); return mul(1 / norm(c), c); };
const record = (s) => [s], append = (path, s) => path.push(s);

const named = ([m, I]) => ({m, I}), moving = ([x, q, v, w]) => ({x, q, v, w});
const body = [[1.0, [0.03475366666666666, 0.10941666666666666, 0.08215366666666667]]].map(named);  // mass [kg], moments about the axes of the body [kg m^2]
const start = [[[[0.0, 0.106, 0.0], [1.0, 0.0, 0.0, 0.0], [1.0, 0.0, 1.0], [0.0, 0.0, 0.0]]]].map((all) => all.map(moving));  // centre of mass [m], turn, velocity [m/s], spin [rad/s]
const gravity = [[0.0, -10.0, 0.0]];
const dt = 0.01, steps = 25, count = 1;

const J = await init();
const vec = (v) => new J.Vec3(...v), real = (v) => new J.RVec3(...v), quat = ([w, x, y, z]) => new J.Quat(x, y, z, w);
const xyz = (v) => [v.GetX(), v.GetY(), v.GetZ()];
const fixed = 0, free = 1, ghost = 2;  // layers
let jolt, system, filter, id, shape, convex_radius = 0.05;

function enter(settings, i) {
  settings.mRestitution = 0.0, settings.mFriction = 0.5;
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
  convex_radius = 0;
  physics.mAllowSleeping = false;
  physics.mMinVelocityForRestitution = 0;
  system.SetPhysicsSettings(physics);
  filter = new J.GroupFilterTable(count + 1), shape = [];
  plane([0.0, 1.0, 0.0], [0.0, 0.0, 0.0]);
  shape[0] = new J.BoxShape(vec([0.485, 0.106, 0.305]), convex_radius);
  id = body.map(({m, I}, i) => {
    const {x, q, v, w} = start[take][i];
    const settings = new J.BodyCreationSettings(
      shape[i] ?? new J.SphereShape(1), real(x), quat(q), J.EMotionType_Dynamic, shape[i] ? free : ghost);
    settings.mOverrideMassProperties = J.EOverrideMassProperties_MassAndInertiaProvided;
    settings.mMassPropertiesOverride.mMass = m;
    settings.mMassPropertiesOverride.mInertia = J.Mat44.prototype.sScaleVec3(vec(I));
    settings.mApplyGyroscopicForce = true;
    settings.mLinearDamping = 0;
    settings.mAngularDamping = 0;
    settings.mMaxLinearVelocity = 1e18;
    settings.mMaxAngularVelocity = 1e18;
    const made = enter(settings, i);
    made.GetMotionProperties().SetInverseMass(1 / m);
    made.GetMotionProperties().SetInverseInertia(vec(I.map((one) => 1 / one)), quat([1, 0, 0, 0]));
    made.SetLinearVelocity(vec(v)), made.SetAngularVelocity(vec(w));
    return made;
  });
  system.OptimizeBroadPhase();
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

function run(take) {
  build(take);
  let path = record(states());
  for (let k = 1; k <= steps; ++k) {
    step();
    append(path, states());
  }
  return path;
}

function worst_of(path) {
  let v = start[0][0].v;
  let slowed = 0.5 * norm(gravity[0]) / norm(v);
  let worst = 0.0;
  for (let k = 0; k <= steps; ++k) {
    let t = min(k * dt, 1 / slowed);
    let must = add(start[0][0].x, mul(t - 0.5 * slowed * t * t, v));
    worst = max(worst, norm(sub(path[k][0].x, must)));
  }
  return worst;
}

let path = run(0);
let worst = worst_of(path);
console.log(worst.toPrecision(9), 'm');
