#include "robot/net/serve/routes.h"

#include <algorithm>
#include <charconv>

#include "robot/core/text.h"
#include "robot/net/http/asset_files.h"
#include "robot/net/serve/session_page.h"

namespace robot::net {
namespace {

constexpr std::string_view kReports = "/reports/", kLogs = "/logs/", kStatus = "/api/status", kList = "/api/sessions";
constexpr std::string_view kSessions = "/api/sessions/", kFilesOfSession = "/files";

// data of the robot; all other paths belong to the viewer
bool is_data(std::string_view path) {
  return path.starts_with("/api/") || path.starts_with("/logs") || path.starts_with(kReports);
}

bool is_list(std::string_view path) { return path == kList || path == "/logs" || path == kLogs; }

bool is_safe_name(std::string_view name) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' ||
           c == '-';
  };
  return !name.empty() && name.size() <= 200 && name.front() != '.' && std::ranges::all_of(name, allowed);
}

Result<std::optional<std::uint64_t>> parse_time(const Target& target, const char* name, const char* who = "logs") {
  const std::string text = target.parameter(name);
  if (text.empty()) return std::optional<std::uint64_t>();
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    return Error{std::string(who) + ": '" + name + "' must be a time in ns since the epoch"};
  return std::optional(value);
}

// the address of the same request, limited to the records until `until_ns`
std::string location(const Target& target, std::uint64_t until_ns) {
  return target.path + "?" + (target.query.empty() ? "" : target.query + "&") + "until=" + std::to_string(until_ns);
}

/// Returns the cookie called `name`, or an empty string.
std::string_view cookie(const HttpRequest& request, std::string_view name) {
  std::string_view rest = request.header("cookie").value_or("");
  while (!rest.empty()) {
    const std::string_view pair = rest.substr(0, rest.find(';'));
    rest.remove_prefix(std::min(rest.size(), pair.size() + 1));
    const std::string_view trimmed = pair.substr(std::min(pair.find_first_not_of(' '), pair.size()));
    if (trimmed.starts_with(name) && trimmed.substr(name.size()).starts_with('='))
      return trimmed.substr(name.size() + 1);
  }
  return {};
}

constexpr const char* kFoxglove = "foxglove";  // ?foxglove

constexpr std::string_view kCookie = "foresight_reader", kMethods = "GET, HEAD, DELETE, OPTIONS";

/// Returns the safe name between `before` and `after` if `path` consists of exactly these three parts.
std::optional<std::string> between(std::string_view before, std::string_view path, std::string_view after) {
  if (path.size() <= before.size() + after.size() || !path.starts_with(before) || !path.ends_with(after)) return {};
  const std::string_view name = path.substr(before.size(), path.size() - before.size() - after.size());
  if (!is_safe_name(name)) return {};
  return std::string(name);
}

/// Returns the lines of `text` that are not empty.
std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  for (const std::string_view line : split(text, "\n"))
    if (!line.empty()) lines.emplace_back(line);
  return lines;
}

HttpResponse game_in_progress() {
  return error_response(
      503, "a game is in progress: recordings can be had when it has finished, or with --practice in a test game");
}

}  // namespace

Access access_of(const AccessOptions& options, std::string_view address, const HttpRequest& request,
                 const Target& target) {
  const std::string token = target.parameter("token");
  const bool loopback = is_loopback(address);
  const bool control = loopback || same_token(token, options.control_token);
  return {.loopback = loopback,
          .may_watch = control || options.read_token.empty() || same_token(token, options.read_token) ||
                       same_token(cookie(request, kCookie), options.read_cookie),
          .may_control = control};
}

Work Routes::work_of(const HttpRequest& request) {
  const auto target = parse_target(request.target);
  if (!target || !is_data(target->path)) return Work::none;
  if (target->path == kStatus || is_list(target->path)) return Work::status;
  const bool whole = between(kSessions, target->path, kFilesOfSession) || target->path.starts_with(kWhole) ||
                     target->parameters.contains(kFoxglove);
  return whole ? Work::checksums : Work::files;
}

HttpResponse Routes::answer(const HttpRequest& request, std::string_view address, const ClientLeft& left) const {
  // with two Host headers, a proxy might check one and we the other
  if (std::ranges::count(request.headers, "host", &Headers::value_type::first) != 1)
    return error_response(400, "HTTP request: expected one Host header");
  if (auto accepted = check_host(access_.origins, *request.header("host")); !accepted)
    return error_response(403, accepted.error());

  HttpResponse response;
  if (const auto target = parse_target(request.target)) {
    response = route(request, *target, address, left);
    add_cookie(*target, response);
  } else {
    response = error_response(400, target.error());
  }
  add_cross_origin_headers(request, response);
  return response;
}

