#include "robot/app/application.h"

#include <cstdio>
#include <filesystem>
#include <utility>

#include "robot/app/build_id.h"
#include "robot/core/byte_source.h"
#include "robot/core/files.h"
#include "robot/core/folder.h"
#include "robot/core/json_library.h"
#include "robot/core/report.h"

namespace robot::app {
namespace {

using nlohmann::json;

std::string text(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

/// Converts a 64-bit number to text, because a browser's numbers are exact to 53 bits only.
std::string exact(std::uint64_t value) { return std::to_string(value); }

json describe(const logging::RecordingStatus& status) {
  return {{"state", name(status.state)}, {"request", status.request},
          {"session", status.session},   {"profile", status.profile},
          {"bytes", status.size_bytes},  {"messages", status.messages},
          {"waiting", status.waiting},   {"dropped", status.dropped},
          {"message", status.message},   {"mb_per_minute", status.mb_per_minute}};
}

json describe(const GameStatus& game) {
  return {{"state", game.state},       {"in_progress", game.in_progress}, {"match_mode", game.match_mode},
          {"practice", game.practice}, {"warning", game.warning},         {"stopped", game.stopped}};
}

json describe(const logging::StreamFile& stream, const std::string& session) {
  return {{"topic", stream.topic},
          {"file", stream.file},
          {"url", "/logs/" + session + "/" + stream.file},
          {"schema", stream.schema},
          {"messages", stream.messages},
          {"size_bytes", stream.size_bytes},
          {"start_ns", exact(stream.start_ns)},
          {"end_ns", exact(stream.end_ns)},
          {"damage", stream.damage}};
}

/// `foxglove`: downloads with ?foxglove are made here.
json describe(const logging::Session& session, bool foxglove) {
  const std::string url = "/logs/" + session.id() + ".mcap";
  json streams = json::array();
  for (const logging::StreamFile& stream : session.streams) streams.push_back(describe(stream, session.id()));
  return {{"session", session.id()},
          {"name", session.info.name},
          {"robot", session.info.robot},
          {"team", session.info.team},
          {"player", session.info.player},
          {"build", session.info.build},
          {"profile", session.info.profile},
          {"start_ns", exact(session.start_ns)},
          {"end_ns", exact(session.end_ns)},
          {"size_bytes", session.size_bytes},
          {"state", name(session.state)},
          {"read", session.read},
          {"message", session.message},
          {"kept", session.info.kept},
          {"only", session.info.only},
          {"behind_ns", std::to_string(session.info.behind_ns)},
          {"url", url},
          {"foxglove_url", foxglove ? url + "?foxglove" : ""},
          {"streams", std::move(streams)}};
}

/// The ending of the names of reports, and the largest that is served.
constexpr std::string_view kReport = ".html";
constexpr std::size_t kMaxReportBytes = 5'000'000;

/// Returns the names of the reports in a folder.
json reports_in(const std::filesystem::path& folder) {
  json reports = json::array();
  const auto entries = list_folder(folder);
  if (!entries) return reports;
  for (const FolderEntry& entry : *entries)
    if (entry.kind == FolderEntry::Kind::file && entry.name.ends_with(kReport)) reports.push_back(entry.name);
  return reports;
}

/// A list waits this long for sessions that nobody has read yet.
constexpr std::uint64_t kListWithinNs = 100 * kMillisecond;

/// Opens a file of a session that is not being recorded. The file's size and time are its version (ETag).
Result<net::LogFile> open_file(const logging::Session& session, const std::string& file) {
  const std::string who = "session " + session.id() + ": ";
  if (session.state == logging::SessionState::recording)
    return Error{who + "it is being recorded, its files are not complete yet"};
  std::error_code ignored;
  const auto kind = std::filesystem::symlink_status(session.folder / file, ignored).type();
  if (kind == std::filesystem::file_type::not_found) return Error{who + "there is no file '" + file + "'"};
  if (kind != std::filesystem::file_type::regular)
    return Error{who + "expected an ordinary file '" + file + "', got a link, a pipe or a folder, which is not served"};
  auto source = FileSource::open(session.folder / file, Links::refuse);
  if (!source) return Error{who + "the file '" + file + "' cannot be read"};
  const auto written = std::filesystem::last_write_time(session.folder / file, ignored).time_since_epoch().count();
  return net::LogFile{.body = *source,
                      .etag = std::to_string((*source)->size()) + "-" + std::to_string(written),
                      .redirect_until_ns = {}};
}

}  // namespace

std::string Application::status_json() {
  return text({{"name", identity_.name},
               {"build", kBuildId},
               {"session_id", identity_.session_id},
               {"time_ns", exact(clock_.now_ns())},
               {"body", identity_.body},
               {"robots", identity_.robots},
               {"recording", describe(recorder_ ? recorder_->status() : logging::RecordingStatus{})},
               {"game", describe(game_ ? game_() : GameStatus{})},
               {"clients", count_clients_()},
               {"disk", {{"free_bytes", store_.disk_free_bytes()}, {"log_dir_bytes", store_.size_bytes()}}}});
}

std::string Application::sessions_json() {
  json sessions = json::array();
  for (const logging::Session& session : store_.list_within(kListWithinNs))
    sessions.push_back(describe(session, bool(foxglove_file_)));
  return text({{"sessions", std::move(sessions)}, {"reports", played_ ? reports_in(store_.folder()) : json::array()}});
}

Result<net::LogFile> Application::open_log(const net::LogRequest& request) {
  const Result<logging::Session> session = store_.find(request.session);
  if (!session) return session.failure();
  if (request.file) return open_file(*session, *request.file);
  if (request.foxglove && !foxglove_file_)
    return Error{
        "session " + request.session + ": " + identity_.name +
        " makes no downloads with ?foxglove; scripts/logs fetches the session, and foresight-lab play makes them"};
  if (session->state == logging::SessionState::recording && !request.until_ns)
    return net::LogFile{
        .body = nullptr, .etag = "", .redirect_until_ns = clock_.now_ns() - logging::Downloads::kLiveMarginNs};
  std::optional<std::string> file;
  if (request.stream) file = *request.stream + ".mcap";
  logging::Downloads::Extend extend;
  if (request.foxglove)
    extend = [&](const std::shared_ptr<const logging::Assembly>& recorded) {
      return foxglove_file_(recorded, store_.folder(), session->info.rules, request.left);
    };
  const auto assembly = downloads_.open(
      *session, file, {.from_ns = request.from_ns, .to_ns = request.to_ns, .until_ns = request.until_ns}, extend);
  if (!assembly) return assembly.failure();
  return net::LogFile{.body = *assembly, .etag = (*assembly)->etag(), .redirect_until_ns = {}};
}

net::HttpResponse Application::session_files(const std::string& session, const net::ClientLeft& left) {
  const Result<logging::Session> found = store_.find(session);
  if (!found) return net::error_response(404, found.error());
  if (found->state == logging::SessionState::recording)
    return net::error_response(409, "session " + session + ": it is being recorded, its files are not complete yet");
  const auto files = checksums_.of_folder(found->folder, left);
  if (!files) return net::error_response(500, files.error());
  json list = json::array();
  for (const logging::SessionFile& file : *files) {
    char crc[9];
    std::snprintf(crc, sizeof crc, "%08x", file.crc32);
    list.push_back({{"name", file.name}, {"size_bytes", file.size_bytes}, {"crc32", crc}});
  }
  return net::text_response(200, "application/json", text({{"session", session}, {"files", std::move(list)}}));
}

net::HttpResponse Application::delete_session(const std::string& session) {
  if (const auto found = store_.find(session); !found) return net::error_response(404, found.error());
  if (const Result<void> removed = store_.remove(session); !removed) return net::error_response(409, removed.error());
  report(Level::info, "logs", "session " + session + " was deleted by a client");
  return {.status = 204};
}

net::HttpResponse Application::report_page(const std::string& page) {
  if (!played_) return net::Backend::report_page(page);
  const std::filesystem::path path = store_.folder() / page;
  if (!is_plain_file(path))
    return net::error_response(404, "reports: there is no page '" + page + "' beside the recording");
  Result<std::string> html = read_file(path, kMaxReportBytes);
  if (!html) return net::error_response(404, html.error());
  net::HttpResponse response = net::text_response(200, "text/html; charset=utf-8", std::move(*html));
  // a page from elsewhere must run no script in the name of the viewer
  response.headers.emplace_back("Content-Security-Policy",
                                "default-src 'none'; style-src 'unsafe-inline'; form-action 'none'");
  response.headers.emplace_back("Cache-Control", "no-cache");
  return response;
}

net::HttpResponse Application::recent(const std::vector<std::string>& topics) {
  if (!recent_) return net::Backend::recent(topics);
  Result<std::shared_ptr<const ByteSource>> file = recent_->file(topics);
  if (!file) return net::error_response(500, file.error());
  const std::uint64_t size = (*file)->size();
  return {.status = 200,
          .headers = {{"Content-Type", "application/octet-stream"},
                      {"Content-Disposition", "attachment; filename=\"recent.mcap\""},
                      {"Cache-Control", "no-store"}},
          .body = net::BodyPart{.source = std::move(*file), .offset = 0, .size = size}};
}

bool Application::match_mode() const { return game_ && game_().match_mode; }

}  // namespace robot::app
