#include "robot/lab/relay/robot_address.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "robot/core/files.h"
#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "robot/net/websocket/web_socket_client.h"

namespace robot::lab {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostFileBytes = 1 << 20;
constexpr unsigned kPort = 8765;

/// Returns whether the word is an address and not a name. Names have neither dots nor colons.
bool looks_like_address(std::string_view word) {
  return word == "localhost" || word.find_first_of(".:") != std::string_view::npos;
}

std::string text_of(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// One robot of the file, with its player number.
struct Listed {
  RobotAddress robot;
  std::string player;
};

Result<Listed> listed(const Json& robot, const std::string& where) {
  if (!robot.is_object() || text_of(robot, "name").empty())
    return Error{where + ": expected a robot with a 'name', got one without"};
  const Json port = robot.value("http_port", Json(kPort)), player = robot.value("player", Json());
  if (!port.is_number_unsigned() || port.get<std::uint64_t>() > 65535)
    return Error{where + ".http_port: expected a whole number 1 .. 65535, got " + port.dump()};
  Listed found{.robot = {.name = text_of(robot, "name"), .addresses = {}},
               .player = player.is_number_unsigned() ? player.dump() : std::string()};
  // a cable first: it is faster and does not load the wireless network
  for (const char* way : {"address", "wired", "wireless"}) {
    const std::string host = text_of(robot, way);
    if (host.empty()) continue;
    const bool bare_v6 = std::ranges::count(host, ':') > 1;
    auto address = web_socket_address((bare_v6 ? "[" + host + "]" : host) + ":" + port.dump());
    if (!address) return address.failure(where + "." + way);
    found.robot.addresses.push_back(std::move(*address));
  }
  if (found.robot.addresses.empty())
    return Error{where + ": expected an 'address', or 'wired' and 'wireless', got neither"};
  return found;
}

Result<std::vector<Listed>> read_robots(const std::filesystem::path& file) {
  const Result<std::string> text = read_file(file, kMostFileBytes);
  if (!text) return text.failure();
  const Result<Json> json = parse_json(*text);
  if (!json) return json.failure(file.string());
  const Json robots = json->is_object() ? json->value("robots", Json()) : Json();
  if (!robots.is_array()) return Error{file.string() + ": expected a JSON object with a list 'robots'"};
  std::vector<Listed> all;
  for (const Json& robot : robots) {
    auto one = listed(robot, file.string() + ": $.robots[" + std::to_string(all.size()) + "]");
    if (!one) return one.failure();
    all.push_back(std::move(*one));
  }
  return all;
}

Result<RobotAddress> named(const std::string& word, const std::vector<Listed>& robots,
                           const std::filesystem::path& file) {
  std::string names;
  const Listed* found = nullptr;
  for (const Listed& one : robots) {
    names += (names.empty() ? "" : ", ") + one.robot.name;
    if (one.robot.name != word && one.player != word) continue;
    if (found)
      return Error{"expected the name of one robot, but '" + word + "' are " + found->robot.name + " and " +
                   one.robot.name};
    found = &one;
  }
  if (found) return found->robot;
  return Error{"expected an address such as 10.0.14.22:8765, or one of " + names + " (" + file.string() + "), got '" +
               word + "'"};
}

}  // namespace

Result<std::string> web_socket_address(std::string_view text) {
  std::string_view rest = text;
  for (const std::string_view scheme : {"ws://", "http://"})
    if (rest.starts_with(scheme)) rest.remove_prefix(scheme.size());
  const std::size_t end = std::min(rest.find_first_of("/?"), rest.size());
  std::string authority(rest.substr(0, end)), target(rest.substr(end));
  const std::size_t bracket = authority.find(']');
  if (authority.find(':', bracket == std::string::npos ? 0 : bracket) == std::string::npos)
    authority += ":" + std::to_string(kPort);
  if (!target.starts_with('/')) target.insert(0, "/");
  std::string address = "ws://" + authority + target;
  if (net::parse_web_socket_url(address) && rest.find("://") == std::string_view::npos) return address;
  return Error{"expected an address such as 10.0.14.22:8765, got '" + std::string(text.substr(0, 200)) + "'"};
}

Result<std::vector<RobotAddress>> find_robots(const std::vector<std::string>& words,
                                              const std::filesystem::path& file) {
  std::optional<std::vector<Listed>> listed;
  std::vector<RobotAddress> found;
  for (const std::string& word : words) {
    RobotAddress robot;
    if (looks_like_address(word)) {
      auto address = web_socket_address(word);
      if (!address) return address.failure();
      // the name is shown, so it must not contain a token
      robot = {.name = word.substr(0, word.find('?')), .addresses = {std::move(*address)}};
    } else {
      if (!listed) {
        auto read = read_robots(file);
        if (!read)
          return Error{"expected an address such as 10.0.14.22:8765, or a name of the robots file, got '" + word +
                       "': " + read.error()};
        listed = std::move(*read);
      }
      auto one = named(word, *listed, file);
      if (!one) return one.failure();
      robot = std::move(*one);
    }
    if (std::ranges::find(found, robot.addresses, &RobotAddress::addresses) != found.end())
      return Error{"expected each robot once, got " + robot.name + " twice"};
    found.push_back(std::move(robot));
  }
  return found;
}

std::filesystem::path default_robots_file() {
  if (const char* given = std::getenv("FORESIGHT_ROBOTS"); given && *given) return given;
  const char* const home = std::getenv("HOME");
  return std::filesystem::path(home ? home : "") / ".config/foresight/robots.json";
}

}  // namespace robot::lab
