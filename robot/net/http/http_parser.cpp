#include "robot/net/http/http_parser.h"

#include <utility>  // before Asio: Boost 1.74 uses std::exchange without it

#define BOOST_ERROR_CODE_HEADER_ONLY
#include <boost/asio/buffer.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>

#include <cctype>

namespace robot::net {
namespace {

namespace http = boost::beast::http;

HttpRequest to_request(const http::request<http::empty_body>& message) {
  HttpRequest request{.method = std::string(message.method_string()),
                      .target = std::string(message.target()),
                      .keep_alive = message.keep_alive()};
  for (const auto& field : message) {
    std::string name(field.name_string());
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    request.headers.emplace_back(std::move(name), std::string(field.value()));
  }
  return request;
}

}  // namespace

struct HttpParser::Parser : http::request_parser<http::empty_body> {
  Parser() {
    header_limit(kMaxHeaderBytes);
    body_limit(0);
  }
};

HttpParser::HttpParser() : parser_(std::make_unique<Parser>()) {}
HttpParser::~HttpParser() = default;

void HttpParser::add(std::string_view bytes) { bytes_ += bytes; }

bool HttpParser::begun() const { return !bytes_.empty() || request_bytes_ > 0; }

std::string HttpParser::take_rest() { return std::exchange(bytes_, {}); }

Result<std::optional<HttpRequest>> HttpParser::next() {
  boost::beast::error_code error;
  while (!bytes_.empty() && !parser_->is_done()) {
    const std::size_t taken = parser_->put(boost::asio::buffer(bytes_), error);
    bytes_.erase(0, taken);
    request_bytes_ += taken;
    if (error == http::error::need_more) break;
    if (error) return Error{"HTTP request: " + error.message()};
    if (taken == 0) break;
  }
  // the parser leaves an unfinished header line in the buffer
  if (!parser_->is_header_done()) {
    if (request_bytes_ + bytes_.size() > kMaxHeaderBytes)
      return Error{"HTTP request: expected a header of at most " + std::to_string(kMaxHeaderBytes) + " bytes"};
    return std::optional<HttpRequest>();
  }
  if (!parser_->is_done()) return Error{"HTTP request: expected none with a body"};

  HttpRequest request = to_request(parser_->get());
  parser_ = std::make_unique<Parser>();
  request_bytes_ = 0;
  return std::optional(std::move(request));
}

}  // namespace robot::net
