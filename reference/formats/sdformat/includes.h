// Which files a file of SDFormat includes, asked of libsdformat itself.
#pragma once

#include <functional>
#include <string>

namespace cylon::formats {

/// Throws Refused, with the way round, where a file includes itself, through others or not: libsdformat reads such files
/// some levels deep, or without end.  `find`: the file or the model's folder of a URI, "" where there is none.
void require_no_circle(const std::string& file, const std::function<std::string(const std::string&)>& find);

}  // namespace cylon::formats
