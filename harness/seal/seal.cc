#include "harness/seal/seal.h"

#include <fcntl.h>
#include <sodium.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <mutex>
#include <system_error>

namespace cylon::seal {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t key_bytes = crypto_auth_hmacsha256_KEYBYTES, id_digits = 8, mac_digits = 32;

// HMAC-SHA-256, RFC 2104; 64 hex digits.
std::string mac_of(const std::string& key, std::string_view message) {
  std::array<unsigned char, crypto_auth_hmacsha256_BYTES> mac;
  crypto_auth_hmacsha256(mac.data(), reinterpret_cast<const unsigned char*>(message.data()), message.size(),
                         reinterpret_cast<const unsigned char*>(key.data()));
  std::array<char, 2 * mac.size() + 1> digits;
  sodium_bin2hex(digits.data(), digits.size(), mac.data(), mac.size());
  return digits.data();
}

// The path in an environment variable; empty where it has none.
fs::path named(const char* variable) {
  const char* value = std::getenv(variable);
  return value ? value : "";
}

// Folders of this program alone, the first of which holds the key where $CYLON_KEY is not set.
std::vector<fs::path> key_folders() {
  std::vector<fs::path> folders;
  if (const fs::path config = named("XDG_CONFIG_HOME"); !config.empty()) folders.push_back(config / "cylon");
  if (const fs::path home = named("HOME"); !home.empty()) folders.push_back(home / ".config" / "cylon");
  return folders;
}

fs::path key_file() {
  if (fs::path file = named("CYLON_KEY"); !file.empty()) return file;
  const std::vector<fs::path> folders = key_folders();
  return folders.empty() ? fs::path() : folders.front() / "key";
}

// "" where the file is no key: missing, of another size or owner, or open to others.
std::string read_key(const fs::path& file) {
  const int fd = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (fd < 0) return "";
  struct stat status = {};
  std::string key(key_bytes + 1, '\0');
  const bool mine = ::fstat(fd, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == ::geteuid() &&
                    (status.st_mode & 077) == 0;
  const ssize_t n = mine ? ::read(fd, key.data(), key.size()) : -1;
  ::close(fd);
  if (n != static_cast<ssize_t>(key_bytes)) return "";
  key.resize(key_bytes);
  return key;
}

// Written beside its place and linked there, so that of two programs that make one the first wins, and nobody
// reads half of it.
void make_key(const fs::path& file) {
  std::error_code ignored;
  fs::create_directories(file.parent_path(), ignored);
  std::string key(key_bytes, '\0'), draft = file.string() + ".XXXXXX";
  randombytes_buf(key.data(), key.size());
  const int fd = ::mkostemp(draft.data(), O_CLOEXEC);  // of mode 0600
  if (fd < 0) return;
  const bool whole =
      ::write(fd, key.data(), key.size()) == static_cast<ssize_t>(key.size()) && ::fsync(fd) == 0;
  ::close(fd);
  if (whole) [[maybe_unused]]
    const int first = ::link(draft.c_str(), file.c_str());
  ::unlink(draft.c_str());
}

struct Key {
  std::string bytes;  // "" where there is none
  std::string id;     // tells a key from another and nothing else of it
};

Key load_key(const fs::path& file) {
  if (file.empty() || sodium_init() < 0) return {};
  std::string bytes = read_key(file);
  if (bytes.empty()) {
    make_key(file);
    bytes = read_key(file);
  }
  if (bytes.empty()) return {};
  return {bytes, mac_of(bytes, "which key is this").substr(0, id_digits)};
}

// Read once per process and place.
const Key& key() {
  static std::mutex mutex;
  static std::map<fs::path, Key> loaded;
  const fs::path file = key_file();
  const std::scoped_lock lock(mutex);
  const auto found = loaded.find(file);
  return found != loaded.end() ? found->second : loaded.emplace(file, load_key(file)).first->second;
}

}  // namespace

bool is_own(std::string_view mac) {
  const Key& mine = key();
  return !mine.id.empty() && mac.size() == id_digits + mac_digits && mac.starts_with(mine.id);
}

std::string seal(std::string_view purpose, std::string_view text) {
  const Key& mine = key();
  if (mine.bytes.empty()) return "";
  // The length keeps the purpose and the text apart.
  std::string message = std::to_string(purpose.size()) + ":";
  message.append(purpose).append(text);
  return mine.id + mac_of(mine.bytes, message).substr(0, mac_digits);
}

bool holds(std::string_view mac, std::string_view purpose, std::string_view text) {
  const std::string right = seal(purpose, text);
  // Compared without a hint, by the time it takes, of how much was right.
  return !right.empty() && mac.size() == right.size() &&
         sodium_memcmp(mac.data(), right.data(), right.size()) == 0;
}

std::vector<fs::path> secret_places() {
  static_cast<void>(key());
  std::vector<fs::path> places = key_folders(), there;
  if (const fs::path file = named("CYLON_KEY"); !file.empty()) places.push_back(file);
  for (const fs::path& place : places) {
    std::error_code absent;
    if (const fs::path real = fs::canonical(place, absent); !absent) there.push_back(real);
  }
  return there;
}

}  // namespace cylon::seal
