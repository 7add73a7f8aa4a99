// JSON and CSV: what is written comes back, whatever an engine printed and whatever it measured.
#include "reports/json.h"
#include "harness/core/input_error.h"
#include "reports/csv.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

namespace cylon::reports {
namespace {

using results::Status;
using results::Verdict;

std::string random_text(std::mt19937& random) {
  static const std::vector<std::string> pieces = {
      "a", "Ω",  "\"", "\\", "\n", "\x1b[31m",          ",", "日本", "</script>", "\t", "=1+1",
      "'", "\r", "&",  "😀",  "<",  std::string(1, '\0')};
  std::string text;
  for (auto n = random() % 6; n > 0; --n) text += pieces[random() % pieces.size()];
  return text;
}

// Any finite double, by its bits.
double random_number(std::mt19937& random) {
  for (;;) {
    const double value = std::bit_cast<double>(std::uint64_t{random()} << 32 | random());
    if (std::isfinite(value)) return value;
  }
}

Verdict random_verdict(std::mt19937& random) {
  Verdict v;
  for (std::string* text :
       {&v.scenario, &v.scenario_hash, &v.engine, &v.version, &v.precision, &v.path, &v.gyroscopic,
        &v.integrator, &v.dt_text, &v.sampling, &v.claim, &v.observable, &v.unit, &v.tolerance_reason,
        &v.detail, &v.complaints, &v.expected_reason, &v.reproduce})
    *text = random_text(random);
  for (double* number : {&v.dt, &v.measured, &v.allowed, &v.truth_error, &v.cpu_seconds})
    *number = random_number(random);
  v.settings = {{"z " + random_text(random), random_text(random)}, {"a", random_text(random)}};
  v.unforceable = {random_text(random), random_text(random)};
  if (random() % 2) v.first_bad_step = static_cast<std::int64_t>(random());
  for (auto n = random() % 3; n > 0; --n) {
    told::Diagnostic& d = v.diagnostics.emplace_back();
    for (std::string* text : {&d.kind, &d.method, &d.limit_unit, &d.unit, &d.text})
      *text = random_text(random);
    d.bodies = {random_text(random), random_text(random)};
    d.body_count = 2 + random() % 5;
    d.order = static_cast<int>(random() % 9);
    d.since = random_number(random);
    d.count = 1 + static_cast<std::int64_t>(random());
    for (std::optional<double>* number : {&d.until, &d.limit, &d.reached})
      if (random() % 2) *number = random_number(random);
  }
  v.status = static_cast<Status>(random() % 8);
  v.expected = static_cast<Status>(random() % 8);
  if (random() % 2) v.expected_size = random_number(random);
  v.expected_within = random_number(random);
  v.version_listed = random() % 2;
  v.closed_form = random() % 2;
  v.substeps = 1 + static_cast<int>(random() % 9);
  v.cpu_verified = random() % 2;
  v.body_steps = static_cast<std::int64_t>(std::uint64_t{random()} << 31 | random());
  return v;
}

void expect_same(const Verdict& a, const Verdict& b) {
  for (const auto member :
       {&Verdict::scenario, &Verdict::scenario_hash, &Verdict::engine, &Verdict::version, &Verdict::precision,
        &Verdict::path, &Verdict::gyroscopic, &Verdict::integrator, &Verdict::dt_text, &Verdict::sampling,
        &Verdict::claim, &Verdict::observable, &Verdict::unit, &Verdict::tolerance_reason, &Verdict::detail,
        &Verdict::complaints, &Verdict::expected_reason, &Verdict::reproduce})
    EXPECT_EQ(a.*member, b.*member);
  for (const auto member :
       {&Verdict::dt, &Verdict::measured, &Verdict::allowed, &Verdict::truth_error, &Verdict::cpu_seconds})
    EXPECT_EQ(std::bit_cast<std::uint64_t>(a.*member), std::bit_cast<std::uint64_t>(b.*member));
  EXPECT_EQ(a.settings, b.settings);
  EXPECT_EQ(a.unforceable, b.unforceable);
  EXPECT_EQ(a.diagnostics, b.diagnostics);
  EXPECT_EQ(a.first_bad_step, b.first_bad_step);
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.expected, b.expected);
  EXPECT_EQ(a.expected_size, b.expected_size);
  EXPECT_EQ(a.expected_within, b.expected_within);
  EXPECT_EQ(a.version_listed, b.version_listed);
  EXPECT_EQ(a.closed_form, b.closed_form);
  EXPECT_EQ(a.substeps, b.substeps);
  EXPECT_EQ(a.cpu_verified, b.cpu_verified);
  EXPECT_EQ(a.body_steps, b.body_steps);
}

TEST(Json, RoundTripsRandomVerdictsBitByBit) {
  std::mt19937 random(20240611);
  for (int i = 0; i < 500; ++i) {
    const Verdict v = random_verdict(random);
    const std::string line = to_json_line(v);
    EXPECT_EQ(line.find_first_of(std::string("\n\r\x1b\0", 4)), std::string::npos);
    expect_same(v, from_json_line(line, "journal"));
  }
}

// Zero would say that no error at all was allowed.
TEST(Json, AllowedIsNullWhereNothingWasMeasured) {
  Verdict v;
  for (const Status status : {Status::unsupported, Status::crash, Status::timeout, Status::protocol}) {
    v.status = status, v.allowed = 0;
    const std::string line = to_json_line(v);
    EXPECT_NE(line.find("\"allowed\":null"), std::string::npos) << line;
    EXPECT_EQ(from_json_line(line, "journal").allowed, 0);
  }
  v.status = Status::fail;
  EXPECT_NE(to_json_line(v).find("\"allowed\":0.0"), std::string::npos);
}

TEST(Json, RoundTripsVerdictsAndProvenance) {
  std::mt19937 random(7);
  const std::vector<Verdict> verdicts = {random_verdict(random), random_verdict(random),
                                         random_verdict(random)};
  Provenance provenance = build_and_machine();
  provenance.date = "2024-06-11T10:00:00Z";
  const std::string document = to_json(verdicts, provenance);
  const auto [back_provenance, back] = read_json(document, "report.json");
  ASSERT_EQ(back.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) expect_same(verdicts[i], back[i]);
  const auto json = nlohmann::json::parse(document);
  EXPECT_EQ(json["provenance"]["date"], "2024-06-11T10:00:00Z");
  EXPECT_EQ(provenance_json(back_provenance), provenance_json(provenance));
  EXPECT_NE(json["provenance"]["compiler"], "");
  EXPECT_EQ(document, to_json(verdicts, provenance));
  EXPECT_TRUE(read_json(to_json({}, {}), "empty").verdicts.empty());
}

TEST(Json, WritesEveryFieldInFixedOrder) {
  std::vector<std::string> keys;
  const nlohmann::ordered_json empty = row({});
  for (const auto& item : empty.items()) keys.push_back(item.key());
  for (const char* key :
       {"scenario",   "engine",      "version",        "precision",   "path",         "gyroscopic",
        "settings",   "unforceable", "integrator",     "dt",          "sampling",     "claim",
        "observable", "measured",    "first_bad_step", "allowed",     "unit",         "truth_error",
        "status",     "expected",    "reason",         "cpu_seconds", "cpu_verified", "body_steps"})
    EXPECT_NE(std::find(keys.begin(), keys.end(), key), keys.end()) << key;
  EXPECT_EQ(keys.front(), "scenario");
}

// Rows of programs that knew no substeps are of one.
TEST(Json, AStepWithoutSubstepsIsOne) {
  Verdict v;
  v.substeps = 4;
  const std::string line = to_json_line(v);
  nlohmann::json row = nlohmann::json::parse(line);
  EXPECT_EQ(row.at("substeps"), 4);
  row.erase("substeps");
  EXPECT_EQ(from_json_line(row.dump(), "journal").substeps, 1);
  row["substeps"] = 0;
  EXPECT_ANY_THROW(from_json_line(row.dump(), "journal"));
}

// Rows of programs that knew no check say nothing of it.
TEST(Json, CostWithoutItsCheckIsNotVerified) {
  Verdict v;
  v.cpu_verified = true;
  std::string line = to_json_line(v);
  EXPECT_TRUE(from_json_line(line, "journal").cpu_verified);
  const auto at = line.find("\"cpu_verified\"");
  line.erase(at, line.find("\"body_steps\"") - at);
  EXPECT_FALSE(from_json_line(line, "journal").cpu_verified);
}

TEST(Json, KeepsEvidenceAndInterval) {
  Verdict v;
  v.evidence = "validated", v.interval = results::Bounds{0.25, 1e300};
  const Verdict back = from_json_line(to_json_line(v), "journal");
  EXPECT_EQ(back.evidence, "validated");
  EXPECT_EQ(back.interval->low, 0.25);
  EXPECT_EQ(back.interval->high, 1e300);
  nlohmann::ordered_json one_end = row(v);
  one_end["interval"] = nlohmann::ordered_json::array({1});
  EXPECT_THROW(from_json_line(one_end.dump(), "journal"), core::InputError);
  EXPECT_NE(to_csv({v}).find("0.25; 1.0000000000000001e+300"), std::string::npos) << to_csv({v});
}

TEST(Json, NonFiniteIsNullWithTheFirstBadStep) {
  Verdict v;
  v.first_bad_step = 17;
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    v.measured = bad;
    const auto json = nlohmann::json::parse(to_json_line(v));
    EXPECT_TRUE(json["measured"].is_null());
    EXPECT_EQ(json["first_bad_step"], 17);
    EXPECT_TRUE(std::isnan(from_json_line(to_json_line(v), "journal").measured));
  }
}

