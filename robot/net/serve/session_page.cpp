#include "robot/net/serve/session_page.h"

#include <ctime>

#include "robot/core/json.h"
#include "robot/core/json_library.h"

namespace robot::net {
namespace {

using Json = nlohmann::json;

std::string text(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

double number(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? found->get<double>() : 0;
}

std::string megabytes(double bytes) {
  char shown[32];
  std::snprintf(shown, sizeof shown, "%.1f MB", bytes / 1e6);
  return shown;
}

// times are decimal strings [ns since the epoch]
std::string shown_time(const std::string& ns) {
  const std::time_t seconds = static_cast<std::time_t>(std::strtoull(ns.c_str(), nullptr, 10) / 1'000'000'000);
  std::tm parts{};
  char shown[32] = "";
  if (seconds == 0 || !gmtime_r(&seconds, &parts)) return "";
  std::strftime(shown, sizeof shown, "%Y-%m-%d %H:%M:%S UTC", &parts);
  return shown;
}

std::string link(const std::string& url, const std::string& name) {
  if (!url.starts_with('/')) return escaped(name);  // our own links only
  return "<a href=\"" + escaped(url) + "\">" + escaped(name) + "</a>";
}

std::string streams(const Json& session) {
  const auto list = session.find("streams");
  if (list == session.end() || !list->is_array() || list->empty()) return "";
  std::string html = "<details><summary>" + std::to_string(list->size()) + " streams</summary><ul>\n";
  for (const Json& stream : *list) {
    if (!stream.is_object()) continue;
    const std::string topic = text(stream, "topic");  // empty if the file does not contain it
    html += "<li>" + link(text(stream, "url"), topic.empty() ? text(stream, "file") : topic) + " " +
            std::to_string(static_cast<long long>(number(stream, "messages"))) + " messages, " +
            megabytes(number(stream, "size_bytes")) + "\n";
  }
  return html + "</ul></details>";
}

std::string row(const Json& session) {
  std::string html = "<tr><td>" + link(text(session, "url"), text(session, "session"));
  const std::string cells[] = {text(session, "name"), text(session, "robot"), shown_time(text(session, "start_ns")),
                               megabytes(number(session, "size_bytes")),
                               text(session, "state") + " " + text(session, "message")};
  for (const std::string& cell : cells) html += "<td>" + escaped(cell);
  return html + "<td>" + streams(session) + "\n";
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text) switch (c) {
      case '&': html += "&amp;"; break;
      case '<': html += "&lt;"; break;
      case '>': html += "&gt;"; break;
      case '"': html += "&quot;"; break;
      case '\'': html += "&#39;"; break;
      default: html += c;
    }
  return html;
}

std::string session_page(std::string_view sessions_json) {
  std::string html =
      "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>Recordings</title>\n<link rel=\"icon\" "
      "href=\"/favicon.svg\" type=\"image/svg+xml\">\n<h1>Recordings</h1>\n"
      "<p>Each is one MCAP file; Foxglove and Lichtblick open it, too. <a href=\"/\">To the viewer</a>\n"
      "<table>\n<tr><th>recording<th>name<th>robot<th>begin<th>size<th>state<th>streams\n";
  const Result<Json> json = parse_json(sessions_json);
  const Json sessions = json && json->is_object() ? json->value("sessions", Json::array()) : Json::array();
  for (const Json& session : sessions)
    if (session.is_object()) html += row(session);
  return html + "</table>\n</html>\n";
}

}  // namespace robot::net
