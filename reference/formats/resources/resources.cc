#include "reference/formats/resources/resources.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include <cstdio>
#include <filesystem>
#include <system_error>

namespace cylon::formats {
namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

// PACKAGE/rest below a root, or rest where the root is the package itself.
std::vector<fs::path> below(const fs::path& root, const fs::path& path) {
  std::vector<fs::path> places = {root / path};
  const fs::path package = *path.begin();
  if (root.filename() == package) places.push_back(root / path.lexically_relative(package));
  return places;
}

}  // namespace

std::string resolve(const std::string& uri, const std::string& file, const std::vector<std::string>& roots) {
  const std::size_t colon = uri.find("://");
  const std::string scheme = colon == std::string::npos ? "" : uri.substr(0, colon);
  const fs::path path = colon == std::string::npos ? uri : uri.substr(colon + 3);
  const fs::path folder = fs::absolute(file).parent_path();
  std::vector<fs::path> places;
  if (scheme.empty() || scheme == "file") {
    places = {path.is_absolute() ? path : folder / path};
  } else if ((scheme == "package" || scheme == "model") && !path.empty()) {
    std::vector<fs::path> all(roots.begin(), roots.end());
    for (fs::path up = folder; up != up.root_path(); up = up.parent_path()) all.push_back(up);
    for (const fs::path& root : all)
      for (const fs::path& place : below(root, path)) places.push_back(place);
  } else {
    throw Refused("'" + uri + "' is no file of this machine");
  }
  for (const fs::path& place : places)
    if (is_file(place)) return place.lexically_normal().string();
  throw Refused("the file '" + uri + "' is not there" +
                (scheme == "package" || scheme == "model"
                     ? "; --root names the folder that holds '" + path.begin()->string() + "'"
                     : ""));
}

void load_mesh(const std::string& file, const foreign::Vector3& scale, foreign::Solid& solid) {
  Assimp::Importer importer;
  // Coordinates as the file has them, as Gazebo and ROS take them; else Assimp turns those of Collada to y up.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene = importer.ReadFile(
      file, aiProcess_Triangulate | aiProcess_PreTransformVertices | aiProcess_JoinIdenticalVertices);
  if (!scene) throw Refused("the mesh '" + file + "': " + importer.GetErrorString());
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
    const aiMesh& mesh = *scene->mMeshes[i];
    const auto first = static_cast<std::int32_t>(solid.vertices.size());
    for (unsigned k = 0; k < mesh.mNumVertices; ++k)
      solid.vertices.emplace_back(
          foreign::Vector3(mesh.mVertices[k].x, mesh.mVertices[k].y, mesh.mVertices[k].z)
              .cwiseProduct(scale));
    for (unsigned k = 0; k < mesh.mNumFaces; ++k)
      if (const aiFace& face = mesh.mFaces[k]; face.mNumIndices == 3)
        solid.faces.push_back({first + static_cast<std::int32_t>(face.mIndices[0]),
                               first + static_cast<std::int32_t>(face.mIndices[1]),
                               first + static_cast<std::int32_t>(face.mIndices[2])});
  }
  if (solid.faces.empty()) throw Refused("the mesh '" + file + "' has no triangle");
}

int refuse(const std::string& why) {
  std::fprintf(stderr, "%s\n", why.c_str());
  return 2;
}

}  // namespace cylon::formats
