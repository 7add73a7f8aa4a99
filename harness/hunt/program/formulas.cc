#include "harness/hunt/program/formulas.h"

#include <algorithm>
#include <array>
#include <utility>

namespace cylon::hunt::program {
namespace {

constexpr std::string_view energy = R"(
fn value(s) {
  let E = ${potential};
  for (let i = 0; i < count; ++i) {
    let w = back(s[i].q, s[i].w);
    E += 0.5 * body[i].m * dot(s[i].v, s[i].v) + 0.5 * dot(w, each(body[i].I, w)) - body[i].m * dot(gravity[0], s[i].x);
  }
  return E;
}
)";

constexpr std::array all = {
    Formula{"linear momentum", "kg m/s", true, Reduce::change, R"(
fn value(s) {
  let P = mul(0.0, s[0].v);
  for (let i = 0; i < count; ++i) P = add(P, mul(body[i].m, s[i].v));
  return P;
}
)"},
    Formula{"angular momentum", "kg m^2/s", true, Reduce::change, R"(
fn value(s) {
  let L = mul(0.0, s[0].w);
  for (let i = 0; i < count; ++i) {
    L = add(L, mul(body[i].m, cross(s[i].x, s[i].v)));
    L = add(L, turn(s[i].q, each(body[i].I, back(s[i].q, s[i].w))));
  }
  return L;
}
)"},
    Formula{"energy", "J", false, Reduce::change, energy},
    Formula{"energy from nowhere", "J", false, Reduce::rise, energy},
    Formula{"rest", "m", false, Reduce::change, R"(
fn value(s) {
  let far = 0.0;
  for (let i = 0; i < count; ++i) far = max(far, norm(sub(s[i].x, start[0][i].x)));
  return far;
}
)"},
    Formula{"penetration", "m", false, Reduce::change, R"(
fn value(s) {
  let depth = 0.0;
${depths}  return depth;
}
)"},
    Formula{"joint gap", "m", false, Reduce::change, R"(
fn value(s) {
  let gap = 0.0;
${gaps}  return gap;
}
)"},
    Formula{"place", "m", false, Reduce::sample, R"(
fn value(s) {
  let far = 0.0;
  for (let i = 0; i < count; ++i) far = max(far, norm(sub(s[i].x, required[i].x)));
  return far;
}
)"},
    Formula{"turn", "rad", false, Reduce::sample, R"(
fn value(s) {
  let far = 0.0;
  for (let i = 0; i < count; ++i) {
    let apart = min(norm(sub(s[i].q, required[i].q)), norm(add(s[i].q, required[i].q)));
    far = max(far, 4 * asin(min(1.0, apart / 2)));
  }
  return far;
}
)"},
    // v' = -mu g v/|v| until the box stands:  x = v t - mu g t^2/2 v/|v|,  t <= |v|/(mu g).
    Formula{"slide", "m", false, Reduce::course, R"(
fn worst_of(path) {
  let v = start[0][0].v;
  let slowed = ${friction} * norm(gravity[0]) / norm(v);
  let worst = 0.0;
  for (let k = 0; k <= steps; ++k) {
    let t = min(k * dt, 1 / slowed);
    let must = add(start[0][0].x, mul(t - 0.5 * slowed * t * t, v));
    worst = max(worst, norm(sub(path[k][0].x, must)));
  }
  return worst;
}
)"},
    // q = (cos(|w| t/2), sin(|w| t/2) w/|w|) q_0
    Formula{"spin", "rad", false, Reduce::course, R"(
fn evenly_turned(q, w, t) {
  let rate = max(norm(w), 1e-300);
  return product(quaternion(cos(0.5 * rate * t), mul(sin(0.5 * rate * t) / rate, w)), q);
}
fn worst_of(path) {
  let worst = 0.0;
  for (let k = 0; k <= steps; ++k)
    for (let i = 0; i < count; ++i) {
      let must = evenly_turned(start[0][i].q, start[0][i].w, k * dt);
      let apart = min(norm(sub(path[k][i].q, must)), norm(add(path[k][i].q, must)));
      worst = max(worst, 4 * asin(min(1.0, apart / 2)));
    }
  return worst;
}
)"},
    // v_n^2/2 + g h of the ball, three steps after the blow, is e^2 of what it was before.
    Formula{"rebound", "m^2/s^2", false, Reduce::course, R"(
fn energy(s, n, g) { return 0.5 * square(dot(n, s.v)) + g * (dot(n, s.x) - ${height}); }
fn worst_of(path) {
  let n = ${normal};
  let g = -dot(gravity[0], n);
  let before = energy(path[0][0], n, g);
  let blow = (dot(n, start[0][0].v) + sqrt(2 * before)) / g;
  let k = ceil((blow + 3 * dt) / dt);
  return abs(energy(path[k][0], n, g) - ${restitution} * ${restitution} * before);
}
)"},
    Formula{"relation rotation", "m", false, Reduce::pair, R"(
fn apart(one, other) { return norm(sub(other.x, turn(change, one.x))); }
)"},
    Formula{"relation translation", "m", false, Reduce::pair, R"(
fn apart(one, other) { return norm(sub(other.x, add(one.x, change))); }
)"},
};

constexpr std::pair<std::string_view, std::string_view> laws[] = {
    {"spring", R"(
fn spring(s, a, ra, b, rb, stiffness, rest, damping) {
  let arm = turn(s[a].q, ra);
  let v = add(s[a].v, cross(s[a].w, arm));
  let arm_b = mul(0.0, arm);
  let end = rb;
  let v_b = mul(0.0, v);
  if (b >= 0) {
    arm_b = turn(s[b].q, rb);
    end = add(s[b].x, arm_b);
    v_b = add(s[b].v, cross(s[b].w, arm_b));
  }
  let d = sub(end, add(s[a].x, arm));
  let length = norm(d);
  if (length == 0) return;
  let F = mul((stiffness * (length - rest) + damping * dot(sub(v_b, v), d) / length) / length, d);
  push(a, F, cross(arm, F));
  if (b >= 0) push(b, mul(-1.0, F), mul(-1.0, cross(arm_b, F)));
}
)"},
    {"drag", R"(
fn drag(s, a, linear, angular, momentum) {
  let L = turn(s[a].q, each(body[a].I, back(s[a].q, s[a].w)));
  push(a, mul(-linear, s[a].v), sub(mul(-angular, s[a].w), mul(momentum, L)));
}
)"},
    {"thrust", R"(
fn thrust(s, a, force) { push(a, turn(s[a].q, force), mul(0.0, force)); }
)"},
    {"drive", R"(
fn drive(t, a, force, frequency) { push(a, mul(cos(frequency * t), force), mul(0.0, force)); }
)"},
    {"attraction", R"(
fn attraction(s, a, b, strength) {
  let d = sub(s[b].x, s[a].x);
  let F = mul(strength * body[a].m * body[b].m / (norm(d) * dot(d, d)), d);
  push(a, F, mul(0.0, F));
  push(b, mul(-1.0, F), mul(0.0, F));
}
)"},
};

}  // namespace

