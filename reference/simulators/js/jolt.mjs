// The adapter of Jolt Physics (jolt-physics, WebAssembly, single precision): a prepared scene in, motion out.
// Knows nothing of the protocol.
import fs from 'node:fs';
import {createRequire} from 'node:module';
import init from 'jolt-physics/wasm';
import {frame_of, held_coordinate, kept} from './joints.mjs';
import {Unsupported} from './scene.mjs';
import {across, rotate, scale} from './vectors.mjs';

const unlimited = 1e18;  // its square is finite in single precision

export const about = {
  name: 'jolt', title: 'Jolt', build: 'WebAssembly', native: 'native code of C++', precision: 'float',
  schemes: [{name: 'semi-implicit-euler', order: 1, conserves: 'linear momentum', adaptive: false}],
  gyroscopic: (values) => (values.gyro === 'on' ? 'explicit, of constant |L|' : 'none'),
  joints: {types: ['ball', 'hinge', 'fixed', 'distance', 'slider', 'cylindrical', 'planar', 'rectangular', 'universal'], limits: ['hinge', 'slider'],
    friction: ['hinge', 'slider']},
  of_the_scene: [
    {name: 'mass, inertia', value: 'of the scene', engine_default: 'of the shape and its density', reason: 'the scene has its own'},
    {name: 'mCombinedRestitution, mCombinedFriction', value: 'of the pair', engine_default: 'the larger; the geometric mean',
      reason: 'all bodies have the same number where all pairs do; else a contact listener sets those of the pair'},
    {name: 'collision steps', value: '1', engine_default: '1', reason: 'one Step is one step'},
    {name: 'collision filter', value: 'GroupFilterTable', engine_default: 'none',
      reason: 'pairs that a joint ties, or that groups and masks keep apart, do not touch'},
  ],
  unforceable: [
    'A bounce acts from a gap on that the step would close (at most speculative-distance), in the step before the touch.',
    'A plane is bounded: it ends 10 km from the foot of the normal through the origin (PlaneShape, types.d.ts:1289).',
    'Joints keep an error that the sweeps of the position solver leave (position-steps, baumgarte).',
    'One integrator; the gyroscopic torque is explicit or none (types.d.ts:2922).',
    'Room for contacts is 10 MB, which JoltSettings does not set (types.d.ts:4441); what has no room is left out, and Step returns nothing that tells it (types.d.ts:4470). A scene that may have more than 20000 manifolds is unsupported.',
    'A speed whose square is beyond single precision, above 1.8e19 m/s, becomes 0.',
    'A step runs on one thread; the build without threads has no other.',
    'A contact listener is told points and depths, and no impulses (types.d.ts:2319, 2387): no forces of contacts are told.',
  ],
  options: [
    {name: 'gyro', setting: 'mApplyGyroscopicForce', values: ['off', 'on'], engine_default: 'off',
      meaning: 'the gyroscopic torque, explicit, after which the size of the angular momentum is restored'},
    {name: 'inertia', setting: 'way of the inertia', values: ['tensor', 'principal'], engine_default: 'tensor',
      meaning: 'tensor: mMassPropertiesOverride, whose principal axes Jolt finds, and sorts, in single precision; principal: SetInverseInertia'},
    {name: 'convex-radius', setting: 'mConvexRadius', least: 0, most: 1e6, engine_default: 0.05,
      meaning: 'radius to which edges and corners of boxes, cylinders, cones and hulls are rounded; less of a small shape [m]'},
    {name: 'linear-damping', setting: 'mLinearDamping', least: 0, most: Infinity, engine_default: 0.05, meaning: 'of velocities [1/s]'},
    {name: 'angular-damping', setting: 'mAngularDamping', least: 0, most: Infinity, engine_default: 0.05, meaning: 'of angular velocities [1/s]'},
    {name: 'max-speed', setting: 'mMaxLinearVelocity', least: 0, most: unlimited, above: true, engine_default: 500, meaning: 'cap of the speed [m/s]'},
    {name: 'max-spin', setting: 'mMaxAngularVelocity', least: 0, most: unlimited, above: true, engine_default: 47.12389,
      meaning: 'cap of the angular speed [rad/s]; by default a quarter turn in 1/30 s'},
    {name: 'sleeping', setting: 'mAllowSleeping', values: ['off', 'on'], engine_default: 'on', meaning: 'slow bodies are taken out of the simulation'},
    {name: 'restitution-threshold', setting: 'mMinVelocityForRestitution', least: 0, most: Infinity, engine_default: 1,
      meaning: 'approach speed below which nothing bounces [m/s]'},
    {name: 'speculative-distance', setting: 'mSpeculativeContactDistance', least: 0, most: Infinity, engine_default: 0.02,
      meaning: 'gap up to which contacts are found before they touch [m]'},
    {name: 'slop', setting: 'mPenetrationSlop', least: 0, most: Infinity, engine_default: 0.02, meaning: 'penetration that is left as it is [m]'},
    {name: 'baumgarte', setting: 'mBaumgarte', least: 0, most: 1, engine_default: 0.2, meaning: 'share of an error of position that a sweep corrects'},
    {name: 'velocity-steps', setting: 'mNumVelocitySteps', least: 2, most: 255, whole: true, engine_default: 10, meaning: 'sweeps of the velocity solver'},
    {name: 'position-steps', setting: 'mNumPositionSteps', least: 0, most: 255, whole: true, engine_default: 2, meaning: 'sweeps of the position solver'},
    {name: 'pair-cache', setting: 'mUseBodyPairContactCache', values: ['off', 'on'], engine_default: 'on',
      meaning: 'a pair that moved by less than 1 mm and 2 degrees keeps what was found of it, also that it does not touch'},
    {name: 'warm-start', setting: 'mConstraintWarmStart', values: ['off', 'on'], engine_default: 'on', meaning: 'the velocity solver starts from the last impulses'},
  ],
  paths: [
    {name: 'plain', summary: 'damping, caps of speed, thresholds and sleeping are off; the gyroscopic torque is on', set: {
      'gyro': ['on', 'bodies turn as they do'],
      'inertia': ['principal', 'the axes are those of the scene, to the bit where they are the axes of the body'],
      'convex-radius': [0, 'edges and corners of the scene are sharp'],
      'linear-damping': [0, 'the scene has no damping'],
      'angular-damping': [0, 'the scene has no damping'],
      'max-speed': [unlimited, 'the scene has no cap'],
      'max-spin': [unlimited, 'the scene has no cap'],
      'sleeping': ['off', 'what moves slowly moves'],
      'restitution-threshold': [0, 'slow impacts bounce too'],
    }},
    {name: 'as-shipped', summary: 'every setting as Jolt has it by itself', set: {}},
  ],
};

