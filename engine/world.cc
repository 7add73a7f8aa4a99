#include "engine/world.h"

#include "engine/constraint.h"
#include "engine/islands/joined_plan.h"
#include "engine/joint.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace cylon::engine {

namespace {

constexpr std::size_t most_notes = 8, most_ended = 32;

Model with(Model model, const Options& options) {
  if (options.constraints) model.reduce_joints = false;
  return model;
}

// Whether there is nothing to part: everything runs on purpose, or every body moves by itself in one run.
bool one_by_nature(const Model& model, const Options& options) {
  if (options.full || options.account) return true;
  if (!model.joints.empty() || !model.forces.only_gravity() || can_touch(model) || model.frame ||
      std::any_of(model.bodies.begin(), model.bodies.end(),
                  [](const Body& b) { return b.locked || b.mass_rate != 0; }))
    return false;
  const Path path = make_plan(model, options).path;
  return path == Path::exact || path == Path::free;
}

}  // namespace

World::World(Model model, const Options& options, Names names)
    : model_(std::make_shared<const Model>(with(std::move(model), options))),
      names_(std::move(names)),
      masses_(model_->bodies),
      options_(options) {
  assert(options_.dt > 0 && unsupported(*model_, options_).empty());
  if (masses_.any()) bodies_ = model_->bodies;
  if (!one_by_nature(*model_, options_)) divide();
  if (islands_.empty())
    islands_.push_back({{}, {}, {}, {}, {}, std::make_unique<Run>(model_, options_), false, {}});
  set_plan();
}

World::~World() = default;

// The islands at t = 0.
void World::divide() {
  interactions_.emplace(*model_, options_.dt);
  const std::size_t n = interactions_->clusters().size();
  if (n == 0) return;  // nothing moves
  motions_ = before_ = model_->motions;
  Forces forces = model_->forces;
  forces.start_turns();
  forces.read_turns(turns_);
  turns_before_ = turns_;
  for (std::size_t i = 0; i < motions_.size(); ++i)
    if (!model_->bodies[i].locked) movable_.push_back(i);
  if (interactions_->too_many()) {
    std::size_t touching = 0;
    for (const std::size_t c : interactions_->open()) touching += interactions_->touching(c).size();
    note(DiagnosticKind::not_divided, 0, interactions_->open(), islands::Interactions::most_watched,
         static_cast<double>(touching));
  }
  island_of_.resize(n);
  ranges_.resize(model_->bodies.size());
  std::vector<std::size_t> all(n), flying;
  for (std::size_t c = 0; c < n; ++c) all[c] = c;
  if (watches()) {
    find_accelerations();
    for (const std::size_t c : all) look(c);
  }
  // What flies alone is one run, if that takes each body by itself.
  std::vector<std::vector<std::size_t>> groups = interactions_->groups(ranges_, all);
  std::erase_if(groups, [&](const auto& group) {
    const bool flies = group.size() == 1 && interactions_->flies(group[0]);
    if (flies) flying.push_back(group[0]);
    return flies;
  });
  if (!add_flight(flying))
    for (const std::size_t c : flying) groups.push_back({c});
  std::sort(groups.begin(), groups.end());
  for (auto& group : groups) add_island(std::move(group), motions_, turns_, 0);
}

bool World::add_flight(const std::vector<std::size_t>& clusters) {
  if (clusters.size() < 2) return false;
  islands::Part part = interactions_->flight(clusters, motions_);
  auto run = std::make_unique<Run>(std::make_shared<const Model>(std::move(part.model)), options_);
  if (run->plan().path != Path::exact && run->plan().path != Path::free) return false;
  for (const std::size_t c : clusters) island_of_[c] = islands_.size();
  std::vector<std::size_t> all = movable(part.bodies);
  islands_.push_back({clusters, std::move(part.bodies), {}, std::move(all), {}, std::move(run), true, {}});
  return true;
}

void World::add_island(std::vector<std::size_t> clusters, const std::vector<Motion>& motions,
                       const std::vector<Real>& turns, std::int64_t first) {
  islands::Part part = interactions_->part(clusters, motions);
  for (std::size_t k = 0; k < part.laws.size(); ++k)
    part.model.forces.coordinate_laws[k].at.start = turns[index(part.laws[k])];
  Options options = options_;
  // An island of a scene that can be stepped but, by its masses, not be followed event by event.  Whether its
  // numbers are fine enough was decided at t = 0.
  if (const std::string why =
          unsupported(first > 0 ? interactions_->part(clusters, model_->motions).model : part.model, options);
      !why.empty()) {
    options.path = "stepping";
    if (first > 0) note(DiagnosticKind::not_followed, first, clusters, {}, {}, why);
  }
  options.force = options.force || first > 0;
  for (const std::size_t c : clusters) island_of_[c] = islands_.size();
  auto run = std::make_unique<Run>(std::make_shared<const Model>(std::move(part.model)), options, first);
  run->keep_contacts(keep_contacts_);
  std::vector<std::size_t> moving = movable(part.bodies);
  islands_.push_back({std::move(clusters),
                      std::move(part.bodies),
                      std::move(part.planes),
                      std::move(moving),
                      std::move(part.laws),
                      std::move(run),
                      false,
                      {}});
}

