#include "robot/lab/relay/robot_address.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.h"

namespace robot::lab {
namespace {

TEST(RobotAddress, AcceptsTheUsualFormsOfAnAddress) {
  const std::pair<const char*, const char*> cases[] = {
      {"10.0.14.22", "ws://10.0.14.22:8765/"},
      {"10.0.14.22:9000", "ws://10.0.14.22:9000/"},
      {"localhost", "ws://localhost:8765/"},
      {"tim.local:80/?token=abc", "ws://tim.local:80/?token=abc"},
      {"http://localhost:8765/", "ws://localhost:8765/"},
      {"ws://[fe80::1]", "ws://[fe80::1]:8765/"},
      {"[fe80::1]:81", "ws://[fe80::1]:81/"},
  };
  for (const auto& [text, address] : cases) {
    const auto found = web_socket_address(text);
    ASSERT_TRUE(found) << text << ": " << found.error();
    EXPECT_EQ(*found, address);
  }
  for (const char* text : {"", ":", "10.0.14.22:port", "wss://10.0.14.22", "a b.c", "[fe80::1", "10.0.0.1:123456"}) {
    const auto found = web_socket_address(text);
    ASSERT_FALSE(found) << text << ": " << *found;
    EXPECT_EQ(found.error(), "expected an address such as 10.0.14.22:8765, got '" + std::string(text) + "'");
  }
}

struct RobotsFile : testing::Test {
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder / "robots.json";

  void write(const std::string& text) { std::ofstream(file) << text; }
  std::string problem(const std::string& word) {
    const auto found = find_robots({word}, file);
    return found ? "" : found.error();
  }
};

TEST_F(RobotsFile, NamesAndPlayerNumbersGiveRobotsWithTheCableFirst) {
  write(R"({"team": 14, "robots": [
    {"name": "tim", "wired": "10.1.14.22", "wireless": "10.0.14.22", "player": 2},
    {"name": "lea", "address": "fe80::2", "http_port": 9000, "player": 3}]})");
  const auto found = find_robots({"tim", "3", "10.0.0.9?token=secret"}, file);
  ASSERT_TRUE(found) << found.error();
  EXPECT_EQ(found->at(0).addresses, (std::vector<std::string>{"ws://10.1.14.22:8765/", "ws://10.0.14.22:8765/"}));
  EXPECT_EQ(found->at(1).name, "lea");
  EXPECT_EQ(found->at(1).addresses, std::vector<std::string>{"ws://[fe80::2]:9000/"});
  EXPECT_EQ(found->at(2).name, "10.0.0.9") << "the name does not contain the token";
  EXPECT_EQ(find_robots({"tim", "2"}, file).error(), "expected each robot once, got tim twice");
}

TEST_F(RobotsFile, AWrongFileOrNameGivesASentence) {
  EXPECT_EQ(
      problem("tim").find("expected an address such as 10.0.14.22:8765, or a name of the robots file, got 'tim': "),
      0u);
  write("[]");
  EXPECT_EQ(problem("tim"), "expected an address such as 10.0.14.22:8765, or a name of the robots file, got 'tim': " +
                                file.string() + ": expected a JSON object with a list 'robots'");
  write(R"({"robots": [{"name": "tim", "player": 2}]})");
  EXPECT_NE(problem("tim").find("$.robots[0]: expected an 'address', or 'wired' and 'wireless', got neither"),
            std::string::npos);
  write(R"({"robots": [{"name": "tim", "address": "a", "http_port": "x"}]})");
  EXPECT_NE(problem("tim").find("$.robots[0].http_port: expected a whole number 1 .. 65535, got \"x\""),
            std::string::npos);
  write(R"({"robots": [{"name": "tim", "address": "a", "player": 2}, {"name": "lea", "address": "b", "player": 2}]})");
  EXPECT_EQ(problem("bob"),
            "expected an address such as 10.0.14.22:8765, or one of tim, lea (" + file.string() + "), got 'bob'");
  EXPECT_EQ(problem("2"), "expected the name of one robot, but '2' are tim and lea");
}

}  // namespace
}  // namespace robot::lab
