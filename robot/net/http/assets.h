// The viewer's files in the program. The viewer's build generates them; without it, no_viewer_assets.cpp has one page.
#pragma once

#include <cstddef>
#include <string_view>

namespace robot::net {

struct Asset {
  std::string_view path, content_type, gzip;  // "/index.html" or "index.html"; the type with its charset; the bytes
  std::string_view etag;                      // without quotes
};

extern const Asset kViewerAssets[];
extern const std::size_t kViewerAssetCount;

}  // namespace robot::net
