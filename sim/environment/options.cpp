#include "sim/environment/options.h"

#include "robot/core/json_library.h"
#include "sim/check/words.h"
#include "sim/io/policy.h"
#include "sim/io/reader.h"
#include "sim/io/source.h"

namespace sim::environment {

using io::Fields;
using io::Json;
using io::Reader;
using robot::Result;

namespace {

constexpr const char* kCalled = "environment";

/// The frame without "frame": what a robot may usefully do with and without the ball.
constexpr const char* kFrame = R"({
  "name": "policy",
  "based_on": "baseline",
  "menu": [
    { "name": "as the chaser of baseline", "use": "chaser" },
    { "name": "shoot at once", "do": "kick", "with": { "aim": "goal", "tolerance": "60 deg" } },
    { "name": "shoot with care", "do": "kick", "with": { "aim": "opening", "tolerance": "12 deg" } },
    { "name": "clear", "do": "kick", "with": { "aim": "away", "tolerance": "60 deg" } },
    { "name": "pass", "do": "pass" },
    { "name": "dribble", "do": "dribble" },
    { "name": "walk to the ball", "do": "walk_to_ball" },
    { "name": "block", "do": "block" },
    { "name": "keep the goal", "do": "keep_goal" },
    { "name": "as the supporter of baseline", "use": "supporter" },
    { "name": "search", "do": "search_ball" },
    { "name": "stand", "do": "stand" }
  ]
})";

struct Numbers {
  int games = 1, ticks = 3, players = 0;
  float seconds = 0;
  bool every_tick = false;

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("games", self.games, "", 1, kMostSideBySide);
    see("ticks", self.ticks, "", 1, 3000);
    see("players", self.players, "", 0, kMaxPlayers);
    see("seconds", self.seconds, "", 0.f, 36000.f);
    see("every_tick", self.every_tick, "", false, true);
  }
};

/// Reads one of several words; returns its number.
int read_word(Reader& reader, const Json& json, const char* key, std::vector<std::string_view> words) {
  const std::string text = reader.text(json, "", key, std::string(words.front()));
  for (std::size_t i = 0; i < words.size(); ++i)
    if (text == words[i]) return static_cast<int>(i);
  reader.refuse(std::string(key) + " must be one of " + io::listed(words) + ", got " + io::quoted(text));
  return 0;
}

check::Fact fact_of(const char* text) {
  check::Words words(text);
  return *check::take_fact(words);
}

/// A whole game as a drill without end.
drills::Drill whole_game() {
  drills::Drill game;
  game.duration = kNever;
  game.score = {{fact_of("our goal"), 1}, {fact_of("their goal"), -1}};
  return game;
}

Result<agent::Frame> frame_in(const Json& json) {
  const auto found = json.find("frame");
  if (found != json.end() && found->is_object()) return io::read_frame(*found, kCalled + std::string(": frame"));
  if (found != json.end() && !found->is_string())
    return robot::Error{kCalled + std::string(": frame must be an object or a file, got ") + io::shown(*found)};
  std::string text = kFrame, called = kCalled + std::string(": frame");
  if (found != json.end()) {
    const std::string name = found->get<std::string>();
    const auto source = io::find_source("frames", "frame", io::is_path(name) ? name : "./" + name);
    if (!source) return source.failure();
    text = source->text, called = source->called;
  }
  const Result<Json> frame = io::parse_object(text, called);
  if (!frame) return frame.failure();
  return io::read_frame(*frame, called);
}

}  // namespace

Result<Options> read_options(std::string_view text) {
  const Result<Json> json = io::parse_object(text, kCalled);
  if (!json) return json.failure();
  Reader reader(kCalled);
  Numbers numbers;
  reader.read(*json, "", Fields::some, numbers,
              {"drill", "rules", "models", "home", "away", "control", "actions", "frame", "restart"});
  const std::string drill = reader.text(*json, "", "drill");
  const int control = read_word(reader, *json, "control", {"home", "away", "both"});
  const int actions = read_word(reader, *json, "actions", {"menu", "skills", "motion"});
  const int restart = read_word(reader, *json, "restart", {"next_step", "never"});
  if (!reader.good()) return reader.error();

  Options options{.games = numbers.games,
                  .ticks = numbers.ticks,
                  .restarts = restart == 0,
                  .controlled = {control != 1, control != 0},
                  .actions = static_cast<Kind>(actions),
                  .has_start = !drill.empty(),
                  .drill = whole_game(),
                  .frame = {}};
  if (options.has_start) {
    Result<drills::Drill> loaded = drills::load_drill(drill);
    if (!loaded) return loaded.failure();
    options.drill = *std::move(loaded);
  }
  io::Matchup& game = options.drill.game;
  game.rules = reader.text(*json, "", "rules", game.rules);
  const std::string models = reader.text(*json, "", "models", game.models[0]);
  game.strategies[0] = reader.text(*json, "", "home", game.strategies[0]);
  game.strategies[1] = reader.text(*json, "", "away", game.strategies[1]);
  if (!reader.good()) return reader.error();
  game.models[0] = game.models[1] = models;
  if (numbers.players > 0) game.players = numbers.players;
  if (numbers.seconds > 0) options.drill.duration = ticks(numbers.seconds);
  game.pace = numbers.every_tick ? Pace::every_tick : Pace::thinned;
  Result<agent::Frame> frame = frame_in(*json);
  if (!frame) return frame.failure();
  options.frame = *std::move(frame);
  return options;
}

}  // namespace sim::environment
