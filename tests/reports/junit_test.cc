// JUnit XML: well formed whatever is in the texts, and bad exactly where a verdict is not as expected.
#include "reports/junit.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace cylon::reports {
namespace {

using results::Status;
using results::Verdict;

// As much of XML 1.0 as these reports use, checked strictly: balanced tags, quoted unique attributes, known
// references, legal characters in valid UTF-8.  The elements come back as "<name>text" for each leaf.
class Checker {
 public:
  explicit Checker(const std::string& text) : text_(text) {}

  bool well_formed() {
    if (!legal_characters()) return false;
    const std::string prolog = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    if (text_.compare(0, prolog.size(), prolog) != 0) return false;
    at_ = prolog.size();
    return element() && text_.substr(at_) == "\n";
  }

  std::map<std::string, int> count;
  std::vector<std::map<std::string, std::string>> attributes;
  std::string characters;

 private:
  bool legal_characters() const {
    for (std::size_t i = 0; i < text_.size();) {
      const auto lead = static_cast<unsigned char>(text_[i]);
      const std::size_t length = lead < 0x80 ? 1 : lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC2 ? 2 : 0;
      if (length == 0 || i + length > text_.size()) return false;
      if (length == 1 && lead < 0x20 && lead != '\n' && lead != '\t' && lead != '\r') return false;
      for (std::size_t k = 1; k < length; ++k)
        if ((static_cast<unsigned char>(text_[i + k]) & 0xC0) != 0x80) return false;
      if (text_.compare(i, 3, "\xEF\xBF\xBE") == 0 || text_.compare(i, 3, "\xEF\xBF\xBF") == 0) return false;
      i += length;
    }
    return true;
  }

  bool take(const std::string& token) {
    if (text_.compare(at_, token.size(), token) != 0) return false;
    at_ += token.size();
    return true;
  }

