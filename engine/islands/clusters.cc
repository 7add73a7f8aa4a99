#include "engine/islands/clusters.h"

#include "engine/islands/unions.h"
#include "engine/joint_points.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <tuple>

namespace cylon::engine::islands {

namespace {

constexpr Real slack = Real(1.01);

// Calls visit(bodies) for each joint, and for each force that does not act on every body.
template <class Visit>
void each_tie(const Model& model, Visit visit) {
  for (const Joint& joint : model.joints) visit(Acted{joint.body, joint.to});
  each_force(model.forces, [&](const auto& force) {
    if (const auto acted = force.acts_on()) visit(*acted);
  });
}

}  // namespace

std::vector<Cluster> find_clusters(const Model& model) {
  const std::size_t n = model.bodies.size();
  Unions unions(n);
  each_tie(model, [&](const Acted& tied) {
    int first = fixed_world;
    for (const int body : tied) {
      if (!model.moves(body)) continue;
      if (first != fixed_world) unions.join(index(first), index(body));
      first = body;
    }
  });
  std::vector<Cluster> clusters;
  std::vector<std::size_t> cluster_of(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (model.bodies[i].locked) continue;
    const std::size_t root = unions.find(i);
    if (root == i) clusters.emplace_back();
    cluster_of[i] = root == i ? clusters.size() - 1 : cluster_of[root];
    clusters[cluster_of[i]].bodies.push_back(static_cast<int>(i));
  }
  // The cluster on which something acts; it keeps the locked bodies.
  const auto owner = [&](const Acted& tied) -> Cluster* {
    const auto mover = std::ranges::find_if(tied, [&](int body) { return model.moves(body); });
    if (mover == tied.end()) return nullptr;
    Cluster& cluster = clusters[cluster_of[index(*mover)]];
    for (const int body : tied)
      if (body != fixed_world && !model.moves(body)) cluster.holders.push_back(body);
    return &cluster;
  };
  for (std::size_t k = 0; k < model.joints.size(); ++k)
    if (Cluster* cluster = owner({model.joints[k].body, model.joints[k].to}))
      cluster->joints.push_back(static_cast<int>(k));
  std::size_t kind = 0;
  each_force_list(model.forces, [&](const auto& list) {
    for (std::size_t k = 0; k < list.size(); ++k) {
      const auto acted = list[k].acts_on();
      if (!acted) {
        for (Cluster& cluster : clusters) cluster.forces[kind].push_back(static_cast<int>(k));
      } else if (Cluster* cluster = owner(*acted)) {
        cluster->forces[kind].push_back(static_cast<int>(k));
      }
    }
    ++kind;
  });
  for (Cluster& cluster : clusters) {
    std::sort(cluster.holders.begin(), cluster.holders.end());
    cluster.holders.erase(std::unique(cluster.holders.begin(), cluster.holders.end()), cluster.holders.end());
  }
  return clusters;
}

// The shortest chain to each body, by Dijkstra's algorithm over the joints.
std::vector<std::optional<Ball>> find_bounds(const Model& model) {
  struct Link {
    int to;
    Real length;  // between the reference points, at most
  };
  struct Reached {
    Real radius;
    int body;
    Vector3 centre;
    bool operator>(const Reached& other) const {
      return std::tie(radius, body) > std::tie(other.radius, other.body);
    }
  };
  std::vector<std::optional<Ball>> bounds(model.bodies.size());
  if (model.joints.empty()) return bounds;
  std::vector<std::vector<Link>> links(model.bodies.size());
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
  for (const Joint& named : model.joints) {
    const Joint joint = at_centres(named, model);
    if (joint.type.place == Joint::Place::along_axis || joint.type.place == Joint::Place::in_plane) continue;
    const auto side = [&](int body, const Vector3& anchor, int to, const Vector3& to_anchor) {
      if (!model.moves(body)) return;
      const Real arm = anchor.norm() + joint.length;
      if (model.moves(to)) {
        links[index(to)].push_back({body, arm + to_anchor.norm()});
      } else {
        const Vector3 place = to == fixed_world ? to_anchor
                                                : Vector3(model.motions[index(to)].position +
                                                          model.motions[index(to)].orientation * to_anchor);
        queue.push({arm, body, place});
      }
    };
    side(joint.body, joint.anchor, joint.to, joint.to_anchor);
    side(joint.to, joint.to_anchor, joint.body, joint.anchor);
  }
  while (!queue.empty()) {
    const Reached next = queue.top();
    queue.pop();
    std::optional<Ball>& bound = bounds[index(next.body)];
    if (bound) continue;
    bound = Ball{next.centre, slack * next.radius};
    for (const Link& link : links[index(next.body)])
      if (!bounds[index(link.to)]) queue.push({next.radius + link.length, link.to, next.centre});
  }
  return bounds;
}

}  // namespace cylon::engine::islands
