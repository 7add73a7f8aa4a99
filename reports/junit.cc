#include "reports/junit.h"

#include "reports/sentence.h"
#include "reports/xml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace cylon::reports {
namespace {

using results::Status;
using results::Verdict;

enum class Outcome { passed, noted, skipped, failed, broken };

Outcome outcome(const Verdict& v) {
  if (v.as_expected())
    return v.status == Status::pass          ? Outcome::passed
           : v.status == Status::unsupported ? Outcome::skipped
                                             : Outcome::noted;
  const bool harness =
      v.status == Status::crash || v.status == Status::timeout || v.status == Status::protocol;
  return harness ? Outcome::broken : Outcome::failed;
}

std::string element(const Verdict& v) {
  const std::string reason = xml(sentence(v));
  const std::string with_command = v.reproduce.empty() ? reason : reason + "\n" + xml(v.reproduce);
  const auto bad = [&](const char* tag) {
    return fmt::format("<{0} type=\"{1}\" message=\"{2}\">{3}</{0}>", tag, results::name(v.status), reason,
                       with_command);
  };
  switch (outcome(v)) {
    case Outcome::passed:
      return "";
    case Outcome::noted:
      return fmt::format("<system-out>{}</system-out>", reason);
    case Outcome::skipped:
      return fmt::format("<skipped message=\"{0}\">{0}</skipped>", reason);
    case Outcome::failed:
      return bad("failure");
    case Outcome::broken:
      return bad("error");
  }
  return "";
}

// The claims of one run share its time: the first has it, so that sums are those of the runs.
using Times = std::map<const Verdict*, double>;

Times times_of(const std::vector<Verdict>& verdicts) {
  Times times;
  std::set<std::tuple<std::string, std::string, std::string, std::string>> runs;
  for (const Verdict& v : verdicts) {
    const bool first = runs.emplace(v.scenario, v.engine, v.integrator, v.dt_text).second;
    times[&v] = first && std::isfinite(v.cpu_seconds) ? v.cpu_seconds : 0;
  }
  return times;
}

std::string testcase(const Verdict& v, double seconds) {
  std::string integrator = v.integrator.empty() ? "" : ", " + v.integrator;
  if (v.tolerance_scale != 1) integrator += fmt::format(", all tolerances times {:g}", v.tolerance_scale);
  const std::string errors =
      v.complaints.empty() ? "" : fmt::format("<system-err>{}</system-err>", xml(v.complaints));
  return fmt::format(
      "    <testcase classname=\"{}.{}\" name=\"{} [dt {}{}]\" time=\"{:.6f}\">{}{}</testcase>\n",
      xml(v.scenario), xml(v.engine), xml(v.claim), xml(v.dt_text), xml(integrator), seconds, element(v),
      errors);
}

using Rows = std::vector<const Verdict*>;

std::string counts(const Rows& rows, const Times& times) {
  const auto count = [&](Outcome wanted) {
    return std::count_if(rows.begin(), rows.end(), [&](const Verdict* v) { return outcome(*v) == wanted; });
  };
  double seconds = 0;
  for (const Verdict* v : rows) seconds += times.at(v);
  return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{:.6f}\"", rows.size(),
                     count(Outcome::failed), count(Outcome::broken), count(Outcome::skipped), seconds);
}

}  // namespace

std::string to_junit(const std::vector<Verdict>& verdicts) {
  Rows all;
  std::vector<std::pair<std::string, Rows>> suites;  // in order of first appearance
  std::map<std::string, std::size_t> index;
  for (const Verdict& v : verdicts) {
    const auto [at, fresh] = index.try_emplace(v.scenario, suites.size());
    if (fresh) suites.emplace_back(v.scenario, Rows{});
    suites[at->second].second.push_back(&v);
    all.push_back(&v);
  }

  const Times times = times_of(verdicts);
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  out += fmt::format("<testsuites name=\"cylon\" {}>\n", counts(all, times));
  for (const auto& [scenario, rows] : suites) {
    out += fmt::format("  <testsuite name=\"{}\" {}>\n", xml(scenario), counts(rows, times));
    for (const Verdict* v : rows) out += testcase(*v, times.at(v));
    out += "  </testsuite>\n";
  }
  return out + "</testsuites>\n";
}

}  // namespace cylon::reports
