// In place of postgres.cc where libpq was not here when this program was built.
#include "harness/core/input_error.h"
#include "harness/tracking/store/postgres.h"

namespace cylon::store {
namespace {

[[noreturn]] void refuse(const std::string& address) {
  throw core::InputError(
      without_password(address), 0, 0,
      "this cylon was built without PostgreSQL; apt-get install libpq-dev, and build again with "
      "./run, or name a file with --store");
}

}  // namespace

std::unique_ptr<Database> open_postgres_to_read(const std::string& address) { refuse(address); }
std::unique_ptr<Database> open_postgres_to_write(const std::string& address) { refuse(address); }

}  // namespace cylon::store