TEST(Json, InvalidUtf8BecomesReplacementCharacters) {
  Verdict v;
  v.complaints =
      "a\xff\xc0\xaf"
      "b";
  const std::string back = from_json_line(to_json_line(v), "journal").complaints;
  EXPECT_EQ(back.substr(0, 1), "a");
  EXPECT_NE(back.find("\xEF\xBF\xBD"), std::string::npos);
  EXPECT_EQ(back.back(), 'b');
}

std::string refusal(const std::string& document) {
  try {
    read_json(document, "report.json");
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Json, MalformedDocumentsAreRefusedWithThePlace) {
  EXPECT_EQ(refusal("{\"schema\": 1,\n  oops}"), "report.json:2:3: not JSON at byte 17");
  EXPECT_NE(refusal("").find("report.json:1:1"), std::string::npos);
  EXPECT_NE(refusal("[]").find("not a report"), std::string::npos);
  EXPECT_NE(refusal("{\"schema\":2,\"verdicts\":[]}").find("schema 2"), std::string::npos);
  EXPECT_NE(refusal("{\"schema\":1,\"verdicts\":3}").find("array"), std::string::npos);
  EXPECT_NE(refusal("{\"schema\":1,\"verdicts\":[4]}").find("verdict 1"), std::string::npos);
  EXPECT_NE(refusal("{\"schema\":1e999,\"verdicts\":[]}"), "accepted");

  // One member at a time made wrong or taken away: each must be missed, by name.
  const auto good = nlohmann::json::parse(to_json_line(results::Verdict{}));
  for (const auto& [key, value] : good.items()) {
    nlohmann::json without = good, wrong = good;
    without.erase(key);
    wrong[key] = value.is_number() || value.is_null() ? nlohmann::json("x") : nlohmann::json(1);
    for (const auto& bad : {without, wrong}) {
      // reports of 0.3 and before lack them
      if ((key == "cpu_verified" || key == "substeps") && bad == without) continue;
      const auto document = nlohmann::json{{"schema", 1}, {"verdicts", nlohmann::json::array({good, bad})}};
      const std::string why = refusal(document.dump());
      EXPECT_NE(why.find("verdict 2: \"" + key + "\""), std::string::npos) << key << ": " << why;
    }
  }
}

TEST(Json, MalformedDiagnosticsAreRefusedWithThePlace) {
  Verdict verdict;
  verdict.diagnostics.emplace_back().kind = "tolerance-missed";
  const auto good = nlohmann::json::parse(to_json_line(verdict));
  const auto refused = [&](const nlohmann::json& diagnostic) {
    nlohmann::json row = good;
    row["diagnostics"][0] = diagnostic;
    return refusal(nlohmann::json{{"schema", 1}, {"verdicts", nlohmann::json::array({row})}}.dump());
  };
  const nlohmann::json one = good["diagnostics"][0];
  EXPECT_EQ(refused(one), "accepted");
  EXPECT_NE(refused(3).find("verdict 1: diagnostic 1"), std::string::npos);
  for (const auto& [key, value] : one.items()) {
    nlohmann::json without = one, wrong = one;
    without.erase(key);
    wrong[key] = value.is_number() || value.is_null() ? nlohmann::json("x") : nlohmann::json(1);
    for (const auto& bad : {without, wrong})
      EXPECT_NE(refused(bad).find("diagnostic 1: \"" + key + "\""), std::string::npos) << key << refused(bad);
  }
  const std::pair<const char*, nlohmann::json> out_of_range[] = {
      {"count", 0}, {"order", -1}, {"order", 4000000000}, {"body_count", -1}, {"bodies", {"a", 3}}};
  for (const auto& [key, value] : out_of_range) {
    nlohmann::json bad = one;
    bad[key] = value;
    EXPECT_NE(refused(bad).find(std::string("\"") + key), std::string::npos) << key << refused(bad);
  }
}

// ---- CSV ----------------------------------------------------------------------------------------

// RFC 4180 by its grammar: fields, quoted or not, CRLF.
std::vector<std::vector<std::string>> parse_csv(const std::string& text) {
  std::vector<std::vector<std::string>> lines(1, {""});
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string& field = lines.back().back();
    if (quoted) {
      if (text[i] != '"')
        field += text[i];
      else if (i + 1 < text.size() && text[i + 1] == '"')
        field += text[++i];
      else
        quoted = false;
    } else if (text[i] == '"') {
      EXPECT_TRUE(field.empty());
      quoted = true;
    } else if (text[i] == ',') {
      lines.back().push_back("");
    } else if (text[i] == '\r') {
      EXPECT_EQ(text.at(++i), '\n');
      lines.push_back({""});
    } else {
      EXPECT_NE(text[i], '\n');
      field += text[i];
    }
  }
  lines.pop_back();
  return lines;
}

