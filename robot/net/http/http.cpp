#include "robot/net/http/http.h"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "robot/core/text.h"

namespace robot::net {
namespace {

/// Returns whether `is` holds for an element of the comma-separated list.
template <class Is>
bool any_element(std::string_view list, Is&& is) {
  return std::ranges::any_of(split(list, ","), [&](std::string_view element) { return is(trimmed(element)); });
}

/// Returns whether `is` holds for an element of the lists in all headers called `name`.
template <class Is>
bool any_element(const Headers& headers, std::string_view name, Is&& is) {
  return std::ranges::any_of(
      headers, [&](const auto& header) { return header.first == name && any_element(header.second, is); });
}

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

std::optional<std::uint64_t> number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// returns nothing if an encoding is malformed
std::optional<std::string> percent_decoded(std::string_view text, bool plus_is_space) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      decoded += plus_is_space && text[i] == '+' ? ' ' : text[i];
      continue;
    }
    unsigned code = 0;
    const std::string_view digits = text.substr(i + 1, 2);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (digits.size() < 2 || error != std::errc() || end != digits.data() + 2) return std::nullopt;
    decoded += static_cast<char>(code);
    i += 2;
  }
  return decoded;
}

bool is_safe(std::string_view raw_path, std::string_view path) {
  const auto count = [](std::string_view text, char c) { return std::ranges::count(text, c); };
  if (!path.starts_with('/') || count(raw_path, '/') != count(path, '/') ||
      path.find_first_of("%\\") != std::string_view::npos)
    return false;
  if (std::ranges::any_of(path, [](unsigned char c) { return c < 0x20 || c == 0x7f; })) return false;
  while (!path.empty()) {
    path.remove_prefix(1);
    const std::string_view segment = path.substr(0, path.find('/'));
    if (segment == "." || segment == "..") return false;
    path.remove_prefix(segment.size());
  }
  return true;
}

std::map<std::string, std::string> parse_query(std::string_view query) {
  std::map<std::string, std::string> parameters;
  while (!query.empty()) {
    const std::string_view pair = query.substr(0, query.find('&'));
    const std::size_t equals = std::min(pair.find('='), pair.size());
    const auto name = percent_decoded(pair.substr(0, equals), true);
    const auto value = percent_decoded(pair.substr(std::min(equals + 1, pair.size())), true);
    if (name && value) parameters.try_emplace(*name, *value);
    query.remove_prefix(std::min(pair.size() + 1, query.size()));
  }
  return parameters;
}

}  // namespace

std::optional<std::string_view> HttpRequest::header(std::string_view name) const {
  const auto found = std::ranges::find(headers, name, &Headers::value_type::first);
  if (found == headers.end()) return std::nullopt;
  return found->second;
}

bool HttpRequest::has_token(std::string_view name, std::string_view token) const {
  return any_element(headers, name, [&](std::string_view element) { return equal_ignoring_case(element, token); });
}

bool HttpRequest::has_exact_token(std::string_view name, std::string_view token) const {
  return any_element(headers, name, [&](std::string_view element) { return element == token; });
}

std::uint64_t HttpResponse::body_size() const {
  if (const auto* part = std::get_if<BodyPart>(&body)) return part->size;
  if (const auto* text = std::get_if<std::string>(&body)) return text->size();
  return std::get<std::string_view>(body).size();
}

HttpResponse text_response(int status, std::string_view content_type, std::string body) {
  return {.status = status,
          .headers = {{"Content-Type", std::string(content_type)}, {"Cache-Control", "no-store"}},
          .body = std::move(body)};
}

HttpResponse error_response(int status, std::string sentence) {
  return text_response(status, "text/plain; charset=utf-8", std::move(sentence) + "\n");
}

std::string Target::parameter(const std::string& name) const {
  const auto found = parameters.find(name);
  return found == parameters.end() ? std::string() : found->second;
}

Result<Target> parse_target(std::string_view target) {
  const std::size_t question = std::min(target.find('?'), target.size());
  const std::string_view raw_path = target.substr(0, question);
  const auto path = percent_decoded(raw_path, false);
  if (!path || !is_safe(raw_path, *path)) return Error{"path: expected a plain path such as /logs/, got another"};
  const std::string_view query = target.substr(std::min(question + 1, target.size()));
  return Target{*path, std::string(query), parse_query(query)};
}

std::pair<RangeOutcome, ByteRange> parse_range(std::string_view header, std::uint64_t size) {
  constexpr std::string_view kUnit = "bytes=";
  const std::pair whole{RangeOutcome::whole, ByteRange{0, size}};
  if (!header.starts_with(kUnit)) return whole;
  header.remove_prefix(kUnit.size());
  const std::size_t dash = header.find('-');
  if (dash == std::string_view::npos || header.find(',') != std::string_view::npos) return whole;

  const std::string_view first_text = trimmed(header.substr(0, dash)), last_text = trimmed(header.substr(dash + 1));
  const auto first = number(first_text), last = number(last_text);
  if ((!first && !first_text.empty()) || (!last && !last_text.empty()) || (!first && !last)) return whole;

  if (!first) {  // a suffix range: the last `*last` bytes
    if (*last == 0 || size == 0) return {RangeOutcome::unsatisfiable, {}};
    const std::uint64_t count = std::min(*last, size);
    return {RangeOutcome::part, {size - count, count}};
  }
  if (last && *last < *first) return whole;
  if (*first >= size) return {RangeOutcome::unsatisfiable, {}};
  const std::uint64_t end = last ? std::min(*last, size - 1) : size - 1;
  return {RangeOutcome::part, {*first, end - *first + 1}};
}

HttpResponse body_response(const HttpRequest& request, std::shared_ptr<const ByteSource> source,
                           const std::string& etag, std::string_view content_type) {
  const std::uint64_t size = source->size();
  HttpResponse response{.headers = {{"Content-Type", std::string(content_type)},
                                    {"Accept-Ranges", "bytes"},
                                    {"ETag", etag},
                                    {"Cache-Control", "no-cache"}}};
  if (not_modified(request, etag)) {
    response.status = 304;
    return response;
  }

  // If-Range: send the rest only if the client's part is of the same version
  const auto if_range = request.header("if-range");
  const auto range_header = if_range && *if_range != etag ? std::nullopt : request.header("range");
  const auto [outcome, range] = parse_range(range_header.value_or(""), size);
  if (outcome == RangeOutcome::unsatisfiable) {
    response.status = 416;
    response.headers.emplace_back("Content-Range", "bytes */" + std::to_string(size));
    return response;
  }
  if (outcome == RangeOutcome::part) {
    response.status = 206;
    response.headers.emplace_back("Content-Range", "bytes " + std::to_string(range.offset) + "-" +
                                                       std::to_string(range.offset + range.size - 1) + "/" +
                                                       std::to_string(size));
  }
  response.body = BodyPart{std::move(source), range.offset, range.size};
  return response;
}

bool not_modified(const HttpRequest& request, std::string_view etag) {
  const auto header = request.header("if-none-match");
  return header && any_element(*header, [&](std::string_view candidate) {
           if (candidate.starts_with("W/")) candidate.remove_prefix(2);
           return candidate == "*" || candidate == etag;
         });
}

}  // namespace robot::net
