// A digest shows damage; a seal shows who changed a value and its digest together.
#include "harness/tracking/store/json_lines.h"
#include "tests/harness/tracking/store/places.h"

namespace cylon::store {
namespace {

class SealedStore : public AnyPlace {
 protected:
  void fill() const {
    Store store = Store::open(place, Mode::write);
    const std::int64_t id = store.begin_run(run("r1"));
    for (int i = 0; i < 3; ++i)
      store.add(id, result("scene" + std::to_string(i), 0.0125, {0.1 + i, 0.7 + i}));
    store.finish_run(id);
    store.pin({"v1", "in-house=anchors/v1", "aa", "2024-05-01T00:00:00Z", "first", ""});
    store.set({"s/cpu_seconds", "r1", "ignored", "2024-05-02T00:00:00Z", "the machine was moved"});
  }
  Seals seals() const { return Store::open(place, Mode::read).seals(); }
  // What a forger does after a change: digests that agree with the values again.
  void renew_digests() const {
    const Store store = Store::open(place, Mode::read);
    for (const RunInfo& r : store.runs()) {
      raw("UPDATE run SET digest = '" + digest(r) + "' WHERE uid = '" + r.uid + "'");
      for (const Result& one : store.results(r.id))
        raw("UPDATE result SET digest = '" + digest(one) +
            "' WHERE cell = (SELECT id FROM cell WHERE hash = '" + one.cell.hash + "')");
    }
    for (const Anchor& a : store.anchors()) raw("UPDATE anchor SET digest = '" + digest(a) + "'");
  }
};

IN_ALL_PLACES(SealedStore);

TEST_P(SealedStore, HoldsWhereNothingWasChanged) {
  fill();
  const Seals found = seals();
  EXPECT_EQ(found.own, 6u);  // a run, three results, an anchor, a change point
  EXPECT_EQ(found.foreign, 0u);
  EXPECT_TRUE(found.broken.empty());
  const Store store = Store::open(place, Mode::read);
  EXPECT_TRUE(store.is_own(store.runs().front()));
  EXPECT_TRUE(store.is_own(store.anchors().front()));
}

TEST_P(SealedStore, ShowsWhatAForgerChanged) {
  const struct {
    const char* what;
    const char* sql;
    const char* says;
  } rows[] = {
      {"a time", "UPDATE sample SET value = 0.01 WHERE value > 2 AND value < 2.5", "scene2"},
      {"a verdict", "UPDATE verdict SET status = 'pass' WHERE cell = (SELECT min(id) FROM cell)", "scene0"},
      {"an engine", "UPDATE anchor SET \"binary\" = 'in-house=anchors/v2'", "anchor v1"},
      {"a revision", "UPDATE run SET revision = 'r7'", "run 1 of r7"},
      {"what a run asks for", "UPDATE run SET request = '{}'", "run 1 of r1"},
      {"a result that is gone", "DELETE FROM result WHERE cell = (SELECT max(id) FROM cell)", "run 1 of r1"},
  };
  for (const auto& row : rows) {
    SCOPED_TRACE(row.what);
    place = fresh(std::string(row.what) + ".db");
    fill();
    raw(row.sql);
    renew_digests();
    EXPECT_TRUE(Store::open(place, Mode::read).check().empty());  // the digests agree
    const Seals found = seals();
    ASSERT_FALSE(found.broken.empty());
    EXPECT_NE(found.broken.front().find(row.says), std::string::npos) << found.broken.front();
  }
}

TEST_P(SealedStore, ARowThatLosesItsSealIsNotOnesOwn) {
  fill();
  raw("UPDATE anchor SET \"binary\" = 'in-house=anchors/v2'; DELETE FROM seal WHERE kind = 'anchor'");
  const Seals found = seals();
  EXPECT_EQ(found.own, 5u);
  EXPECT_EQ(found.foreign, 1u);
  const Store store = Store::open(place, Mode::read);
  EXPECT_FALSE(store.is_own(store.anchors().front()));
}

TEST_P(SealedStore, ImportsBearNoSeal) {
  fill();
  std::ostringstream out;
  write_json_lines(Store::open(place, Mode::read), out);
  Store other = Store::open(fresh("other.db"), Mode::write);
  other.set_author(Author::import);
  read_json_lines(other, out.str(), "h.jsonl");
  const Seals found = other.seals();
  EXPECT_EQ(found.own, 0u);
  EXPECT_EQ(found.foreign, 6u);
  EXPECT_TRUE(found.broken.empty());
}

}  // namespace
}  // namespace cylon::store