const is_on = (word) => word === 'on';
const largest = 3.4e38;        // of single precision
const in_six = ['cylindrical', 'planar', 'rectangular', 'universal'];
const plane_extent = 1e4;      // [m]
const most_manifolds = 20000;  // 472 bytes each of the temporary allocator's 10 MB; 30000 abort the module
const layer = {still: 0, moving: 1, ghost: 2};

export async function start() {
  const require = createRequire(import.meta.url);
  const {version} = JSON.parse(fs.readFileSync(require.resolve('jolt-physics/package.json'), 'utf8'));
  const J = await init({print: console.error, printErr: console.error});
  return {version, load: (scene, dt, values) => new World(J, scene, dt, values), defaults: () => defaults(J)};
}

/** The engine's own values of the options, asked of itself; null where it does not tell. */
function defaults(J) {
  const word = (on) => (on ? 'on' : 'off'), body = new J.BodyCreationSettings(), physics = new J.PhysicsSettings();
  return {
    'gyro': word(body.mApplyGyroscopicForce), 'inertia': null, 'convex-radius': new J.BoxShapeSettings(new J.Vec3(1, 1, 1)).mConvexRadius,
    'linear-damping': body.mLinearDamping, 'angular-damping': body.mAngularDamping,
    'max-speed': body.mMaxLinearVelocity, 'max-spin': body.mMaxAngularVelocity,
    'sleeping': word(body.mAllowSleeping && physics.mAllowSleeping), 'restitution-threshold': physics.mMinVelocityForRestitution,
    'speculative-distance': physics.mSpeculativeContactDistance, 'slop': physics.mPenetrationSlop, 'baumgarte': physics.mBaumgarte,
    'velocity-steps': physics.mNumVelocitySteps, 'position-steps': physics.mNumPositionSteps,
    'pair-cache': word(physics.mUseBodyPairContactCache), 'warm-start': word(physics.mConstraintWarmStart),
  };
}

