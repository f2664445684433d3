#include "sim/guest/wire.h"

#include <charconv>
#include <iterator>
#include <span>
#include <string_view>

#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "sim/agent/beliefs.h"

namespace sim::guest {
namespace {

using Json = nlohmann::json;

// by enumerator
constexpr std::span kSetPlayWords = std::span(agent::kSetPlayWords).first<agent::kSetPlays>();
constexpr const char* kRoles[] = {"keeper", "chaser", "supporter", "defender"};
constexpr const char* kBodies[] = {"usual", "stand", "walk_speed", "walk_to", "kick", "squat"};
constexpr const char* kHeads[] = {"usual", "angles", "look_to"};

constexpr std::size_t kShown = 120;  // bytes of a wrong answer in its error

/// A writer of JSON. A document object would take longer than the decision.
class Line {
 public:
  Line& open(std::string_view name = {}) { return key(name), text_ += '{', first_ = true, *this; }
  Line& close() { return text_ += '}', first_ = false, *this; }
  Line& open_list(std::string_view name) { return key(name), text_ += '[', first_ = true, *this; }
  Line& close_list() { return text_ += ']', first_ = false, *this; }
  Line& add(std::string_view name, const char* word) { return key(name), (text_ += '"') += word, text_ += '"', *this; }
  Line& flag(std::string_view name, bool value) { return key(name), text_ += value ? "true" : "false", *this; }
  Line& null(std::string_view name) { return key(name), text_ += "null", *this; }
  template <class Number>
  Line& number(std::string_view name, Number value) {
    key(name);
    char digits[40];
    text_.append(digits, std::to_chars(digits, std::end(digits), value).ptr);
    return *this;
  }
  Line& tick(std::string_view name, std::uint32_t tick) {
    return tick == FORESIGHT_NEVER ? null(name) : number(name, tick);
  }
  std::string end() { return text_ + "}\n"; }

 private:
  void key(std::string_view name) {
    if (!first_) text_ += ',';
    first_ = false;
    if (!name.empty()) ((text_ += '"') += name) += "\":";
  }

  std::string text_ = "{";
  bool first_ = true;
};

const char* word(std::span<const char* const> words, std::int32_t number) {
  const auto index = static_cast<std::size_t>(number);  // a negative one is too large
  return index < words.size() ? words[index] : "unknown";
}

std::string shown(const std::string& answer) {
  return answer.size() <= kShown ? "'" + answer + "'" : "'" + answer.substr(0, kShown) + "…'";
}

std::string not_ours(const std::string& answer) { return "expected a JSON object as answer, got " + shown(answer); }

/// A reader of one answer. It keeps the first error.
class Answer {
 public:
  explicit Answer(const Json& json) : json_(json) {}

  void number(const char* name, float& into) {
    if (const Json* value = find(name)) {
      if (value->is_number())
        into = value->get<float>();
      else
        refuse(name, "a number", *value);
    }
  }
  void word(const char* name, std::span<const char* const> words, std::int32_t& into) {
    const Json* value = find(name);
    if (!value) return;
    for (std::size_t i = 0; i < words.size(); ++i)
      if (*value == words[i]) return void(into = static_cast<std::int32_t>(i));
    std::string all;
    for (const char* each : words) all += (all.empty() ? "" : ", ") + std::string(each);
    refuse(name, "one of " + all, *value);
  }
  void flag(const char* name, std::int32_t& into) {
    if (const Json* value = find(name)) {
      if (value->is_boolean())
        into = value->get<bool>();
      else
        refuse(name, "true or false", *value);
    }
  }
  const Json* find(const char* name) {
    const auto found = json_.find(name);
    if (found == json_.end()) return nullptr;
    ++known_;
    return &*found;
  }
  void refuse(const std::string& name, const std::string& expected, const Json& got) {
    if (problem_.empty()) problem_ = name + " must be " + expected + ", got " + got.dump().substr(0, kShown);
  }
  /// Returns the first error. An unknown entry is one, because it may be a typing mistake.
  std::string problem() {
    if (problem_.empty() && known_ != json_.size())
      return "expected body, head, x, y, turn, gain, kick, kick_left, look, role and time_to_ball in an answer, got "
             "something else: " +
             shown(json_.dump());
    return problem_;
  }

