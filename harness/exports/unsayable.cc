#include "harness/exports/unsayable.h"

#include <fmt/format.h>
#include <toml++/toml.h>

namespace cylon::exports {
namespace {

// Whose a table is: bodies and planes have a name of their own, joints and forces are on a body.
bool is_of(const toml::table& table, const std::string& name) {
  return table["name"].value<std::string>() == name || table["body"].value<std::string>() == name;
}

// The node of the key, else of the table; null where the file has none, as of a body that a generator makes.
const toml::node* node_of(const Unsayable& what, const toml::table& root) {
  const toml::table* owner = nullptr;
  if (what.table.empty()) {
    owner = &root;
  } else if (const toml::node_view numbered = root[what.table][what.number];
             what.name.empty() && numbered.is_table()) {
    owner = numbered.as_table();
  } else if (const toml::array* tables = root[what.table].as_array()) {
    for (const toml::node& node : *tables)
      if (const toml::table* table = node.as_table(); table && is_of(*table, what.name)) {
        // Of several joints of a body the one that has the key.
        if (!owner || (!owner->contains(what.key) && table->contains(what.key))) owner = table;
      }
  } else {
    owner = root[what.table].as_table();
  }
  if (!owner) return nullptr;
  const toml::node* node = owner->get(what.key);
  return node ? node : owner == &root ? nullptr : owner;
}

}  // namespace

core::InputError located(const Unsayable& what, std::string_view text, const std::string& file,
                         std::string_view format) {
  const toml::table root = toml::parse(text);
  const toml::node* node = node_of(what, root);
  const std::string owner = what.table.empty()  ? ""
                            : what.name.empty() ? fmt::format("[{}]", what.table)
                                                : fmt::format("{} of '{}'", what.table, what.name);
  const std::string key = what.key.empty() ? owner
                          : owner.empty()  ? fmt::format("'{}'", what.key)
                                           : fmt::format("'{}' of {}", what.key, owner);
  return {file, node ? static_cast<unsigned>(node->source().begin.line) : 0,
          node ? static_cast<unsigned>(node->source().begin.column) : 0,
          fmt::format("{} cannot say {}: {}", format, key, what.why)};
}

}  // namespace cylon::exports
