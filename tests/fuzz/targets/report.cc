#include "harness/core/input_error.h"
#include "reports/json.h"
#include "reports/trace_block.h"
#include "tests/fuzz/targets/targets.h"

namespace cylon::fuzz {
namespace {

// What is written of it and read again is written alike.
void require_same_again(const reports::RunReport& report) {
  const std::string written = reports::to_json(report.verdicts, report.provenance);
  const reports::RunReport again = reports::read_json(written, "again.json");
  if (reports::to_json(again.verdicts, again.provenance) != written)
    throw Broken("a report is read as it was written");
}

}  // namespace

// As `cylon report` tells them apart.
void report(std::string_view bytes) {
  try {
    if (bytes.substr(0, bytes.find('\n')).find("cylon-trace/1") != std::string_view::npos) {
      reports::trace_from_json_line(bytes.substr(0, bytes.find('\n')), "t.jsonl:1");
      return;
    }
    std::optional<reports::RunReport> read;
    read = reports::read_json(bytes, "v.json");
    require_same_again(*read);
  } catch (const core::InputError&) {
  }
}

}  // namespace cylon::fuzz
