// Joints as trees, for engines with reduced coordinates; those that close a loop, and distances, are left over.
// The same rule as reference/applied/forest.cc.  Knows no engine.

/** {nodes: [{joint, parent, children, depth}] by body (-1: none, the world), roots, loops: joints}. */
export function forest_of(scene) {
  const moves = (i) => i >= 0 && !scene.bodies[i].locked;
  const in_tree = (joint) => joint.type !== 'distance';
  const nodes = scene.bodies.map(() => ({joint: -1, parent: -1, children: [], depth: 1}));
  const found = new Set(), used = new Set(), roots = [], edge = [];
  const of_body = scene.bodies.map(() => []);
  scene.joints.forEach((joint, j) => { for (const end of [joint.body, joint.to]) if (moves(end)) of_body[end].push(j); });
  const hang = (body, joint, parent) => {
    Object.assign(nodes[body], {joint, parent});
    if (parent < 0) roots.push(body);
    else nodes[parent].children.push(body), nodes[body].depth = nodes[parent].depth + 1;
    if (joint >= 0) used.add(joint);
    found.add(body);
    edge.push(body);
  };
  const spread = () => {
    for (let body; (body = edge.shift()) !== undefined;)
      for (const j of of_body[body]) {
        const joint = scene.joints[j], other = joint.body === body ? joint.to : joint.body;
        if (in_tree(joint) && moves(other) && !found.has(other)) hang(other, j, body);
      }
  };
  scene.joints.forEach((joint, j) => {
    if (!in_tree(joint) || moves(joint.body) === moves(joint.to)) return;
    const body = moves(joint.body) ? joint.body : joint.to;
    if (!found.has(body)) hang(body, j, -1);
  });
  spread();
  scene.bodies.forEach((body, i) => {
    if (found.has(i) || body.locked) return;
    hang(i, -1, -1);
    spread();
  });
  const loops = scene.joints.map((_, j) => j).filter((j) => !used.has(j) && (moves(scene.joints[j].body) || moves(scene.joints[j].to)));
  return {nodes, roots, loops};
}
