// A trace in the bytes that a page reads: small, and unpacked only when somebody looks at it.
#pragma once

#include "reports/trace.h"

#include <string>
#include <string_view>
#include <vector>

namespace cylon::reports {

/// u32 little-endian length of the header; the header, JSON as `Trace` of
/// reports/web/src/shared/documents.ts; zeros up to a multiple of 4; the arrays, at offsets that count from
/// there.  Times and curves are float32. Positions are whole multiples of range / 2^18 of their axis,
/// orientations of 2^-15, their differences from frame to frame in LEB128 bytes; what is not finite is the
/// lowest of all, which the page takes for NaN.
std::string trace_block(const reports::Trace&);

/// A trace ready for a page, and whose it is.
struct PackedTrace {
  std::string scenario, engine, integrator, dt_text;
  std::string block;  ///< base64(gzip(trace_block))
};
PackedTrace pack(const reports::Trace&);

/// {"format":"cylon-trace/1", …} on a line, with its end; and back.  Throws core::InputError, with `place`.
std::string to_json_line(const PackedTrace&);
PackedTrace trace_from_json_line(std::string_view line, const std::string& place);

}  // namespace cylon::reports
