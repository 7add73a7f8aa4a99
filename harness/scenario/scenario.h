// One phenomenon: a scene, how long to watch it, what must hold, and its story.  Says nothing of who runs it.
#pragma once

#include "harness/core/claim.h"
#include "harness/core/scene.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::scenario {

class CertifiedClaims;

/// What the order or the error bound that an integrator states means for the errors in this scenario:
/// study/theory.h.
struct Theory {
  enum class Forces {
    smooth,
    kinked,  ///< Friction changes its law within a step: no order shows, though the bound holds.
    jumping  ///< Forces jump or bodies strike: fixed steps are of first order.
  };
  double rate = 0;           ///< The fastest of the motion [1/s], > 0.
  double magnification = 1;  ///< What the motion itself makes of an error, >= 1.
  Forces forces = Forces::smooth;
  double until = 0;    ///< How far it goes [s], a whole number of steps.
  std::string reason;  ///< Where the rate comes from.
};

struct Scenario {
  std::string name;  ///< The file's name without its ending.
  std::string file;  ///< As given.
  std::string title, story;
  std::vector<std::string> tags;
  std::vector<std::string> sources;  ///< "owner/repository#number" of GitHub, or a title.
  double duration = 0;               ///< [s]
  double step = 0;                   ///< Nominal [s].
  std::string step_text;             ///< As written: "1/60" or "0.001".
  core::Scene scene;
  std::vector<core::Claim> claims;
  std::optional<Theory> theory;  ///< Absent: nothing is claimed by theory.
  std::string hash;              ///< FNV-1a 64 of the file and of every file that it names, as 16 hex digits.
  std::shared_ptr<const CertifiedClaims> unsolved = nullptr;  ///< Claims without their truth: see prepare().
};

/// Reads a scenario file, or one of another format by foreign_reader().  Throws core::InputError "file:line:column: …" for all that cannot be: a file that
/// is missing, a folder, empty or over 16 MB; bad TOML; unknown keys, with the nearest valid one; impossible
/// values, with the valid range.  Claims that follow the certified truth do not have it yet.
Scenario read(const std::filesystem::path&);

/// read() from text; files that it names are looked for beside `file_name`.
Scenario read(std::string_view text, const std::string& file_name);

/// What makes a scenario's text of a file in another format: harness/imports sets it at the start of a program; without
/// it such files are refused.
std::function<std::string(const std::filesystem::path&)>& foreign_reader();

/// Solves the certified truths and checks the tolerances of the claims that follow them.  Throws
/// core::InputError at the claim.  Does nothing where all claims have their truths.  Scenarios that are
/// judged must be prepared.
void prepare(Scenario&);

/// prepare() as far as that takes some seconds; false where the certified truths take more (budget::soon),
/// and the scenario is as it was.
bool prepare_soon(Scenario&);

/// Throws std::logic_error unless the scenario is prepared.
void require_prepared(const Scenario&);

/// read() and prepare().
Scenario load(const std::filesystem::path&);

/// load() from text.
Scenario parse(std::string_view text, const std::string& file_name);

/// JSON Schema (draft 2020-12) of a scenario file, from the same key tables that the reader uses.
std::string schema_json();

/// A fresh, commented scenario that loads as it stands.
std::string template_toml(const std::string& name);

}  // namespace cylon::scenario
