// A worker that wrote a number beyond a double's range, 1e999, ended the harness with an internal error: the
// JSON library reports it by another exception than bad syntax.  It is a protocol failure like any other
// garbage.
#include "harness/process/json_fields.h"

#include <gtest/gtest.h>

namespace cylon::process {
namespace {

TEST(NumberBeyondDouble, IsRejected) {
  EXPECT_THROW(parse_object(R"({"step_ns": 1e999})"), MalformedMessage);
  EXPECT_THROW(parse_object(R"({"step_ns": [-1e999]})"), MalformedMessage);
  EXPECT_EQ(parse_object(R"({"step_ns": 1e99})")["step_ns"], 1e99);
}

}  // namespace
}  // namespace cylon::process
