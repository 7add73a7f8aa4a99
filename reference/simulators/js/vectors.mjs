// Vectors as arrays of three, quaternions as (w, x, y, z), matrices as nine numbers row by row: the protocol's own forms.

export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (s, a) => [s * a[0], s * a[1], s * a[2]];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const norm = (a) => Math.sqrt(dot(a, a));
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const is_zero = (a) => a[0] === 0 && a[1] === 0 && a[2] === 0;

/** q v q*:  v + 2 w (u x v) + 2 u x (u x v)  with u the vector part of the unit quaternion q. */
export function rotate(q, v) {
  const u = [q[1], q[2], q[3]], t = scale(2, cross(u, v));
  return add(v, add(scale(q[0], t), cross(u, t)));
}
export const conjugate = (q) => [q[0], -q[1], -q[2], -q[3]];
export const multiply = (a, b) => [
  a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
  a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
  a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
  a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
];

/** A v. */
export const times = (m, v) => [0, 1, 2].map((i) => m[3 * i] * v[0] + m[3 * i + 1] * v[1] + m[3 * i + 2] * v[2]);
/** The tensor m of body axes applied to the vector v of world axes, for the orientation q:  R m R^T v. */
export const world_times = (m, q, v) => rotate(q, times(m, rotate(conjugate(q), v)));

/** A unit vector across the unit vector a. */
export function across(a) {
  const least = [0, 1, 2].reduce((k, i) => (Math.abs(a[i]) < Math.abs(a[k]) ? i : k), 0);
  const axis = [0, 0, 0];
  axis[least] = 1;
  const c = cross(a, axis);
  return scale(1 / norm(c), c);
}

/** The unit quaternion of the rotation matrix whose columns are the right-handed triple (x, y, z); by the largest
 *  component, so that nothing is divided by a small number (Shepperd 1978). */
export function quaternion_of(x, y, z) {
  const m = [[x[0], y[0], z[0]], [x[1], y[1], z[1]], [x[2], y[2], z[2]]];
  const trace = m[0][0] + m[1][1] + m[2][2];
  const squares = [trace, m[0][0], m[1][1], m[2][2]];
  const k = squares.indexOf(Math.max(...squares));
  const q = [0, 0, 0, 0];
  if (k === 0) {
    q[0] = 1 + trace, q[1] = m[2][1] - m[1][2], q[2] = m[0][2] - m[2][0], q[3] = m[1][0] - m[0][1];
  } else {
    const i = k - 1, j = (i + 1) % 3, l = (i + 2) % 3;
    q[k] = 1 + m[i][i] - m[j][j] - m[l][l];
    q[j + 1] = m[j][i] + m[i][j], q[l + 1] = m[l][i] + m[i][l], q[0] = m[l][j] - m[j][l];
  }
  const length = Math.hypot(...q);
  return q.map((c) => c / length);
}

/** The shortest rotation of +y to the unit vector n. */
export function turn_of_y(n) {
  const x = across(n);
  return n[0] === 0 && n[1] === 1 && n[2] === 0 ? [1, 0, 0, 0] : quaternion_of(x, n, cross(x, n));
}

/** Principal moments of a symmetric tensor (nine numbers) and the quaternion from principal to body axes, by Jacobi's
 *  rotations in cyclic order (Golub and Van Loan, section 8.5).  A diagonal tensor keeps its axes to the bit. */
export function principal_axes(tensor) {
  const a = [tensor.slice(0, 3), tensor.slice(3, 6), tensor.slice(6, 9)];
  const v = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];  // columns are axes
  for (let sweep = 0; sweep < 64; ++sweep) {
    const off = Math.abs(a[0][1]) + Math.abs(a[0][2]) + Math.abs(a[1][2]);
    if (off === 0) break;
    for (const [p, q] of [[0, 1], [0, 2], [1, 2]]) {
      if (a[p][q] === 0) continue;
      const tau = (a[q][q] - a[p][p]) / (2 * a[p][q]);
      const t = Math.sign(tau || 1) / (Math.abs(tau) + Math.sqrt(1 + tau * tau));
      const c = 1 / Math.sqrt(1 + t * t), s = t * c;
      for (let k = 0; k < 3; ++k) [a[k][p], a[k][q]] = [c * a[k][p] - s * a[k][q], s * a[k][p] + c * a[k][q]];
      for (let k = 0; k < 3; ++k) [a[p][k], a[q][k]] = [c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]];
      a[p][q] = a[q][p] = 0;
      for (let k = 0; k < 3; ++k) [v[k][p], v[k][q]] = [c * v[k][p] - s * v[k][q], s * v[k][p] + c * v[k][q]];
    }
  }
  const column = (k) => [v[0][k], v[1][k], v[2][k]];
  const untouched = v.every((row, i) => row[i] === 1);
  return {moments: [a[0][0], a[1][1], a[2][2]], axes: untouched ? [1, 0, 0, 0] : quaternion_of(column(0), column(1), column(2))};
}
