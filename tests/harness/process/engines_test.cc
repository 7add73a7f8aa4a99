// Parsing of engine names and variants.
#include "harness/process/engines.h"
#include "harness/core/input_error.h"
#include "harness/process/engine_table.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace cylon::process {
namespace {

const std::vector<EngineRow> rows = default_engines("/opt/cylon");

std::string complaint(std::string_view text) {
  try {
    parse_engine(text, rows);
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Engines, IdNamesWorkerAndPath) {
  const EngineChoice choice = parse_engine("bullet-multibody-float", rows);
  EXPECT_EQ(choice.row.command, std::vector<std::string>{"/opt/cylon/cylon-worker-bullet-f32"});
  EXPECT_EQ(choice.path, "multibody");
  EXPECT_TRUE(choice.options.empty());
}

TEST(Engines, AVariantSetsOptionsPathAndIntegrator) {
  const EngineChoice choice = parse_engine("bullet/gyro=none,erp=0,path=multibody,integrator=x=y", rows);
  EXPECT_EQ(choice.id, "bullet/gyro=none,erp=0,path=multibody,integrator=x=y");
  EXPECT_EQ(choice.row.id, "bullet");
  EXPECT_EQ(choice.path, "multibody");
  EXPECT_EQ(choice.integrator, "x=y");
  EXPECT_EQ(choice.options, (std::map<std::string, std::string>{{"erp", "0"}, {"gyro", "none"}}));
  EXPECT_EQ(parse_engine("ode/path=quick", rows).path, "quick");
  EXPECT_EQ(parse_engine("ode", rows).path, "step");
}

TEST(Engines, FollowTheTableOfEngines) {
  std::ifstream table(std::string(source_dir) + "/reference/simulators/engines.txt");
  std::vector<std::string> ids, compared;
  for (std::string line; std::getline(table, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream words(line);
    std::string id, build, path, mark;
    words >> id >> build >> path >> mark;
    ids.push_back(id);
    if (mark == "compared") compared.push_back(id);
    const EngineChoice choice = parse_engine(id, rows);
    EXPECT_EQ(choice.row.command, std::vector<std::string>{"/opt/cylon/cylon-worker-" + build});
    EXPECT_EQ(choice.path, path == "-" ? "" : path);
  }
  ASSERT_FALSE(compared.empty());
  ASSERT_EQ(ids.size(), rows.size());
  for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_EQ(rows[i].id, ids[i]);
  EXPECT_EQ(compared_engines(), compared);
}

TEST(Engines, MistakesAreNamed) {
  EXPECT_NE(complaint("bulet").find("unknown engine 'bulet', did you mean 'bullet'?"), std::string::npos);
  EXPECT_NE(complaint("").find("unknown engine ''"), std::string::npos);
  EXPECT_EQ(complaint("ode/gyro"), "engine 'ode/gyro': expected key=value, got 'gyro'");
  EXPECT_EQ(complaint("ode/"), "engine 'ode/': expected key=value, got ''");
  EXPECT_EQ(complaint("ode/=1"), "engine 'ode/=1': expected key=value, got '=1'");
  EXPECT_EQ(complaint("ode/a=1,"), "engine 'ode/a=1,': expected key=value, got ''");
  EXPECT_EQ(complaint("ode/a=1,a=2"), "engine 'ode/a=1,a=2': 'a' is given twice");
}

// A worker in Node that was built, and whose package or Node has gone since then, is as missing as one that was not built.
TEST(Engines, AWorkerInNodeIsMissingWithoutItsPackageAndWithoutNode) {
  struct Row {
    bool worker, package, node, here;
  };
  const std::string usual_path = std::getenv("PATH");
  for (const Row row : {Row{true, true, true, true},
                        {false, true, true, false},
                        {true, false, true, false},
                        {true, true, false, false}}) {
    const TemporaryFolder folder;
    namespace fs = std::filesystem;
    const fs::path sources = folder.path() / "js", bin = folder.path() / "bin";
    fs::create_directories(sources / "node_modules");
    fs::create_directories(bin);
    std::ofstream(sources / "worker.mjs") << "#!/usr/bin/env node\n";
    if (row.worker) fs::create_symlink(sources / "worker.mjs", folder.path() / "cylon-worker-rapier");
    if (row.package) {
      const fs::path package = sources / "node_modules/@dimforge/rapier3d-compat";
      fs::create_directories(package);
      std::ofstream(package / "package.json") << "{}";
    }
    if (row.node) fs::create_symlink("/bin/true", bin / "node");
    ::setenv("PATH", bin.c_str(), 1);
    const auto reason = missing(parse_engine("rapier", default_engines(folder.path())).row);
    ::setenv("PATH", usual_path.c_str(), 1);
    EXPECT_EQ(!reason, row.here) << row.worker << row.package << row.node;
    EXPECT_EQ(reason.value_or("rapier is not here; `./run engines` brings it"),
              "rapier is not here; `./run engines` brings it");
  }
}

}  // namespace
}  // namespace cylon::process
