#include "reference/certified/cache.h"

#include "harness/seal/seal.h"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string_view>

namespace cylon::certified {
namespace {

namespace fs = std::filesystem;
using namespace std::string_literals;

// magic, key, seal of the body, body: doubles and counts as the machine has them.
const std::string magic = "cylon certified solution 3, "s + (sizeof(double) == 8 ? "f64" : "?") + "\n";

template <class T>
void put(std::string& bytes, const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}
template <class T>
void put(std::string& bytes, const std::vector<T>& values) {
  put(bytes, static_cast<std::uint64_t>(values.size()));
  if (!values.empty()) bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

// Takes values off the front; `good` stays true while there are enough.
struct Taker {
  std::string_view bytes;
  bool good = true;

  template <class T>
  void take(T& value) {
    if (bytes.size() < sizeof value) return void(good = false);
    std::memcpy(&value, bytes.data(), sizeof value);
    bytes.remove_prefix(sizeof value);
  }
  template <class T>
  void take(std::vector<T>& values) {
    std::uint64_t size = 0;
    take(size);
    if (!good || size > bytes.size() / sizeof(T)) return void(good = false);
    values.resize(size);
    if (size > 0) std::memcpy(values.data(), bytes.data(), size * sizeof(T));
    bytes.remove_prefix(size * sizeof(T));
  }
};

std::string body_of(const Dense& d) {
  std::string bytes;
  put(bytes, d.bodies), put(bytes, d.starts), put(bytes, d.first), put(bytes, d.coefficients);
  put(bytes, d.horizon), put(bytes, d.error), put(bytes, d.ulp), put(bytes, std::uint8_t{d.lost});
  put(bytes, d.work);
  return bytes;
}

// Under the user's key: a truth that somebody else put there is none.
std::string sealed(const std::string& key, std::string_view body) {
  return seal::seal("certified " + key, body) + "\n";
}

std::optional<fs::path> file_of(const std::string& key) {
  const auto folder = cache_folder();
  if (!folder) return std::nullopt;
  return *folder / "certified" / (key + ".bin");
}

// Dense::at() needs: steps in order of time, each with polynomials of one degree for all numbers.
bool sound(const Dense& d) {
  if (d.bodies == 0 || d.starts.empty() || d.first.size() != d.starts.size() + 1) return false;
  if (d.bodies > d.coefficients.size() / Dense::numbers) return false;
  const auto finite = [](double t) { return std::isfinite(t); };
  if (!std::ranges::all_of(d.starts, finite) || !std::ranges::is_sorted(d.starts) || !finite(d.horizon))
    return false;
  if (d.first.front() != 0) return false;
  for (std::size_t i = 0; i + 1 < d.first.size(); ++i)
    if (d.first[i] >= d.first[i + 1] || (d.first[i + 1] - d.first[i]) % (d.bodies * Dense::numbers) != 0)
      return false;
  return d.first.back() == d.coefficients.size();
}

}  // namespace

std::optional<fs::path> cache_folder() {
  if (const char* folder = std::getenv("CYLON_CACHE"); folder && *folder) {
    if (std::string_view(folder) == "off") return std::nullopt;
    return folder;
  }
  if (const char* folder = std::getenv("XDG_CACHE_HOME"); folder && *folder)
    return fs::path(folder) / "cylon";
  if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".cache" / "cylon";
  return std::nullopt;
}

std::optional<Dense> parse_body(std::string_view body) {
  Dense d;
  Taker taker{body};
  taker.take(d.bodies), taker.take(d.starts), taker.take(d.first), taker.take(d.coefficients);
  std::uint8_t lost = 0;  // a bool has two values
  taker.take(d.horizon), taker.take(d.error), taker.take(d.ulp), taker.take(lost);
  taker.take(d.work);
  if (!taker.good || !taker.bytes.empty() || lost > 1 || !sound(d)) return std::nullopt;
  d.lost = lost == 1;
  return d;
}

std::optional<Dense> load(const std::string& key) {
  const auto file = file_of(key);
  if (!file) return std::nullopt;
  std::ifstream in(*file, std::ios::binary);
  std::stringstream stream;
  stream << in.rdbuf();
  const std::string bytes = stream.str(), head = magic + key + "\n";
  if (!in || !bytes.starts_with(head)) return std::nullopt;
  const std::string_view rest = std::string_view(bytes).substr(head.size());
  const std::size_t end = rest.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view body = rest.substr(end + 1);
  if (!seal::holds(rest.substr(0, end), "certified " + key, body)) return std::nullopt;
  return parse_body(body);
}

void keep(const std::string& key, const Dense& d) {
  const auto file = file_of(key);
  if (!file) return;
  std::error_code error;
  fs::create_directories(file->parent_path(), error);
  std::string temporary = file->string() + ".XXXXXX";
  const int draft = ::mkostemp(temporary.data(), O_CLOEXEC);
  if (draft < 0) return;
  ::close(draft);
  {
    const std::string body = body_of(d);
    std::ofstream out(temporary, std::ios::binary);
    out << magic << key << "\n" << sealed(key, body) << body;
    out.close();
    if (!out) return void(fs::remove(temporary, error));
  }
  fs::rename(temporary, *file, error);
  if (error) fs::remove(temporary, error);
}

}  // namespace cylon::certified