std::span<const Formula> formulas() { return all; }

std::string_view law(std::string_view force) {
  const auto at = std::ranges::find(laws, force, [](const auto& one) { return one.first; });
  return at == std::end(laws) ? std::string_view() : at->second;
}

const std::string_view run = R"(
fn run(take) {
  build(take);
  let path = record(states());
  for (let k = 1; k <= steps; ++k) {
${act}    step();
    append(path, states());
  }
  return path;
}
)";

std::string_view reduction(const Formula& formula) {
  switch (formula.reduce) {
    case Reduce::change:
      return formula.vector ? R"(let path = run(0);
let worst = 0.0;
for (let k = 1; k <= steps; ++k) worst = max(worst, norm(sub(value(path[k]), value(path[0]))));
)"
                            : R"(let path = run(0);
let worst = 0.0;
for (let k = 1; k <= steps; ++k) worst = max(worst, abs(value(path[k]) - value(path[0])));
)";
    case Reduce::rise:
      return R"(let path = run(0);
let least = value(path[0]);
let worst = 0.0;
for (let k = 1; k <= steps; ++k) {
  worst = max(worst, value(path[k]) - least);
  least = min(least, max(value(path[k - 1]), value(path[k])));
}
)";
    case Reduce::sample:
      return R"(let path = run(0);
let worst = value(path[${sample}]);
)";
    case Reduce::course:
      return R"(let path = run(0);
let worst = worst_of(path);
)";
    case Reduce::pair:
      return R"(let path = run(0);
let other = run(1);
let worst = 0.0;
for (let k = 0; k <= steps; ++k)
  for (let i = 0; i < count; ++i) worst = max(worst, apart(path[k][i], other[k][i]));
)";
  }
  return {};
}

}  // namespace cylon::hunt::program
