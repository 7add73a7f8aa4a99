#include "harness/imports/steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace cylon::imports {
namespace {

// What the reader of scenarios takes (harness/scenario/bodies.cc).
constexpr std::size_t longest = 150;  // [bytes], with room for a number

}  // namespace

std::string legal_name(std::string name) {
  std::ranges::replace_if(
      name,
      [](char c) {
        return std::iscntrl(static_cast<unsigned char>(c)) || c == ',' || c == '"' || c == '*' || c == '?';
      },
      '_');
  if (name.size() > longest) name.resize(longest);
  return name.empty() ? "body" : name;
}

void name_bodies(foreign::Model& model) {
  std::set<std::string> taken = {"world"};  // what is no body
  for (foreign::Body& body : model.bodies) {
    std::string name = legal_name(body.name);
    for (int i = 2; !taken.insert(name).second; ++i) name = fmt::format("{} ({})", legal_name(body.name), i);
    if (name != body.name) model.losses.push_back({"name", body.place, fmt::format("'{}' here", name)});
    body.name = name;
  }
}

}  // namespace cylon::imports
