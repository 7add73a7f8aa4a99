// The files of a hunt: for each card a scenario, a page, a picture and a program; and one document of all.
#pragma once

#include "harness/hunt/card.h"
#include "harness/hunt/program/program.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace cylon::cli {

struct WrittenCard {
  hunt::Card card;
  hunt::Written program;
};

/// The error at each step that was asked, and what is allowed, as SVG; "" where the fault has no numbers.
std::string picture(const hunt::Card&);

/// Writes the files of a card to a folder.
void write_card(const std::filesystem::path& folder, const WrittenCard&);

/// A document `cylon-hunt/1`, which `cylon report` makes a page of.
nlohmann::ordered_json document(const std::vector<WrittenCard>&);

}  // namespace cylon::cli
