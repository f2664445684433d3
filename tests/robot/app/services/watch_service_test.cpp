#include "robot/app/services/watch_service.h"

#include <gtest/gtest.h>

#include "robot/core/json_library.h"
#include "robot/logging/sessions/session_writer.h"
#include "tests/support/temporary_folder.h"

namespace robot::app {
namespace {

struct WatchService : ::testing::Test {
  WatchService() { add_watch_service(services, store, wish); }

  const tests::TemporaryFolder folder;
  const logging::SessionStore store{folder.path(), 1'000'000};
  net::Services services;
  WatchWish wish;
};

TEST_F(WatchService, RefusesEverythingThatIsNoSessionOfTheFolder) {
  const net::ClientContext here{.id = 1, .loopback = true, .may_control = true};
  for (const char* request :
       {"{}", R"({"session":3})", R"({"session":"none"})", R"({"session":"../x"})", R"({"session":""})"})
    EXPECT_NE(services.call(1, request, here).find(R"("ok":false)"), std::string::npos) << request;
  EXPECT_NE(services.call(1, R"({"session":"none"})", {.id = 2}).find(R"("cause":"token")"), std::string::npos);
  EXPECT_FALSE(wish.get());
}

TEST_F(WatchService, PlaysAFileWithManyChannelsBesideTheSessions) {
  const auto watch = [&](const std::string& name) {
    return services.call(1, R"({"session":")" + name + "\"}", {.id = 1, .loopback = true, .may_control = true});
  };
  auto writer = logging::SessionWriter::create(folder / "s", {.robot = "14/2"});
  ASSERT_TRUE((*writer)->write({.topic = "/14/2/a"}, 5, "a"));
  ASSERT_TRUE((*writer)->close());
  std::filesystem::copy_file(folder / "s/14.2.a.mcap", folder / "game.mcap");
  std::filesystem::create_symlink(folder / "game.mcap", folder / "link.mcap");
  for (const char* name : {"none.mcap", "link.mcap", "../game.mcap", "s/14.2.a.mcap"})
    EXPECT_NE(watch(name).find(R"("ok":false)"), std::string::npos) << name;
  EXPECT_FALSE(wish.get());
  EXPECT_EQ(watch("game.mcap"), R"({"ok":true})");
  EXPECT_EQ(wish.get(), folder / "game.mcap");
}

}  // namespace
}  // namespace robot::app
