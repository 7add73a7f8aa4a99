// Who may ask what of the viewer's server: told by the head of a request alone.
#pragma once

#include "harness/view/http.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace cylon::view {

inline constexpr const char* loopback = "127.0.0.1";

http::Answer json_answer(int status, const nlohmann::json& body);
/// {"error": why}
http::Answer refusal(int status, const std::string& why);

/// The answer to who may not ask, or asks for what is not there or too large; nothing where the request is to
/// be served.  Server says the rules.
std::optional<http::Answer> refusal_of(const http::Head&, int port, std::string_view token);

}  // namespace cylon::view
