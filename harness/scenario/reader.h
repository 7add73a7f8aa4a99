// A checked TOML document.  Every key, type and range is checked against the key tables before anything is
// read, so that what follows reads plainly.  Knows words and places, no physics.
#pragma once

#include "harness/core/input_error.h"
#include "harness/core/scene.h"
#include "harness/scenario/input.h"
#include "harness/scenario/keys.h"

#include <toml++/toml.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::scenario {

/// One table of a document, in which every key present is known and of its type.
class Table {
 public:
  Table(const std::string* file, const toml::table* table, std::string label)
      : file_(file), table_(table), label_(std::move(label)) {}

  bool has(std::string_view key) const { return table_->contains(key); }
  double number(std::string_view key, double absent = 0) const;
  std::int64_t whole(std::string_view key, std::int64_t absent = 0) const;
  bool boolean(std::string_view key, bool absent = false) const;
  std::string text(std::string_view key, std::string absent = "") const;
  core::Vector3 vector(std::string_view key, const core::Vector3& absent = core::Vector3::Zero()) const;
  std::vector<double> numbers(std::string_view key) const;
  std::vector<std::string> texts(std::string_view key) const;  ///< Texts; numbers as they stand in TOML.
  std::vector<std::vector<double>> rows(std::string_view key) const;  ///< Of points or triangles.
  std::optional<Table> table(std::string_view key, std::string label = "") const;
  std::vector<Table> tables(std::string_view key, std::string label = "") const;
  bool is_text(std::string_view key) const;

  /// Position of the word among `choices`; an absent key gives `absent`.
  template <class Enum>
  Enum choice(std::string_view key, const std::vector<std::string>& choices, Enum absent) const {
    const std::string word = text(key);
    for (std::size_t i = 0; i < choices.size(); ++i)
      if (choices[i] == word) return static_cast<Enum>(i);
    return absent;
  }

  /// Throws core::InputError at the key's value, or at the table where the key is absent.
  [[noreturn]] void fail(std::string_view key, const std::string& message) const;
  [[noreturn]] void fail(const std::string& message) const;

  const std::string& label() const { return label_; }
  const std::string& file() const { return *file_; }
  const toml::table& raw() const { return *table_; }

 private:
  const std::string* file_;
  const toml::table* table_;
  std::string label_;
};

/// Throws core::InputErrors for unknown keys, missing keys, wrong types, values out of their range, and words that are no
/// choice, anywhere below the table.
void check(const toml::table&, const Spec&, const std::string& file);

/// A whole file, checked.
class Document {
 public:
  /// Throws core::InputError "file:line:column: …" for bad TOML and for whatever the key tables refuse.
  Document(std::string_view text, const std::string& file, const Spec&);

  Table root() const { return {file_.get(), table_.get(), label_}; }

  /// A step as it was written: "0.001", "1/60".
  std::string written(const Table&, std::string_view key) const;

 private:
  std::unique_ptr<std::string> file_;  // tables point here, so it must not move
  std::unique_ptr<toml::table> table_;
  std::string label_;
  std::vector<std::string> lines_;
};

}  // namespace cylon::scenario