// ---- Shapes -------------------------------------------------------------------------------------------

class Shapes {
  constructor(J, convex_radius) { this.J = J, this.convex_radius = convex_radius; }

  vec3([x, y, z]) { return new this.J.Vec3(x, y, z); }
  quat([w, x, y, z]) { return new this.J.Quat(x, y, z, w); }
  made(settings, name) {
    const result = settings.Create();
    if (result.HasError()) throw new Unsupported(`Body '${name}': Jolt makes no shape of it: ${result.GetError().c_str()}`);
    return result.Get();
  }

  /** A shape in its own axes and, where those are not the part's, how it stands in them. */
  primitive(shape, body) {
    const J = this.J;
    switch (shape.type) {
      case 'sphere': return this.made(new J.SphereShapeSettings(shape.radius), body.name);
      case 'box': return this.made(new J.BoxShapeSettings(this.vec3(shape.half_extents), this.convex_radius), body.name);
      case 'capsule': return this.made(new J.CapsuleShapeSettings(shape.length / 2, shape.radius), body.name);
      case 'cylinder': return this.made(new J.CylinderShapeSettings(shape.length / 2, shape.radius, this.convex_radius), body.name);
      case 'cone': return this.made(new J.TaperedCylinderShapeSettings(shape.length / 2, 0, shape.radius, this.convex_radius), body.name);
      case 'hull': return this.hull(shape, body);
      case 'mesh': return this.mesh(shape, body);
      default: throw new Unsupported(`Body '${body.name}': Jolt has no solid without thickness, such as a ${shape.type}.`);
    }
  }

  hull(shape, body) {
    const settings = new this.J.ConvexHullShapeSettings();
    settings.mMaxConvexRadius = this.convex_radius;
    for (const vertex of shape.vertices) settings.mPoints.push_back(this.vec3(vertex));
    return this.made(settings, body.name);
  }

  mesh(shape, body) {
    const J = this.J;
    if (!body.locked) throw new Unsupported(`Body '${body.name}': Jolt collides a mesh only where it does not move.`);
    const vertices = new J.VertexList(), triangles = new J.IndexedTriangleList();
    for (const [x, y, z] of shape.vertices) vertices.push_back(new J.Float3(x, y, z));
    for (const [a, b, c] of shape.faces) triangles.push_back(new J.IndexedTriangle(a, b, c, 0));
    return this.made(new J.MeshShapeSettings(vertices, triangles, new J.PhysicsMaterialList()), body.name);
  }

  /** Where a shape's own origin is in the axes of a part: Jolt's cone stands about the middle of its height. */
  foot(shape) { return shape.type === 'cone' ? [0, shape.length / 4, 0] : [0, 0, 0]; }

  /** Of a body, with its centre of mass where the scene has it: Jolt's is that of the shape. */
  of(body) {
    const J = this.J;
    if (!body.touches) return new J.SphereShape(1);
    const shape = body.shape;
    if (shape.type !== 'compound' && shape.type !== 'cone') return this.centred(this.primitive(shape, body), body);
    const parts = shape.type === 'cone' ? [{shape, position: [0, 0, 0], orientation: [1, 0, 0, 0]}] : shape.parts.filter((p) => p.shape);
    const settings = new J.StaticCompoundShapeSettings();
    for (const part of parts) {
      const foot = rotate(part.orientation, this.foot(part.shape));
      const at = part.position.map((x, k) => x + foot[k]);
      settings.AddShapeShape(this.vec3(at), this.quat(part.orientation), this.primitive(part.shape, body), 0);
    }
    return this.centred(this.made(settings, body.name), body);
  }

  centred(shape, body) {
    const centre = shape.GetCenterOfMass(), off = [-centre.GetX(), -centre.GetY(), -centre.GetZ()];
    if (body.locked || off.every((x) => x === 0)) return shape;
    return new this.J.OffsetCenterOfMassShape(shape, this.vec3(off));
  }
}

// ---- A world ------------------------------------------------------------------------------------------

