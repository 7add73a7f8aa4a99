// Sweeps in lanes are the sweeps of one pair after another, and nobody's neighbour in a lane changes his bits.
#include "engine/pile/crowd.h"
#include "engine/rotation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace cylon::engine::pile {
namespace {

struct Scene {
  Crowd::Step step;
  std::vector<Body> bodies;
  std::vector<Motion> motions;
  std::vector<Mover> movers;
  std::vector<Block> blocks;
  std::vector<Group> groups;
};

class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}
  Real number(Real low, Real high) { return std::uniform_real_distribution<Real>(low, high)(random_); }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  Vector3 vector(Real size) { return {number(-size, size), number(-size, size), number(-size, size)}; }

 private:
  std::mt19937 random_;
};

// A group of two bodies or more that move and one that is locked, each on the one before, some on the world; pairs of one to
// six points in the order of the blocks' bodies or against it.
void add_group(Scene& scene, int count, Real deepest, Real highest, Draw& draw) {
  const int first = static_cast<int>(scene.bodies.size());
  Group group;
  for (int i = 0; i <= count; ++i) {
    const Vector3 size = Vector3(draw.number(1, 2), draw.number(1, 2), draw.number(1, 2));
    Body body = make_body(draw.number(Real(0.5), 2), size.asDiagonal().toDenseMatrix());
    body.locked = i == count;
    const Motion motion = make_motion(body, draw.vector(1), exponential(draw.vector(3)),
                                      draw.vector(Real(0.1)), draw.vector(Real(0.1)));
    Mover mover;
    if (!body.locked) {
      const Matrix3 r = motion.orientation.toRotationMatrix();
      mover.inverse_mass = body.inverse_mass;
      mover.inverse_inertia = r * body.inverse_inertia * r.transpose();
      mover.v = velocity(body, motion), mover.w = mover.inverse_inertia * motion.angular_momentum;
    }
    scene.bodies.push_back(body), scene.motions.push_back(motion), scene.movers.push_back(mover);
    group.bodies.push_back(first + i);
  }
  for (int i = 0; i < count; ++i) {
    const int kind = draw.whole(0, 3);
    Block pair;
    pair.a = first + i, pair.b = kind == 0   ? fixed_world
                                 : kind == 1 ? first + count
                                             : first + (i + 1) % count;
    if (kind == 1 && draw.whole(0, 1) == 1) std::swap(pair.a, pair.b);  // what is locked comes first
    if (kind == 0) pair.plane = 0;
    pair.normal = (Vector3::UnitY() + draw.vector(Real(0.4))).normalized();
    pair.friction = draw.whole(0, 3) == 0 ? Real(0) : draw.number(Real(0.1), Real(0.9));
    for (int k = draw.whole(1, 6); k > 0; --k) {
      Block block = pair;
      block.arm = draw.vector(Real(0.5)), block.to_arm = draw.vector(Real(0.5));
      block.gap = draw.number(deepest, highest);
      block.impulse = draw.number(0, Real(0.05)) * block.normal + draw.vector(Real(0.01));
      const Motion& a = scene.motions[index(block.a)];
      // The point of b is where that of a is: the gap is as found.
      const Vector3 point = a.position + block.arm;
      if (block.b == fixed_world)
        block.to_anchor = point, block.to_arm.setZero();
      else
        block.to_arm = point - scene.motions[index(block.b)].position;
      group.blocks.push_back(static_cast<int>(scene.blocks.size()));
      scene.blocks.push_back(block);
    }
  }
  scene.groups.push_back(group);
}

struct Mix {
  std::vector<int> counts;  // bodies of each group
  int parts;
  Real deepest, highest;  // gaps
  unsigned seed;
};

Scene scene_of(const Mix& mix) {
  Draw draw(mix.seed);
  Scene scene;
  scene.step = {{Real(0.3), Real(-9.81), Real(0.2)}, Real(mix.parts) / 300, mix.parts, Real(1e-5)};
  for (const int count : mix.counts) add_group(scene, count, mix.deepest, mix.highest, draw);
  return scene;
}

// The header's formulas, pair by pair from the top down, in plain vectors.  Velocities and ways per body.
struct Plain {
  std::vector<Vector3> v, w, moved, turned;
};

