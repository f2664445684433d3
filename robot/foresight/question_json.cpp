// Questions as JSON.
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "robot/foresight/question.h"

namespace robot::foreseeing {
namespace {

using nlohmann::json;

// the enumerators of the messages are those of the simulator
using sim::foresight::kMeasureNames;
using sim::foresight::kUntilNames;

/// Reads members of a JSON object into a message, and keeps the first error.
class Reader {
 public:
  bool good() const { return problem_.empty(); }
  Error error() const { return Error{problem_}; }
  void refuse(std::string problem) {
    if (good()) problem_ = std::move(problem);
  }

  bool is_object(const json& value, const std::string& path, std::initializer_list<std::string_view> keys) {
    if (!value.is_object()) {
      refuse((path.empty() ? "a question" : "'" + path + "'") + " must be an object, got " + shown(value));
      return false;
    }
    for (const auto& item : value.items())
      if (std::find(keys.begin(), keys.end(), item.key()) == keys.end())
        refuse("'" + below(path, item.key().substr(0, 40)) + "' is no member of a question");
    return good();
  }

  /// Calls set(number) if the member exists. Ranges are checked by `complete`.
  template <class Set>
  void read_number(const json& object, const std::string& path, const char* key, Set&& set) {
    const auto found = object.find(key);
    if (found == object.end()) return;
    if (!found->is_number() || !std::isfinite(found->get<double>()))
      return refuse("'" + below(path, key) + "' must be a number, got " + shown(*found));
    set(found->get<double>());
  }

  template <class Set>
  void read_count(const json& object, const std::string& path, const char* key, Set&& set) {
    const auto found = object.find(key);
    if (found == object.end()) return;
    const std::optional<std::int64_t> count = whole_number(*found);
    if (!count || *count < 0 || *count > 1'000'000'000)
      return refuse("'" + below(path, key) + "' must be a whole number 0 .. 1000000000, got " + shown(*found));
    set(static_cast<std::uint32_t>(*count));
  }

  template <class Set>
  void read_text(const json& object, const char* key, Set&& set) {
    const auto found = object.find(key);
    if (found == object.end()) return;
    if (!found->is_string()) return refuse("'" + std::string(key) + "' must be a text, got " + shown(*found));
    set(found->get<std::string>());
  }

  template <std::size_t Count, class Set>
  void read_name(const json& object, const char* key, const std::array<const char*, Count>& names, Set&& set) {
    const auto found = object.find(key);
    if (found == object.end()) return;
    std::string all;
    for (std::size_t i = 0; i < Count; ++i) {
      if (*found == names[i]) return set(static_cast<int>(i));
      all += (i == 0 ? "" : ", ") + std::string(names[i]);
    }
    refuse("'" + std::string(key) + "' must be one of " + all + ", got " + shown(*found));
  }

  static std::string below(const std::string& path, std::string_view key) {
    return path.empty() ? std::string(key) : path + "." + std::string(key);
  }

 private:
  std::string problem_;
};

void read_place(Reader& reader, const json& object, const std::string& path, auto& place) {
  for (const char* key : {"x", "y"})
    if (!object.contains(key)) reader.refuse("'" + Reader::below(path, key) + "' is missing");
  reader.read_number(object, path, "x", [&](double x) { place.set_x(static_cast<float>(x)); });
  reader.read_number(object, path, "y", [&](double y) { place.set_y(static_cast<float>(y)); });
}

void read_moved(Reader& reader, const json& object, const std::string& path, pb::WhatIf::MovedRobot& robot) {
  if (!reader.is_object(object, path, {"side", "player", "x", "y", "heading"})) return;
  const auto side = object.find("side");
  if (side == object.end() || (*side != "own" && *side != "opponent"))
    reader.refuse("'" + path + ".side' must be own or opponent, got " +
                  (side == object.end() ? "nothing" : shown(*side)));
  else
    robot.set_opponent(*side == "opponent");
  if (!object.contains("player")) reader.refuse("'" + path + ".player' is missing");
  reader.read_count(object, path, "player", [&](std::uint32_t player) { robot.set_player(player); });
  read_place(reader, object, path, robot);
  reader.read_number(object, path, "heading", [&](double heading) { robot.set_heading(static_cast<float>(heading)); });
}

void read_edit(Reader& reader, const json& object, pb::WhatIf::Edit& edit) {
  if (!reader.is_object(object, "edit", {"ball", "robots", "own_score", "opponent_score", "seconds_remaining"})) return;
  if (const auto ball = object.find("ball"); ball != object.end() && reader.is_object(*ball, "edit.ball", {"x", "y"}))
    read_place(reader, *ball, "edit.ball", *edit.mutable_ball());
  if (const auto robots = object.find("robots"); robots != object.end()) {
    if (!robots->is_array() || robots->size() > sim::kMaxRobots)
      return reader.refuse("'edit.robots' must be a list of at most " + std::to_string(sim::kMaxRobots) + ", got " +
                           shown(*robots));
    for (std::size_t i = 0; i < robots->size(); ++i)
      read_moved(reader, (*robots)[i], "edit.robots[" + std::to_string(i) + "]", *edit.add_robots());
  }
  reader.read_count(object, "edit", "own_score", [&](std::uint32_t score) { edit.set_own_score(score); });
  reader.read_count(object, "edit", "opponent_score", [&](std::uint32_t score) { edit.set_opponent_score(score); });
  reader.read_number(object, "edit", "seconds_remaining",
                     [&](double seconds) { edit.set_seconds_remaining(static_cast<float>(seconds)); });
}

}  // namespace

Result<pb::WhatIf> parse_question(const json& asked) {
  Reader reader;
  pb::WhatIf question;
  if (!reader.is_object(
          asked, "",
          {"strategies", "opponent", "measure", "until", "horizon", "budget_ms", "switching_cost", "sure", "edit"}))
    return reader.error();
  if (const auto strategies = asked.find("strategies"); strategies != asked.end()) {
    if (!strategies->is_array() ||
        !std::all_of(strategies->begin(), strategies->end(), [](const json& name) { return name.is_string(); }) ||
        strategies->size() > 100)
      reader.refuse("'strategies' must be a list of names, got " + shown(*strategies));
    else
      for (const json& name : *strategies) question.add_strategies(name.get<std::string>());
  }
  reader.read_text(asked, "opponent", [&](std::string name) { question.set_opponent(std::move(name)); });
  reader.read_name(asked, "measure", kMeasureNames,
                   [&](int i) { question.set_measure(static_cast<pb::WhatIf::Measure>(i)); });
  reader.read_name(asked, "until", kUntilNames, [&](int i) { question.set_until(static_cast<pb::WhatIf::Until>(i)); });
  // 0 would mean absent
  reader.read_number(asked, "", "horizon", [&](double seconds) {
    if (const Result<void> checked = check_horizon(seconds); !checked) reader.refuse(checked.error());
    question.set_horizon(static_cast<float>(seconds));
  });
  reader.read_count(asked, "", "budget_ms", [&](std::uint32_t budget_ms) {
    if (const Result<void> checked = check_budget(budget_ms); !checked) reader.refuse(checked.error());
    question.set_budget_ms(budget_ms);
  });
  reader.read_number(asked, "", "switching_cost",
                     [&](double cost) { question.set_switching_cost(static_cast<float>(cost)); });
  reader.read_number(asked, "", "sure", [&](double sure) { question.set_sure(static_cast<float>(sure)); });
  if (const auto edit = asked.find("edit"); edit != asked.end()) read_edit(reader, *edit, *question.mutable_edit());
  if (!reader.good()) return reader.error();
  return question;
}

}  // namespace robot::foreseeing
