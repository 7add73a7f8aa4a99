#include "harness/results/verdict.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cylon::results {
namespace {

struct Row {
  Status status;
  std::string_view name;
};
constexpr std::array rows = {
    Row{Status::pass, "pass"},
    Row{Status::low_quality, "low-quality"},
    Row{Status::fail, "fail"},
    Row{Status::undecided, "undecided"},
    Row{Status::unsupported, "unsupported"},
    Row{Status::crash, "crash"},
    Row{Status::timeout, "timeout"},
    Row{Status::non_finite, "non-finite"},
    Row{Status::protocol, "protocol"},
};

}  // namespace

std::string_view name(Status status) { return rows[static_cast<std::size_t>(status)].name; }

std::optional<Status> status_from(std::string_view word) {
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& r) { return r.name == word; });
  return row == rows.end() ? std::nullopt : std::optional(row->status);
}

Status judge(double measured, double allowed) {
  if (!std::isfinite(measured)) return Status::non_finite;
  if (measured <= allowed) return Status::pass;
  return measured <= 10 * allowed ? Status::low_quality : Status::fail;
}

Status judge(const Bounds& known, double allowed) {
  if (!std::isfinite(known.low) || !std::isfinite(known.high)) return Status::non_finite;
  if (known.high <= allowed) return Status::pass;
  return known.low > allowed ? Status::fail : Status::undecided;
}

bool is_measured(Status status) { return status <= Status::undecided; }

double digits(double measured, double allowed) {
  if (!std::isfinite(measured)) return -99;
  if (measured == 0) return 99;
  if (allowed == 0) return -99;
  return std::clamp(std::log10(allowed / measured), -99.0, 99.0);
}

bool Verdict::as_expected() const {
  if (status == Status::undecided) return is_measured(expected);
  if (!expected_size) return status == expected;
  if (!is_measured(status)) return false;
  if (status == Status::pass && *expected_size <= allowed) return true;
  if (expected_within > 10 && status != expected) return false;
  return *expected_size / expected_within <= measured && measured <= *expected_size * expected_within;
}

}  // namespace cylon::results