  std::string word() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (std::isalpha(static_cast<unsigned char>(text_[at_])) || text_[at_] == '-'))
      ++at_;
    return text_.substr(begin, at_ - begin);
  }

  // Characters up to `stop`, references resolved.
  bool data(char stop, std::string& out) {
    static const std::vector<std::pair<std::string, char>> references = {
        {"&amp;", '&'}, {"&lt;", '<'},   {"&gt;", '>'},  {"&quot;", '"'},
        {"&#9;", '\t'}, {"&#10;", '\n'}, {"&#13;", '\r'}};
    while (at_ < text_.size() && text_[at_] != stop) {
      if (text_[at_] == '<' || text_[at_] == '>') return false;
      if (text_[at_] != '&') {
        out += text_[at_++];
        continue;
      }
      bool known = false;
      for (const auto& [reference, meaning] : references)
        if (!known && take(reference)) out += meaning, known = true;
      if (!known) return false;
    }
    return at_ < text_.size();
  }

  bool element() {
    if (!take("<")) return false;
    const std::string name = word();
    ++count[name];
    std::map<std::string, std::string> found;
    while (take(" ")) {
      const std::string key = word();
      std::string value;
      if (key.empty() || found.count(key) || !take("=\"") || !data('"', value) || !take("\"")) return false;
      found[key] = value;
    }
    found[""] = name;
    attributes.push_back(found);
    if (!take(">")) return false;
    for (;;) {
      if (!data('<', characters)) return false;
      if (take("</")) return take(name + ">");
      if (!element()) return false;
    }
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

Verdict make(Status status, Status expected) {
  Verdict v;
  v.scenario = "heavy_top";
  v.engine = "bullet";
  v.claim = "axis follows heavy_top";
  v.dt_text = "1/60";
  v.measured = 2.5;
  v.allowed = 1e-3;
  v.unit = "rad";
  v.detail = "signal 11";
  v.status = status;
  v.expected = expected;
  v.reproduce = "cylon run heavy_top/bullet --dt 1/60";
  return v;
}

const std::vector<Status> every_status = {Status::pass,      Status::low_quality, Status::fail,
                                          Status::undecided, Status::unsupported, Status::crash,
                                          Status::timeout,   Status::non_finite,  Status::protocol};

TEST(Junit, FailsExactlyWhereVerdictDiffers) {
  for (const Status status : every_status) {
    for (const Status expected : every_status) {
      const Verdict v = make(status, expected);
      const std::string text = to_junit({v});
      Checker xml(text);
      ASSERT_TRUE(xml.well_formed()) << text;
      EXPECT_EQ(xml.count["failure"] + xml.count["error"], v.as_expected() ? 0 : 1) << text;
      const bool broken = status == Status::crash || status == Status::timeout || status == Status::protocol;
      EXPECT_EQ(xml.count["error"], !v.as_expected() && broken) << text;
      EXPECT_EQ(xml.count["skipped"], v.as_expected() && status == Status::unsupported) << text;
      const bool note = v.as_expected() && status != Status::pass && status != Status::unsupported;
      EXPECT_EQ(xml.count["system-out"], note) << text;
      EXPECT_EQ(xml.attributes[0]["failures"], std::to_string(xml.count["failure"]));
      EXPECT_EQ(xml.attributes[0]["errors"], std::to_string(xml.count["error"]));
    }
  }
}

TEST(Junit, ReasonIsTextOfElement) {
  const std::string text = to_junit({make(Status::fail, Status::pass)});
  Checker xml(text);
  ASSERT_TRUE(xml.well_formed());
  EXPECT_NE(xml.characters.find("fail (expected pass): measured 2.5 rad, allowed 0.001 rad, -3.4 digits"),
            std::string::npos)
      << text;
  EXPECT_NE(xml.characters.find("cylon run heavy_top/bullet --dt 1/60"), std::string::npos);
}

TEST(Junit, OneSuitePerScenarioEvenWhenRowsInterleave) {
  Verdict a = make(Status::pass, Status::pass), b = a;
  b.scenario = "projectile";
  const std::string text = to_junit({a, b, a});
  Checker xml(text);
  ASSERT_TRUE(xml.well_formed());
  EXPECT_EQ(xml.count["testsuite"], 2);
  EXPECT_EQ(xml.count["testcase"], 3);
  EXPECT_EQ(xml.attributes[1]["name"], "heavy_top");
  EXPECT_EQ(xml.attributes[1]["tests"], "2");
}

// Each claim of a run had the time of the whole: sums were several times what was spent.
TEST(Junit, ClaimsOfARunShareItsTime) {
  std::vector<Verdict> rows(5, make(Status::pass, Status::pass));
  for (Verdict& v : rows) v.cpu_seconds = 0.5;
  rows[2].dt_text = "1/240";        // another run
  rows[3].dt_text = "1/240";        // its second claim
  rows[4].scenario = "projectile";  // a third run, in another suite
  const std::string text = to_junit(rows);
  Checker xml(text);
  ASSERT_TRUE(xml.well_formed()) << text;
  std::map<std::string, std::vector<std::string>> times;
  for (auto& attributes : xml.attributes) times[attributes[""]].push_back(attributes["time"]);
  const std::string half = "0.500000", nothing = "0.000000";
  EXPECT_EQ(times["testcase"], (std::vector<std::string>{half, nothing, half, nothing, half}));
  EXPECT_EQ(times["testsuite"], (std::vector<std::string>{"1.000000", half}));
  EXPECT_EQ(times["testsuites"], std::vector<std::string>{"1.500000"});
}

TEST(Junit, EscapesHostileTexts) {
  const std::vector<std::string> hostile = {"</testcase><script>alert(1)</script>",
                                            "]]>",
                                            "\"' onload=\"x",
                                            "&undefined; &#0;",
                                            "\x1b[2J\x07",
                                            std::string("nul \0 nul", 9),
                                            "\xff\xfe \xc0\xaf \xed\xa0\x80 \xf4\x90\x80\x80",
                                            "\uFFFE\uFFFF",
                                            "\u202e\u200b",
                                            "\xe2\x82",
                                            "line\nline\ttab\rreturn",
                                            std::string(1 << 18, '<')};
  for (const std::string& text : hostile) {
    Verdict v = make(Status::fail, Status::pass);
    for (std::string* field : {&v.scenario, &v.engine, &v.claim, &v.dt_text, &v.detail, &v.complaints,
                               &v.reproduce, &v.expected_reason, &v.unit, &v.integrator})
      *field = text;
    const std::string report = to_junit({v});
    Checker xml(report);
    ASSERT_TRUE(xml.well_formed()) << text.substr(0, 40);
    EXPECT_EQ(xml.count["testcase"], 1);
    EXPECT_EQ(xml.count["script"], 0);
    EXPECT_EQ(report.find('\x1b'), std::string::npos);
  }
}

TEST(Junit, NoVerdictsGiveValidDocument) {
  const std::string text = to_junit({});
  Checker xml(text);
  EXPECT_TRUE(xml.well_formed());
  EXPECT_EQ(xml.attributes[0]["tests"], "0");
}

}  // namespace
}  // namespace cylon::reports
