#include "harness/core/input_error.h"
#include "harness/tracking/store/google_benchmark.h"
#include "harness/tracking/store/json_lines.h"
#include "harness/tracking/store/samples_csv.h"
#include "tests/fuzz/targets/folder.h"
#include "tests/fuzz/targets/targets.h"

namespace cylon::fuzz {
namespace {

// Thrown to roll an import back, so that the store stays empty.
struct Undone {};

store::Imported import(store::Store& store, std::string_view bytes) {
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  const std::string_view head = start == std::string_view::npos ? "" : bytes.substr(start);
  if (head.starts_with("{\"cylon_history\"")) return store::read_json_lines(store, bytes, "h.jsonl");
  if (!head.starts_with('{')) return store::read_samples_csv(store, bytes, "h.csv");
  return store::read_google_benchmark(store, bytes, "h.json", {});
}

}  // namespace

void history(std::string_view bytes) {
  static store::Store store = [] {
    store::Store made = store::Store::open(folder() / "h.db", store::Mode::write);
    made.set_author(store::Author::import);
    return made;
  }();
  try {
    store.in_one_transaction([&] {
      const store::Imported found = import(store, bytes);
      if (store.runs().size() != found.runs) throw Broken("as many runs are stored as were told");
      throw Undone();
    });
  } catch (const Undone&) {
  } catch (const core::InputError&) {
  }
}

}  // namespace cylon::fuzz
