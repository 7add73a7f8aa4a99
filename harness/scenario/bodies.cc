// [[body]], and the template inside [[lattice]] and [[cloud]].
#include "harness/core/solid.h"
#include "harness/scenario/budget.h"
#include "harness/scenario/draft.h"
#include "harness/scenario/read_element.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

namespace cylon::scenario {
namespace {

void check_name(const Table& table, const std::string& name) {
  const bool bad = std::ranges::any_of(name, [](char c) {
    return std::iscntrl(static_cast<unsigned char>(c)) || c == ',' || c == '"' || c == '*' || c == '?';
  });
  if (name.size() > budget::name)
    table.fail("name", fmt::format("name: at most {} bytes are allowed", budget::name));
  if (bad) table.fail("name", "name: quotes, commas, *, ? and control characters are not allowed");
}

double read_mass(const Table& table, const core::Shape& shape) {
  const auto* compound = std::get_if<core::Compound>(&shape);
  if (!compound) {
    if (!table.has("mass") && !table.boolean("locked"))
      table.fail(fmt::format("{} needs 'mass'", table.label()));
    return table.number("mass", 1);
  }
  double sum = 0;
  for (const core::Part& part : compound->parts) sum += part.mass;
  const double mass = table.number("mass", sum);
  if (std::abs(mass - sum) > 1e-9 * sum)
    table.fail("mass", fmt::format("mass = {}, but the parts have {} kg together", mass, sum));
  return mass;
}

// Three principal moments in body axes, or nine numbers by rows.
core::Matrix3 read_inertia(const Table& table) {
  const std::vector<double> v = table.numbers("inertia");
  core::Matrix3 inertia = core::Matrix3::Zero();
  if (v.size() == 3) {
    inertia.diagonal() = core::Vector3(v[0], v[1], v[2]);
  } else {
    inertia << v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8];
    const core::Matrix3 skew = inertia - inertia.transpose();
    if (skew.cwiseAbs().maxCoeff() > 1e-12 * inertia.cwiseAbs().maxCoeff())
      table.fail(
          "inertia",
          fmt::format(
              "inertia: nine numbers must be symmetric, but {} against {}, {} against {}, {} against {}",
              v[1], v[3], v[2], v[6], v[5], v[7]));
    inertia -= skew / 2;  // a sum may be too large, and the half of a number may be none
    inertia = core::Matrix3(inertia.selfadjointView<Eigen::Upper>());  // to the last bit
  }
  const double least = core::principal_axes(inertia).moments.minCoeff();
  if (!(least > 0))
    table.fail("inertia", fmt::format("inertia has the principal moment {}, but must be > 0 kg m^2", least));
  if (const auto why = core::impossible(inertia)) table.fail("inertia", "inertia: " + *why);
  return inertia;
}

// Without `inertia` the shape's own, and the origin of hulls, meshes and compounds moves to their centre of
// mass.
core::Matrix3 inertia_of_shape(const Table& table, core::Shape& shape, double mass) {
  try {
    const core::MassProperties p = core::mass_properties(shape, mass);
    if (const auto why = core::impossible(p.inertia)) throw std::invalid_argument(*why);
    core::move(shape, -p.centre);
    return p.inertia;
  } catch (const std::invalid_argument& error) {
    table.fail("shape", fmt::format("shape: {}; or state `inertia`", error.what()));
  }
}

void check_color(const Table& table, const std::string& color) {
  const bool good = color.empty() || (color.size() == 7 && color[0] == '#' &&
                                      std::all_of(color.begin() + 1, color.end(), [](char c) {
                                        return std::isxdigit(static_cast<unsigned char>(c));
                                      }));
  if (!good) table.fail("color", fmt::format("color = '{}', valid: \"#rrggbb\"", color));
}

core::Body read_body(const Table& table, Draft& draft) {
  auto body = read_element<core::Body>(table, draft);
  check_name(table, body.name);
  if (const auto shape = table.table("shape")) body.shape = read_shape(*shape, draft);
  const bool has_shape = !std::holds_alternative<std::monostate>(body.shape);
  body.mass = read_mass(table, body.shape);
  body.inertia = table.has("inertia") ? read_inertia(table) : inertia_of_shape(table, body.shape, body.mass);
  if (!body.inertia.allFinite()) table.fail("mass", "the inertia of this body is not finite");
  for (const char* key : {"velocity", "angular_velocity"})
    if (body.locked && !table.vector(key).isZero(0))
      table.fail(key, fmt::format("{}: a locked body does not move", key));
  if (body.locked && body.gravity) table.fail("gravity", "gravity: a locked body does not fall");
  if (body.gravity && !std::isfinite(body.mass * body.gravity->dot(body.initial.position)))
    table.fail("gravity", "gravity: the body has no finite energy at the start: a number is too large");
  body.collide = table.boolean("collide", has_shape);
  if (body.collide && !has_shape) table.fail("collide", "collide = true, but the body has no shape");
  check_color(table, body.color);
  return body;
}

// Points of hulls and meshes, and what counts for as many.
std::size_t points_of(const core::Shape& shape) {
  return std::visit(
      []<class Kind>(const Kind& kind) -> std::size_t {
        if constexpr (requires { kind.vertices.size(); }) {
          return kind.vertices.size();
        } else if constexpr (std::is_same_v<Kind, core::Compound>) {
          std::size_t sum = budget::points_of_part * kind.parts.size();
          for (const core::Part& part : kind.parts)
            std::visit(
                [&](const auto& of_part) {
                  if constexpr (requires { of_part.vertices.size(); }) sum += of_part.vertices.size();
                },
                part.shape);
          return sum;
        } else {
          return 0;
        }
      },
      shape);
}

// The template of `copies` bodies.
core::Body read_template(const Table& table, Draft& draft, double copies) {
  core::Body body = read_body(table, draft);
  draft.add_points(table, copies * static_cast<double>(points_of(body.shape)));
  return body;
}

bool is_point(const Table& table) { return !table.has("shape") && !table.has("inertia"); }

// Opens the group of a generator of `count` bodies, into which what is returned takes them.
TakeBody open_group(const Table& table, double count, Draft& draft) {
  const std::string name = table.text("name");
  auto [group, is_new] = draft.groups.try_emplace(name);
  if (!is_new) table.fail("name", fmt::format("name '{}' is taken by another generator", name));
  draft.expect(static_cast<std::size_t>(count));
  return [&table, &draft, &members = group->second, is_point = is_point(table)](core::Body&& body) {
    members.push_back(static_cast<int>(draft.scene.bodies.size()));
    draft.add(std::move(body), table, is_point);
  };
}

void refuse_too_many(const Table& table, const Draft& draft, double more) {
  if (static_cast<double>(draft.scene.bodies.size()) + more > static_cast<double>(budget::bodies))
    table.fail("count", fmt::format("count: {} bodies, but at most {} are allowed", more, budget::bodies));
}

}  // namespace

void read_bodies(const Table& root, Draft& draft) {
  for (const Table& table : root.tables("body"))
    draft.add(read_template(table, draft, 1), table, is_point(table));
  for (const Table& table : root.tables("lattice")) {
    double count = 1;
    for (const double n : table.numbers("count")) count *= n;
    refuse_too_many(table, draft, count);
    const core::Body pattern = read_template(table, draft, count);
    lattice(table, pattern, open_group(table, count, draft));
  }
  const std::vector<Table> clouds = root.tables("cloud");
  for (std::size_t i = 0; i < clouds.size(); ++i) {
    const auto count = static_cast<double>(clouds[i].whole("count"));
    refuse_too_many(clouds[i], draft, count);
    const core::Body pattern = read_template(clouds[i], draft, count);
    cloud(clouds[i], pattern, draft, std::span(clouds).first(i), open_group(clouds[i], count, draft));
  }
  if (draft.scene.bodies.empty()) root.fail("the scene has no body; add a [[body]]");
}

}  // namespace cylon::scenario
