#include "sim/io/json.h"
#include "robot/core/json_library.h"

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <vector>

namespace sim::io {

using robot::Error;
using robot::Result;

namespace {

constexpr int kMaxDepth = 64;

/// A check during parsing for faults that valid JSON may have.
class Watch {
 public:
  using Event = Json::parse_event_t;
  bool operator()(int depth, Event event, const Json& parsed) {
    if (depth > kMaxDepth && wrong_.empty()) wrong_ = "nested deeper than " + std::to_string(kMaxDepth);
    if (event == Event::object_start) keys_.emplace_back();
    if (event == Event::object_end) keys_.pop_back();
    if (event == Event::key && !keys_.back().insert(parsed.get<std::string>()).second && wrong_.empty())
      wrong_ = "'" + parsed.get<std::string>() + "' stands twice in one object";
    return true;
  }
  const std::string& wrong() const { return wrong_; }

 private:
  std::vector<std::set<std::string>> keys_;  // of the open objects
  std::string wrong_;
};

/// Returns the parser's message without its number.
std::string complaint(std::string_view what) {
  const std::size_t end = what.find("] ");
  return std::string(end == what.npos ? what : what.substr(end + 2));
}

}  // namespace

Result<Json> parse_object(std::string_view text, const std::string& called) {
  try {
    Watch watch;
    Json json = Json::parse(text, std::ref(watch));
    if (!watch.wrong().empty()) return Error{called + ": " + watch.wrong()};
    if (!json.is_object()) return Error{called + ": expected a JSON object, got " + shown(json)};
    return json;
  } catch (const Json::exception& error) {
    return Error{called + ": not JSON: " + complaint(error.what())};
  }
}

std::string printed(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

std::string shown(const Json& json) {
  constexpr std::size_t kLongest = 40;
  const std::string text = json.dump(-1, ' ', true, Json::error_handler_t::replace);
  return text.size() <= kLongest ? text : text.substr(0, kLongest) + "…";
}

std::string quoted(std::string_view text) { return shown(Json(std::string(text))); }

std::string short_text(float value) {
  char text[32];
  // six digits or more; all floats differ in nine. std::to_chars would bring 125 kB of tables to the robot.
  for (int digits = 6; digits <= 9; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, static_cast<double>(value));
    if (std::strtof(text, nullptr) == value) break;
  }
  return text;
}

double short_number(float value) {
  const std::string text = short_text(value);
  double number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

}  // namespace sim::io
