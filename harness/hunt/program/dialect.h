// What a standalone program against one engine's own API is written of: a row of texts for each part of a scene.
// In the texts ${name} stands for a value of the part, of the scene, or of a setting that the engine told.
#pragma once

#include "harness/core/joint_kinds.h"

#include <map>
#include <span>
#include <string>
#include <string_view>

namespace cylon::hunt::program {

using Words = std::map<std::string, std::string, std::less<>>;

/// The text with ${name} replaced; ${name} without a word stays, so that a test finds it.
std::string filled(std::string_view text, const Words&);

/// The text without those lines of `helpers` that define a function which nothing else in it calls.
std::string without_unused(std::string text, std::string_view helpers);

/// A language: how it writes a number, a vector and the formulas that are the same in all (formulas.h).
struct Language {
  std::string_view ending;          ///< "cc"
  std::string_view comment;         ///< "// "
  std::string_view open, close;     ///< Of a vector: "V{", "}".
  std::string_view list, end_list;  ///< Of a list: "{", "}".
  std::string_view helpers;         ///< Vectors: add, sub, mul, …, one function a line.
  std::string_view data;  ///< Types and constants of the scene: ${bodies}, ${starts}, ${gravities}, ${dt}, …
  std::string_view act;   ///< act(t, s): ${forces} at a time and in a state.
  std::string_view main;  ///< Calls ${main}.
  std::string (*translated)(std::string_view formulas);
};
extern const Language cpp, javascript;

struct ShapeRow {
  std::string_view name;  ///< core::Element<Shape>::name
  std::string_view text;  ///< An expression.
};
struct JointRow {
  core::JointType type;
  std::string_view to_world, to_body;  ///< Statements; "": none.
};
/// A statement for a setting that is not the engine's own.
struct SettingRow {
  std::string_view name;   ///< "*" at its end: what begins so.
  std::string_view value;  ///< "": any; ${value} is it.
  enum class Where { program, world, body, shape } where;
  std::string_view text;  ///< "": the program does so in any case.
};

struct Dialect {
  std::string_view engine;  ///< Of core::Engine.
  std::string_view title;
  const Language* language;
  std::string_view needs;    ///< Installs what it needs.
  std::string_view command;  ///< Compiles and runs ${file}; builds in the folder where it is called.
  std::string_view head;     ///< Includes, and what has no place elsewhere.
  std::string_view
      functions;  ///< build(take), which calls the rows; push(i, force, torque), step(), states().
  std::string_view body_shape;  ///< Statement that gives body ${i} the shape ${shape}.
  std::string_view no_shape;
  std::string_view plane;  ///< Statement.
  std::span<const ShapeRow> shapes;
  std::span<const JointRow> joints;
  std::span<const SettingRow> settings;
  /// Of engines whose joints hang a body from an earlier one: statement for body ${a}, which hangs from nothing.  ${joints}
  /// then has one statement for each body.
  std::string_view free_body = {};
  bool asks = false;  ///< The engine calls act() when it needs forces; else each step begins with it.
};

std::span<const Dialect* const> dialects();

}  // namespace cylon::hunt::program
