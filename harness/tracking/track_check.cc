// cylon track check
#include "harness/tracking/track.h"

#include "reports/text.h"

#include <fmt/format.h>

#include <iostream>

namespace cylon::tracking {

using namespace cli;  // commands are written in the words of the command line

Command add_track_check(App& app, const Context&) {
  const auto file = std::make_shared<std::string>();
  add_store_option(app, *file);
  app.footer(
      "Checks the database pages, the references between tables, the digest of every "
      "result, and that what you recorded here still bears your seal. Rows that were imported bear none.");
  return [file] {
    const store::Store store = store::Store::open(*file, store::Mode::read);
    const std::vector<std::string> findings = store.check();
    if (!findings.empty())
      throw core::InputError(
          *file, 0, 0,
          fmt::format(
              "is damaged: {}{}; restore a backup, or import what `cylon track export` "
              "still gives into a new store",
              findings.front(),
              findings.size() == 1 ? "" : fmt::format(" (and {} more findings)", findings.size() - 1)));
    const store::Seals seals = store.seals();
    if (!seals.broken.empty())
      throw core::InputError(
          *file, 0, 0,
          fmt::format(
              "is forged: {}{}; restore a backup", seals.broken.front(),
              seals.broken.size() == 1 ? "" : fmt::format(" (and {} more)", seals.broken.size() - 1)));
    std::cout << fmt::format("{}: {}, {}, sound; {} rows bear your seal, {} do not\n", *file,
                             reports::counted(store.runs().size(), "run"),
                             reports::counted(store.cells().size(), "cell"), seals.own, seals.foreign);
    return ok;
  };
}

}  // namespace cylon::tracking
