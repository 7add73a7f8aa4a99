#include "harness/core/files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

namespace cylon::core {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }
  fs::path folder = fs::temp_directory_path() / ("cylon-files-" + std::to_string(::getpid()));
};

// No descriptor is left while this lives.
class WithoutDescriptors {
 public:
  WithoutDescriptors() {
    ::getrlimit(RLIMIT_NOFILE, &before_);
    rlimit none = before_;
    none.rlim_cur = 0;
    ::setrlimit(RLIMIT_NOFILE, &none);
  }
  WithoutDescriptors(const WithoutDescriptors&) = delete;
  WithoutDescriptors& operator=(const WithoutDescriptors&) = delete;
  ~WithoutDescriptors() { ::setrlimit(RLIMIT_NOFILE, &before_); }

 private:
  rlimit before_{};
};

TEST_F(Files, AreReadWhole) {
  const std::string bytes("a\0b\n\xff", 5);
  std::ofstream(folder / "a", std::ios::binary) << bytes;
  EXPECT_EQ(whole_file(folder / "a"), bytes);
  EXPECT_EQ(std::distance(entries_of(folder), {}), 1);
}

TEST_F(Files, ThatAreNotThereAreEmpty) {
  EXPECT_EQ(whole_file(folder / "none"), "");
  EXPECT_EQ(entries_of(folder / "none"), fs::directory_iterator());
}

// A recording was kept under the name of another engine, whose file counted as empty.
TEST_F(Files, ThatCannotBeReadNowAreNotTakenForEmpty) {
  std::ofstream(folder / "a") << "text";
  const WithoutDescriptors none;
  EXPECT_THROW(whole_file(folder / "a"), std::system_error);
  EXPECT_THROW(entries_of(folder), std::system_error);
}

}  // namespace
}  // namespace cylon::core
