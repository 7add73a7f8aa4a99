// What becomes of each element and attribute that SDFormat knows: a table of what the reader reads and of what it loses.
// Knows no model.
#pragma once

#include <sdf/sdf.hh>

#include <string>
#include <string_view>

namespace cylon::formats {

/// The path of a row: "surface/friction/ode/mu" from the nearest of world, model, include, link, joint, axis, inertial,
/// collision and surface.  <axis2> is an axis.
struct Path {
  std::string row;    ///< Of the element itself: "collision/surface".
  std::string below;  ///< Of what is in it: "surface".
};
Path path_of(const std::string& parent, const std::string& name);

enum class Use {
  read,  ///< It is in the model, or holds what is; what is below it has rows of its own.
  told,  ///< The reader reads it, or tells its loss, with all that is below it.
  lost,  ///< It is a loss of the kind `what` where it `holds`, with all that is below it.
};

struct ElementRow {
  std::string_view path;
  Use use = Use::read;
  const char* what = "";
  /// `windy`: the world has wind.
  bool (*holds)(const sdf::Element&, bool windy) = nullptr;
};

/// The row of an element; of one that the format knows and that has none, or that stands where only shapes stand, a row that
/// is a loss of the kind `unread` wherever a file states another value than the format's own.  Null of one that the
/// format does not know.
const ElementRow* row_of(std::string_view path, bool is_known);

/// The kind of loss of an attribute with this value; "" where it is read.
std::string_view loss_of(const sdf::Element&, const sdf::Param& attribute);

/// One line for each element and attribute of the library's own description, "PATH: USE", USE being "no row" where the
/// tables name none; and one for each row of an element that the description has not.
std::string known_elements();

}  // namespace cylon::formats