class World {
  constructor(J, scene, dt, values) {
    this.J = J, this.scene = scene, this.dt = dt;
    this.vec = new J.Vec3(0, 0, 0);  // for calls of a step
    this.make_system(values);
    this.system = this.jolt.GetPhysicsSystem();
    const {gravity} = scene;
    this.system.SetGravity(this.v(gravity));
    this.set_physics(values);
    this.shapes = new Shapes(J, values['convex-radius']);
    this.restitution = scene.contacts.uniform('restitution'), this.friction = scene.contacts.uniform('friction');
    if (this.restitution === undefined || this.friction === undefined) this.listen();
    this.filter();
    this.planes = scene.planes.map((plane) => this.make_plane(plane));
    this.bodies = scene.bodies.map((body) => this.make_body(body, values));
    for (const joint of scene.joints) this.make_joint(joint);
    this.system.OptimizeBroadPhase();
  }

  v([x, y, z]) {
    this.vec.Set(x, y, z);
    return this.vec;
  }

  make_system() {
    const J = this.J, layers = 3, settings = new J.JoltSettings();
    const pairs = new J.ObjectLayerPairFilterTable(layers);
    pairs.EnableCollision(layer.still, layer.moving);
    pairs.EnableCollision(layer.moving, layer.moving);
    const map = new J.BroadPhaseLayerInterfaceTable(layers, layers);
    for (let i = 0; i < layers; ++i) {
      const broad = new J.BroadPhaseLayer(i);
      map.MapObjectToBroadPhaseLayer(i, broad);
      J.destroy(broad);
    }
    settings.mObjectLayerPairFilter = pairs;
    settings.mBroadPhaseLayerInterface = map;
    settings.mObjectVsBroadPhaseLayerFilter = new J.ObjectVsBroadPhaseLayerFilterTable(map, layers, pairs, layers);
    const things = this.scene.bodies.length + this.scene.planes.length;
    settings.mMaxBodies = things + 8;
    settings.mMaxBodyPairs = settings.mMaxContactConstraints = this.room();
    this.jolt = new J.JoltInterface(settings);
    J.destroy(settings);
  }

  /** Manifolds for which there must be room: all pairs, or of many things 7 for each (spheres of one size have 12
   *  neighbours, 6 pairs each, and a plane).  Jolt leaves out what has no room and does not tell. */
  room() {
    const touching = this.scene.contacts.things, parts = (thing) => this.scene.bodies[thing.id]?.shape.parts?.length ?? 1;
    const most = touching.reduce((n, thing) => Math.max(n, parts(thing)), 1) ** 2;
    const n = touching.length, room = Math.min(n * (n - 1) / 2, 7 * n) * most + 64;
    if (room > most_manifolds)
      throw new Unsupported(`Jolt's allocator in this build has room for ${most_manifolds} contact manifolds, and this scene may have ${room}.`);
    return room;
  }

  set_physics(values) {
    const settings = this.system.GetPhysicsSettings();
    settings.mMinVelocityForRestitution = values['restitution-threshold'];
    settings.mSpeculativeContactDistance = values['speculative-distance'];
    settings.mPenetrationSlop = values.slop;
    settings.mBaumgarte = values.baumgarte;
    settings.mNumVelocitySteps = values['velocity-steps'];
    settings.mNumPositionSteps = values['position-steps'];
    settings.mAllowSleeping = is_on(values.sleeping);
    settings.mUseBodyPairContactCache = is_on(values['pair-cache']);
    settings.mConstraintWarmStart = is_on(values['warm-start']);
    this.system.SetPhysicsSettings(settings);
  }

  /** The materials of pairs, where they differ, as each contact is made or goes on. */
  listen() {
    const J = this.J, listener = new J.ContactListenerJS();
    const set = (first, second, manifold, pointer) => {
      const id = (body) => J.wrapPointer(body, J.Body).GetUserData();
      const material = this.scene.contacts.material(id(first), id(second));
      const settings = J.wrapPointer(pointer, J.ContactSettings);
      settings.mCombinedRestitution = material.restitution;
      settings.mCombinedFriction = material.friction;
    };
    listener.OnContactAdded = listener.OnContactPersisted = set;
    listener.OnContactValidate = () => J.ValidateResult_AcceptAllContactsForThisBodyPair;
    listener.OnContactRemoved = () => {};
    this.system.SetContactListener(listener);
    this.listener = listener;
  }

  filter() {
    let table;
    for (const [a, b] of this.scene.contacts.kept_apart()) {
      table ??= new this.J.GroupFilterTable(this.scene.bodies.length + this.scene.planes.length);
      table.DisableCollision(a, b);
    }
    this.groups = table;
  }