std::vector<std::size_t> World::movable(const std::vector<int>& bodies) const {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (!model_->bodies[index(bodies[i])].locked) places.push_back(i);
  return places;
}

void World::step() {
  if (watches()) {
    for (const std::size_t i : movable_) before_[i] = motions_[i];
    turns_before_ = turns_;
  }
  if (keeps_reactions()) last_ = motions();
  for (Island& island : islands_) island.run->step();
  ++steps_;
  take();
  if (watches()) watch();
}

void World::advance(std::int64_t n) {
  if (watches() || keeps_reactions()) {
    for (; n > 0; --n) step();
    return;
  }
  for (Island& island : islands_) island.run->advance(n);
  steps_ += n;
  take();
}

void World::keep_contacts(bool keep) {
  keep_contacts_ = keep;
  last_.clear();
  for (Island& island : islands_) island.run->keep_contacts(keep);
}

std::optional<std::vector<Reaction>> World::reactions() const {
  if (model_->joints.empty()) return std::vector<Reaction>();
  if (last_.empty()) return std::nullopt;
  const Time before = static_cast<Time>(steps_ - 1) * options_.dt;
  return engine::reactions(*model_, {before, &last_}, {time(), &motions()}, contacts_);
}

// Motions, impacts and contacts of all islands, by the numbers of the whole model.
void World::take() {
  masses_.set(time(), bodies_);
  impacts_.clear(), contacts_.clear();
  for (const Island& island : islands_) take(island);
  if (islands_.size() > 1) sort_impacts();
}

void World::take(const Island& island) {
  if (is_whole(island)) {
    impacts_ = island.run->impacts();
    if (keep_contacts_) contacts_ = island.run->contacts();
    return;
  }
  const std::vector<Motion>& motions = island.run->motions();
  if (!island.laws.empty()) {
    std::vector<Real> turns;
    island.run->read_turns(turns);
    for (std::size_t k = 0; k < turns.size(); ++k) turns_[index(island.laws[k])] = turns[k];
  }
  for (const std::size_t i : island.movable)
    if (island.left.empty() || !island.left[i]) motions_[index(island.bodies[i])] = motions[i];
  const auto numbered = [&](auto touch) {
    touch.body = island.bodies[index(touch.body)];
    if (touch.other != fixed_world) touch.other = island.bodies[index(touch.other)];
    if (touch.plane >= 0) touch.plane = island.planes[index(touch.plane)];
    return touch;
  };
  for (const Impact& impact : island.run->impacts()) impacts_.push_back(numbered(impact));
  if (!keep_contacts_) return;
  for (const Contact& contact : island.run->contacts()) contacts_.push_back(numbered(contact));
}

void World::sort_impacts() {
  std::stable_sort(impacts_.begin(), impacts_.end(),
                   [](const Impact& a, const Impact& b) { return a.time < b.time; });
}

// ---- Kicks -------------------------------------------------------------------------------------------

std::string World::no_kick() const {
  if (options_.account) return "works are accounted since t = 0, and a kick does work of its own";
  return "";
}

//   K += J,  L += I I^+ (angular impulse)  with I^+ the inverse where there is inertia
void World::kick(int body, const Vector3& impulse, const Vector3& angular_impulse) {
  const Body& kicked = bodies()[index(body)];
  if (kicked.locked) return;
  std::vector<Motion> now = motions();
  Motion& motion = now[index(body)];
  const Matrix3 r = motion.orientation.toRotationMatrix();
  motion.momentum += impulse;
  motion.angular_momentum +=
      r * (kicked.inertia * (kicked.inverse_inertia * (r.transpose() * angular_impulse)));
  Rows rows;
  for (const Joint& joint : model_->joints) add_rows(joint, bodies(), now.data(), rows.rows);
  const auto first = static_cast<std::ptrdiff_t>(rows.rows.size());
  add_rotor_rows(*model_, now.data(), rows.rows);
  const std::vector<Motion>& before = motions();
  std::for_each(rows.rows.begin() + first, rows.rows.end(),
                [&](Row& row) { row.offset = speed_of(row, bodies(), before.data()); });
  if (!rows.rows.empty()) rows.project_velocities(bodies(), now.data());
  if (whole()) return begin_anew(now);
  motions_ = std::move(now);
  const auto& clusters = interactions_->clusters();
  const auto own = static_cast<std::size_t>(
      std::ranges::find_if(
          clusters, [&](const islands::Cluster& c) { return std::ranges::count(c.bodies, body) > 0; }) -
      clusters.begin());
  const Island& island = islands_[island_of_[own]];
  std::vector<std::size_t> group = island.flies ? std::vector{own} : island.clusters;
  for (const std::size_t c : group) leave(c);
  looked_ = group;
  add_island(std::move(group), motions_, turns_, steps_);
  drop_empty();
  if (watches()) {
    find_accelerations();
    for (const std::size_t c : looked_) look(c);
    jumped_.assign(clusters.size(), 0);
    while (merge()) continue;
  }
  set_plan();
}

