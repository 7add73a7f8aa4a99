// A file that leads a browser to an address which no other user may see.
#pragma once

#include <filesystem>
#include <string>

namespace cylon::view {

/// An HTML file that its owner alone can read, in a folder that its owner alone can enter.  Both go with the object.
class Redirect {
 public:
  /// `address` has no character that means something to HTML.  Throws std::system_error where the file cannot be written.
  explicit Redirect(const std::string& address);
  ~Redirect();
  Redirect(const Redirect&) = delete;
  Redirect& operator=(const Redirect&) = delete;

  std::filesystem::path file() const { return folder_ / "view.html"; }

 private:
  std::filesystem::path folder_;
};

}  // namespace cylon::view
