#include "harness/imports/program.h"

#include "harness/core/input_error.h"
#include "harness/input/json.h"
#include "harness/process/child.h"
#include "harness/process/sandbox.h"
#include "harness/scenario/foreign.h"
#include "harness/scenario/input.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace cylon::imports {
namespace {

namespace fs = std::filesystem;

constexpr double patience = 60;                                 // [s]
constexpr std::size_t memory = std::size_t{4} << 30;            // [bytes]
constexpr std::size_t largest_answer = std::size_t{256} << 20;  // [bytes]

// MuJoCo 2.2.2 takes 100, and MuJoCo 3 in WebAssembly writes over its own memory from some 125 on, where its stack ends.
constexpr int deepest_mjcf = 110;

constexpr std::array formats = {
    Format{"MJCF", "cylon-import-mjcf", "libmujoco-dev", "body", deepest_mjcf, "cylon-import-mujoco3"},
    Format{"SDFormat", "cylon-import-sdformat", "libsdformat-dev", "link"},
    Format{"URDF", "cylon-import-urdf", "liburdfdom-dev", "link"},
};

// Which format a root element is of, and the ending of its files.
struct Root {
  std::string_view element, format, ending;
};
constexpr std::array roots = {
    Root{"mujoco", "MJCF", ".xml"},
    Root{"mujocoinclude", "MJCF", ".xml"},
    Root{"sdf", "SDFormat", ".sdf"},
    Root{"robot", "URDF", ".urdf"},
};

// The last lines of what the library said, in one, without colours.
std::string said(const std::string& complaints) {
  std::string text;
  for (std::size_t i = 0; i < complaints.size(); ++i) {
    const char c = complaints[i];
    if (c == '\x1b')  // a colour, "\x1b[1;31m"
      i = std::min(complaints.find('m', i), complaints.size() - 1);
    else
      text += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  while (!text.empty() && text.back() == ' ') text.pop_back();
  constexpr std::size_t most = 1500;
  return text.size() > most ? "… " + text.substr(text.size() - most) : text;
}

std::vector<std::string> command_of(const Format& format, const fs::path& file, const Options& options,
                                    const fs::path& programs) {
  std::vector<std::string> words = {program_of(format, programs).string(), file.string()};
  if (format.name == "MJCF") {
    if (!options.keyframe.empty()) words.push_back(options.keyframe);
    return words;
  }
  for (const std::string& root : options.roots) words.push_back(root);
  return words;
}

// MuJoCo and libsdformat read a URDF by rules of their own: they leave joints, couplings and massless links out.
void refuse_other_root(const Format& format, const XmlFacts& facts, const std::string& file) {
  const auto root = std::ranges::find(roots, facts.root, &Root::element);
  if (root == roots.end() || root->format == format.name) return;
  throw core::InputError(file, facts.line, facts.column,
                         fmt::format("<{}> is the root of a file of {}, and this one's ending is that of {}: "
                                     "name it {}",
                                     facts.root, root->format, format.name, root->ending));
}

// What the program reads, or why it does not.
XmlFacts checked(const Format& format, const std::string& text, const std::string& file) {
  const XmlFacts facts = require_small_xml(text, file, format.body, format.deepest);
  refuse_other_root(format, facts, file);
  if (format.name == "MJCF")
    require_no_nan(text, file);
  else
    require_single(text, file);
  return facts;
}

}  // namespace

const Format* format_of(const fs::path& file) {
  const auto found = std::ranges::find(formats, scenario::foreign_format(file), &Format::name);
  return found == formats.end() ? nullptr : &*found;
}

fs::path program_of(const Format& format, const fs::path& programs) {
  const fs::path folder = fs::absolute(programs);
  std::error_code ignored;
  if (!format.newer.empty() && fs::exists(folder / format.newer, ignored)) return folder / format.newer;
  return folder / format.program;
}

nlohmann::json read_by(const Format& format, const fs::path& file, const Options& options,
                       const fs::path& programs) {
  const XmlFacts facts =
      checked(format, scenario::read_file(file), file.string());  // and it is a file, and not too large
  const auto fail = [&](const std::string& why) -> core::InputError {
    return core::InputError(file.string(), 0, 0, why);
  };
  const std::vector<std::string> command = command_of(format, file, options, programs);
  std::error_code ignored;
  if (!fs::exists(command.front(), ignored))
    throw fail(fmt::format("{} is read by a library that is not here; `./run engines` brings it ({})",
                           format.name, format.package));
  const bool alone = process::sandboxing();
  std::optional<process::SandboxFilter> filter;
  if (alone) filter.emplace();
  std::string answer;
  try {
    process::Child child(alone ? process::sandboxed(command, *filter) : command, memory,
                         alone ? filter->inherited() : process::Inherited{});
    child.set_deadline(patience, format.name == "MJCF" ? "compiling the model" : "reading the model");
    while (child.receive()) {
      answer += child.output();
      child.consume(child.output().size());
      if (answer.size() > largest_answer)
        throw fail("the model is too large: its numbers take more than 256 MB");
    }
    const process::Failure end = child.ending();
    if (!std::string_view(end.what()).starts_with("exited 0 ")) {
      const std::string complaints = said(child.complaints());
      // Exit code 2 is the program's own: the library refuses the file and has said why.
      throw fail(std::string_view(end.what()).starts_with("exited 2 ") && !complaints.empty()
                     ? complaints
                     : fmt::format("the library of {} {}", format.name, end.what()));
    }
  } catch (const process::Failure& failure) {
    throw fail(fmt::format("the library of {}: {}; the file has {} elements <{}>", format.name,
                           failure.what(), facts.bodies, format.body));
  }
  try {
    return input::parse_json(answer);
  } catch (const input::BadJson& error) {
    throw fail(fmt::format("{} says {}", format.program, error.what()));
  }
}

}  // namespace cylon::imports
