#include "sim/io/models.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <vector>

#include "sim/io/embedded.h"
#include "sim/io/source.h"
#include "sim/motion/motion.h"
#include "tests/support/temporary_folder.h"

namespace sim::io {
namespace {

/// Returns the sentence of an Error, or an empty text.
std::string error_of_models(const std::string& name) {
  const auto models = load_models(name);
  return models ? "" : models.error();
}

Models loaded_models(const std::string& name) {
  auto models = load_models(name);
  EXPECT_TRUE(models) << models.error();
  return std::move(models).value();
}

std::vector<bool> effects_of(const Models& models) {
  std::vector<bool> all;
  Effects::visit(models.effects, [&](const char*, bool value, const char*, bool, bool) { all.push_back(value); });
  return all;
}

TEST(Models, EmbeddedModelsHaveTheirFilesNames) {
  EXPECT_EQ(listed(names_of("models")), "friendly, match, nao, perfect");
  for (const std::string_view name : names_of("models")) EXPECT_EQ(loaded_models(std::string(name)).name, name);
}

TEST(Models, InPerfectEveryEffectIsOff) {
  for (const bool effect : effects_of(loaded_models("perfect"))) EXPECT_FALSE(effect);
}

TEST(Models, RobotsFallAndHitPartlyInAMatchOnly) {
  EXPECT_TRUE(loaded_models("match").effects.falls);
  for (const char* name : {"friendly", "perfect"}) {
    EXPECT_FALSE(loaded_models(name).effects.falls) << name;
    EXPECT_FALSE(loaded_models(name).effects.partial_hits) << name;
  }
}

TEST(Models, FriendlyIsMatchWithSmallerErrors) {
  const Models match = loaded_models("match"),
               friendly = loaded_models("friendly,falls=on,partial_hits=on,lost_pose=on,duels=on");
  EXPECT_EQ(effects_of(friendly), effects_of(match));
  ASSERT_EQ(friendly.motion.kick_count, match.motion.kick_count);
  for (int i = 0; i < match.motion.kick_count; ++i) {
    EXPECT_STREQ(friendly.motion.kicks[i].name, match.motion.kicks[i].name);
    EXPECT_GE(friendly.motion.kicks[i].range, match.motion.kicks[i].range);
    EXPECT_LT(friendly.motion.kicks[i].range_deviation, match.motion.kicks[i].range_deviation);
  }
  EXPECT_GT(friendly.perception.ball.far, match.perception.ball.far);
  EXPECT_LE(friendly.perception.noise.pixels, match.perception.noise.pixels);
  EXPECT_LT(friendly.perception.radio.loss, match.perception.radio.loss);
}

TEST(Models, APrintedDescriptionReadsBackIdentically) {
  for (const char* name :
       {"friendly", "match", "nao", "perfect", "match,falls=off,walk.forward=0.1234567,radio.loss=0.7"}) {
    const std::string printed = print_models(loaded_models(name));
    const auto again = parse_models(printed, "again");
    ASSERT_TRUE(again) << again.error();
    EXPECT_EQ(print_models(*again), printed);
    EXPECT_EQ(again->motion.kick_count, loaded_models(name).motion.kick_count);
  }
}

TEST(Models, PrintedModelsKeepTheirSources) {
  for (const char* name : {"friendly", "match", "perfect"}) {
    Sources sources, again;
    const Models models = load_models(name, &sources).value();
    EXPECT_GT(sources.size(), 20u) << name;
    ASSERT_TRUE(parse_models(print_models(models, sources), "again", &again));
    EXPECT_EQ(again, sources) << name;
  }
}

TEST(Models, ATableOfFallsKeepsItsSources) {
  Sources sources, again;
  const Models nao = load_models("nao", &sources).value();
  EXPECT_EQ(sources["falls.table.collisions.soft"], "estimate: half of a team's robots are worn");
  ASSERT_TRUE(parse_models(print_models(nao, sources), "again", &again));
  EXPECT_EQ(again["falls.table.collisions.soft"], sources["falls.table.collisions.soft"]);
}

TEST(Models, AChangedValueHasNoSource) {
  Sources plain, varied;
  ASSERT_TRUE(load_models("match", &plain));
  ASSERT_TRUE(load_models("match,walk.forward=0.2", &varied));
  EXPECT_EQ(plain.erase("walk.forward"), 1u);
  EXPECT_EQ(varied, plain);
}

TEST(Models, VariationsChangeOnlyTheNamedEntries) {
  Models varied = loaded_models("match,falls=off,walk.forward=0.2,kicks.long.range=4");
  EXPECT_EQ(varied.name, "match,falls=off,walk.forward=0.2,kicks.long.range=4");
  EXPECT_FALSE(varied.effects.falls);
  EXPECT_EQ(varied.motion.walk.forward, 0.2f);
  const Models match = loaded_models("match");
  for (int i = 0; i < match.motion.kick_count; ++i) {
    const bool named = std::strcmp(match.motion.kicks[i].name, "long") == 0;
    EXPECT_EQ(varied.motion.kicks[i].range, named ? 4 : match.motion.kicks[i].range);
    varied.motion.kicks[i].range = match.motion.kicks[i].range;
  }
  varied.name = match.name;
  varied.effects.falls = match.effects.falls;
  varied.motion.walk.forward = match.motion.walk.forward;
  EXPECT_EQ(print_models(varied), print_models(match));
}

TEST(Models, AKickThatIsFalseIsRemoved) {
  const Models match = loaded_models("match"), fewer = loaded_models("match,kicks.long=off");
  EXPECT_EQ(fewer.motion.kick_count, match.motion.kick_count - 1);
  EXPECT_LT(motion::find_kick(fewer.motion, "long"), 0);
  for (int i = 0; i < fewer.motion.kick_count; ++i) {
    const motion::Kick& kick = fewer.motion.kicks[i];
    EXPECT_EQ(kick.range, match.motion.kicks[motion::find_kick(match.motion, kick.name)].range) << kick.name;
  }
  EXPECT_EQ(error_of_models("match,kicks.lonk=off"),
            "models 'match,kicks.lonk=off': kicks: there is no 'lonk' to remove");
  std::string all = "match";
  for (int i = 0; i < match.motion.kick_count; ++i) all += std::string(",kicks.") + match.motion.kicks[i].name + "=off";
  EXPECT_EQ(error_of_models(all), "models '" + all + "': kicks: expected at least one, got none");
}

TEST(Models, OurOwnBodyFallsByTheTableOfItsWalk) {
  const Models nao = loaded_models("nao"), match = loaded_models("match");
  EXPECT_TRUE(nao.motion.falls.table.given);
  EXPECT_FALSE(match.motion.falls.table.given) << "its falls are those of real games";
  const Models other = loaded_models("match,falls.table=foresight");
  EXPECT_EQ(print_models(nao).substr(print_models(nao).find("\"table\"")).substr(0, 2000),
            print_models(other).substr(print_models(other).find("\"table\"")).substr(0, 2000));
  EXPECT_FALSE(loaded_models("nao,falls.table=off").motion.falls.table.given);
}

TEST(Models, ATableOfFallsIsAlsoReadFromAFileOrFromTheModels) {
  const tests::TemporaryFolder folder;
  const std::string path = folder.path() / "theirs.json";
  std::string table(find_source("falls", "table of falls", "foresight")->text);
  std::ofstream(path) << table;
  const Models named = loaded_models("match,falls.table=foresight"), read = loaded_models("match,falls.table=" + path);
  EXPECT_EQ(print_models(read).substr(print_models(read).find("\"ball\"")),
            print_models(named).substr(print_models(named).find("\"ball\"")));
  const auto within =
      parse_models(R"({"name": "mine", "based_on": "match", "falls": {"table": )" + table + "}}", "models 'mine'");
  ASSERT_TRUE(within) << within.error();
  EXPECT_EQ(within->motion.falls.table.soft.walking.half[7], named.motion.falls.table.soft.walking.half[7]);

  const auto error_with = [&](const std::string& old, const std::string& text) {
    std::string changed = table;
    changed.replace(changed.find(old), old.size(), text);
    std::ofstream(path) << changed;
    return error_of_models("match,falls.table=" + path);
  };
  const std::string opening = "models 'match,falls.table=" + path + "': table of falls '" + path + "': ";
  EXPECT_EQ(error_with("\"stiff_walking\"", "\"stif_walking\""), opening + "stiff_walking is missing");
  EXPECT_EQ(error_with("\"mass\": {\"value\": 5.3", "\"mass\": {\"value\": -5.3"),
            opening + "collisions.mass must be 0.5 .. 100 [kg], got -5.3");
  EXPECT_EQ(error_with("\"made_by\"", "\"mode_by\"").substr(0, opening.size() + 22),
            opening + "mode_by is unknown; di");
  EXPECT_EQ(error_with("{", "[").substr(0, opening.size() + 10), opening + "not JSON: ");
}

TEST(Models, NameTheErrorInATableOfFalls) {
  EXPECT_EQ(error_of_models("match,falls.table=foresigth"),
            "models 'match,falls.table=foresigth': no table of falls 'foresigth'; did you mean 'foresight'?");
  EXPECT_EQ(
      error_of_models("match,falls.table=3"),
      "models 'match,falls.table=3': falls.table must be a table of falls, its name or its path, or false, got 3");
  EXPECT_EQ(
      error_of_models("perfect,falls.table=foresight"),
      "models 'perfect,falls.table=foresight': falls.table is not played while the effect falls is off; switch it on "
      "with effects.falls=on");
  EXPECT_EQ(error_of_models("perfect,effects.falls=on,falls.table=foresight"), "");
  EXPECT_EQ(error_of_models("nao,falls=off"), "");
}

TEST(Models, SingleFiguresOfATableOfFallsCanBeChanged) {
  const Models varied = loaded_models("nao,falls.table.collisions.soft=0.25"), nao = loaded_models("nao");
  EXPECT_EQ(varied.motion.falls.table.collisions.soft, 0.25f);
  EXPECT_EQ(varied.motion.falls.table.collisions.mass, nao.motion.falls.table.collisions.mass);
  EXPECT_EQ(error_of_models("match,falls.table.collisions.soft=0.25"),
            "models 'match,falls.table.collisions.soft=0.25': falls.table.collisions.mass is missing, expected 0.5 .. "
            "100 [kg]");
  EXPECT_EQ(
      error_of_models("nao,falls.per_minute_walking=1"),
      "models 'nao,falls.per_minute_walking=1': falls.per_minute_walking is not played with a table of falls; leave "
      "that out with falls.table=off");
  for (const std::string other : {"lying", "getting_up", "failure"})
    EXPECT_NE(error_of_models("nao,falls." + other + "=0.5").find("is not played with a table of falls"),
              std::string::npos);
  EXPECT_EQ(error_of_models("nao,falls.table=off,falls.per_minute_walking=1"), "");
  EXPECT_EQ(
      error_of_models("nao,falls.table.alone.front=0.7,falls.table.alone.back=0.7"),
      "models 'nao,falls.table.alone.front=0.7,falls.table.alone.back=0.7': falls.table.alone: front and back must "
      "be at most 1 together, got 1.4");
}

TEST(Models, ATableOfFallsIsForAllRobotsOfATeam) {
  EXPECT_EQ(with_falls("match", "mine"), "match,falls.table=mine");
  EXPECT_EQ(with_falls("match+3=nao,walk.forward=0.1", "mine"),
            "match,falls.table=mine+3=nao,walk.forward=0.1,falls.table=mine");
  EXPECT_EQ(names_of_falls("match,falls.table=a.json+3=nao,falls.table=b.json,walk.forward=0.1"),
            (std::vector<std::string>{"a.json", "b.json"}));
  EXPECT_EQ(names_of_falls("match,falls=off"), std::vector<std::string>{});
}

TEST(Models, OurOwnBodyKicksOnlyInTheWalk) {
  const Models nao = loaded_models("nao");
  for (int i = 0; i < nao.motion.kick_count; ++i) EXPECT_TRUE(nao.motion.kicks[i].in_walk) << nao.motion.kicks[i].name;
}

TEST(Models, EveryEffectCanBeSwitchedByItsName) {
  const Models match = loaded_models("match");
  Effects::visit(match.effects, [](const char* name, bool value, const char*, bool, bool) {
    const Models varied = loaded_models(std::string("match,") + name + (value ? "=off" : "=on"));
    Effects::visit(varied.effects, [&](const char* other, bool now, const char*, bool, bool) {
      EXPECT_TRUE(std::strcmp(name, other) != 0 || now != value) << name;
    });
  });
}

TEST(Models, NamesTheErrorInAVariation) {
  EXPECT_EQ(error_of_models("mach"), "no models 'mach'; did you mean 'match'?");
  EXPECT_EQ(error_of_models("match,walk.forward=9"),
            "models 'match,walk.forward=9': walk.forward must be 0.01 .. 3 [m/s], got 9");
  EXPECT_EQ(error_of_models("match,falls=maybe"),
            "models 'match,falls=maybe': effects.falls must be true or false, got \"maybe\"");
  EXPECT_EQ(error_of_models("match,wlak.forward=0.2"),
            "models 'match,wlak.forward=0.2': wlak is unknown; did you mean 'walk'?");
  EXPECT_EQ(error_of_models("match,walk.foward=0.2"),
            "models 'match,walk.foward=0.2': walk.foward is unknown; did you mean 'forward'?");
  EXPECT_EQ(error_of_models("match,fals=on"), "models 'match,fals=on': effects.fals is unknown; did you mean 'falls'?");
  EXPECT_EQ(error_of_models("match,head.yaw=1"),
            "models 'match,head.yaw=1': head.yaw is unknown; there are: yaw_limit, pitch_up, pitch_down, yaw_speed, "
            "pitch_speed");
  for (const char* wrong : {"falls", "falls=", "=on", "falls=on,falls=off", "walk..forward=1", "walk.forward.x=1"})
    EXPECT_NE(error_of_models(std::string("match,") + wrong), "") << wrong;
  EXPECT_EQ(error_of_models("match,falls"),
            "models 'match,falls': expected name=value behind a comma, once each, got 'falls'");
  EXPECT_EQ(error_of_models("match:4"), "models 'match:4': models take no number behind a colon");
  EXPECT_EQ(error_of_models("match,kicks.bicycle.range=3").substr(0, 69),
            "models 'match,kicks.bicycle.range=3': kicks.bicycle.ball_x is missing");
}

TEST(Models, NamesTheErrorInADescription) {
  const auto error = [](std::string_view text) {
    const auto models = parse_models(text, "models 'mine'");
    return models ? "" : models.error();
  };
  EXPECT_EQ(error(R"({"name": "mine"})"), "models 'mine': effects is missing");
  EXPECT_EQ(error(R"({"based_on": "match"})"), "models 'mine': name is missing");
  EXPECT_EQ(error(R"({"name": "mine", "based_on": "mach"})"),
            "models 'mine': based_on: no models 'mach'; did you mean 'match'?");
  EXPECT_EQ(error(R"({"name": "mine", "based_on": "match", "walk": 3})"),
            "models 'mine': walk must be an object, got 3");
  EXPECT_EQ(error(R"({"name": "mine", "based_on": "match", "kicks": {"a_name_far_too_long": {}}})"),
            "models 'mine': kicks: a name must have 1 .. 15 bytes, got 'a_name_far_too_long'");
  EXPECT_EQ(error(R"({"name": "mine", "based_on": "match", "wings": {}})").substr(0, 40),
            "models 'mine': wings is unknown; there a");
}

TEST(Models, TooManyKicksAreRefused) {
  std::string text = print_models(loaded_models("match"));
  const std::string kick = text.substr(text.find("\"forward\": {", text.find("\"kicks\"")) + 11);
  const std::string one = kick.substr(0, kick.find("\n    }") + 6);
  std::string more;
  for (int i = loaded_models("match").motion.kick_count; i <= motion::kMaxKicks; ++i)
    more += "\"kick" + std::to_string(i) + "\": " + one + ",";
  text.insert(text.find("\"forward\": {", text.find("\"kicks\"")), more);
  const auto models = parse_models(text, "mine");
  ASSERT_FALSE(models);
  EXPECT_EQ(models.error().substr(0, 44), "mine: kicks: expected at most 8, got one mor");
}

TEST(Models, AFileIsFoundByItsPath) {
  EXPECT_EQ(error_of_models("./no/such.json").substr(0, 26), "models './no/such.json': c");
  EXPECT_EQ(error_of_models("nothing.json").substr(0, 22), "models 'nothing.json':");
}

// not every size of the longer texts, to keep the test fast
TEST(Embedded, TruncatedModelsAreRefused) {
  for (const Embedded& file : embedded_files()) {
    if (file.kind != "models") continue;
    const std::size_t end = file.text.rfind('}');
    for (std::size_t size = 0; size <= end; size += 1 + size / 256)
      EXPECT_FALSE(parse_models(file.text.substr(0, size), "cut")) << file.name << " cut to " << size;
  }
}

}  // namespace
}  // namespace sim::io
