#include "harness/view/command.h"
#include "harness/view/gate.h"
#include "harness/view/http_head.h"
#include "tests/fuzz/targets/targets.h"

#include <boost/asio/buffer.hpp>

namespace cylon::fuzz {
namespace {

using namespace view::http;

constexpr int port = 8080;
constexpr std::string_view token = "0123456789abcdef0123456789abcdef";
constexpr std::size_t most_body = std::size_t{32} << 20;  // [bytes]

// Gives the parser what it takes of the bytes; false where it refuses them.
bool put(Parser& parser, std::string_view& bytes) {
  boost::system::error_code error;
  const std::size_t used = parser.put(boost::asio::buffer(bytes.data(), bytes.size()), error);
  bytes.remove_prefix(used);
  if (error && error != boost::beast::http::error::need_more) {
    const auto answer = answer_to(error);
    if (answer && (answer->status < 400 || answer->status > 499))
      throw Broken("bytes that are no request are the client's fault");
    return false;
  }
  return true;
}

}  // namespace

void http(std::string_view bytes) {
  Parser parser;
  set_limits(parser);
  if (!put(parser, bytes) || !parser.is_header_done()) return;
  Head head;
  if (read_head(parser, head)) return;
  if (view::refusal_of(head, port, token)) return;
  if (head.length > most_body) throw Broken("a body that is read is at most 32 MiB");
  if (head.path != "/" && head.header("x-cylon-token") != token)
    throw Broken("nothing but the page is served without its token");
  while (!parser.is_done() && !bytes.empty()) {
    const std::size_t before = bytes.size();
    if (!put(parser, bytes) || bytes.size() == before) return;
  }
  if (!parser.is_done()) return;
  if (parser.get().body().size() != head.length) throw Broken("a body is as long as it was said");
  if (head.path == "/api/command") command(parser.get().body());
}

}  // namespace cylon::fuzz
