#include "robot/app/services/watch_service.h"

#include <gtest/gtest.h>

#include "robot/core/json_library.h"
#include "tests/support/temporary_folder.h"

namespace robot::app {
namespace {

TEST(WatchService, RefusesEverythingThatIsNoSessionOfTheFolder) {
  const tests::TemporaryFolder folder;
  const logging::SessionStore store(folder.path(), 1'000'000);
  net::Services services;
  WatchWish wish;
  add_watch_service(services, store, wish);
  const net::ClientContext here{.id = 1, .loopback = true, .may_control = true};
  for (const char* request :
       {"{}", R"({"session":3})", R"({"session":"none"})", R"({"session":"../x"})", R"({"session":""})"})
    EXPECT_NE(services.call(1, request, here).find(R"("ok":false)"), std::string::npos) << request;
  EXPECT_NE(services.call(1, R"({"session":"none"})", {.id = 2}).find(R"("cause":"token")"), std::string::npos);
  EXPECT_FALSE(wish.get());
}

}  // namespace
}  // namespace robot::app
