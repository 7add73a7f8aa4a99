#include "reports/gzip.h"

#include "harness/core/input_error.h"

#include <zlib.h>

#include <array>
#include <cstdint>
#include <stdexcept>

namespace cylon::reports {
namespace {

constexpr int gzip_window = 15 + 16;  // zlib: 32 KiB, with a gzip header
constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

// zlib reads through a pointer to mutable bytes and does not write there.
Bytef* bytes_of(std::string_view text) {
  return reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));  // NOLINT
}

}  // namespace

std::string gzip(std::string_view bytes) {
  z_stream stream{};
  constexpr int memory = 9;
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, gzip_window, memory, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("zlib cannot start");
  stream.next_in = bytes_of(bytes), stream.avail_in = static_cast<uInt>(bytes.size());
  std::string out;
  int result = Z_OK;
  while (result == Z_OK) {
    std::array<char, 1 << 15> piece;
    stream.next_out = reinterpret_cast<Bytef*>(piece.data()), stream.avail_out = piece.size();
    result = deflate(&stream, Z_FINISH);
    out.append(piece.data(), piece.size() - stream.avail_out);
  }
  deflateEnd(&stream);
  if (result != Z_STREAM_END) throw std::runtime_error("zlib does not end");
  return out;
}

std::string gunzip(std::string_view packed, std::size_t most) {
  z_stream stream{};
  if (inflateInit2(&stream, gzip_window) != Z_OK) throw std::runtime_error("zlib cannot start");
  stream.next_in = bytes_of(packed), stream.avail_in = static_cast<uInt>(packed.size());
  std::string out;
  int result = Z_OK;
  while (result == Z_OK && out.size() <= most) {
    std::array<char, 1 << 15> piece;
    stream.next_out = reinterpret_cast<Bytef*>(piece.data()), stream.avail_out = piece.size();
    result = inflate(&stream, Z_NO_FLUSH);
    out.append(piece.data(), piece.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (out.size() > most) throw core::InputError("the compressed data is too large");
  if (result != Z_STREAM_END) throw core::InputError("the compressed data is damaged");
  return out;
}

std::string base64(std::string_view bytes) {
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = (group << 8) | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      out += i + k <= bytes.size() ? alphabet[(group >> (18 - 6 * k)) & 63] : '=';
  }
  return out;
}

std::string from_base64(std::string_view text) {
  std::string out;
  if (text.size() % 4 != 0) throw core::InputError("base64: the length is no multiple of 4");
  for (std::size_t i = 0; i < text.size(); i += 4) {
    std::uint32_t group = 0;
    std::size_t padding = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const char c = text[i + k];
      const std::size_t value = alphabet.find(c);
      const bool pad = c == '=' && i + 4 == text.size() && k >= 2;
      if ((value == std::string_view::npos && !pad) || (padding > 0 && !pad))
        throw core::InputError("base64: an invalid character");
      padding += pad;
      group = (group << 6) | static_cast<std::uint32_t>(pad ? 0 : value);
    }
    for (std::size_t k = 0; k < 3 - padding; ++k) out += static_cast<char>((group >> (16 - 8 * k)) & 255);
  }
  return out;
}

}  // namespace cylon::reports