std::size_t column(const std::vector<std::string>& header, const std::string& name) {
  return static_cast<std::size_t>(std::find(header.begin(), header.end(), name) - header.begin());
}

TEST(Csv, ParsesBackWithEveryDigit) {
  std::mt19937 random(5);
  std::vector<Verdict> verdicts;
  for (int i = 0; i < 100; ++i) verdicts.push_back(random_verdict(random));
  const auto lines = parse_csv(to_csv(verdicts));
  ASSERT_EQ(lines.size(), 101u);
  for (std::size_t i = 0; i < 100; ++i) {
    ASSERT_EQ(lines[i + 1].size(), lines[0].size());
    EXPECT_EQ(std::strtod(lines[i + 1][column(lines[0], "measured")].c_str(), nullptr), verdicts[i].measured);
    EXPECT_EQ(lines[i + 1][column(lines[0], "status")], results::name(verdicts[i].status));
  }
}

TEST(Csv, KeepsCommasQuotesAndLineEnds) {
  Verdict v;
  v.detail = "a \"b\", c\r\nd\ne";
  v.settings = {{"erp", "0.2"}, {"gyro", "implicit"}};
  for (const char* kind : {"stiff", "more"}) v.diagnostics.emplace_back().kind = kind;
  const auto lines = parse_csv(to_csv({v}));
  EXPECT_EQ(lines[1][column(lines[0], "detail")], v.detail);
  EXPECT_EQ(lines[1][column(lines[0], "settings")], "erp=0.2; gyro=implicit");
  EXPECT_EQ(lines[1][column(lines[0], "diagnostics")], "stiff; more");
  EXPECT_EQ(lines[1][column(lines[0], "measured")], "");
}

