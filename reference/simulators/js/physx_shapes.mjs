// The shapes of PhysX (physx.mjs), of those of a prepared scene.  Knows no bodies and no steps.
import {Unsupported} from './scene.mjs';
import {multiply, norm, quaternion_of, rotate} from './vectors.mjs';

const most_vertices = 255;  // of a convex mesh; more are left out when it is cooked

/** PhysX has capsules, cylinders and cones along x. */
export const x_to_y = quaternion_of([0, 1, 0], [-1, 0, 0], [0, 0, 1]);
const along_y = {orientation: x_to_y, position: [0, 0, 0]};
export const as_it_is = {orientation: [1, 0, 0, 0], position: [0, 0, 0]};

export class Shapes {
  constructor(engine, values, filtered) { this.engine = engine, this.offset = values['contact-offset'], this.filtered = filtered, this.meshes = []; }

  points(vertices, use) {
    const {P} = this.engine, array = new P.PxArray_PxVec3(vertices.length);
    vertices.forEach((v, i) => this.engine.vec3(v, (point) => array.set(i, point)));
    try {
      return use(array.begin());
    } finally {
      P.destroy(array);
    }
  }

  hull(shape, {name}) {
    const {engine} = this, {P} = engine;
    if (shape.vertices.length > most_vertices)
      throw new Unsupported(`Body '${name}': PhysX has convex meshes of at most ${most_vertices} vertices; this hull has ${shape.vertices.length}.`);
    const mesh = this.points(shape.vertices, (data) => engine.with('PxConvexMeshDesc', [], (desc) => {
      Object.assign(desc.points, {count: shape.vertices.length, stride: 12, data});
      return engine.with('PxConvexFlags', [engine.value('PxConvexFlagEnum', 'eCOMPUTE_CONVEX')], (flags) => {
        desc.flags = flags;
        return engine.top.CreateConvexMesh(engine.cooking, desc);
      });
    }));
    this.keep(mesh, `Body '${name}': PhysX makes no hull of these vertices.`);
    this.require_extent(mesh, shape.vertices, name);
    return new P.PxConvexMeshGeometry(mesh);
  }

  keep(mesh, otherwise) {
    if (!mesh || this.engine.P.getPointer(mesh) === 0) throw new Unsupported(otherwise);
    this.meshes.push(mesh);
  }

  /** PhysX thickens what has no volume, and says nothing. */
  require_extent(mesh, vertices, name) {
    const bounds = mesh.getLocalBounds(), ends = [Math.min, Math.max];
    const size = norm(['x', 'y', 'z'].map((axis) => bounds.maximum[axis] - bounds.minimum[axis]));
    [bounds.minimum, bounds.maximum].forEach((end, side) => ['x', 'y', 'z'].forEach((axis, k) => {
      const stated = ends[side](...vertices.map((v) => v[k]));
      if (Math.abs(end[axis] - stated) > 1e-5 * size)
        throw new Unsupported(`Body '${name}': PhysX makes no hull of these vertices, but one that ends at ${axis} = ${end[axis]} m in place of ${stated} m.`);
    }));
  }

  mesh(shape, {name, locked}) {
    const {engine} = this, {P} = engine;
    if (!locked) throw new Unsupported(`Body '${name}': PhysX collides a mesh only where it does not move.`);
    const indices = new P.PxArray_PxU32(3 * shape.faces.length);
    shape.faces.flat().forEach((index, i) => indices.set(i, index));
    const mesh = this.points(shape.vertices, (data) => engine.with('PxTriangleMeshDesc', [], (desc) => {
      Object.assign(desc.points, {count: shape.vertices.length, stride: 12, data});
      Object.assign(desc.triangles, {count: shape.faces.length, stride: 12, data: indices.begin()});
      return engine.top.CreateTriangleMesh(engine.cooking, desc);
    }));
    P.destroy(indices);
    this.keep(mesh, `Body '${name}': PhysX makes no mesh of these triangles.`);
    return new P.PxTriangleMeshGeometry(mesh);
  }

  /** A geometry in PhysX' own axes, and how those stand in the part's. */
  geometry(shape, body) {
    const {P} = this.engine;
    const core = (Type) => {
      const made = new P[Type](shape.length, shape.radius);
      const geometry = P.PxConvexCoreGeometryFactory.prototype[Type.replace('PxConvexCore', 'createFrom')](made, 0);
      P.destroy(made);
      return geometry;
    };
    const made = {
      sphere: () => [new P.PxSphereGeometry(shape.radius), as_it_is],
      box: () => [new P.PxBoxGeometry(...shape.half_extents), as_it_is],
      capsule: () => [new P.PxCapsuleGeometry(shape.radius, shape.length / 2), along_y],
      cylinder: () => [core('PxConvexCoreCylinder'), along_y],
      cone: () => [core('PxConvexCoreCone'), {...along_y, position: [0, shape.length / 4, 0]}],  // about mid-height
      hull: () => [this.hull(shape, body), as_it_is],
      mesh: () => [this.mesh(shape, body), as_it_is],
    }[shape.type];
    if (!made) throw new Unsupported(`Body '${body.name}': PhysX has no solid without thickness, such as a ${shape.type}.`);
    return made();
  }

  /** Attaches the shape of a body to its actor. */
  attach(actor, body, material, thing) {
    const parts = body.shape.type === 'compound' ? body.shape.parts.filter((part) => part.shape) : [{...as_it_is, shape: body.shape}];
    for (const part of parts) {
      const [geometry, foot] = this.geometry(part.shape, body);
      const position = rotate(part.orientation, foot.position).map((x, k) => x + part.position[k]);
      this.attach_one(actor, geometry, {position, orientation: multiply(part.orientation, foot.orientation)}, material, thing);
    }
  }

  attach_one(actor, geometry, {position, orientation}, material, thing) {
    const {engine} = this;
    const shape = engine.with('PxShapeFlags', [engine.value('PxShapeFlagEnum', 'eSIMULATION_SHAPE')],
      (flags) => engine.physics.createShape(geometry, material, true, flags));
    shape.setContactOffset(this.offset);
    engine.pose(position, orientation, (pose) => shape.setLocalPose(pose));
    // The bindings' own filter has a bit of a group and a mask; this adapter's has the thing.
    engine.with('PxFilterData', this.filtered ? [thing, 0, 0, 0] : [1, 1, 0, 0], (data) => shape.setSimulationFilterData(data));
    actor.attachShape(shape);
    shape.release();  // the actor holds it
    engine.P.destroy(geometry);
  }

  free() { for (const mesh of this.meshes) mesh.release(); }
}
