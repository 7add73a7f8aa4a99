// A folder of its own for each test, and runs and results of general values to put into a store there.
#pragma once

#include "harness/tracking/store/store.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <stdlib.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace cylon::store {

class Folder : public testing::Test {
 protected:
  void SetUp() override { ::setenv("CYLON_KEY", (folder / "key").c_str(), 1); }

  const TemporaryFolder own_;
  const std::filesystem::path folder = own_.path(), file = folder / "history.db";
};

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

inline RunInfo run(const std::string& revision) {
  RunInfo r;
  r.label = "nightly";
  r.revision = revision;
  r.date = "2024-05-01T03:04:05Z";
  r.machine = "a processor, 2 logical CPUs";
  r.os = "an operating system";
  r.compiler = "gcc 12.2.0";
  r.flags = "-O2";
  r.build = "0123456789abcdef";
  r.command_line = "cylon track record 'top*'";
  r.note = "warm, naïve: \"quoted\"";
  return r;
}

inline Result result(const std::string& scenario, double dt, const std::vector<double>& seconds) {
  Result r;
  r.cell.scenario = scenario;
  r.cell.scenario_hash = "fedcba9876543210";
  r.cell.engine = "bullet/gyro=none";
  r.cell.path = "rigid";
  r.cell.integrator = "semi-implicit";
  r.cell.precision = "double";
  r.cell.settings = "erp=0.2; cfm=0";
  r.cell.dt = dt;
  r.cell.dt_text = "0.0125";
  r.engine_version = "2.1";
  r.asked = scenario + " asked";
  for (std::size_t i = 0; i < seconds.size(); ++i)
    r.samples.push_back({{"cpu_seconds", Kind::time, "s"}, static_cast<std::int64_t>(i), seconds[i], ""});
  r.samples.push_back({{"error:position", Kind::error, "m"}, 0, 3.0625e-5 / 3, ""});
  r.samples.push_back({{"state_hash", Kind::exact, ""}, 0, std::numeric_limits<double>::quiet_NaN(), "00ff"});
  r.judgements.push_back(
      {"position", "position", "m", "low-quality", "pass", 3.0625e-5 / 3, 2e-6, 1e-13, "x > y"});
  return r;
}

}  // namespace cylon::store
