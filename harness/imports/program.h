// The program that holds the library of a format, and what it prints.
#pragma once

#include "harness/imports/imports.h"
#include "harness/imports/xml_check.h"

#include <nlohmann/json.hpp>

namespace cylon::imports {

/// Of one format (harness/scenario/foreign.h): the program, the Debian package of its library, the element that is a body,
/// how deep its elements may be inside each other, and a program with a newer library, which goes first where it is here.
struct Format {
  std::string_view name, program, package, body;
  int deepest = deepest_xml;
  std::string_view newer = {};
};

/// The program of the two that reads the format here; a path that does not exist where none does.
std::filesystem::path program_of(const Format&, const std::filesystem::path& programs);

/// Null for a file of none.
const Format* format_of(const std::filesystem::path&);

/// What the program says of the file.  Throws core::InputError; at a file whose root is that of another format before the
/// program sees it, since each of the libraries takes another's files in part.
nlohmann::json read_by(const Format&, const std::filesystem::path& file, const Options&,
                       const std::filesystem::path& programs);

}  // namespace cylon::imports
