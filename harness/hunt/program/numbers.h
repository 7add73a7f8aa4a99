// Numbers, vectors and lists as a language writes them: every double to its last bit.
#pragma once

#include "harness/core/scene.h"
#include "harness/hunt/program/dialect.h"

#include <fmt/format.h>

#include <initializer_list>
#include <string>

namespace cylon::hunt::program {

class Numbers {
 public:
  explicit Numbers(const Language& language) : language_(language) {}

  /// With a point, so that no language takes it for an integer.
  static std::string number(double x) {
    std::string text = fmt::format("{}", x);
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
  }
  static std::string listed(const core::Vector3& v) {
    return fmt::format("{}, {}, {}", number(v.x()), number(v.y()), number(v.z()));
  }
  std::string vector(const core::Vector3& v) const { return of({v.x(), v.y(), v.z()}); }
  std::string vector(const core::Quaternion& q) const { return of({q.w(), q.x(), q.y(), q.z()}); }

  template <class Range, class Text>
  std::string list(const Range& range, const Text& text) const {
    std::string out(language_.list);
    for (const auto& one : range) out += (out.size() > language_.list.size() ? ", " : "") + text(one);
    return out + std::string(language_.end_list);
  }
  std::string state(const core::BodyState& s) const {
    return fmt::format("{}{}, {}, {}, {}{}", language_.list, vector(s.position), vector(s.orientation),
                       vector(s.velocity), vector(s.angular_velocity), language_.end_list);
  }
  std::string body(const core::Body& b) const {
    return fmt::format("{}{}, {}{}", language_.list, number(b.mass),
                       vector(core::Vector3(b.inertia.diagonal())), language_.end_list);
  }

 private:
  std::string of(std::initializer_list<double> numbers) const {
    std::string out(language_.open);
    for (const double x : numbers) out += (out.size() > language_.open.size() ? ", " : "") + number(x);
    return out + std::string(language_.close);
  }

  const Language& language_;
};

}  // namespace cylon::hunt::program
