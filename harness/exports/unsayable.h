// What a format cannot say, and where the scenario's file says it.
#pragma once

#include "harness/core/input_error.h"

#include <string>
#include <string_view>

namespace cylon::exports {

/// Thrown while a scene is written.
struct Unsayable {
  std::string_view table;  ///< "body", "joint", "" for the top of the file.
  std::string
      name;  ///< Of the body or plane, or of the body that a joint or a force is on; "" where the table is one.
  std::string_view key;  ///< "" for the table as a whole.
  std::string why;
  int number = 0;  ///< Of tables without names: which.
};

/// "file:line:column: FORMAT cannot say KEY of TABLE 'NAME': WHY"; the line is that of the table, or 0 of a body that a
/// generator made, where the key is not written.
core::InputError located(const Unsayable&, std::string_view text, const std::string& file,
                         std::string_view format);

}  // namespace cylon::exports