  /** Into the world; `thing` as in scene.contacts. */
  add(settings, thing) {
    const J = this.J;
    settings.mUserData = thing;
    settings.mRestitution = this.restitution ?? 0;
    settings.mFriction = this.friction ?? 0;
    if (this.groups) {
      settings.mCollisionGroup.SetGroupFilter(this.groups);
      settings.mCollisionGroup.SetGroupID(0);
      settings.mCollisionGroup.SetSubGroupID(thing);
    }
    const bodies = this.system.GetBodyInterface(), body = bodies.CreateBody(settings);
    bodies.AddBody(body.GetID(), J.EActivation_Activate);
    J.destroy(settings);
    return body;
  }

  make_plane(plane) {
    const J = this.J;
    const foot = scale(plane.offset, plane.normal);
    const shape = new J.PlaneShape(new J.Plane(this.v(plane.normal), 0), null, plane_extent);
    return this.add(new J.BodyCreationSettings(shape, new J.RVec3(...foot), new J.Quat(0, 0, 0, 1), J.EMotionType_Static, layer.still),
      this.scene.bodies.length + plane.index);
  }

  make_body(body, values) {
    const J = this.J, [w, x, y, z] = body.orientation;
    const settings = new J.BodyCreationSettings(
      this.shapes.of(body), new J.RVec3(...body.position), new J.Quat(x, y, z, w),
      body.locked ? J.EMotionType_Static : J.EMotionType_Dynamic,
      !body.touches ? layer.ghost : body.locked ? layer.still : layer.moving);
    settings.mGravityFactor = body.gravity ? 0 : 1;  // its own is a force
    settings.mApplyGyroscopicForce = is_on(values.gyro);
    settings.mAllowSleeping = is_on(values.sleeping);
    settings.mLinearDamping = values['linear-damping'];
    settings.mAngularDamping = values['angular-damping'];
    settings.mMaxLinearVelocity = values['max-speed'];
    settings.mMaxAngularVelocity = values['max-spin'];
    settings.mOverrideMassProperties = J.EOverrideMassProperties_MassAndInertiaProvided;
    this.shape_mass(settings.mMassPropertiesOverride, body, values.inertia === 'tensor');
    const made = this.add(settings, body.index);
    if (!body.locked) this.move(made, body, values.inertia === 'principal');
    return made;
  }

  // Of a locked body, and of one whose principal moments come later, any that Jolt takes.
  shape_mass(properties, body, as_tensor) {
    const J = this.J, stated = as_tensor && !body.locked;
    properties.mMass = stated ? body.mass : 1;
    const tensor = J.Mat44.prototype.sIdentity();
    const m = stated ? body.inertia : [1, 0, 0, 0, 1, 0, 0, 0, 1];
    for (let k = 0; k < 3; ++k) tensor.SetColumn4(k, new J.Vec4(m[k], m[3 + k], m[6 + k], 0));
    properties.mInertia = tensor;
  }

  // Not among the settings, which Jolt would hold to its caps: the state of the scene is what it is.
  move(made, body, by_principal_axes) {
    if (by_principal_axes) {
      const motion = made.GetMotionProperties(), {moments, axes: [w, x, y, z]} = body.principal;
      motion.SetInverseMass(1 / body.mass);
      motion.SetInverseInertia(this.v(moments.map((moment) => 1 / moment)), new this.J.Quat(x, y, z, w));
    }
    made.SetLinearVelocity(this.v(body.velocity));
    made.SetAngularVelocity(this.v(body.spin));
  }