// the cookie replaces the token for reading, so that the token stays out of links that people share
void Routes::add_cookie(const Target& target, HttpResponse& response) const {
  const std::string token = target.parameter("token");
  if (access_.read_cookie.empty()) return;
  if (!same_token(token, access_.control_token) && !same_token(token, access_.read_token)) return;
  response.headers.emplace_back(
      "Set-Cookie", std::string(kCookie) + "=" + access_.read_cookie + "; Path=/; HttpOnly; SameSite=Strict");
}

HttpResponse Routes::route(const HttpRequest& request, const Target& target, std::string_view address,
                           const ClientLeft& left) const {
  const bool reads = request.method == "GET" || request.method == "HEAD";
  if (request.method == "OPTIONS") return {.status = 204, .headers = {{"Allow", std::string(kMethods)}}};
  if (!reads && request.method != "DELETE") {
    HttpResponse refused = error_response(405, "HTTP request: expected one of " + std::string(kMethods));
    refused.headers.emplace_back("Allow", kMethods);
    return refused;
  }

  // the viewer itself is public; the data that it shows may be protected
  if (auto asset = reads ? asset_response(assets_, request, target.path) : std::nullopt) return *std::move(asset);
  if (!is_data(target.path)) return error_response(404, "there is nothing at this path");
  const Access access = access_of(access_, address, request, target);
  return reads ? answer_data(request, target, access, left) : delete_session(request, target, access);
}

HttpResponse Routes::answer_data(const HttpRequest& request, const Target& target, const Access& access,
                                 const ClientLeft& left) const {
  if (!access.may_watch)
    return error_response(401, "reading from this robot needs its read token: add ?token=<token> to the address");
  if (target.path == kStatus) return text_response(200, "application/json", backend_.status_json());
  if (target.path == kList) return text_response(200, "application/json", backend_.sessions_json());
  if (is_list(target.path)) return answer_sessions(request);

  if (!access.loopback && backend_.match_mode()) return game_in_progress();
  if (const auto session = between(kSessions, target.path, kFilesOfSession))
    return backend_.session_files(*session, left);
  if (target.path.starts_with(kLogs)) return answer_log(request, target, left);
  if (const auto name = between(kReports, target.path, "")) return answer_report(*name);
  if (target.path == "/api/played") return answer_played(target);
  if (target.path.starts_with(kWhole)) return backend_.whole(target, left);
  if (target.path == "/api/recent") return backend_.recent(lines_of(target.parameter("topics")));
  return error_response(404, "there is nothing at this path");
}

HttpResponse Routes::delete_session(const HttpRequest& request, const Target& target, const Access& access) const {
  // a browser on this machine needs no token, so a foreign page must not use it to delete
  if (auto accepted = check_origin(access_.origins, request.header("origin"), request.header("host").value_or(""));
      !accepted)
    return error_response(403, accepted.error());
  if (!access.may_control)
    return error_response(401, "deleting a recording needs the control token: add ?token=<token> to the address");
  if (!access.loopback && backend_.match_mode()) return game_in_progress();
  const auto session = between(kLogs, target.path, "");
  return session ? backend_.delete_session(*session) : error_response(404, "expected DELETE /logs/<session>");
}

HttpResponse Routes::answer_sessions(const HttpRequest& request) const {
  std::string sessions = backend_.sessions_json();
  if (request.has_token("accept", "application/json"))
    return text_response(200, "application/json", std::move(sessions));
  return text_response(200, "text/html; charset=utf-8", session_page(sessions));
}

