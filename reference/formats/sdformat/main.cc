// cylon-import-sdformat FILE ROOT…: lets libsdformat read a world or a model and prints it as a foreign model
// (harness/imports/model).  cylon-import-sdformat --elements: what becomes of all elements that the format knows.
#include "harness/imports/model/model_json.h"
#include "reference/formats/resources/resources.h"
#include "reference/formats/sdformat/known.h"
#include "reference/formats/sdformat/reader.h"

#include <cstdio>
#include <exception>
#include <string>

int main(int argc, char** argv) {
  if (argc < 2) return cylon::formats::refuse("usage: cylon-import-sdformat FILE ROOT…");
  try {
    if (std::string(argv[1]) == "--elements") {
      const std::string lines = cylon::formats::known_elements();
      std::fwrite(lines.data(), 1, lines.size(), stdout);
      return std::fflush(stdout) == 0 ? 0 : cylon::formats::refuse("stdout cannot be written");
    }
    const cylon::foreign::Model model = cylon::formats::SdfReader(argv[1], {argv + 2, argv + argc}).read();
    const std::string text = to_json(model).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    std::fwrite(text.data(), 1, text.size(), stdout);
    return std::fflush(stdout) == 0 ? 0 : cylon::formats::refuse("stdout cannot be written");
  } catch (const std::exception& error) {
    return cylon::formats::refuse(error.what());
  }
}
