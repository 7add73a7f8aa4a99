#include "harness/scenario/reader.h"

#include "harness/scenario/toml_depth.h"

#include <fmt/format.h>

#include <utility>

namespace cylon::scenario {
namespace {

double as_double(const toml::node& node) {
  const auto* integer = node.as_integer();
  return integer ? static_cast<double>(integer->get()) : node.as_floating_point()->get();
}

std::string as_text(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* integer = node.as_integer()) return fmt::format("{}", integer->get());
  return fmt::format("{}", node.as_floating_point()->get());
}

std::vector<double> as_doubles(const toml::node& node) {
  std::vector<double> values;
  for (const toml::node& value : *node.as_array()) values.push_back(as_double(value));
  return values;
}

std::vector<std::string> split_lines(std::string_view text) {
  std::vector<std::string> lines(1);
  for (const char c : text) {
    if (c == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += c;
    }
  }
  return lines;
}

}  // namespace

double Table::number(std::string_view key, double absent) const {
  const toml::node* node = table_->get(key);
  return node ? as_double(*node) : absent;
}

std::int64_t Table::whole(std::string_view key, std::int64_t absent) const {
  const toml::node* node = table_->get(key);
  return node ? node->as_integer()->get() : absent;
}

bool Table::boolean(std::string_view key, bool absent) const {
  const toml::node* node = table_->get(key);
  return node ? node->as_boolean()->get() : absent;
}

std::string Table::text(std::string_view key, std::string absent) const {
  const toml::node* node = table_->get(key);
  return node ? as_text(*node) : std::move(absent);
}

core::Vector3 Table::vector(std::string_view key, const core::Vector3& absent) const {
  if (!has(key)) return absent;
  const std::vector<double> v = numbers(key);
  return {v[0], v[1], v[2]};
}

std::vector<double> Table::numbers(std::string_view key) const {
  const toml::node* node = table_->get(key);
  return node ? as_doubles(*node) : std::vector<double>{};
}

std::vector<std::string> Table::texts(std::string_view key) const {
  std::vector<std::string> result;
  if (const toml::node* node = table_->get(key))
    for (const toml::node& value : *node->as_array()) result.push_back(as_text(value));
  return result;
}

std::vector<std::vector<double>> Table::rows(std::string_view key) const {
  std::vector<std::vector<double>> result;
  if (const toml::node* node = table_->get(key))
    for (const toml::node& row : *node->as_array()) result.push_back(as_doubles(row));
  return result;
}

std::optional<Table> Table::table(std::string_view key, std::string label) const {
  const toml::node* node = table_->get(key);
  if (!node || !node->is_table()) return std::nullopt;
  return Table(file_, node->as_table(), label.empty() ? std::string(key) : std::move(label));
}

std::vector<Table> Table::tables(std::string_view key, std::string label) const {
  if (label.empty()) label = fmt::format("[[{}]]", key);
  std::vector<Table> result;
  if (const toml::node* node = table_->get(key))
    for (const toml::node& entry : *node->as_array()) result.emplace_back(file_, entry.as_table(), label);
  return result;
}

bool Table::is_text(std::string_view key) const {
  const toml::node* node = table_->get(key);
  return node && node->is_string();
}

void Table::fail(std::string_view key, const std::string& message) const {
  const toml::node* node = table_->get(key);
  const toml::source_position where = (node ? node->source() : table_->source()).begin;
  throw core::InputError(*file_, where.line, where.column, message);
}

void Table::fail(const std::string& message) const { fail("", message); }

Document::Document(std::string_view text, const std::string& file, const Spec& spec)
    : file_(std::make_unique<std::string>(file)), label_(spec.label) {
  if (text.size() > largest_input)
    throw core::InputError(
        fmt::format("{}: {} bytes, but at most {} (16 MB) are read", file, text.size(), largest_input));
  require_shallow_toml(text, file);
  lines_ = split_lines(text);
  try {
    table_ = std::make_unique<toml::table>(toml::parse(text, std::string_view(*file_)));
  } catch (const toml::parse_error& error) {
    const toml::source_position where = error.source().begin;
    throw core::InputError(file, where.line, where.column, std::string(error.description()));
  }
  if (table_->empty())
    throw core::InputError(file, 1, 1, fmt::format("the file is empty, but {} is expected", spec.label));
  check(*table_, spec, file);
}

std::string Document::written(const Table& table, std::string_view key) const {
  const toml::node* node = table.raw().get(key);
  if (!node || node->is_string()) return table.text(key);
  const toml::source_region& where = node->source();
  if (where.begin.line != where.end.line || where.begin.line == 0 || where.begin.line > lines_.size())
    return table.text(key);
  // Columns count characters, but a number stands behind its key, where a line is ASCII as a rule.
  const std::string& line = lines_[where.begin.line - 1];
  if (where.begin.column == 0 || where.end.column > line.size() + 1) return table.text(key);
  std::string word = line.substr(where.begin.column - 1, where.end.column - where.begin.column);
  while (!word.empty() && (word.back() == ' ' || word.back() == '\r' || word.back() == '\t')) word.pop_back();
  try {
    return parse_step(word) == as_double(*node) ? word : table.text(key);
  } catch (const core::InputError&) {
    return table.text(key);  // "1_000"
  }
}

}  // namespace cylon::scenario
