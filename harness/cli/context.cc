#include "harness/cli/context.h"

#include "harness/cli/folders.h"
#include "harness/core/input_error.h"
#include "harness/process/engine_table.h"
#include "harness/scenario/foreign.h"

#include <fmt/format.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <langinfo.h>
#include <algorithm>
#include <clocale>
#include <cstdlib>
#include <tuple>

namespace cylon::cli {
namespace {

namespace fs = std::filesystem;

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

int terminal_width() {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col >= 40) return size.ws_col;
  const int columns = std::atoi(environment("COLUMNS").c_str());
  return columns >= 40 ? columns : isatty(STDOUT_FILENO) ? 80 : width_without_terminal;
}

}  // namespace

Context make_context() {
  Context context;
  std::error_code ignored;
  const fs::path executable = fs::read_symlink("/proc/self/exe", ignored);
  const std::string scenarios = environment("CYLON_SCENARIOS"), workers = environment("CYLON_WORKERS");
  const Folders own = folders_of(executable);
  context.scenarios = (scenarios.empty() ? own.scenarios : fs::path(scenarios)).lexically_normal();
  context.workers = workers.empty() ? own.workers : fs::path(workers);
  context.engines = process::default_engines(context.workers);
  if (own.installed)  // ./run is a script of the sources
    for (std::size_t i = 0; const process::BuiltEngine& built : process::engine_table())
      if (process::EngineRow& row = context.engines[i++]; row.optional())
        row.brought_by = built.packaged ? fmt::format("apt-get install ./cylon-{}_*.deb", row.id)
                                        : "cd SOURCES && ./run engines";
  std::setlocale(LC_CTYPE, "");
  // The C locale of a bare container says ASCII though every terminal of today shows UTF-8; only a locale
  // that somebody chose is believed.
  const bool chosen =
      !environment("LC_ALL").empty() || !environment("LC_CTYPE").empty() || !environment("LANG").empty();
  context.utf8 = !chosen || std::string(nl_langinfo(CODESET)) == "UTF-8";
  context.colour = isatty(STDOUT_FILENO) && environment("NO_COLOR").empty();
  context.progress = isatty(STDERR_FILENO) && environment("CI").empty();
  context.width = terminal_width();
  return context;
}

scenario::Expectations expectations(const Context& context) {
  const fs::path file = context.scenarios / "expected.toml";
  return fs::exists(file) ? scenario::Expectations::load(file) : scenario::Expectations();
}

std::vector<fs::path> scenario_files(const Context& context) {
  std::vector<fs::path> files;
  const auto add = [&](const fs::path& folder) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error))
      if (entry.path().extension() == ".toml" && entry.path().filename() != "expected.toml")
        files.push_back(entry.path());
    return error;
  };
  if (const std::error_code error = add(context.scenarios))
    throw core::InputError(
        fmt::format("{}: no scenarios here: {}", context.scenarios.string(), error.message()));
  for (const char* folder : {"extremes", "validation"})
    add(context.scenarios / folder);  // which may be absent
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return std::tuple(a.stem(), a) < std::tuple(b.stem(), b);
  });
  return files;
}

bool is_path(const std::string& word) {
  return word.ends_with(".toml") || !scenario::foreign_format(word).empty();
}

core::InputError unknown_scenario(const Context& context, const std::string& name) {
  std::vector<std::string> names;
  for (const fs::path& file : scenario_files(context)) names.push_back(file.stem().string());
  return core::InputError(
      fmt::format("no scenario '{}' in {}{} (`cylon list` shows all; a file's name ends in .toml)", name,
                  context.scenarios.string(), core::did_you_mean(name, names)));
}

std::optional<fs::path> own_scenario(const Context& context, const std::string& name) {
  for (const fs::path& file : scenario_files(context))
    if (file.stem() == name) return file;
  return std::nullopt;
}

fs::path find_scenario(const Context& context, const std::string& name) {
  if (is_path(name) || name.find('/') != std::string::npos) return name;
  if (const auto own = own_scenario(context, name)) return *own;
  std::error_code ignored;
  if (fs::is_regular_file(name, ignored)) return name;
  throw unknown_scenario(context, name);
}

}  // namespace cylon::cli
