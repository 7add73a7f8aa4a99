#include "reports/trace_block.h"

#include "harness/core/input_error.h"
#include "harness/input/json.h"
#include "reports/gzip.h"
#include "reports/json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>

namespace cylon::reports {
namespace {

using Json = nlohmann::ordered_json;

constexpr double position_steps = 262144, orientation_step = 1.0 / 32768;
constexpr const char* trace_format = "cylon-trace/1";

void append_u32(std::string& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>((value >> shift) & 255);
}

// The arrays behind the header.
class Arrays {
 public:
  Json floats(const std::vector<double>& values) {
    align();
    const Json where = {{"offset", bytes_.size()}, {"count", values.size()}};
    for (const double value : values) {
      const auto rounded = static_cast<float>(value);
      std::uint32_t bits = 0;
      std::memcpy(&bits, &rounded, sizeof bits);
      append_u32(bytes_, bits);
    }
    return where;
  }

  /// value(frame, channel); step: of a channel's values, or 0 for range / position_steps.
  Json steps(std::size_t frames, std::size_t channels, double fixed_step,
             const std::function<double(std::size_t, std::size_t)>& value) {
    const std::size_t begin = bytes_.size();
    Json minima = Json::array(), steps = Json::array();
    for (std::size_t c = 0; c < channels; ++c) {
      double least = std::numeric_limits<double>::infinity(), most = -least;
      for (std::size_t f = 0; f < frames; ++f)
        if (const double x = value(f, c); std::isfinite(x))
          least = std::min(least, x), most = std::max(most, x);
      if (least > most) least = most = 0;
      // A range beyond the largest double would make the step infinite.
      const double step = fixed_step > 0 ? fixed_step : (most / position_steps - least / position_steps);
      minima.push_back(least), steps.push_back(step);
      std::int64_t last = 0;
      for (std::size_t f = 0; f < frames; ++f) {
        const double x = value(f, c);
        // 0 stands for what is not finite, k + 1 for least + step k.
        std::int64_t k = 0;
        if (std::isfinite(x)) k = 1 + (step > 0 ? std::llround(x / step - least / step) : 0);
        append_difference(k - last);
        last = k;
      }
    }
    return {{"offset", begin},
            {"bytes", bytes_.size() - begin},
            {"frames", frames},
            {"min", minima},
            {"step", steps}};
  }

  const std::string& bytes() const { return bytes_; }

