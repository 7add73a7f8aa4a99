#include "harness/seal/sha256.h"

#include <sodium.h>

#include <array>

namespace cylon::seal {

std::string sha256(std::string_view message) {
  std::array<unsigned char, crypto_hash_sha256_BYTES> digest;
  crypto_hash_sha256(digest.data(), reinterpret_cast<const unsigned char*>(message.data()), message.size());
  std::array<char, 2 * digest.size() + 1> digits;
  sodium_bin2hex(digits.data(), digits.size(), digest.data(), digest.size());
  return digits.data();
}

}  // namespace cylon::seal
