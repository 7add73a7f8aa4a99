#include "harness/scenario/writer.h"

#include "harness/core/fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <type_traits>
#include <vector>

namespace cylon::scenario {
namespace {

using Lines = std::vector<std::string>;

std::string list(const Lines& values) { return fmt::format("[{}]", fmt::join(values, ", ")); }

template <class Values, class Text>
std::string list(const Values& values, Text text) {
  Lines texts;
  for (const auto& value : values) texts.push_back(text(value));
  return list(texts);
}

class Writer {
 public:
  explicit Writer(const core::Scene& scene) : scene_(scene) {}

  /// "key = value" of every member that a file states, in the order of the table.
  template <class T>
  Lines lines(const T& element) const {
    Lines result;
    const auto append = [&](const Lines& more) { result.insert(result.end(), more.begin(), more.end()); };
    core::for_each_field(element, [&](const auto& field, const auto& value) {
      using Value = std::remove_cvref_t<decltype(value)>;
      if (field.applies && !field.applies(element)) return;
      if constexpr (std::is_same_v<Value, core::BodyState>) {
        append(lines(value));
      } else if constexpr (std::is_same_v<Value, core::Primitive>) {
        append(lines_of_shape(value));  // beside the keys of the part
      } else if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
        if (!value.empty()) append({fmt::format("{} = {}", field.key, list(value, toml_text))});
      } else if constexpr (std::is_same_v<Value, std::vector<double>> ||
                           std::is_same_v<Value, std::vector<core::JointDisplacement>> ||
                           std::is_same_v<Value, std::vector<core::JointAngle>>) {
        if (!value.empty()) append({fmt::format("{} = {}", field.key, written(value))});
      } else if (const std::string text = written(value); !text.empty()) {
        result.push_back(fmt::format("{} = {}", core::key_of(element, field), text));
      }
    });
    return result;
  }

 private:
  template <class... Kind>
  Lines lines_of_shape(const std::variant<std::monostate, Kind...>& any) const {
    return std::visit(
        [&]<class Shape>(const Shape& shape) -> Lines {
          if constexpr (std::is_same_v<Shape, std::monostate>) {
            return {};
          } else {
            Lines result = lines(shape);
            result.insert(result.begin(), fmt::format("type = \"{}\"", core::Element<Shape>::name));
            return result;
          }
        },
        any);
  }

  // A value as TOML; empty where a file has no key for it.
  std::string written(double x) const { return toml_number(x); }
  std::string written(bool flag) const { return flag ? "true" : "false"; }
  std::string written(const std::string& text) const { return text.empty() ? "" : toml_text(text); }
  std::string written(const std::string (&pair)[2]) const { return list(pair, toml_text); }
  std::string written(int body) const {
    return body == core::world ? "" : toml_text(scene_.bodies.at(static_cast<std::size_t>(body)).name);
  }
  std::string written(const std::vector<int>& bodies) const {
    return list(bodies, [this](int body) { return written(body); });
  }
  std::string written(const core::NamedNumbers& numbers) const {
    Lines entries;
    for (const auto& [name, value] : numbers)
      entries.push_back(fmt::format("{} = {}", toml_text(name), toml_number(value)));
    return in_braces(entries);
  }
  std::string written(const core::Vector3& v) const { return list(v, toml_number); }
  std::string written(const std::optional<core::Vector3>& v) const { return v ? written(*v) : ""; }
  std::string written(const core::Quaternion& q) const {
    return list(std::array{q.w(), q.x(), q.y(), q.z()}, toml_number);
  }
  std::string written(
      const core::Matrix3& inertia) const {  // no file states a moment of zero, as a rod has it
    if (!(core::principal_axes(inertia).moments.minCoeff() > 0)) return "";
    return list(inertia.reshaped<Eigen::RowMajor>(), toml_number);
  }
  template <class Enum>
  requires std::is_enum_v<Enum> std::string written(Enum value)
  const { return toml_text(core::Words<Enum>::list[static_cast<std::size_t>(value)]); }
  std::string written(const std::optional<double>& x) const { return x ? written(*x) : ""; }
  std::string written(const core::JointDisplacement& coordinate) const { return of_coordinate(coordinate); }
  std::string written(const core::JointAngle& coordinate) const { return of_coordinate(coordinate); }
  std::string written(const std::array<std::int32_t, 3>& face) const {
    return fmt::format("[{}]", fmt::join(face, ", "));
  }
  std::string written(const core::Part& part) const { return in_braces(lines(part)); }
  std::string written(const core::Shape& shape) const {
    const Lines inside = lines_of_shape(shape);
    return inside.empty() ? "" : in_braces(inside);
  }
  template <class T>
  std::string written(const std::vector<T>& values) const {
    return list(values, [&](const T& value) { return written(value); });
  }

  // Without what an absent key means: the reader refuses keys that do nothing.
  template <class Coordinate>
  std::string of_coordinate(const Coordinate& coordinate) const {
    Lines stated = lines(coordinate);
    const Lines plain = lines(Coordinate{});
    std::erase_if(stated,
                  [&](const std::string& line) { return std::ranges::find(plain, line) != plain.end(); });
    return in_braces(stated);
  }

  static std::string in_braces(const Lines& inside) { return fmt::format("{{{}}}", fmt::join(inside, ", ")); }

  const core::Scene& scene_;
};

}  // namespace

std::string toml_number(double x) {
  std::string text = fmt::format("{}", x);  // the shortest digits that read back as the same double
  return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
}

std::string toml_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      result += fmt::format("\\{}", c);
    else if (byte < ' ' || byte == 127)
      result += fmt::format("\\u{:04X}", byte);
    else
      result += c;
  }
  return result + '"';
}

std::string to_toml(const core::Scene& scene) {
  const Writer writer(scene);
  std::optional<core::UniformGravity> gravity;  // no sum with zero: -0 stays -0
  std::string tables;
  core::for_each_element(scene, [&]<class T>(const T& element) {
    if constexpr (std::is_same_v<T, core::UniformGravity>) {
      if (gravity)
        gravity->acceleration += element.acceleration;
      else
        gravity = element;
    } else {
      tables += fmt::format(std::is_same_v<T, core::Frame> ? "\n[{}]\n{}\n" : "\n[[{}]]\n{}\n",
                            core::Element<T>::name, fmt::join(writer.lines(element), "\n"));
    }
  });
  return fmt::format("impacts = \"{}\"\n{}{}",
                     core::Words<core::Impacts>::list[static_cast<std::size_t>(scene.impacts)],
                     gravity ? writer.lines(*gravity).front() + "\n" : "", tables);
}

}  // namespace cylon::scenario
