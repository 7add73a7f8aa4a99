// Bytes small enough for a page, and back: gzip and base64.
#pragma once

#include <string>
#include <string_view>

namespace cylon::reports {

/// RFC 1952, without time or name: the same bytes give the same bytes.
std::string gzip(std::string_view bytes);

/// The bytes of a gzip file.  Throws core::InputError for what is none, or unpacks to more than `most`.
std::string gunzip(std::string_view packed, std::size_t most);

/// RFC 4648, section 4, padded.
std::string base64(std::string_view bytes);

/// Throws core::InputError for what is no such text.
std::string from_base64(std::string_view text);

}  // namespace cylon::reports
