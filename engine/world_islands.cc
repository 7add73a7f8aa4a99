// Islands of a world: they become one when they may meet, and part again.
#include "engine/islands/unions.h"
#include "engine/loaded.h"
#include "engine/world.h"

#include <algorithm>
#include <utility>

namespace cylon::engine {

namespace {

bool is_finite(const Motion& m) {
  return m.position.allFinite() && m.momentum.allFinite() && m.orientation.coeffs().allFinite() &&
         m.angular_momentum.allFinite();
}

}  // namespace

void World::find_accelerations() {
  const std::size_t n = motions_.size();
  accelerations_.assign(n, 0);
  if (model_->forces.only_gravity()) return;
  Forces forces = model_->forces;
  for (std::size_t k = 0; k < turns_.size(); ++k) forces.coordinate_laws[k].at.near = turns_[k];
  const std::vector<Load> loads = loaded(forces, time(), bodies(), motions_).loads;
  for (std::size_t i = 0; i < n; ++i)
    accelerations_[i] = (bodies()[i].inverse_mass * loads[i].force - model_->gravity_of(i)).norm();
}

void World::look(std::size_t cluster) {
  for (const int body : interactions_->touching(cluster))
    ranges_[index(body)] =
        interactions_->range(body, bodies()[index(body)], motions_[index(body)], accelerations_[index(body)]);
}

// After a step.  Every `ahead` steps all ranges are made anew, and besides those of a cluster with a body
// that will leave its own in the next step: what is looked at when depends on that cluster alone.
void World::watch() {
  const bool all = steps_ % islands::Interactions::ahead == 0;
  if (all) find_accelerations();
  looked_.clear();
  jumped_.assign(interactions_->clusters().size(), 0);
  for (const std::size_t c : interactions_->open()) {
    bool leaves = all;
    for (const int body : interactions_->touching(c)) {
      const islands::Range& range = ranges_[index(body)];
      if (range.for_ever) continue;
      const Motion& motion = motions_[index(body)];
      const Real way = (motion.position - range.ball.centre).norm();
      const Real next = velocity(bodies()[index(body)], motion).norm() * static_cast<Real>(options_.dt);
      leaves = leaves || way + next > range.ball.radius;
      jumped_[c] = jumped_[c] || way > range.ball.radius;
    }
    if (!leaves) continue;
    look(c);
    looked_.push_back(c);
  }
  bool changed = false;
  while (merge()) changed = true;
  if (all) changed = part() || changed;
  if (changed) set_plan();
}

// Islands of which two may meet become one.  What has left its range within the step may have met something
// in it: that step is made again, after which its bodies may meet others.  Whether any became one.
bool World::merge() {
  const std::size_t n = interactions_->clusters().size();
  islands::Unions unions(n);
  for (const Island& island : islands_)
    for (const std::size_t c : island.clusters)
      if (!island.flies) unions.join(island.clusters.front(), c);
  std::vector<std::size_t> met;
  for (const std::size_t c : looked_)
    for (const std::size_t other : interactions_->open())
      if (unions.find(c) != unions.find(other) && interactions_->may_meet(c, other, ranges_))
        unions.join(c, other), met.push_back(c);
  if (met.empty()) return false;
  looked_.clear();

  std::vector<std::vector<std::size_t>> merged;  // clusters of the new islands
  for (std::size_t root = 0; root < n; ++root) {
    if (std::none_of(met.begin(), met.end(), [&](std::size_t c) { return unions.find(c) == root; })) continue;
    merged.emplace_back();
    for (std::size_t c = root; c < n; ++c)
      if (unions.find(c) == root) merged.back().push_back(c);
  }
  for (std::vector<std::size_t>& clusters : merged) {
    const bool again =
        std::any_of(clusters.begin(), clusters.end(), [&](std::size_t c) { return jumped_[c] != 0; });
    for (const std::size_t c : clusters) leave(c);
    const std::int64_t first = again ? steps_ - 1 : steps_;
    if (again) forget(clusters);
    add_island(std::move(clusters), again ? before_ : motions_, again ? turns_before_ : turns_, first);
    Island& island = islands_.back();
    if (again) {
      island.run->step();
      take(island);
      sort_impacts();
      for (const std::size_t c : island.clusters) {
        look(c);
        looked_.push_back(c);
        jumped_[c] = 1;
      }
    }
    note(DiagnosticKind::merged, first, island.clusters);
  }
  drop_empty();
  return true;
}

// An island in fixed steps of which parts cannot meet in twice the time ahead.
bool World::part() {
  const std::size_t before = islands_.size();
  for (std::size_t k = 0; k < before; ++k) {
    if (islands_[k].clusters.size() < 2 || !islands_[k].run->is_stepped()) continue;
    const std::vector<Motion>& motions = islands_[k].run->motions();
    if (!std::all_of(motions.begin(), motions.end(), [](const Motion& m) { return is_finite(m); })) continue;
    std::vector<islands::Range> wide = ranges_;
    for (const std::size_t c : islands_[k].clusters)
      for (const int body : interactions_->touching(c))
        wide[index(body)] = interactions_->range(body, bodies()[index(body)], motions_[index(body)],
                                                 accelerations_[index(body)], 2);
    auto groups = interactions_->groups(wide, islands_[k].clusters);
    if (groups.size() < 2) continue;
    for (const std::size_t c : islands_[k].clusters) leave(c);
    for (auto& group : groups) {
      add_island(std::move(group), motions_, turns_, steps_);
      note(DiagnosticKind::parted, steps_, islands_.back().clusters);
    }
  }
  if (islands_.size() == before) return false;
  drop_empty();
  return true;
}

// Takes a cluster out of its island, before it goes to another.
void World::leave(std::size_t cluster) {
  Island& island = islands_[island_of_[cluster]];
  if (!island.run) return;
  if (!island.flies) {
    note_end(island);
    end_run(island);
    return;
  }
  const int body = interactions_->clusters()[cluster].bodies.front();
  island.left.resize(island.bodies.size(), 0);
  for (std::size_t i = 0; i < island.bodies.size(); ++i) island.left[i] |= island.bodies[i] == body;
  std::erase(island.clusters, cluster);
  if (island.clusters.empty()) end_run(island);
}

void World::end_run(Island& island) {
  spent_ += island.run->operations();
  island.run.reset();
}

// What these clusters touched in the last step, which is made again.
void World::forget(const std::vector<std::size_t>& clusters) {
  std::vector<char> gone(motions_.size() + 1, 0);  // the last: the world
  for (const std::size_t c : clusters)
    for (const int body : interactions_->clusters()[c].bodies) gone[index(body)] = 1;
  const auto touched = [&](const auto& touch) {
    return gone[index(touch.body)] || (touch.other != fixed_world && gone[index(touch.other)]);
  };
  std::erase_if(impacts_, touched);
  std::erase_if(contacts_, touched);
}

void World::drop_empty() {
  std::erase_if(islands_, [](const Island& island) { return !island.run; });
  std::sort(islands_.begin(), islands_.end(),
            [](const Island& a, const Island& b) { return a.clusters.front() < b.clusters.front(); });
  for (std::size_t k = 0; k < islands_.size(); ++k)
    for (const std::size_t c : islands_[k].clusters) island_of_[c] = k;
}

}  // namespace cylon::engine
