#include "harness/view/page.h"

#include "reports/web_bundle.h"

#include <fmt/format.h>
#include <sys/random.h>

#include <cstdint>
#include <stdexcept>

namespace cylon::view {

std::string page() {
  return fmt::format(R"(<!doctype html>
<html data-page="view" lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Cylon</title>
<style>{}</style>
</head>
<body>
<div id="app"></div>
<script>{}</script>
</body>
</html>
)",
                     web::style(), web::script());
}

std::string security_policy() {
  return fmt::format(
      "default-src 'none'; script-src '{}'; style-src 'unsafe-inline'; img-src data: blob:; connect-src "
      "'self'; "
      "base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
      web::script_hash());
}

std::string random_token() {
  std::uint64_t bits[2];
  if (getrandom(bits, sizeof bits, 0) != static_cast<ssize_t>(sizeof bits))
    throw std::runtime_error("the system provides no random numbers");
  return fmt::format("{:016x}{:016x}", bits[0], bits[1]);
}

}  // namespace cylon::view
