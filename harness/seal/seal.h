// Seals: who wrote a file.  A seal is a message authentication code under a key that this user alone can
// read, so that a journal, a store or a cached truth of somebody else is not taken for one's own.  The
// cryptography is libsodium's.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::seal {

/// 8 hex digits that tell the key and 32 of HMAC-SHA-256 over `purpose` and `text` under this user's key; ""
/// where there is no key and none can be made.  `purpose` says what the text is and where it belongs, so that
/// a seal holds nowhere else.
///
/// The key is 32 random bytes in $CYLON_KEY, else $XDG_CONFIG_HOME/cylon/key, else $HOME/.config/cylon/key;
/// it is made on first use, readable by its owner alone.  A key that others can read or write is not used.
std::string seal(std::string_view purpose, std::string_view text);

/// Whether `mac` was made with this user's key, or says so.
bool is_own(std::string_view mac);

/// Whether `mac` is the seal of the text; never where there is no key.
bool holds(std::string_view mac, std::string_view purpose, std::string_view text);

/// What no program but Cylon needs to read, of what is there, without symbolic links: the file of $CYLON_KEY and the folders
/// that hold a key where that is not set.  The key is made first, so that none comes to be later.
std::vector<std::filesystem::path> secret_places();

}  // namespace cylon::seal