Plain plainly(const Scene& scene) {
  const Crowd::Step& step = scene.step;
  const Real h = step.span / static_cast<Real>(step.parts);
  // a = 2 zeta + omega h, with zeta 5 and omega h 1.2 (E. Catto, Soft constraints, GDC 2011)
  const Real a = Real(11.2), b = Real(1.2) * a;
  Plain now;
  for (const Mover& m : scene.movers)
    now.v.push_back(m.v), now.w.push_back(m.w), now.moved.push_back(Vector3::Zero());
  now.turned = now.moved;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t from = 0, to = 0; from < scene.blocks.size(); from = to) {
    while (to < scene.blocks.size() && scene.blocks[to].a == scene.blocks[from].a &&
           scene.blocks[to].b == scene.blocks[from].b && scene.blocks[to].normal == scene.blocks[from].normal)
      ++to;
    pairs.emplace_back(from, to);
  }
  const auto depth = [&](const auto& pair) {
    const Block& first = scene.blocks[pair.first];
    return step.gravity.dot(scene.motions[index(first.a)].position + first.arm);
  };
  std::stable_sort(pairs.begin(), pairs.end(),
                   [&](const auto& one, const auto& other) { return depth(one) < depth(other); });
  std::vector<Vector3> impulses;
  for (const Block& block : scene.blocks) {
    const Vector3 j = block.impulse / static_cast<Real>(step.parts);
    const Real along = block.normal.dot(j);
    impulses.push_back(j + (std::max(along, Real(0)) - along) * block.normal);
  }
  const auto give = [&](const Block& block, const Vector3& j) {
    const auto one = [&](int body, const Vector3& arm, const Vector3& by) {
      if (body == fixed_world) return;
      now.v[index(body)] += scene.movers[index(body)].inverse_mass * by;
      now.w[index(body)] += scene.movers[index(body)].inverse_inertia * arm.cross(by);
    };
    one(block.a, block.arm, j), one(block.b, block.to_arm, -j);
  };
  const auto across = [&](const Block& block, const std::vector<Vector3>& x,
                          const std::vector<Vector3>& turn) {
    Vector3 u = x[index(block.a)] + turn[index(block.a)].cross(block.arm);
    if (block.b != fixed_world) u -= x[index(block.b)] + turn[index(block.b)].cross(block.to_arm);
    return u;
  };
  const auto k_of = [&](const Block& block) {
    Matrix3 k = Matrix3::Zero();
    const auto add = [&](int body, const Vector3& arm) {
      if (body == fixed_world) return;
      Matrix3 r;
      r << 0, -arm.z(), arm.y(), arm.z(), 0, -arm.x(), -arm.y(), arm.x(), 0;
      const Mover& m = scene.movers[index(body)];
      k += m.inverse_mass * Matrix3::Identity() - r * m.inverse_inertia * r;
    };
    add(block.a, block.arm), add(block.b, block.to_arm);
    return k;
  };
  const auto sweep = [&](bool relaxes) {
    for (const auto& [from, to] : pairs)
      for (std::size_t i = from; i < to; ++i) {
        const Block& block = scene.blocks[i];
        const Vector3& n = block.normal;
        const Matrix3 k = k_of(block);
        const Real s = block.gap + n.dot(across(block, now.moved, now.turned)), k_n = n.dot(k * n);
        const Real u_n = n.dot(across(block, now.v, now.w)), before = n.dot(impulses[i]);
        Real change = 0;
        if (s > 0)
          change = (-s / h - u_n) / k_n;
        else if (relaxes)
          change = -u_n / k_n;
        else
          change = b / (1 + b) * (Real(1.2) / (h * a) * std::max(-s - step.slop, Real(0)) - u_n) / k_n -
                   before / (1 + b);
        change = std::max(before + change, Real(0)) - before;
        impulses[i] += change * n, give(block, change * n);
        const Vector3 t1 = n.unitOrthogonal(), t2 = n.cross(t1), u = across(block, now.v, now.w);
        Eigen::Matrix<Real, 3, 2> t;
        t << t1, t2;
        const Eigen::Matrix<Real, 2, 2> k_t = t.transpose() * k * t;
        const Real limit = block.friction * (before + change);
        const Vector3 held = impulses[i] - n.dot(impulses[i]) * n;
        Vector3 next = held - t * k_t.inverse() * (t.transpose() * u);
        if (next.norm() > limit) {
          // No more than the least eigenvalue of K's inverse across; the frame of its bound is the engine's.
          int least = 0;
          n.cwiseAbs().minCoeff(&least);
          const Vector3 e1 = n.cross(Vector3::Unit(least)).normalized(), e2 = n.cross(e1);
          const Real bound = std::max(e1.dot(k * e1), e2.dot(k * e2)) + std::abs(e1.dot(k * e2));
          next = held - (u - n.dot(u) * n) / bound;
          if (next.norm() > limit || limit == 0)
            next *= limit / std::max(next.norm(), Real(1e-30));
          else
            next *= limit / std::max(next.norm(), limit);
        }
        impulses[i] += next - held, give(block, next - held);
      }
  };
  for (int part = 0; part < step.parts; ++part) {
    for (std::size_t i = 0; i < now.v.size(); ++i)
      if (!scene.bodies[i].locked) now.v[i] += h * step.gravity;
    for (const auto& [from, to] : pairs)
      for (std::size_t i = from; i < to; ++i) give(scene.blocks[i], impulses[i]);
    sweep(false);
    for (std::size_t i = 0; i < now.v.size(); ++i)
      now.moved[i] += h * now.v[i], now.turned[i] += h * now.w[i];
    sweep(true);
  }
  return now;
}