HttpResponse Routes::answer_log(const HttpRequest& request, const Target& target, const ClientLeft& left) const {
  auto log_request = parse_log_request(target);
  if (!log_request) return error_response(404, log_request.error());
  log_request->left = left;
  auto file = backend_.open_log(*log_request);
  if (!file) return error_response(404, file.error());
  std::string fixed;  // the address of what is sent now, if the recording grows
  if (file->redirect_until_ns) {
    fixed = location(target, *file->redirect_until_ns);
    // ranges of one file need one address; a whole file is sent at once, also to programs that follow no redirect
    if (request.method == "HEAD" || request.header("range"))
      return {.status = 307, .headers = {{"Location", fixed}, {"Cache-Control", "no-store"}}};
    log_request->until_ns = file->redirect_until_ns;
    file = backend_.open_log(*log_request);
    if (!file) return error_response(404, file.error());
  }

  const std::string name =
      log_request->file ? *log_request->file
                        : log_request->session + (log_request->stream ? "." + *log_request->stream : "") + ".mcap";
  HttpResponse response =
      body_response(request, std::move(file->body), "\"" + file->etag + "\"", "application/octet-stream");
  if (!fixed.empty()) response.headers.emplace_back("Content-Location", fixed);
  response.headers.emplace_back("Content-Disposition", "attachment; filename=\"" + name + "\"");
  return response;
}

// a page's link to a recording beside it opens the viewer, while the same link opens the file where nothing serves the page
HttpResponse Routes::answer_report(const std::string& name) const {
  if (name.ends_with(".html")) return backend_.report_page(name);
  if (name.ends_with(".mcap")) return {.status = 302, .headers = {{"Location", "/#/?session=" + name}}};
  return error_response(404, "reports: expected a path like /reports/<page>.html");
}

HttpResponse Routes::answer_played(const Target& target) const {
  const auto request = parse_played_request(target);
  return request ? backend_.played(*request) : error_response(400, request.error());
}

// pages of accepted origins may read our responses: Lichtblick opens recordings by their address
void Routes::add_cross_origin_headers(const HttpRequest& request, HttpResponse& response) const {
  const auto origin = request.header("origin");
  if (!origin || !check_origin(access_.origins, origin, request.header("host").value_or(""))) return;
  response.headers.emplace_back("Access-Control-Allow-Origin", *origin);
  response.headers.emplace_back(
      "Access-Control-Expose-Headers",
      "Accept-Ranges, Content-Length, Content-Range, ETag, Content-Type, " + std::string(kPlayedUntil));
  if (request.method == "OPTIONS") {
    response.headers.emplace_back("Access-Control-Allow-Methods", "GET, HEAD, OPTIONS");
    response.headers.emplace_back("Access-Control-Allow-Headers", "Range, If-Range, If-None-Match, Accept");
    response.headers.emplace_back("Access-Control-Max-Age", "600");
  }
  response.headers.emplace_back("Vary", "Origin");
}

Result<LogRequest> parse_log_request(const Target& target) {
  constexpr std::string_view kEnding = ".mcap", kFiles = "/files/";
  std::string_view rest = target.path;
  if (const std::size_t files = rest.find(kFiles); files != std::string_view::npos) {
    const auto session = between(kLogs, rest.substr(0, files), ""), file = between(kFiles, rest.substr(files), "");
    if (!session || !file) return Error{"logs: expected a path like /logs/<session>/files/<file>"};
    return LogRequest{.session = *session, .file = *file};
  }
  if (!rest.starts_with(kLogs) || !rest.ends_with(kEnding))
    return Error{"logs: expected a path like /logs/<session>.mcap"};
  rest.remove_prefix(kLogs.size());
  rest.remove_suffix(kEnding.size());

  LogRequest request;
  const std::size_t slash = rest.find('/');
  request.session = rest.substr(0, slash);
  if (slash != std::string_view::npos) request.stream = rest.substr(slash + 1);
  if (!is_safe_name(request.session) || (request.stream && !is_safe_name(*request.stream)))
    return Error{"logs: names consist of letters, digits, '.', '_' and '-' and do not begin with '.'"};

  for (const auto& [name, field] :
       {std::pair{"from", &LogRequest::from_ns}, {"to", &LogRequest::to_ns}, {"until", &LogRequest::until_ns}}) {
    const auto time = parse_time(target, name);
    if (!time) return time.failure();
    request.*field = *time;
  }
  request.foxglove = target.parameters.contains(kFoxglove);
  return request;
}

Result<PlayedRequest> parse_played_request(const Target& target) {
  PlayedRequest request{.topic = target.parameter("topic")};
  if (request.topic.empty()) return Error{"played: expected ?topic=<topic>, and from and to in ns since the epoch"};
  for (const auto& [name, field] : {std::pair{"from", &PlayedRequest::from_ns}, {"to", &PlayedRequest::to_ns}}) {
    const auto time = parse_time(target, name, "played");
    if (!time) return time.failure();
    if (*time) request.*field = **time;
  }
  return request;
}

}  // namespace robot::net
