#include "sim/check/event.h"

#include <charconv>
#include <string>

#include "robot/core/json_library.h"
#include "sim/io/json.h"
#include "sim/io/values.h"
#include "sim/referee/court.h"

namespace sim::check {

using robot::Error;
using robot::Result;

namespace {

constexpr float kFarthest = 20;  // [m]

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

bool take(std::string_view& text, std::string_view beginning) {
  const bool has = text.starts_with(beginning);
  if (has) text = trimmed(text.substr(beginning.size()));
  return has;
}

Result<float> read(std::string_view text, const io::Expected& expected) {
  return io::Values().read(trimmed(text), expected);
}

/// Parses a whole number, or returns 0.
int number_in(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size() ? number : 0;
}

/// Returns whether the text names that side: "home" or the number of its team.
bool names(std::string_view text, Side side, const io::SituationTeams& teams) {
  return text == (side == Side::home ? "home" : "away") || (teams.of(side) != 0 && number_in(text) == teams.of(side));
}

Result<Event> penalise(Event event, std::string_view text, int players, const io::SituationTeams& teams) {
  event.kind = Event::Kind::penalise;
  event.robot = robot_named(text, players, teams);
  if (event.robot != kNobody) return event;
  const bool unnamed = teams.home == 0 && number_in(text.substr(0, text.find('/'))) > 0;
  return Error{"penalise: expected " + robot_names(players, teams) + ", got '" + std::string(text) + "'" +
               (unnamed ? "; the situation has no \"teams\"" : "")};
}

Result<Event> place_ball(Event event, std::string_view text) {
  event.kind = Event::Kind::ball;
  const std::size_t comma = text.find(',');
  if (comma == text.npos) return Error{"ball at: expected x, y in [m], got '" + std::string(text) + "'"};
  const Result<float> x = read(text.substr(0, comma), {"m", -kFarthest, kFarthest, nullptr});
  const Result<float> y = read(text.substr(comma + 1), {"m", -kFarthest, kFarthest, nullptr});
  if (!x) return Error{"ball at: x " + x.error()};
  if (!y) return Error{"ball at: y " + y.error()};
  event.ball = {*x, *y};
  return event;
}

}  // namespace

int robot_named(std::string_view text, int players, const io::SituationTeams& teams) {
  const std::size_t slash = text.find('/');
  if (slash == text.npos) return kNobody;
  const int player = number_in(text.substr(slash + 1));
  if (player < 1 || player > players) return kNobody;
  for (const Side side : {Side::home, Side::away})
    if (names(text.substr(0, slash), side, teams)) return robot_of(side, player);
  return kNobody;
}

std::string robot_names(int players, const io::SituationTeams& teams) {
  const bool numbered = teams.home != 0;
  const std::string numbers =
      numbered ? ", " + std::to_string(teams.home) + "/N or " + std::to_string(teams.away) + "/N" : "";
  return (numbered ? "home/N, away/N" : "home/N or away/N") + numbers + ", N from 1 to " + std::to_string(players);
}

Result<Event> parse_event(std::string_view text, int players, const io::SituationTeams& teams) {
  std::string_view rest = trimmed(text);
  const std::size_t colon = rest.find(':');
  if (!take(rest, "at ") || colon == text.npos)
    return Error{"expected 'at TIME: ACTION' such as 'at 5 s: penalise home/3', got '" + std::string(text) + "'"};
  const std::string_view time = rest.substr(0, rest.find(':'));
  const Result<float> seconds = read(time, {"s", 0, 3600, nullptr});
  if (!seconds) return Error{"the time " + seconds.error()};
  std::string_view action = trimmed(rest.substr(time.size() + 1));
  const Event event{.at = ticks(*seconds)};
  if (take(action, "penalise ")) return penalise(event, action, players, teams);
  if (take(action, "ball at ")) return place_ball(event, action);
  return Error{"expected 'penalise home/N' or 'ball at X, Y', got '" + std::string(action) + "'"};
}

void apply(const Event& event, const Params& params, State& state) {
  referee::Events unused;
  const Models& models = params.teams[0].models;  // ball and contacts are those of the home side
  referee::Court court{params.rules, params.rules.field, models.ball,  models.contact,
                       state.world,  state.book,         state.counts, unused};
  if (event.kind == Event::Kind::ball) return referee::place_ball(court, event.ball);
  if (referee::on_field(court, event.robot)) referee::remove_robot(court, event.robot, referee::Event::Kind::pushing);
}

}  // namespace sim::check
