#include "harness/tracking/run_words.h"

#include "harness/cli/provenance_now.h"
#include "reports/provenance.h"

namespace cylon::tracking {

void add_run_options(cli::App& app, RunWords& words) {
  app.add_option("--revision", words.revision, "Revision under test. Default: the revision of this program")
      ->type_name("TEXT");
  app.add_option("--order", words.order,
                 "Position of the revision in the history, ascending, for example from `git rev-list "
                 "--count`. Default: after all others")
      ->type_name("N");
  app.add_option("--label", words.label, "A name for this run")->type_name("TEXT");
  app.add_option("--note", words.note, "A remark")->type_name("TEXT");
}

store::RunInfo run_here(const cli::Context& context, const RunWords& words) {
  const reports::Provenance here = reports::build_and_machine();
  store::RunInfo run;
  run.label = words.label;
  run.revision = words.revision.empty() ? here.revision : words.revision;
  run.revision_order = words.order;
  run.date = cli::now();
  run.machine = here.machine, run.os = here.os, run.compiler = here.compiler, run.flags = here.flags;
  run.command_line = context.command_line;
  run.note = words.note;
  return run;
}

}  // namespace cylon::tracking
