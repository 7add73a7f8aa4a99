#include "harness/study/side.h"

#include "harness/core/files.h"
#include "harness/process/child.h"
#include "harness/process/sandbox.h"
#include "harness/seal/sha256.h"
#include "harness/study/modules.h"

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>
#include <system_error>

namespace cylon::study {
namespace {

namespace fs = std::filesystem;

/// Of a file as it is now; a file that did not change since is not read again.
std::string file_hash(const fs::path& file) {
  struct Known {
    fs::file_time_type written;
    std::uintmax_t size = 0;
    std::string hash;
  };
  static std::map<fs::path, Known> known;
  std::error_code ignored;
  Known now{fs::last_write_time(file, ignored), fs::file_size(file, ignored), ""};
  Known& before = known[file];
  if (!before.hash.empty() && before.written == now.written && before.size == now.size) return before.hash;
  now.hash = seal::sha256(core::whole_file(file));
  before = now;
  return now.hash;
}

constexpr double patience = 10;                             // [s]
constexpr std::size_t memory = std::size_t{1} << 30;        // [bytes]
constexpr std::size_t largest_list = std::size_t{1} << 20;  // [bytes]

/// What ldd prints of a program; "" where it prints too much or too long.  ldd runs the loader that the program itself
/// names, which a stranger may have written: it is confined as the engine is.
std::string printed_by_ldd(const std::string& program) {
  const bool alone = process::sandboxing();
  std::optional<process::SandboxFilter> filter;
  if (alone) filter.emplace();
  const std::vector<std::string> command = {"ldd", program};
  std::string text;
  try {
    process::Child ldd(alone ? process::sandboxed(command, *filter) : command, memory,
                       alone ? filter->inherited() : process::Inherited{});
    ldd.set_deadline(patience, "ldd");
    while (ldd.receive()) {
      text += ldd.output();
      ldd.consume(ldd.output().size());
      if (text.size() > largest_list) return "";
    }
  } catch (const process::Failure&) {
    return "";
  }
  return text;
}

/// The files in "libfmt.so.9 => /lib/libfmt.so.9 (0x…)" and "/lib64/ld.so (0x…)"; none of what is no dynamic
/// program.
std::vector<fs::path> libraries(const std::string& program) {
  std::vector<fs::path> files;
  std::istringstream words(printed_by_ldd(program));
  for (std::string word; words >> word;)
    if (std::error_code ignored; word.starts_with('/') && fs::is_regular_file(word, ignored))
      files.emplace_back(word);
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::optional<process::EngineChoice> on(const Side& side, const process::EngineChoice& choice) {
  const auto row = std::find_if(side.engines.begin(), side.engines.end(),
                                [&](const process::EngineRow& r) { return r.id == choice.row.id; });
  if (row == side.engines.end() || row->command.empty()) return std::nullopt;
  const std::string& program = row->command.front();
  if (program.find('/') != std::string::npos && ::access(program.c_str(), X_OK) != 0) return std::nullopt;
  process::EngineChoice here = choice;
  here.row = *row;
  return here;
}

std::string content_hash(const std::vector<std::string>& command) {
  std::string content;
  for (const std::string& word : command) {
    std::error_code ignored;
    if (!fs::is_regular_file(word, ignored)) {
      content += word + "\n";
      continue;
    }
    content += file_hash(word) + "\n";
    // A program may tell by the name of the link what it is to be, as workers in Node do.
    if (fs::is_symlink(word, ignored)) content += fs::path(word).filename().string() + "\n";
    for (const fs::path& library : libraries(word)) content += file_hash(library) + "\n";
    for (const fs::path& module : modules_beside(word))
      content += module.filename().string() + " " + file_hash(module) + "\n";
  }
  return seal::sha256(content).substr(0, 16);
}

}  // namespace cylon::study
