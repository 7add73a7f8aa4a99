// The bytes of a trace, read back by what docs and page say of them.
#include "reports/trace_block.h"

#include "harness/core/input_error.h"
#include "reports/gzip.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstring>
#include <random>

namespace cylon::reports {
namespace {

using nlohmann::json;

struct Block {
  explicit Block(const std::string& bytes) : bytes_(bytes) {
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data(), 4);
    header = json::parse(bytes.substr(4, length));
    start_ = (std::size_t{length} + 7) / 4 * 4;
  }

  std::vector<double> floats(const json& where) const {
    std::vector<double> values(where["count"].get<std::size_t>());
    for (std::size_t i = 0; i < values.size(); ++i) {
      float value = 0;
      std::memcpy(&value, bytes_.data() + start_ + std::size_t(where["offset"]) + 4 * i, 4);
      values[i] = value;
    }
    return values;
  }

  double steps(const json& where, std::size_t frame, std::size_t channel) const {
    std::size_t at = start_ + std::size_t(where["offset"]);
    std::int64_t k = 0;
    for (std::size_t c = 0; c <= channel; ++c) {
      k = 0;
      for (std::size_t f = 0; f < std::size_t(where["frames"]); ++f) {
        std::uint64_t zigzag = 0;
        for (int shift = 0;; shift += 7) {
          const auto byte = static_cast<unsigned char>(bytes_[at++]);
          zigzag |= std::uint64_t(byte & 127) << shift;
          if (byte < 128) break;
        }
        k += static_cast<std::int64_t>(zigzag >> 1) ^ -static_cast<std::int64_t>(zigzag & 1);
        if (c == channel && f == frame)
          return k == 0 ? NAN : double(where["min"][c]) + double(where["step"][c]) * double(k - 1);
      }
    }
    return NAN;
  }

  json header;

 private:
  const std::string& bytes_;
  std::size_t start_;
};

reports::Trace sample() {
  reports::Trace trace;
  trace.scenario = "two", trace.engine = "in-house", trace.integrator = "rk4", trace.dt_text = "1/60";
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int frame = 0; frame < 40; ++frame) {
    core::State state(2);
    for (core::BodyState& body : state) {
      body.position = {3 * normal(random), 1e4 + normal(random), -2};
      body.orientation =
          core::Quaternion(normal(random), normal(random), normal(random), normal(random)).normalized();
    }
    trace.motion.time.push_back(0.25 * frame);
    trace.motion.states.push_back(state);
  }
  trace.motion.states[17][1].position.x() = NAN;
  trace.motion.states[18][0].position.y() = INFINITY;
  trace.errors.push_back(
      {"position follows </script>", "m", 0.5, {0, 1, 2}, {1e-17, NAN, 3e30}, {{1, 60, NAN}}});
  trace.totals.push_back({"energy", "J", "", {0, 2}, {-1.5, 2.25}});
  trace.events.push_back({1.5, "bounce", "1, \x1b[31m\xff and floor"});
  return trace;
}

TEST(TraceBlock, FramesComeBackWithinTheirStep) {
  const reports::Trace trace = sample();
  const std::string bytes = trace_block(trace);
  const Block block(bytes);
  const json& motion = block.header["motion"];
  EXPECT_EQ(block.header["bodies"], 2);
  EXPECT_EQ(block.floats(motion["time"]), trace.motion.time);
  double range[3] = {};
  for (std::size_t f = 0; f < 40; ++f)
    for (std::size_t b = 0; b < 2; ++b) {
      core::Quaternion q;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double want = trace.motion.states[f][b].position[static_cast<Eigen::Index>(axis)];
        const double got = block.steps(motion["position"], f, 3 * b + axis);
        const double step = motion["position"]["step"][3 * b + axis];
        range[axis] = std::max(range[axis], step * 262144);
        if (std::isfinite(want))
          EXPECT_NEAR(got, want, step / 2 + 1e-12 * std::abs(want)) << f << ' ' << b << ' ' << axis;
        else
          EXPECT_TRUE(std::isnan(got));
      }
      q.w() = block.steps(motion["orientation"], f, 4 * b);
      for (std::size_t axis = 0; axis < 3; ++axis)
        q.coeffs()[static_cast<Eigen::Index>(axis)] = block.steps(motion["orientation"], f, 4 * b + 1 + axis);
      // Either sign is the same turn; half a step in four components.
      EXPECT_NEAR(std::abs(q.dot(trace.motion.states[f][b].orientation)), 1, 2.0 / 32768);
    }
  EXPECT_LT(range[1], 10) << "the range of a channel, not the distance from the origin, sets its step";
}

