#include "harness/view/http_head.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <utility>

namespace cylon::view::http {
namespace {

namespace beast = boost::beast;

constexpr std::uint32_t longest_head = 16 << 10;  // [bytes]
constexpr std::size_t most_headers = 100;

}  // namespace

Answer plain(int status, std::string why) { return {status, "text/plain", std::move(why), {}}; }

std::string Head::header(const std::string& lower_name) const {
  const auto found = headers.find(lower_name);
  return found == headers.end() ? "" : found->second;
}

void set_limits(Parser& parser) {
  parser.header_limit(longest_head);
  // The rules say what each may have; boost::none refuses every body in Boost 1.74.
  parser.body_limit(std::numeric_limits<std::uint64_t>::max());
}

std::optional<Answer> answer_to(boost::system::error_code error) {
  if (error == beast::http::error::header_limit || error == beast::http::error::buffer_overflow)
    return plain(431, "the head is too long");
  if (error.category() == make_error_code(beast::http::error::bad_field).category() &&
      error != beast::http::error::end_of_stream && error != beast::http::error::partial_message)
    return plain(400, error.message());
  return std::nullopt;
}

std::optional<Answer> read_head(const Parser& parser, Head& head) {
  const auto& request = parser.get();
  const auto text = [](auto view) { return std::string(view.data(), view.size()); };
  if (request.version() != 11) return plain(400, "not a request of HTTP/1.1");
  const std::string target = text(request.target());
  if (!target.starts_with('/')) return plain(400, "not a request of HTTP/1.1");
  const std::size_t mark = std::min(target.find('?'), target.size());
  head.method = text(request.method_string());
  head.path = target.substr(0, mark);
  head.query = target.substr(std::min(mark + 1, target.size()));
  for (const auto& line : request) {
    std::string name = text(line.name_string());
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (head.headers.size() == most_headers) return plain(431, "too many headers");
    if (!head.headers.emplace(std::move(name), text(line.value())).second)
      return plain(400, "a header twice");
  }
  if (head.headers.contains("transfer-encoding") || head.headers.contains("content-encoding"))
    return plain(501, "bodies have a length and no encoding");
  const bool has_body = head.method != "GET";
  if (has_body && !parser.content_length()) return plain(411, "a body needs its length");
  head.length = static_cast<std::size_t>(parser.content_length().value_or(0));
  if (!has_body && head.length > 0) return plain(400, "a GET has no body");
  return std::nullopt;
}

}  // namespace cylon::view::http