class CrowdSweeps : public testing::TestWithParam<Mix> {};

TEST_P(CrowdSweeps, AreThoseOfOnePairAfterAnother) {
  Scene scene = scene_of(GetParam());
  const Plain plain = plainly(scene);
  const std::vector<Motion> start = scene.motions;
  Crowd crowd;
  crowd.advance(scene.groups, scene.step, scene.bodies, scene.movers, scene.blocks, scene.motions, nullptr);
  // Ways of 1e-2 m and velocities of 1 m/s, by sums of some hundred roundings.
  const Real near = 2000 * std::numeric_limits<Real>::epsilon();
  int moved = 0;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const Vector3 way = scene.motions[i].position - start[i].position;
    EXPECT_LT((way - plain.moved[i]).norm(), near) << i;
    if (scene.bodies[i].locked) continue;
    EXPECT_LT((velocity(scene.bodies[i], scene.motions[i]) - plain.v[i]).norm(), near) << i;
    EXPECT_LT((scene.motions[i].orientation.coeffs() - turned(start[i].orientation, plain.turned[i]).coeffs())
                  .norm(),
              near)
        << i;
    moved += way.norm() > Real(1e-4);
  }
  EXPECT_GT(moved, 0);
}

TEST_P(CrowdSweeps, OfAGroupGiveTheBitsThatItHasAlone) {
  const Scene scene = scene_of(GetParam());
  Crowd crowd;
  Scene together = scene;
  std::vector<Vector3> pressed(scene.blocks.size(), Vector3::Zero());
  crowd.advance(scene.groups, scene.step, together.bodies, together.movers, together.blocks, together.motions,
                &pressed);
  std::vector<Real> residuals;
  for (std::size_t g = 0; g < scene.groups.size(); ++g) residuals.push_back(crowd.residual(g));
  for (std::size_t g = 0; g < scene.groups.size(); ++g) {
    Scene alone = scene;
    std::vector<Vector3> mine(scene.blocks.size(), Vector3::Zero());
    crowd.advance({scene.groups[g]}, scene.step, alone.bodies, alone.movers, alone.blocks, alone.motions,
                  &mine);
    EXPECT_EQ(residuals[g], crowd.residual(0));
    for (const int body : scene.groups[g].bodies) {
      EXPECT_EQ(together.motions[index(body)].position, alone.motions[index(body)].position);
      EXPECT_EQ(together.motions[index(body)].momentum, alone.motions[index(body)].momentum);
      EXPECT_EQ(together.motions[index(body)].angular_momentum, alone.motions[index(body)].angular_momentum);
      EXPECT_EQ(together.motions[index(body)].orientation.coeffs(),
                alone.motions[index(body)].orientation.coeffs());
    }
    for (const int k : scene.groups[g].blocks) {
      EXPECT_EQ(together.blocks[index(k)].impulse, alone.blocks[index(k)].impulse);
      EXPECT_EQ(pressed[index(k)], mine[index(k)]);
    }
  }
}

// Where a gap closes in a part of the step, rounding decides whether it is a spring in the next: what is compared
// over many parts overlaps in all of them.
INSTANTIATE_TEST_SUITE_P(All, CrowdSweeps,
                         testing::Values(Mix{{4}, 1, Real(-2e-3), Real(1e-3), 1},
                                         Mix{{2}, 1, Real(-2e-3), Real(1e-3), 2},
                                         Mix{{3, 5}, 1, Real(-2e-3), Real(1e-3), 3},
                                         Mix{{2, 2, 2, 2, 2, 2, 2, 2, 2}, 1, Real(-2e-3), Real(1e-3), 4},
                                         Mix{{40, 30}, 1, Real(-2e-3), Real(1e-3), 5},
                                         Mix{{7}, 5, Real(-4e-2), Real(-2e-2), 6},
                                         Mix{{9, 2, 6, 4}, 5, Real(-4e-2), Real(-2e-2), 7},
                                         Mix{{40, 30}, 5, Real(-4e-2), Real(-2e-2), 8}),
                         [](const auto& mix) { return "Seed" + std::to_string(mix.param.seed); });

}  // namespace
}  // namespace cylon::engine::pile
