// Files that a model names by a URI, and the triangles of its meshes (read by Assimp).
#pragma once

#include "harness/imports/model/model.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace cylon::formats {

/// What the library refuses, or what is missing; what() is for people.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The file of "package://PACKAGE/…", "model://MODEL/…", "file://…" or a path beside `file`.  The first two are looked for
/// below each of `roots`, and below the folders that `file` is in.  Throws Refused where it is not there.
std::string resolve(const std::string& uri, const std::string& file, const std::vector<std::string>& roots);

/// Adds the triangles of all meshes of a file to the solid, scaled, in its own axes.
void load_mesh(const std::string& file, const foreign::Vector3& scale, foreign::Solid&);

/// "element: what() …" of whatever was thrown for it goes to stderr; 2, the exit code of a refusal.
int refuse(const std::string& why);

}  // namespace cylon::formats
