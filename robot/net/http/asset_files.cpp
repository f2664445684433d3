#include "robot/net/http/asset_files.h"

#include <zlib.h>

#include <algorithm>

namespace robot::net {
namespace {

std::string_view without_slash(std::string_view path) {
  if (path.starts_with('/')) path.remove_prefix(1);
  return path;
}

// "gzip;q=0" refuses gzip explicitly; it is rare, and inflating is the right answer
bool takes_gzip(const HttpRequest& request) {
  return request.has_token("accept-encoding", "gzip") || request.has_token("accept-encoding", "*");
}

}  // namespace

std::optional<HttpResponse> asset_response(std::span<const Asset> assets, const HttpRequest& request,
                                           std::string_view path) {
  if (path == "/") path = "/index.html";
  const auto asset =
      std::ranges::find(assets, without_slash(path), [](const Asset& a) { return without_slash(a.path); });
  if (asset == assets.end()) return std::nullopt;

  // the two forms are different bytes and so have different ETags
  const bool gzip = takes_gzip(request);
  const std::string etag = "\"" + std::string(asset->etag) + (gzip ? "-gzip\"" : "\"");
  // names under assets/ contain a hash of their content, so these files never change
  const bool immutable = without_slash(path).starts_with("assets/");
  HttpResponse response{.headers = {{"Content-Type", std::string(asset->content_type)},
                                    {"Cache-Control", immutable ? "public, max-age=31536000, immutable" : "no-cache"},
                                    {"Vary", "Accept-Encoding"},
                                    {"ETag", etag}}};
  if (not_modified(request, etag)) {
    response.status = 304;
    return response;
  }
  if (gzip) {
    response.headers.emplace_back("Content-Encoding", "gzip");
    response.body = asset->gzip;
    return response;
  }
  auto bytes = inflate_gzip(asset->gzip);
  if (!bytes) return error_response(500, bytes.error());
  response.body = std::move(*bytes);
  return response;
}

Result<std::string> inflate_gzip(std::string_view packed) {
  z_stream stream{};
  if (inflateInit2(&stream, 16 + MAX_WBITS) != Z_OK) return Error{"gzip: no memory"};
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());

  std::string bytes;
  char block[16384];
  int outcome = Z_OK;
  while (outcome == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(block);
    stream.avail_out = sizeof block;
    outcome = inflate(&stream, Z_NO_FLUSH);
    bytes.append(block, sizeof block - stream.avail_out);
  }
  inflateEnd(&stream);
  if (outcome != Z_STREAM_END) return Error{"gzip: the data are damaged"};
  return bytes;
}

}  // namespace robot::net
