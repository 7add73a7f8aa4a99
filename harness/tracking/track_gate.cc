// cylon track gate
#include "harness/tracking/track_compare.h"

namespace cylon::tracking {

using namespace cli;  // commands are written in the words of the command line

Command add_track_gate(App& app, const Context& context) {
  const auto asked = std::make_shared<CompareRequest>();
  asked->gate = true;
  add_compare_options(app, *asked);
  app.footer(
      "For continuous integration: `compare`, with the risk of a false alarm held at 1 % over all cells "
      "together "
      "(Holm). Improvements are reported and do not fail.\n"
      "Exit codes: 0 no regression, 1 a regression is confirmed, 2 bad input, 3 inconclusive under --strict, "
      "4 nothing "
      "selected or compared, 5 harness failure, 130 interrupted.");
  return [asked, &context] { return compare(context, *asked); };
}

}  // namespace cylon::tracking
