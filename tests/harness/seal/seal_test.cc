#include "harness/seal/seal.h"

#include "harness/seal/sha256.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace cylon::seal {
namespace {

// FIPS 180-4's examples (NIST, "Examples with intermediate values", SHA256.pdf).
TEST(Sha256, AgreesWithPublishedValues) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

// By Python: hmac.new(bytes(range(1, 33)), b"which key is this", "sha256").hexdigest()[:8] +
//            hmac.new(bytes(range(1, 33)), b"7:journalx = 1", "sha256").hexdigest()[:32]
TEST(Seal, IsAnHmacUnderTheKey) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "key";
  std::string key;
  for (char c = 1; c <= 32; ++c) key += c;
  std::ofstream(file) << key;
  ASSERT_EQ(::chmod(file.c_str(), 0600), 0);
  ::setenv("CYLON_KEY", file.c_str(), 1);
  EXPECT_EQ(seal("journal", "x = 1"), "71c3e5cdda406f2a1a51ec881d4807203da6afff");
}

TEST(Seal, HoldsForItsTextAndPurposeUnderAPrivateKey) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "inner/key";
  ::setenv("CYLON_KEY", file.c_str(), 1);
  const std::string mac = seal("journal /a", "x = 1");
  EXPECT_EQ(mac.size(), 40u);
  EXPECT_TRUE(is_own(mac));
  EXPECT_FALSE(is_own("00000000" + mac.substr(8)));
  struct stat status = {};
  ASSERT_EQ(::stat(file.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0600u);
  EXPECT_EQ(status.st_size, 32);
  EXPECT_EQ(seal("journal /a", "x = 1"), mac);
  EXPECT_TRUE(holds(mac, "journal /a", "x = 1"));
  EXPECT_FALSE(holds(mac, "journal /a", "x = 2"));
  EXPECT_FALSE(holds(mac, "journal /b", "x = 1"));
  EXPECT_FALSE(holds(mac, "journal ", "/ax = 1"));
  EXPECT_FALSE(holds(mac.substr(1), "journal /a", "x = 1"));
  EXPECT_FALSE(holds("", "journal /a", "x = 1"));
}

TEST(Seal, NamesItsPlacesWithoutLinks) {
  const TemporaryFolder folder;
  const std::filesystem::path real = std::filesystem::canonical(folder.path()) / "home",
                              link = real.parent_path() / "link";
  std::filesystem::create_directories(real);
  std::filesystem::create_symlink(real, link);
  ::setenv("HOME", link.c_str(), 1);
  ::unsetenv("XDG_CONFIG_HOME");
  ::unsetenv("CYLON_KEY");
  const std::vector<std::filesystem::path> by_default = {real / ".config/cylon"};
  EXPECT_EQ(secret_places(), by_default);  // made by asking
  EXPECT_TRUE(std::filesystem::is_regular_file(real / ".config/cylon/key"));
  ::setenv("CYLON_KEY", (link / "mine").c_str(), 1);
  const std::vector<std::filesystem::path> both = {real / ".config/cylon", real / "mine"};
  EXPECT_EQ(secret_places(), both);
}

TEST(Seal, AKeyThatOthersCanReadSealsNothing) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "key";
  std::ofstream(file) << std::string(32, 'k');
  ASSERT_EQ(::chmod(file.c_str(), 0644), 0);
  ::setenv("CYLON_KEY", file.c_str(), 1);
  EXPECT_EQ(seal("journal", "x"), "");
  EXPECT_FALSE(holds("", "journal", "x"));
}

}  // namespace
}  // namespace cylon::seal