 private:
  const Json& json_;
  std::size_t known_ = 0;
  std::string problem_;
};

}  // namespace

std::string greeting_of(const ForesightPlayer& player) {
  Line line;
  line.number("version", FORESIGHT_BEHAVIOUR_VERSION).number("players", player.players).number("seed", player.seed);
  line.open("field").number("length", player.field_length).number("width", player.field_width);
  line.number("goal_width", player.goal_width).close();
  line.open("walk").number("forward", player.walk_forward).number("backward", player.walk_backward);
  line.number("sideward", player.walk_sideward).number("turn", player.walk_turn).close();
  line.open_list("kicks");
  for (int i = 0; i < player.kick_count; ++i) {
    const ForesightKick& kick = player.kicks[i];
    line.open().add("name", kick.name).number("ball_x", kick.ball_x).number("ball_y", kick.ball_y);
    line.number("gate_x", kick.gate_x).number("gate_y", kick.gate_y).number("delay", kick.delay);
    line.number("duration", kick.duration).number("range", kick.range).number("direction", kick.direction).close();
  }
  return line.close_list().end();
}

std::string question_of(const ForesightPlayer& player, const ForesightMoment& moment) {
  Line line;
  line.number("player", player.player).number("now", moment.now).flag("entered", moment.entered);
  line.add("phase", word(agent::kPhaseWords, moment.phase)).add("set_play", word(kSetPlayWords, moment.set_play));
  line.flag("own_kick", moment.own_kick).flag("penalised", moment.penalised).number("half", moment.half);
  line.number("own_score", moment.own_score).number("opponent_score", moment.opponent_score);
  line.number("remaining", moment.remaining).number("since_phase", moment.since_phase);
  line.open("ball").tick("seen", moment.ball_seen).flag("visible", moment.ball_visible);
  line.number("x", moment.ball_x).number("y", moment.ball_y).number("vx", moment.ball_vx).number("vy", moment.ball_vy);
  line.number("deviation", moment.ball_deviation).close();
  line.number("x", moment.x).number("y", moment.y).number("heading", moment.heading);
  line.number("deviation", moment.deviation).number("deviation_heading", moment.deviation_heading);

  line.open_list("mates");
  for (int i = 0; i < player.players; ++i) {
    const ForesightMate& mate = moment.mates[i];
    if (mate.sent == FORESIGHT_NEVER) continue;
    line.open().number("player", i + 1).tick("sent", mate.sent).number("x", mate.x).number("y", mate.y);
    line.number("heading", mate.heading).number("ball_x", mate.ball_x).number("ball_y", mate.ball_y);
    line.tick("ball_age", mate.ball_age).number("time_to_ball", mate.time_to_ball);
    line.add("role", word(kRoles, mate.role)).flag("active", mate.active).close();
  }
  line.close_list().open_list("opponents");
  for (int i = 0; i < player.players; ++i) {
    const ForesightOpponent& opponent = moment.opponents[i];
    if (opponent.seen == FORESIGHT_NEVER) continue;
    line.open().number("player", i + 1).tick("seen", opponent.seen).number("x", opponent.x).number("y", opponent.y);
    line.close();
  }
  return line.close_list().end();
}

std::string check_greeting(const std::string& answer) {
  const auto json = robot::parse_json(answer);
  if (!json || !json->is_object()) return not_ours(answer);
  if (const auto version = json->find("version"); version == json->end() || *version != FORESIGHT_BEHAVIOUR_VERSION)
    return "expected {\"version\": " + std::to_string(FORESIGHT_BEHAVIOUR_VERSION) + ", …} as the first answer, got " +
           shown(answer);
  return {};
}

std::string read_answer(const std::string& text, const ForesightPlayer& player, ForesightCommand& command) {
  const auto json = robot::parse_json(text);
  if (!json || !json->is_object()) return not_ours(text);
  Answer answer(*json);
  answer.word("body", kBodies, command.body);
  answer.word("head", kHeads, command.head);
  answer.number("x", command.x), answer.number("y", command.y);
  answer.number("turn", command.turn), answer.number("gain", command.gain);
  answer.flag("kick_left", command.kick_left);
  answer.word("role", kRoles, command.role);
  answer.number("time_to_ball", command.time_to_ball);
  if (const Json* look = answer.find("look")) {
    const bool three = look->is_array() && look->size() == 3;
    for (std::size_t i = 0; i < 3; ++i)
      if (three && (*look)[i].is_number())
        command.look[i] = (*look)[i].get<float>();
      else
        answer.refuse("look", "a list of three numbers", *look);
  }
  if (const Json* kick = answer.find("kick")) {
    std::int32_t found = -1;
    for (int i = 0; i < player.kick_count; ++i)
      if (*kick == player.kicks[i].name) found = i;
    if (found >= 0)
      command.kick = found;
    else
      answer.refuse("kick", "the name of a kick", *kick);
  }
  return answer.problem();
}

}  // namespace sim::guest