TEST(Csv, LeavesAllowedBlankWhereNothingWasMeasured) {
  using enum results::Status;
  for (const auto& [status, allowed] : {std::pair{pass, "0.25"},
                                        {undecided, "0.25"},
                                        {non_finite, "0.25"},
                                        {unsupported, ""},
                                        {crash, ""},
                                        {timeout, ""},
                                        {protocol, ""}}) {
    Verdict v;
    v.status = status, v.allowed = 0.25;
    const auto lines = parse_csv(to_csv({v}));
    EXPECT_EQ(lines[1][column(lines[0], "allowed")], allowed) << results::name(status);
  }
}

TEST(Csv, EscapesFormulasAndControlCharacters) {
  for (const std::string start : {"=cmd|' /C calc'!A0", "+1", "-1+1", "@SUM(A1)", "\t=1", "\r=1", "＝1"}) {
    Verdict v;
    v.detail = start;
    const auto lines = parse_csv(to_csv({v}));
    EXPECT_EQ(lines[1][column(lines[0], "detail")], "'" + start);
  }
  Verdict v;
  v.complaints = std::string("\x1b[2J\xff") + '\0' + "\u202e" + "end";
  const auto lines = parse_csv(to_csv({v}));
  EXPECT_EQ(lines[1][column(lines[0], "stderr")], "\\x1b[2J\\xff\\x00\\u{202e}end");
  v = {};
  v.measured = -2.5;  // a number is no formula
  EXPECT_EQ(parse_csv(to_csv({v}))[1][column(lines[0], "measured")], "-2.5");
  EXPECT_EQ(parse_csv(to_csv({})).size(), 1u);
}

}  // namespace
}  // namespace cylon::reports