TEST(TraceBlock, CurvesKeepRelativePrecisionAndNaN) {
  const std::string bytes = trace_block(sample());
  const Block block(bytes);
  const json& curve = block.header["errors"][0];
  const std::vector<double> values = block.floats(curve["value"]);
  EXPECT_NEAR(values[0], 1e-17, 1e-24);
  EXPECT_TRUE(std::isnan(values[1]));
  EXPECT_NEAR(values[2], 3e30, 1e24);
  EXPECT_EQ(curve["first_violation"]["step"], 60);
  EXPECT_TRUE(curve["first_violation"]["value"].is_null());
  EXPECT_EQ(curve["claim"], "position follows </script>");
}

TEST(TraceBlock, TheSameTraceGivesTheSameBytes) {
  EXPECT_EQ(pack(sample()).block, pack(sample()).block);
  EXPECT_EQ(gunzip(from_base64(pack(sample()).block), 1 << 20), trace_block(sample()));
}

TEST(TraceBlock, AMotionWithoutFramesIsEmpty) {
  const std::string bytes = trace_block(reports::Trace());
  const Block block(bytes);
  EXPECT_EQ(block.header["bodies"], 0);
  EXPECT_EQ(block.header["motion"]["position"]["frames"], 0);
}

TEST(TraceBlock, LinesComeBack) {
  const PackedTrace packed = pack(sample());
  const std::string line = to_json_line(packed);
  EXPECT_EQ(line.find('\n'), line.size() - 1);
  const PackedTrace back = trace_from_json_line(line, "x:1");
  EXPECT_EQ(back.block, packed.block);
  EXPECT_EQ(back.dt_text, "1/60");
}

TEST(TraceBlock, RejectsMalformedLines) {
  for (
      const char* line :
      {"", "{}", "[]", "{\"format\":\"cylon-trace/2\"}",
       R"({"format":"cylon-trace/1","scenario":"a","engine":"b","integrator":"c","dt_text":"1","block":"</script>"})",
       R"({"format":"cylon-trace/1","scenario":"a","engine":"b","integrator":"c","dt_text":"1","block":7})"})
    try {
      trace_from_json_line(line, "traces.jsonl:3");
      ADD_FAILURE() << line;
    } catch (const core::InputError& error) {
      EXPECT_EQ(std::string(error.what()).find("traces.jsonl:3: "), 0u) << error.what();
    }
}

// RFC 4648, section 10.
TEST(Base64, TestVectors) {
  const std::pair<const char*, const char*> cases[] = {{"", ""},
                                                       {"f", "Zg=="},
                                                       {"fo", "Zm8="},
                                                       {"foo", "Zm9v"},
                                                       {"foob", "Zm9vYg=="},
                                                       {"fooba", "Zm9vYmE="},
                                                       {"foobar", "Zm9vYmFy"}};
  for (const auto& [plain, coded] : cases) {
    EXPECT_EQ(base64(plain), coded);
    EXPECT_EQ(from_base64(coded), plain);
  }
  for (const char* bad : {"Z", "Zg=", "Z===", "Zg=a", "Zm9v\n", "Zg==Zg==", "<br>"})
    EXPECT_THROW(from_base64(bad), core::InputError) << bad;
}

TEST(Gzip, RoundTrips) {
  std::string bytes;
  std::mt19937 random(3);
  for (int i = 0; i < 100000; ++i) bytes += static_cast<char>(random() % (static_cast<unsigned>(i) % 7 + 1));
  EXPECT_EQ(gunzip(gzip(bytes), bytes.size()), bytes);
  EXPECT_EQ(gunzip(gzip(""), 0), "");
  EXPECT_THROW(gunzip(gzip(bytes), bytes.size() - 1), core::InputError) << "a bomb is refused";
  EXPECT_THROW(gunzip(gzip(bytes).substr(0, 500), bytes.size()), core::InputError);
  EXPECT_THROW(gunzip("no gzip", 100), core::InputError);
}

}  // namespace
}  // namespace cylon::reports