  make_joint(joint) {
    const J = this.J, scene = this.scene, first = scene.bodies[joint.body], second = scene.bodies[joint.to];
    if (first.locked && (!second || second.locked)) return;
    const place = new J.RVec3(...(joint.point ?? [0, 0, 0]));
    const axis = joint.axis && scale(1 / Math.hypot(...joint.axis), joint.axis);
    const set = {
      ball: () => Object.assign(new J.PointConstraintSettings(), {mPoint1: place, mPoint2: place}),
      hinge: () => {
        const along = new J.Vec3(...axis), normal = new J.Vec3(...across(axis));
        return Object.assign(new J.HingeConstraintSettings(),
          {mPoint1: place, mPoint2: place, mHingeAxis1: along, mHingeAxis2: along, mNormalAxis1: normal, mNormalAxis2: normal});
      },
      fixed: () => {
        const x = new J.Vec3(1, 0, 0), y = new J.Vec3(0, 1, 0);
        return Object.assign(new J.FixedConstraintSettings(),
          {mAutoDetectPoint: false, mPoint1: place, mPoint2: place, mAxisX1: x, mAxisX2: x, mAxisY1: y, mAxisY2: y});
      },
      distance: () => Object.assign(new J.DistanceConstraintSettings(), {
        mPoint1: new J.RVec3(...first.position), mPoint2: second ? new J.RVec3(...second.position) : place,
        mMinDistance: joint.length, mMaxDistance: joint.length}),
      slider: () => {
        const along = new J.Vec3(...axis), normal = new J.Vec3(...across(axis));
        return Object.assign(new J.SliderConstraintSettings(), {
          mAutoDetectPoint: false, mPoint1: place, mPoint2: place, mSliderAxis1: along, mSliderAxis2: along, mNormalAxis1: normal, mNormalAxis2: normal});
      },
      cylindrical: () => this.six_axes(joint, place, ['TranslationX', 'RotationX']),
      planar: () => this.six_axes(joint, place, ['TranslationY', 'TranslationZ', 'RotationX']),
      rectangular: () => this.six_axes(joint, place, ['TranslationY', 'TranslationZ']),
      universal: () => this.six_axes(joint, place, ['RotationX', 'RotationZ']),
    }[kept(joint)];
    const settings = set();
    settings.mSpace = J.EConstraintSpace_WorldSpace;
    this.hold(settings, joint);
    const other = second ? this.bodies[joint.to] : J.JoltInterface.prototype.sGetFixedToWorldBody();
    // Of six axes those of the first body carry the directions, as those of `to` do in a scene.
    const ends = in_six.includes(joint.type) ? [other, this.bodies[joint.body]] : [this.bodies[joint.body], other];
    this.system.AddConstraint(settings.Create(...ends));
  }

  // Jolt turns by  R(z, swing) R(x, twist): of a universal joint z is its axis, and x its second.
  six_axes(joint, place, free) {
    const J = this.J, [first, second, third] = frame_of(joint).map((v) => new J.Vec3(...v));
    const [x, y] = joint.type === 'universal' ? [second, third] : [first, second];
    const settings = Object.assign(new J.SixDOFConstraintSettings(),
      {mPosition1: place, mPosition2: place, mAxisX1: x, mAxisX2: x, mAxisY1: y, mAxisY2: y, mSwingType: J.ESwingType_Pyramid});
    for (const axis of ['TranslationX', 'TranslationY', 'TranslationZ', 'RotationX', 'RotationY', 'RotationZ']) {
      const which = J[`SixDOFConstraintSettings_EAxis_${axis}`];
      if (free.includes(axis)) settings.MakeFreeAxis(which);
      else settings.MakeFixedAxis(which);
    }
    return settings;
  }

  // Jolt counts the second body against the first, which is `body`.
  hold(settings, joint) {
    const held = held_coordinate(joint, true);
    if (!held) return;
    const slides = joint.type === 'slider', most = slides ? largest : Math.PI;
    if (held.limited) settings.mLimitsMin = Math.max(held.lower, -most), settings.mLimitsMax = Math.min(held.upper, most);
    settings[slides ? 'mMaxFrictionForce' : 'mMaxFrictionTorque'] = held.friction;
  }

  step() { this.jolt.Step(this.dt, 1); }

  push(i, force, torque) {
    this.bodies[i].AddForce(this.v(force));
    this.bodies[i].AddTorque(this.v(torque));
  }

  set_mass(i, mass) { this.bodies[i].GetMotionProperties().SetInverseMass(1 / mass); }

  read(i) {
    const start = this.scene.bodies[i], body = this.bodies[i];
    if (start.locked) return {position: start.position, orientation: start.orientation, velocity: [0, 0, 0], spin: [0, 0, 0]};
    const three = (v) => [v.GetX(), v.GetY(), v.GetZ()];
    const q = body.GetRotation();
    return {
      orientation: [q.GetW(), q.GetX(), q.GetY(), q.GetZ()], position: three(body.GetCenterOfMassPosition()),
      velocity: three(body.GetLinearVelocity()), spin: three(body.GetAngularVelocity()),
    };
  }

  free() {
    this.J.destroy(this.vec);
    this.J.destroy(this.jolt);
    if (this.listener) this.J.destroy(this.listener);
  }
}
