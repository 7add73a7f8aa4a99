// What is read without TOML: the bytes of a file, and a step as it is written.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace cylon::scenario {

/// Files larger than this are refused [bytes].
inline constexpr std::uintmax_t largest_input = 16u << 20;

/// The bytes of a regular file of at most `largest_input`; throws core::InputError for anything else.
std::string read_file(const std::filesystem::path&);

/// Seconds of "1/60", "0.001" or "1e-3": > 0 and finite; throws core::InputError, which names the option that
/// the word belongs to, where one is given.
double parse_step(std::string_view, std::string_view option = "");

}  // namespace cylon::scenario