// The one island that is the whole model.
void World::begin_anew(const std::vector<Motion>& motions) {
  note_end(islands_.front());
  Model model = *model_;
  model.motions = motions;
  std::vector<Real> turns;
  islands_.front().run->read_turns(turns);
  for (std::size_t k = 0; k < turns.size(); ++k) model.forces.coordinate_laws[k].at.start = turns[k];
  Options options = options_;
  options.force = true;  // whether the numbers are fine enough was decided at t = 0
  end_run(islands_.front());
  islands_.front().run =
      std::make_unique<Run>(std::make_shared<const Model>(std::move(model)), options, steps_);
  islands_.front().run->keep_contacts(keep_contacts_);
  set_plan();
}

// ---- What is said -----------------------------------------------------------------------------------

void World::set_plan() {
  std::vector<islands::NamedPlan> plans;
  for (const Island& island : islands_) plans.push_back({named(island), &island.run->plan()});
  plan_ = islands::joined_plan(plans);
}

// Of the islands themselves: when they change.
void World::note(DiagnosticKind kind, std::int64_t first, const std::vector<std::size_t>& clusters,
                 std::optional<double> limit, std::optional<double> reached, const std::string& cause) {
  if (notes_.size() == most_notes) {
    ++more_notes_;
    return;
  }
  Diagnostic& note = notes_.emplace_back();
  note.kind = kind;
  note.since = static_cast<Time>(first) * options_.dt;
  note.limit = limit, note.reached = reached, note.cause = cause;
  set_bodies(clusters, note.island);
  note.island.whole =
      note.island.whole && kind == DiagnosticKind::not_divided;  // else who they are is the point
}

// What the run of an island had to say, once for the same kind and bodies.
void World::note_end(const Island& island) {
  for (Diagnostic& d : island.run->diagnostics()) {
    set_bodies(island, d.island);
    d.until = time();
    const auto same =
        std::find_if(ended_.begin(), ended_.end(), [&](const Diagnostic& e) { return same_matter(d, e); });
    if (same != ended_.end())
      add(d, *same);
    else if (ended_.size() < most_ended)
      ended_.push_back(std::move(d));
    else
      ++more_ended_;
  }
}

// The moving bodies of clusters.
void World::set_bodies(const std::vector<std::size_t>& clusters, IslandName& island) const {
  island.bodies.clear();
  island.count = 0;
  for (const std::size_t c : clusters)
    for (const int body : interactions_->clusters()[c].bodies)
      if (island.count++ < IslandName::most_named) island.bodies.push_back(body);
  island.whole = island.count == movable_.size();
}

void World::set_bodies(const Island& island, IslandName& name) const {
  if (!is_whole(island)) return set_bodies(island.clusters, name);
  name.bodies.clear();
  name.count = 0;
  for (std::size_t i = 0; i < model_->bodies.size(); ++i)
    if (!model_->bodies[i].locked && name.count++ < IslandName::most_named)
      name.bodies.push_back(static_cast<int>(i));
  name.whole = true;
}

// The moving bodies of an island.
std::string World::named(const Island& island) const {
  IslandName name;
  if (!is_whole(island)) set_bodies(island, name);
  return names_of(name, names_);
}

std::int64_t World::operations() const {
  std::int64_t sum = spent_;
  for (const Island& island : islands_) sum += island.run->operations();
  return sum;
}

std::vector<Diagnostic> World::diagnostics() const {
  std::vector<Diagnostic> all = notes_;
  all.insert(all.end(), ended_.begin(), ended_.end());
  for (const Island& island : islands_)
    for (Diagnostic& d : island.run->diagnostics()) {
      set_bodies(island, d.island);
      all.push_back(std::move(d));
    }
  std::size_t left_out = more_notes_ + more_ended_;
  if (all.size() + (left_out > 0) > most_diagnostics) {
    left_out += all.size() - (most_diagnostics - 1);
    all.resize(most_diagnostics - 1);
  }
  if (left_out == 0) return all;
  Diagnostic more{.kind = DiagnosticKind::more, .count = static_cast<std::int64_t>(left_out)};
  all.push_back(std::move(more));
  return all;
}

}  // namespace cylon::engine
