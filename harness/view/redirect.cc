#include "harness/view/redirect.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace cylon::view {
namespace {

namespace fs = std::filesystem;

std::system_error failure(const fs::path& what) { return {errno, std::generic_category(), what.string()}; }

// Mode 0700, by mkdtemp.
fs::path private_folder() {
  std::string name = (fs::temp_directory_path() / "cylon-view-XXXXXX").string();
  if (!::mkdtemp(name.data())) throw failure(name);
  return name;
}

void write_private(const fs::path& file, const std::string& text) {
  const int fd = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (fd < 0) throw failure(file);
  const ssize_t written = ::write(fd, text.data(), text.size());
  const int error = errno;
  ::close(fd);
  errno = written < 0 ? error : ENOSPC;
  if (written != static_cast<ssize_t>(text.size())) throw failure(file);
}

std::string page_to(const std::string& address) {
  return fmt::format(R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="referrer" content="no-referrer">
<meta http-equiv="refresh" content="0; url={0}">
<title>Cylon</title>
</head>
<body><a href="{0}">The viewer</a></body>
</html>
)",
                     address);
}

void remove_folder(const fs::path& folder) {
  std::error_code ignored;
  fs::remove_all(folder, ignored);
}

}  // namespace

Redirect::Redirect(const std::string& address) : folder_(private_folder()) {
  try {
    write_private(file(), page_to(address));
  } catch (...) {
    remove_folder(folder_);
    throw;
  }
}

Redirect::~Redirect() { remove_folder(folder_); }

}  // namespace cylon::view
