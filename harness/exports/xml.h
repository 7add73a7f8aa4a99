// Elements of an XML file, written by Boost's property trees.
#pragma once

#include "harness/core/scene.h"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>
#include <string>
#include <string_view>

namespace cylon::exports {

using Element = boost::property_tree::ptree;

/// The shortest digits that read back as the same number; several with blanks between.
inline std::string text(double x) { return fmt::format("{}", x); }
inline std::string text(const core::Vector3& v) { return fmt::format("{} {} {}", v.x(), v.y(), v.z()); }
inline std::string text(std::string_view words) { return std::string(words); }
inline std::string text(int i) { return std::to_string(i); }

template <class Value>
void set(Element& element, const std::string& attribute, const Value& value) {
  element.put("<xmlattr>." + attribute, text(value));
}

/// A new last child.
inline Element& add(Element& element, const std::string& name) {
  return element.push_back({name, Element()})->second;
}
template <class Value>
Element& add(Element& element, const std::string& name, const Value& content) {
  Element& child = add(element, name);
  child.put_value(text(content));
  return child;
}

inline std::string document(const Element& root) {
  std::ostringstream out;
  boost::property_tree::write_xml(out, root,
                                  boost::property_tree::xml_writer_make_settings<std::string>(' ', 2));
  return out.str();
}

}  // namespace cylon::exports
