#include "harness/tracking/store/json_lines.h"

#include "harness/core/input_error.h"
#include "harness/input/json.h"
#include "harness/tracking/store/json_object.h"
#include "harness/tracking/store/json_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <utility>

namespace cylon::store {
namespace {

using nlohmann::json;
using Ordered = nlohmann::ordered_json;

class Reader {
 public:
  Reader(Store& store, std::string file) : store_(store), place_{std::move(file), 0} {}

  void line(std::string_view text) {
    ++place_.line;
    if (text.find_first_not_of(" \t\r") == std::string_view::npos) return;
    const json row = parse_json(text, place_);
    if (!row.is_object() || row.size() != 1) place_.refuse("a line must be an object with one key");
    const std::string key = row.begin().key();
    if (!headed_ && key != "cylon_history")
      place_.refuse("the first line must be {\"cylon_history\": 1}, as `cylon track export` writes it");
    for (const auto& [known, read] : readers)
      if (key == known) return (this->*read)(row.begin().value());
    std::vector<std::string> names;
    for (const auto& [known, read] : readers) names.emplace_back(known);
    place_.refuse(fmt::format("unknown key '{}'{}", clean(key), core::did_you_mean(key, names)));
  }

  const Imported& imported() const { return imported_; }

 private:
  void head(const json& value) {
    if (value != json_lines_version)
      place_.refuse(fmt::format("\"cylon_history\" is version {}, this program reads {}", input::shown(value),
                                json_lines_version));
    headed_ = true;
  }

  void cell(const json& value) {
    Cell c = cell_from({value, place_, "cell"});
    cells_[c.hash] = std::move(c);
  }

  void run(const json& value) {
    const RunInfo r = run_from({value, place_, "run"});
    std::int64_t id = 0;
    if (store_.import_run(r, id))
      ++imported_.runs;
    else if (r.complete)
      store_.finish_run(id);
    runs_[r.uid] = id;
  }

  void result(const json& value) {
    JsonObject object(value, place_, "result");
    Result r;
    const std::string uid = object.text("run"), hash = object.text("cell");
    const auto run = runs_.find(uid);
    if (run == runs_.end()) object.refuse("run", fmt::format("'{}' is not defined above", clean(uid)));
    const auto cell = cells_.find(hash);
    if (cell == cells_.end()) object.refuse("cell", fmt::format("'{}' is not defined above", clean(hash)));
    r.cell = cell->second;
    r.engine_version = object.text("engine_version");
    r.asked = object.text("asked");
    for (const json& item : object.array("samples"))
      r.samples.push_back(sample_from({item, place_, "sample"}));
    for (const json& item : object.array("verdicts"))
      r.judgements.push_back(judgement_from({item, place_, "verdict"}));
    object.finish();
    if (const std::string word = twice(r); !word.empty())
      place_.refuse(fmt::format("result: {} stands twice", word));
    const std::string stored = store_.stored_digest(run->second, hash);
    if (stored == digest(r)) {
      ++imported_.here_already;
    } else if (stored.empty()) {
      store_.add(run->second, r);
      ++imported_.results;
    } else {
      object.refuse("cell", fmt::format("'{}' of run {} is in the store with other values", hash, uid));
    }
  }

  void anchor(const json& value) {
    const Anchor a = anchor_from({value, place_, "anchor"});
    const std::vector<Anchor> here = store_.anchors();
    if (std::none_of(here.begin(), here.end(),
                     [&](const Anchor& other) { return other.name == a.name && other.date > a.date; }))
      store_.pin(a, Author::import);
  }

  void change_point(const json& value) {
    const ChangePoint p = change_point_from({value, place_, "change_point"});
    const std::vector<ChangePoint> here = store_.change_points();
    if (std::none_of(here.begin(), here.end(), [&](const ChangePoint& other) {
          return other.series == p.series && other.revision == p.revision && other.date > p.date;
        }))
      store_.set(p, Author::import);
  }

  static constexpr std::pair<const char*, void (Reader::*)(const json&)> readers[] = {
      {"cylon_history", &Reader::head}, {"cell", &Reader::cell},     {"run", &Reader::run},
      {"result", &Reader::result},      {"anchor", &Reader::anchor}, {"change_point", &Reader::change_point},
  };

  Store& store_;
  Place place_;
  bool headed_ = false;
  std::map<std::string, Cell> cells_;
  std::map<std::string, std::int64_t> runs_;
  Imported imported_;
};

}  // namespace

void write_json_lines(const Store& store, std::ostream& out) {
  const auto line = [&](const char* key, const Ordered& value) {
    out << Ordered{{key, value}}.dump(-1, ' ', true) << '\n';
  };
  line("cylon_history", json_lines_version);
  std::vector<Cell> cells = store.cells();
  std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) { return a.hash < b.hash; });
  for (const Cell& cell : cells) line("cell", to_json(cell));
  std::vector<RunInfo> runs = store.runs();
  std::sort(runs.begin(), runs.end(), [](const RunInfo& a, const RunInfo& b) { return a.id < b.id; });
  for (const RunInfo& run : runs) {
    line("run", to_json(run));
    for (const Result& result : store.results(run.id)) line("result", to_json(run, result));
  }
  for (const Anchor& anchor : store.anchors()) line("anchor", to_json(anchor));
  for (const ChangePoint& point : store.change_points()) line("change_point", to_json(point));
}

Imported read_json_lines(Store& store, std::string_view document, const std::string& file) {
  Reader reader(store, file);
  store.in_one_transaction([&] {
    while (!document.empty()) {
      const std::size_t end = document.find('\n');
      reader.line(document.substr(0, end));
      document.remove_prefix(end == std::string_view::npos ? document.size() : end + 1);
    }
  });
  return reader.imported();
}

}  // namespace cylon::store
