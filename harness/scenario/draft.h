// A scene while it is read: where each body was written, which names a generator gave, which files were used.
#pragma once

#include "harness/core/content_hash.h"
#include "harness/core/scene.h"
#include "harness/scenario/reader.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace cylon::scenario {

struct Draft {
  core::Scene scene;
  std::vector<Table> origin;                       ///< One per body: where it was written.
  std::vector<bool> point;                         ///< One per body: no shape and no inertia.
  std::set<std::string> planes;                    ///< Their names.
  std::map<std::string, std::vector<int>> groups;  ///< Bodies of each generator, by its name.
  std::filesystem::path folder;                    ///< Files are named relative to it.
  core::ContentHash content;
  std::size_t points = 0;      ///< Of hulls and meshes so far.
  double hull_work = 0;        ///< Sum of the squares of the points of hulls so far.
  std::uintmax_t bytes = 0;    ///< Of the files named so far.
  std::size_t neighbours = 0;  ///< Looked at for overlaps so far.

  /// Adds a body; fails at its `name` where that is taken, and where a number of it is not finite.
  void add(core::Body&&, const Table&, bool is_point);
  /// Makes room for so many bodies more.
  void expect(std::size_t more);

  /// Whether a body has that name.
  bool has_body(const std::string& name) const { return index_.contains(name); }
  /// Fails where `more` points would be too many in all.
  void add_points(const Table&, double more);

  /// Index of the body that the key names, or one of those that it names; fails with the nearest valid name.
  int body(const Table& table, std::string_view key) const { return body(table, key, table.text(key)); }
  int body(const Table&, std::string_view key, const std::string& name) const;

  /// The file that the key names, relative to the scenario; its bytes enter the hash.
  std::string read(const Table&, std::string_view key);

 private:
  std::unordered_map<std::string, int> index_;
};

// Each reads its tables of the document and checks what the key tables cannot; all throw core::InputError.
void read_bodies(const Table& root, Draft&);
void read_forces(const Table& root, Draft&);
void read_joints(const Table& root, Draft&);
void read_planes(const Table& root, Draft&);
void read_materials(const Table& root, Draft&);

/// What each body and plane read so far, and no other, states of collision groups makes sense.
void check_collision_groups(const Table& root, const Draft&);

/// Every body read so far, and no other: fails where two spheres, or a body and a plane, overlap by more than
/// 1e-9 m.
void refuse_overlaps(Draft&);

/// `shape` of a body, or of a part.
core::Shape read_shape(const Table&, Draft&);

/// A unit quaternion, normalised within 1e-9; fails with the normalised value otherwise.
core::Quaternion read_orientation(const Table&, std::string_view key);

/// Divides by the norm unless that is 1 to rounding: what was made a unit vector once stays as it is.
void make_unit(core::Vector3&);

/// Bodies of a [[lattice]] and of a [[cloud]], one after another: copies of the template at their places.  `earlier`: the
/// clouds before this one in the file.
using TakeBody = std::function<void(core::Body&&)>;
void lattice(const Table&, const core::Body& pattern, const TakeBody&);
void cloud(const Table&, const core::Body& pattern, Draft& others, std::span<const Table> earlier,
           const TakeBody&);

/// "[x, y, z]" with all digits that matter.
std::string written(const core::Vector3&);

}  // namespace cylon::scenario
