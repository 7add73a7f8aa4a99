// The options of MuJoCo by our names: one table of what each takes, what MuJoCo calls it and where its model has it.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::simulators {

/// The place in MuJoCo's model: an attribute of <option>, of <flag>, or a number of solref and solimp.
enum class MujocoPlace { option, flag, reference, impedance };

/// A word out of some, or a number within bounds.
struct MujocoOption {
  const char* name;
  const char* setting;  ///< MuJoCo's own name.
  MujocoPlace place;
  std::vector<std::string> words;  ///< None: a number.  Of a flag: "disable", "enable".
  double engine_default;           ///< The number, or the place among the words.
  const char* meaning;
  double least = 0, most = 0;
  bool whole = false;  ///< A whole number.
  bool above = false;  ///< `least` itself is senseless.
};

std::span<const MujocoOption> mujoco_options();

/// Every option by its name: its number, or the place of its word.
using MujocoValues = std::map<std::string, double, std::less<>>;

/// MuJoCo's own.
MujocoValues mujoco_defaults();

/// A value as MuJoCo reads it and a report shows it.
std::string mujoco_text(const MujocoOption&, double value);

/// Throws std::logic_error for a name that is no option.
const MujocoOption& mujoco_option(std::string_view name);

/// Sets an option to what was given.  Throws std::invalid_argument, naming the nearest valid one, for what is
/// no option or no value of it.
void mujoco_set(MujocoValues&, const std::string& option, const std::string& given);

/// Throws std::invalid_argument, naming the nearest valid one, for a word that is none of them.
void mujoco_require(const std::string& kind, const std::string& word, const std::vector<std::string>& valid);

}  // namespace cylon::simulators
