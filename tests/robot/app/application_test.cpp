#include "robot/app/application.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>

#include "robot/core/files.h"
#include "robot/core/json_library.h"
#include "robot/logging/mcap/format.h"
#include "robot/logging/mcap/index.h"
#include "robot/logging/sessions/owned_folder.h"
#include "robot/logging/sessions/session_writer.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_channel.h"

namespace robot::app {
namespace {

using nlohmann::json;

struct ServedSession : ::testing::Test {
  ServedSession() {
    auto writer = logging::SessionWriter::create(folder / "one", {.name = "\"<b>\xff", .robot = "14/2"});
    EXPECT_TRUE((*writer)->write({.topic = "/14/2/a"}, 9'007'199'254'740'993, "a"));
    EXPECT_TRUE((*writer)->close());
  }
  const tests::TemporaryFolder folder;
  ManualClock clock{9'007'199'254'740'993};
  logging::SessionStore store{folder.path(), 1'000'000'000};
  Application application{
      {.name = "foresight-test", .body = "none", .robots = {"14/2"}, .session_id = "7"}, clock, store, nullptr};
};

TEST_F(ServedSession, StatusReportsTheNamesOfTheProcess) {
  application.count_clients_by([] { return std::size_t{3}; });
  const json status = json::parse(application.status_json());
  EXPECT_EQ(status["name"], "foresight-test");
  EXPECT_EQ(status["robots"], json::array({"14/2"}));
  EXPECT_EQ(status["clients"], 3);
  EXPECT_EQ(status["recording"]["state"], "off");
}

TEST_F(ServedSession, StatusReportsTheGame) {
  json game = {{"state", ""},       {"in_progress", false}, {"match_mode", false},
               {"practice", false}, {"warning", ""},        {"stopped", ""}};
  EXPECT_EQ(json::parse(application.status_json())["game"], game);
  EXPECT_FALSE(application.match_mode());
  application.tell_game_by([] { return GameStatus{.state = "set", .in_progress = true, .match_mode = true}; });
  game["state"] = "set";
  game["in_progress"] = game["match_mode"] = true;
  EXPECT_EQ(json::parse(application.status_json())["game"], game);
  EXPECT_TRUE(application.match_mode());
}

TEST_F(ServedSession, TheLastMinutesAreAnMcapFileOrNotKept) {
  EXPECT_EQ(application.recent({}).status, 404);
  memory::Channels channels;
  const auto channel = tests::make_channel(clock);
  ASSERT_TRUE(channels.add(channel));
  logging::RecentPast recent(channels);
  application.recall_from(recent);
  ASSERT_TRUE(channel->write_bytes("a value", 5));
  const net::HttpResponse response = application.recent({channel->info().topic});
  EXPECT_EQ(response.status, 200);
  const auto& body = std::get<net::BodyPart>(response.body);
  EXPECT_EQ(body.size, body.source->size());
  const auto index = logging::read_index(*body.source);
  ASSERT_TRUE(index);
  EXPECT_EQ(index->statistics.messages, 1u);
}

// a browser's numbers are exact up to 2^53
TEST_F(ServedSession, TimesKeepAllTheirDigits) {
  EXPECT_EQ(json::parse(application.status_json())["time_ns"], "9007199254740993");
  EXPECT_EQ(json::parse(application.sessions_json())["sessions"][0]["start_ns"], "9007199254740993");
}

TEST_F(ServedSession, SessionsOfAnyNameAreListed) {
  const json session = json::parse(application.sessions_json())["sessions"][0];
  EXPECT_EQ(session["session"], "one");
  EXPECT_EQ(session["url"], "/logs/one.mcap");
  EXPECT_EQ(session["streams"][0]["url"], "/logs/one/14.2.a.mcap");
  EXPECT_EQ(session["streams"][0]["messages"], 1);
}

TEST_F(ServedSession, ItsChosenObjectsAreListedOrNone) {
  EXPECT_EQ(json::parse(application.sessions_json())["sessions"][0]["only"], json::array());
  auto writer = logging::SessionWriter::create(folder / "two", {.robot = "14/2", .only = {"a"}});
  ASSERT_TRUE((*writer)->close());
  const json listing = json::parse(application.sessions_json());
  for (const json& session : listing["sessions"])
    EXPECT_EQ(session["only"], session["session"] == "two" ? json::array({"a"}) : json::array());
}

TEST_F(ServedSession, ADownloadIsReadFromAnyOffset) {
  const auto file = application.open_log({.session = "one"});
  ASSERT_TRUE(file) << file.error();
  std::string whole(file->body->size(), '\0');
  ASSERT_TRUE(file->body->read(0, whole));
  for (std::uint64_t offset = 0; offset < whole.size(); ++offset) {
    char byte = 0;
    ASSERT_TRUE(file->body->read(offset, {&byte, 1}));
    ASSERT_EQ(byte, whole[offset]);
  }
  char beyond = 0;
  EXPECT_FALSE(file->body->read(whole.size(), {&beyond, 1}));
}

TEST_F(ServedSession, ADownloadOfARunningSessionRedirectsToATimeThatIsWritten) {
  const auto owner = logging::OwnedFolder::own(folder / "one");
  const auto file = application.open_log({.session = "one"});
  ASSERT_TRUE(file);
  EXPECT_EQ(file->redirect_until_ns, 9'007'199'254'740'993 - logging::Downloads::kLiveMarginNs);
  EXPECT_TRUE(application.open_log({.session = "one", .until_ns = 9'007'199'254'740'993})->body);
}

TEST_F(ServedSession, ItsFilesAreServedUnchanged) {
  const json files = json::parse(std::get<std::string>(application.session_files("one", {}).body))["files"];
  ASSERT_EQ(files.size(), 2u);
  for (const json& listed : files) {
    const std::string name = listed["name"];
    const auto file = application.open_log({.session = "one", .file = name});
    ASSERT_TRUE(file) << file.error();
    std::string bytes(listed["size_bytes"].get<std::size_t>(), '\0');
    ASSERT_EQ(file->body->size(), bytes.size());
    ASSERT_TRUE(file->body->read(0, bytes));
    EXPECT_EQ(bytes, *read_file(folder / "one" / name, 1 << 20));
    EXPECT_EQ(std::stoul(listed["crc32"].get<std::string>(), nullptr, 16), logging::mcap::crc32(bytes));
  }
  EXPECT_EQ(application.session_files("two", {}).status, 404);
  EXPECT_EQ(application.open_log({.session = "one", .file = "token"}).error(), "session one: there is no file 'token'");
}

TEST_F(ServedSession, LinksPipesAndSubfoldersInItAreNotServed) {
  ASSERT_TRUE(replace_file(folder / "secret", "secret"));
  std::filesystem::create_symlink(folder / "secret", folder / "one" / "link");
  std::filesystem::create_symlink(folder / "one" / "14.2.a.mcap", folder / "one" / "link.mcap");
  std::filesystem::create_directory(folder / "one" / "sub");
  for (const char* pipe : {"pipe", "pipe.mcap"}) ASSERT_EQ(::mkfifo((folder / "one" / pipe).c_str(), 0600), 0);
  for (const char* name : {"link", "link.mcap", "sub", "pipe", "pipe.mcap"})
    EXPECT_EQ(application.open_log({.session = "one", .file = name}).error(),
              std::string("session one: expected an ordinary file '") + name +
                  "', got a link, a pipe or a folder, which is not served");
  EXPECT_EQ(application.open_log({.session = "one", .stream = "link"}).error(),
            "session one: there is no stream 'link.mcap'");
  EXPECT_EQ(application.open_log({.session = "one", .stream = "pipe"}).error(),
            "session one: there is no stream 'pipe.mcap'");
  // the rest of the session is served as before
  EXPECT_TRUE(application.open_log({.session = "one"}));
  const json session = json::parse(application.sessions_json())["sessions"][0];
  EXPECT_EQ(session["streams"].size(), 1u);
  EXPECT_EQ(json::parse(std::get<std::string>(application.session_files("one", {}).body))["files"].size(), 2u);
  // a pipe instead of the description
  std::filesystem::create_directory(folder / "two");
  ASSERT_EQ(::mkfifo((folder / "two" / "session.json").c_str(), 0600), 0);
  EXPECT_EQ(json::parse(application.sessions_json())["sessions"].size(), 1u);
  EXPECT_EQ(application.session_files("two", {}).status, 404);
}

TEST_F(ServedSession, IsNeitherServedNorDeletedDuringItsRecording) {
  std::optional owner = *logging::OwnedFolder::own(folder / "one");
  EXPECT_EQ(application.session_files("one", {}).status, 409);
  EXPECT_FALSE(application.open_log({.session = "one", .file = "session.json"}));
  EXPECT_EQ(application.delete_session("one").status, 409);
  owner.reset();
  EXPECT_EQ(application.delete_session("one").status, 204);
  EXPECT_EQ(application.delete_session("one").status, 404);
}

TEST_F(ServedSession, DownloadsForOtherViewersAreMadeByWhoeverSetsTheirMaker) {
  EXPECT_EQ(application.open_log({.session = "one", .foxglove = true}).error(),
            "session one: foresight-test makes no downloads with ?foxglove; scripts/logs fetches the session, and "
            "foresight-lab play makes them");
  const auto offered = [&] { return json::parse(application.sessions_json())["sessions"][0]["foxglove_url"]; };
  EXPECT_EQ(offered(), "") << "a page offers only what works";
  application.draw_downloads_by([](const auto&, const std::filesystem::path&, const std::string&, const auto&) {
    return Result<std::shared_ptr<const ByteSource>>(Error{"made elsewhere"});
  });
  EXPECT_EQ(application.open_log({.session = "one", .foxglove = true}).error(), "made elsewhere");
  EXPECT_EQ(offered(), "/logs/one.mcap?foxglove");
  EXPECT_TRUE(application.open_log({.session = "one"}));
}

TEST_F(ServedSession, ReportsBesideAPlayedRecordingAreServedWithoutScripts) {
  ASSERT_TRUE(replace_file(folder / "report.html", "<h1>B is better</h1>"));
  ASSERT_TRUE(replace_file(folder / "notes.txt", "private"));
  std::filesystem::create_symlink(folder / "notes.txt", folder / "link.html");
  EXPECT_EQ(json::parse(application.sessions_json())["reports"], json::array());
  EXPECT_EQ(application.report_page("report.html").status, 404) << "a robot plays nothing";
  application.play_by([](const net::PlayedRequest&) { return net::HttpResponse{}; });
  EXPECT_EQ(json::parse(application.sessions_json())["reports"], json::array({"report.html"}));
  const net::HttpResponse page = application.report_page("report.html");
  EXPECT_EQ(page.status, 200);
  EXPECT_EQ(std::get<std::string>(page.body), "<h1>B is better</h1>");
  const auto policy =
      std::ranges::find(page.headers, "Content-Security-Policy", [](const auto& one) { return one.first; });
  ASSERT_NE(policy, page.headers.end());
  EXPECT_TRUE(policy->second.starts_with("default-src 'none'; ")) << policy->second;
  for (const char* none : {"link.html", "none.html", "one"})
    EXPECT_EQ(application.report_page(none).status, 404) << none;
}

TEST_F(ServedSession, AnUnknownSessionOrFileIsNamed) {
  EXPECT_EQ(application.open_log({.session = "two"}).error(), "session: there is none called 'two'");
  EXPECT_EQ(application.open_log({.session = "one", .stream = "b"}).error(),
            "session one: there is no stream 'b.mcap'");
}

}  // namespace
}  // namespace robot::app
