#include "tests/fuzz/targets/random_scene.h"

#include "harness/scenario/keys.h"
#include "tests/fuzz/targets/random_value.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string_view>

namespace cylon::fuzz {
namespace {

namespace fs = std::filesystem;
using scenario::Key, scenario::Kind, scenario::Spec;

// A scenario as its tables: the lines before the first header, and each header with the lines after it.
struct Block {
  std::string header;  // "[[body]]"; of the first: ""
  std::vector<std::string> lines;

  std::string name() const {
    const std::size_t start = header.find_first_not_of('[');
    return start == std::string::npos ? "" : header.substr(start, header.find(']') - start);
  }
};
using Blocks = std::vector<Block>;

Blocks blocks_of(const std::string& text) {
  Blocks blocks(1);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    at = end + 1;
    if (line.starts_with('['))
      blocks.push_back({line, {}});
    else
      blocks.back().lines.push_back(line);
  }
  return blocks;
}

std::string text_of(const Blocks& blocks) {
  std::string text;
  for (const Block& block : blocks) {
    if (!block.header.empty()) text += block.header + '\n';
    for (const std::string& line : block.lines) text += line + '\n';
  }
  return text;
}

// The names of bodies, generators and planes, which other tables mean.
std::vector<std::string> names_in(const std::string& text) {
  static const std::regex name(R"re(\bname\s*=\s*"([^"\n]*)")re");
  std::vector<std::string> names;
  for (std::sregex_iterator i(text.begin(), text.end(), name), end; i != end; ++i) names.push_back((*i)[1]);
  return names;
}

const Key* key_of_table(const std::string& name) {
  const std::vector<Key>& keys = scenario::scenario_keys().keys;
  const auto found = std::ranges::find(keys, name, &Key::name);
  return found != keys.end() && found->spec ? &*found : nullptr;
}

// ---- Changes, each of one thing ----------------------------------------------------------------------

struct Change {
  Blocks& blocks;
  const Blocks& other;  ///< Of another scene.
  const std::vector<std::string>& names;
  Random& random;

  Block& block() { return blocks[random.below(blocks.size())]; }
};

// A number becomes another: extreme, or near.
void number(Change& change) {
  static const std::regex value(R"(-?\b\d+\.?\d*(e[-+]?\d+)?)");
  static const char* const extremes[] = {"0",    "-1",  "1e308", "1e-308",  "5e-324", "1e9",
                                         "1e-9", "0.1", "2",     "1000000", "-0.0",   "3"};
  Block& block = change.block();
  if (block.lines.empty()) return;
  std::string& line = block.lines[change.random.below(block.lines.size())];
  const std::vector<std::smatch> found(std::sregex_iterator(line.begin(), line.end(), value), {});
  if (found.empty()) return;
  const std::smatch& one = found[change.random.below(found.size())];
  const double near = std::strtod(one.str().c_str(), nullptr) * change.random.between(-2, 2);
  const std::string instead = change.random.below(2) ? extremes[change.random.below(std::size(extremes))]
                                                     : change.random.written(near);
  line = one.prefix().str() + instead + one.suffix().str();
}

void line_away(Change& change) {
  std::vector<std::string>& lines = change.block().lines;
  if (!lines.empty())
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(change.random.below(lines.size())));
}

void table_away(Change& change) {
  if (change.blocks.size() > 1)
    change.blocks.erase(change.blocks.begin() + 1 +
                        static_cast<std::ptrdiff_t>(change.random.below(change.blocks.size() - 1)));
}

void table_of_another(Change& change) {
  if (change.other.size() > 1)
    change.blocks.push_back(change.other[1 + change.random.below(change.other.size() - 1)]);
}

// A key of the table, with a value of its kind.
void key(Change& change) {
  Block& block = change.block();
  const Key* table = key_of_table(block.name());
  const Spec& spec = block.header.empty() || !table ? scenario::scenario_keys() : *table->spec();
  const Key& added = spec.keys[change.random.below(spec.keys.size())];
  if (block.header.empty() && added.spec) return;  // tables have their own lines
  block.lines.insert(block.lines.begin(),
                     added.name + " = " + random_value(added, change.names, change.random));
}

void table(Change& change) {
  std::vector<const Key*> tables;
  for (const Key& one : scenario::scenario_keys().keys)
    if (one.spec && one.kind == Kind::tables) tables.push_back(&one);
  const Key& one = *tables[change.random.below(tables.size())];
  Block block{"[[" + one.name + "]]", {}};
  for (const auto& [name, value] : random_table(*one.spec(), change.names, change.random))
    block.lines.push_back(name + " = " + value);
  change.blocks.push_back(std::move(block));
}

constexpr void (*changes[])(Change&) = {number,     number,           number, number, line_away,
                                        table_away, table_of_another, key,    key,    table};

}  // namespace

std::vector<SceneFile> shipped_scenes(const fs::path& source) {
  std::vector<SceneFile> all;
  for (const char* folder : {"scenarios", "scenarios/extremes", "tests/data/mixes", "tests/odd"})
    for (const auto& entry : fs::directory_iterator(source / folder)) {
      const fs::path& path = entry.path();
      if (path.extension() != ".toml" || path.filename() == "expected.toml") continue;
      std::ifstream in(path, std::ios::binary);
      std::string text(std::istreambuf_iterator<char>(in), {});
      if (text.find("certified") == std::string::npos && text.size() < 20'000)
        all.push_back({path.string(), std::move(text)});
    }
  std::ranges::sort(all, {}, &SceneFile::file);
  return all;
}

SceneFile random_scene(const std::vector<SceneFile>& shipped, std::uint64_t n) {
  Random random(n);
  const SceneFile& from = shipped[random.below(shipped.size())];
  const Blocks other = blocks_of(shipped[random.below(shipped.size())].text);
  Blocks blocks = blocks_of(from.text);
  const std::vector<std::string> names = names_in(from.text);
  Change change{blocks, other, names, random};
  for (std::size_t i = 0, count = 1 + random.below(4); i < count; ++i)
    changes[random.below(std::size(changes))](change);
  return {from.file, text_of(blocks)};
}

}  // namespace cylon::fuzz
