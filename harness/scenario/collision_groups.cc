// What bodies and planes say of the groups that touch each other.
#include "harness/scenario/budget.h"
#include "harness/scenario/draft.h"

#include "harness/core/collision_filter.h"
#include "harness/core/surfaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace cylon::scenario {
namespace {

using Names = std::vector<std::string>;

constexpr const char* const keys[] = {"collision_groups", "collision_mask"};

void check_names(const Table& t, const char* key, const Names& names, const char* instead) {
  if (t.has(key) && names.empty())
    t.fail(key, fmt::format("{} = [], but names one group at least{}", key, instead));
  if (names.size() > core::most_groups)
    t.fail(key, fmt::format("{}: {} names, but a scene has at most {} groups", key, names.size(),
                            core::most_groups));
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].empty() || names[i] == "*" || names[i].size() > budget::name)
      t.fail(key,
             fmt::format("{}: '{}' is no name of a group; valid: 1 to {} bytes, but not \"*\" (without the "
                         "key all are meant)",
                         key, names[i].substr(0, budget::name), budget::name));
    if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
        names.begin() + static_cast<std::ptrdiff_t>(i))
      t.fail(key, fmt::format("{}: '{}' stands there twice", key, names[i]));
  }
}

void check_known(const Table& t, const Names& mask, const Names& known) {
  for (const std::string& name : mask)
    if (std::ranges::find(known, name) == known.end())
      t.fail("collision_mask", fmt::format("collision_mask: nothing that may touch is in group '{}'{}", name,
                                           core::did_you_mean(name, known)));
}

class Groups {
 public:
  Groups(const Table& root, const Draft& draft) : draft_(draft), planes_(root.tables("plane")) {}

  void check() {
    each([](const Table& t, const auto& thing) {
      check_names(t, keys[0], thing.collision_groups, R"(; without the key a thing is in "default")");
      check_names(t, keys[1], thing.collision_mask,
                  std::is_same_v<decltype(thing), const core::Body&>
                      ? "; what touches nothing has collide = false"
                      : "");
    });
    for (std::size_t i = 0; i < bodies().size(); ++i)
      for (const char* key : keys)
        if (draft_.origin[i].has(key) && !collides(bodies()[i]))
          draft_.origin[i].fail(key,
                                fmt::format("{}: the body does not collide, so it is in no group and touches "
                                            "none",
                                            key));
    const Names known = names();
    each([&](const Table& t, const auto& thing) { check_known(t, thing.collision_mask, known); });
    try {
      core::CollisionFilters{draft_.scene};
    } catch (const std::invalid_argument& error) {
      draft_.origin.back().fail(error.what());
    }
  }

 private:
  const std::vector<core::Body>& bodies() const { return draft_.scene.bodies; }

  // Shows the first body of each table, and each plane.
  template <class Visit>
  void each(Visit visit) const {
    const toml::table* last = nullptr;
    for (std::size_t i = 0; i < bodies().size(); ++i) {
      const Table& origin = draft_.origin[i];
      if (std::exchange(last, &origin.raw()) != &origin.raw()) visit(origin, bodies()[i]);
    }
    for (std::size_t i = 0; i < planes_.size(); ++i) visit(planes_[i], draft_.scene.planes[i]);
  }

  // Of all groups that something is in; fails where they are too many.
  Names names() const {
    Names known;
    std::set<std::string> seen;
    const auto add = [&](const Table& t, const std::string& name) {
      if (!seen.insert(name).second) return;
      known.push_back(name);
      const std::size_t named = seen.size() - seen.count(std::string(core::default_group));
      if (named >= core::most_groups)
        t.fail(keys[0],
               fmt::format("collision_groups: '{}' is one group too many; valid: {} groups in a scene, "
                           "\"default\" among them",
                           name, core::most_groups));
    };
    each([&](const Table& t, const auto& thing) {
      if constexpr (std::is_same_v<decltype(thing), const core::Body&>)
        if (!collides(thing)) return;
      if (thing.collision_groups.empty()) add(t, std::string(core::default_group));
      for (const std::string& name : thing.collision_groups) add(t, name);
    });
    return known;
  }

  const Draft& draft_;
  const std::vector<Table> planes_;
};

}  // namespace

void check_collision_groups(const Table& root, const Draft& draft) { Groups(root, draft).check(); }

}  // namespace cylon::scenario
