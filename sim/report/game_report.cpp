#include "sim/report/game_report.h"
#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "sim/contest/repetition.h"

#include <array>

namespace sim::report {
namespace {

using robot::formatted;

using Kind = referee::Event::Kind;

constexpr std::array kSides = {"home", "away"};

/// One row of the table: a figure of each side.
struct Row {
  const char* key;
  const char* shown;
  const char* format;  // of a double
  double (*value)(const Result& result, int side, int players);
};

double seen(const Result& result, int side, int players) {
  double ticks = 0;
  for (int player = 1; player <= players; ++player)
    ticks += result.counts.seen[robot_of(static_cast<Side>(side), player)];
  return result.counts.in_play == 0 ? 0 : ticks / players / result.counts.in_play;
}

double penalties(const Result& result, int side, int) {
  double sum = 0;
  for (const Kind kind : {Kind::pushing, Kind::illegal_defender, Kind::leaving, Kind::local_stuck, Kind::global_stuck,
                          Kind::illegal_kick, Kind::illegal_position})
    sum += result.events[static_cast<int>(kind)][side];
  return sum;
}

// shares are in [0..1]; their formats end in "%%" and show hundredths
constexpr Row kRows[] = {
    {"goals", "goals", "%.0f", [](const Result& result, int side, int) { return double(result.score[side]); }},
    {"shots", "shots", "%.0f", [](const Result& result, int side, int) { return double(result.counts.shots[side]); }},
    {"kicks", "kicks", "%.0f", [](const Result& result, int side, int) { return double(result.counts.kicks[side]); }},
    {"whiffs", "missed kicks", "%.0f",
     [](const Result& result, int side, int) { return double(result.counts.whiffs[side]); }},
    {"possession", "possession", "%.1f %%",
     [](const Result& result, int side, int) { return double(result.possession(static_cast<Side>(side))); }},
    {"ball_seen", "ball seen", "%.1f %%", seen},
    {"walked", "walked", "%.0f m", [](const Result& result, int side, int) { return double(result.walked[side]); }},
    {"penalties", "penalties", "%.0f", penalties},
    {"packets", "packets", "%.0f", [](const Result& result, int side, int) { return double(result.packets[side]); }},
};

bool is_share(const Row& row) { return std::string_view(row.format).ends_with("%%"); }

std::string shown(const Row& row, double value) { return formatted(row.format, is_share(row) ? 100 * value : value); }

/// Returns true for events of the text report. Changes of the phase are only in the JSON.
bool is_news(Kind kind) { return kind >= Kind::goal && kind != Kind::placed; }

double goals(const GameReport& report) { return report.result.score[0] + report.result.score[1]; }

std::string heading(const io::Matchup& choice, const Params& params) {
  const field::Rules& rules = params.rules;
  std::string line = formatted("%s: %d a side, %d x %s", choice.rules.c_str(), rules.players, rules.halves,
                               clock_text(rules.half_duration).c_str());
  for (int side = 0; side < 2; ++side)
    line += formatted("\n  %s  %s, models %s", kSides[static_cast<std::size_t>(side)], choice.strategies[side].c_str(),
                      params.teams[side].models.name.c_str());
  return line + "\n";
}

const char* winner_of(const ShootOut& shoot_out) {
  const auto winner = referee::shoot_out::winner(shoot_out.tally);
  return winner ? kSides[static_cast<std::size_t>(*winner)] : "nobody";
}

double seconds_of(const PenaltyShot& shot) { return static_cast<double>(shot.ticks) / kTicksPerSecond; }

Json json_of(const ShootOut& shoot_out) {
  Json json = {{"score", {shoot_out.tally.goals[0], shoot_out.tally.goals[1]}},
               {"winner", winner_of(shoot_out)},
               {"shots", Json::array()}};
  for (const PenaltyShot& shot : shoot_out.shots)
    json["shots"].push_back({{"side", kSides[static_cast<std::size_t>(shot.side)]},
                             {"end", name_of(shot.end)},
                             {"seconds", seconds_of(shot)}});
  return json;
}

std::string text_of(const ShootOut& shoot_out) {
  std::string all = formatted("\npenalty shoot-out %d:%d, %s wins\n", shoot_out.tally.goals[0],
                              shoot_out.tally.goals[1], winner_of(shoot_out));
  for (const PenaltyShot& shot : shoot_out.shots)
    all += formatted("  %-6s%-8s%5.1f s\n", kSides[static_cast<std::size_t>(shot.side)], name_of(shot.end),
                     seconds_of(shot));
  return all;
}

/// Returns the line about the shoot-outs of several games, or an empty string without one.
std::string shoot_outs_text(const std::vector<GameReport>& reports) {
  int count = 0, won[2] = {0, 0};
  for (const GameReport& report : reports) {
    if (!report.shoot_out) continue;
    ++count;
    if (const auto winner = referee::shoot_out::winner(report.shoot_out->tally)) ++won[static_cast<int>(*winner)];
  }
  if (count == 0) return "";
  return formatted("%d penalty shoot-outs: home won %d, away won %d, nobody won %d\n", count, won[0], won[1],
                   count - won[0] - won[1]);
}

}  // namespace

std::string who(const referee::Event& event) {
  if (event.kind == Kind::half_time || event.kind == Kind::end || event.kind == Kind::global_stuck) return "";
  std::string name = kSides[static_cast<std::size_t>(event.side)];
  if (event.robot != kNobody) name += " " + std::to_string(player_of(event.robot));
  return name;
}

std::string clock_text(float seconds) {
  const int whole = static_cast<int>(seconds);
  return formatted("%02d:%02d", whole / 60, whole % 60);
}

Json to_json(const GameReport& report, int players) {
  Json json = {{"seed", report.seed},
               {"score", {report.result.score[0], report.result.score[1]}},
               {"finished", report.result.over},
               {"seconds", static_cast<double>(report.result.ticks) / kTicksPerSecond},
               {"in_play_seconds", static_cast<double>(report.result.counts.in_play) / kTicksPerSecond}};
  for (const int side : {0, 1}) {
    Json& figures = json[kSides[static_cast<std::size_t>(side)]];
    for (const Row& row : kRows) figures[row.key] = row.value(report.result, side, players);
  }
  if (report.shoot_out) json["shoot_out"] = json_of(*report.shoot_out);
  json["events"] = Json::array();
  for (const Decision& decision : report.decisions)
    json["events"].push_back({{"kind", referee::name_of(decision.event.kind)},
                              {"who", who(decision.event)},
                              {"half", decision.half},
                              {"clock", decision.clock},
                              {"tick", decision.event.tick},
                              {"x", decision.event.at.x},
                              {"y", decision.event.at.y},
                              {"score", {decision.score[0], decision.score[1]}}});
  return json;
}

std::string to_text(const GameReport& report, const io::Matchup& choice, const Params& params) {
  const Result& result = report.result;
  std::string all =
      heading(choice, params) + formatted("  seed  %llu\n\n", static_cast<unsigned long long>(report.seed));
  all += formatted("%-14s%10s%10s\n", "", "home", "away");
  for (const Row& row : kRows)
    all += formatted("%-14s%10s%10s\n", row.shown, shown(row, row.value(result, 0, params.rules.players)).c_str(),
                     shown(row, row.value(result, 1, params.rules.players)).c_str());
  all += "\n";
  for (const Decision& decision : report.decisions)
    if (is_news(decision.event.kind))
      all += formatted(who(decision.event).empty() ? "%d  %s  %d:%d  %s\n" : "%d  %s  %d:%d  %-17s %s\n", decision.half,
                       clock_text(decision.clock).c_str(), decision.score[0], decision.score[1],
                       referee::name_of(decision.event.kind), who(decision.event).c_str());
  if (report.shoot_out) all += text_of(*report.shoot_out);
  return all;
}

std::int64_t different_games(const std::vector<GameReport>& reports) {
  std::vector<std::uint64_t> hashes;
  for (const GameReport& report : reports) hashes.push_back(report.hash);
  return contest::different_games(std::move(hashes));
}

Json to_json(const std::vector<GameReport>& reports, int players) {
  Json json = {{"games", reports.size()},
               {"different_games", different_games(reports)},
               {"means", Json::object()},
               {"scores", Json::array()}};
  for (const int side : {0, 1})
    for (const Row& row : kRows) {
      std::vector<double> values;
      for (const GameReport& report : reports) values.push_back(row.value(report.result, side, players));
      const contest::Mean mean = contest::mean_of(values);
      json["means"][kSides[static_cast<std::size_t>(side)]][row.key] = {{"mean", mean.mean},
                                                                        {"standard_error", mean.error}};
    }
  for (const GameReport& report : reports) {
    json["scores"].push_back(
        {{"seed", report.seed}, {"home", report.result.score[0]}, {"away", report.result.score[1]}});
    if (report.shoot_out) json["scores"].back()["shoot_out"] = json_of(*report.shoot_out);
  }
  return json;
}

std::string to_text(const std::vector<GameReport>& reports, const io::Matchup& choice, const Params& params) {
  std::string all = heading(choice, params) + formatted("  seeds %llu .. %llu\n\n",
                                                        static_cast<unsigned long long>(reports.front().seed),
                                                        static_cast<unsigned long long>(reports.back().seed));
  all += formatted("%-14s%20s%20s\n", "mean of a game", "home", "away");
  for (const Row& row : kRows) {
    all += formatted("%-14s", row.shown);
    for (const int side : {0, 1}) {
      std::vector<double> values;
      for (const GameReport& report : reports) values.push_back(row.value(report.result, side, params.rules.players));
      const contest::Mean mean = contest::mean_of(values);
      const double scale = is_share(row) ? 100 : 1;
      all += formatted("%12.2f ± %5.2f", scale * mean.mean, scale * mean.error) + (is_share(row) ? "%" : " ");
    }
    all += "\n";
  }

  int won[2] = {0, 0}, goalless = 0;
  std::vector<double> sums;
  for (const GameReport& report : reports) {
    const auto& score = report.result.score;
    if (score[0] != score[1]) ++won[score[0] > score[1] ? 0 : 1];
    if (goals(report) == 0) ++goalless;
    sums.push_back(goals(report));
  }
  const int count = static_cast<int>(reports.size());
  const contest::Mean mean = contest::mean_of(sums);
  all += formatted("\n%d games: home won %d, away won %d, drawn %d, of these %d goalless; %.2f ± %.2f goals a game\n",
                   count, won[0], won[1], count - won[0] - won[1], goalless, mean.mean, mean.error);
  return all + shoot_outs_text(reports);
}

}  // namespace sim::report