 private:
  void align() { bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0'); }

  // Zigzag, so that small differences of either sign are small numbers; then 7 bits a byte, the lowest first.
  void append_difference(std::int64_t d) {
    auto zigzag = static_cast<std::uint64_t>((d << 1) ^ (d >> 63));
    for (; zigzag > 127; zigzag >>= 7) bytes_ += static_cast<char>((zigzag & 127) | 128);
    bytes_ += static_cast<char>(zigzag);
  }

  std::string bytes_;
};

Json motion_json(const core::Trajectory& motion, Arrays& arrays) {
  const std::size_t frames = motion.states.size();
  const std::size_t bodies = frames > 0 ? motion.states.front().size() : 0;
  const auto position = [&](std::size_t f, std::size_t c) {
    return motion.states[f][c / 3].position[static_cast<Eigen::Index>(c % 3)];
  };
  // A quaternion and its negative are one orientation: the sign nearest to the frame before packs best.
  std::vector<core::Quaternion> turns(frames * bodies);
  for (std::size_t b = 0; b < bodies; ++b)
    for (std::size_t f = 0; f < frames; ++f) {
      core::Quaternion q = motion.states[f][b].orientation;
      if (f > 0 && q.dot(turns[(f - 1) * bodies + b]) < 0) q.coeffs() = -q.coeffs();
      turns[f * bodies + b] = q;
    }
  const auto orientation = [&](std::size_t f, std::size_t c) {
    const core::Quaternion& q = turns[f * bodies + c / 4];
    return c % 4 == 0 ? q.w() : q.coeffs()[static_cast<Eigen::Index>(c % 4 - 1)];  // coeffs: x, y, z, w
  };
  Json time = arrays.floats(motion.time);
  Json positions = arrays.steps(frames, 3 * bodies, 0, position);
  return {{"time", std::move(time)},
          {"position", std::move(positions)},
          {"orientation", arrays.steps(frames, 4 * bodies, orientation_step, orientation)}};
}

Json errors_json(const std::vector<reports::ErrorCurve>& curves, Arrays& arrays) {
  Json list = Json::array();
  for (const reports::ErrorCurve& curve : curves) {
    Json first = nullptr;
    if (curve.first_violation)
      first = {{"time", curve.first_violation->time},
               {"step", curve.first_violation->step},
               {"value", number(curve.first_violation->value)}};
    Json time = arrays.floats(curve.time);
    list.push_back({{"claim", curve.claim},
                    {"unit", curve.unit},
                    {"allowed", number(curve.allowed)},
                    {"time", std::move(time)},
                    {"value", arrays.floats(curve.value)},
                    {"first_violation", first}});
  }
  return list;
}

Json totals_json(const std::vector<reports::TotalCurve>& curves, Arrays& arrays) {
  Json list = Json::array();
  for (const reports::TotalCurve& curve : curves) {
    Json time = arrays.floats(curve.time);
    list.push_back({{"name", curve.name},
                    {"unit", curve.unit},
                    {"component", curve.component},
                    {"time", std::move(time)},
                    {"value", arrays.floats(curve.value)}});
  }
  return list;
}

Json events_json(const std::vector<reports::TraceEvent>& events) {
  Json list = Json::array();
  for (const reports::TraceEvent& event : events)
    list.push_back({{"time", number(event.time)}, {"kind", event.kind}, {"what", event.what}});
  return list;
}

}  // namespace

std::string trace_block(const reports::Trace& trace) {
  Arrays arrays;
  Json ghost = nullptr;
  if (trace.ghost) {
    ghost = motion_json(trace.ghost->motion, arrays);
    ghost["follows"] = trace.ghost->follows;
    ghost["source"] = trace.ghost->source;
  }
  Json header = {{"bodies", trace.motion.states.empty() ? 0 : trace.motion.states.front().size()},
                 {"motion", motion_json(trace.motion, arrays)},
                 {"ghost", std::move(ghost)},
                 {"errors", errors_json(trace.errors, arrays)},
                 {"totals", totals_json(trace.totals, arrays)},
                 {"events", events_json(trace.events)},
                 {"remarks", trace.remarks}};
  const std::string text = header.dump(-1, ' ', /*ensure_ascii=*/true, Json::error_handler_t::replace);
  std::string block;
  append_u32(block, static_cast<std::uint32_t>(text.size()));
  block += text;
  block.resize((block.size() + 3) / 4 * 4, '\0');
  return block + arrays.bytes();
}

PackedTrace pack(const reports::Trace& trace) {
  return {trace.scenario, trace.engine, trace.integrator, trace.dt_text, base64(gzip(trace_block(trace)))};
}

std::string to_json_line(const PackedTrace& trace) {
  const Json row = {{"format", trace_format},         {"scenario", trace.scenario}, {"engine", trace.engine},
                    {"integrator", trace.integrator}, {"dt_text", trace.dt_text},   {"block", trace.block}};
  return row.dump(-1, ' ', /*ensure_ascii=*/true, Json::error_handler_t::replace) + '\n';
}

PackedTrace trace_from_json_line(std::string_view line, const std::string& place) try {
  const Json row = input::parse_json<Json>(line);
  if (row.at("format") != trace_format)
    throw core::InputError(fmt::format("\"format\" must be \"{}\"", trace_format));
  PackedTrace trace{row.at("scenario"), row.at("engine"), row.at("integrator"), row.at("dt_text"),
                    row.at("block")};
  from_base64(trace.block);  // it goes into a page as it is
  return trace;
} catch (const std::exception& error) {
  throw core::InputError(fmt::format("{}: no trace: {}", place, error.what()));
}

}  // namespace cylon::reports
