// The head of a request, from the bytes that Boost.Beast's parser took.  Knows no connection.
#pragma once

#include "harness/view/http.h"

#include <boost/beast/http.hpp>

#include <optional>
#include <string>

namespace cylon::view::http {

using Parser = boost::beast::http::request_parser<boost::beast::http::string_body>;

/// An answer in plain text.
Answer plain(int status, std::string why);

/// Heads of 16 KiB at most.  Bodies are not limited here: the rules of a server say what each may have.
void set_limits(Parser&);

/// What to say to a head that the parser refused; nothing where the connection has failed.
std::optional<Answer> answer_to(boost::system::error_code);

/// What is wrong with a head that the parser took, if anything; else `head`.
std::optional<Answer> read_head(const Parser&, Head& head);

}  // namespace cylon::view::http
