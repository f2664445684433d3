#include "robot/net/scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <set>

#include "robot/core/clock.h"
#include "robot/core/encoding.h"
#include "robot/net/scene/field_scene.h"
#include "robot/net/scene/game_scene.h"
#include "robot/net/scene/points.h"
#include "robot/net/scene/scene_channels.h"
#include "robot/net/scene/schemas.h"
#include "tests/robot/net/scene/decoded.h"

namespace robot::net {
namespace {

using nlohmann::json;
namespace pb = foresight;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

json update_of(SceneStream& stream, const Scene& scene, std::uint64_t capture_ns = kSecond) {
  return tests::decoded(field_channel().schema, stream.update(scene, capture_ns));
}
json update_of(const Scene& scene) {
  SceneStream stream;
  return update_of(stream, scene);
}

Scene balls(std::initializer_list<const char*> ids, double x = 0) {
  Scene scene;
  for (const char* id : ids)
    scene.push_back({id, {{.kind = Shape::Kind::ball, .place = {x, 0, 0}, .size = {1, 1, 1}}}});
  return scene;
}

std::set<std::string> ids(const json& list) {
  std::set<std::string> found;
  for (const json& item : list) found.insert(item["id"].get<std::string>());
  return found;
}

/// A client that applies updates as Foxglove does: deletions first, then each entity replaces the one with its id.
struct Watcher {
  std::set<std::string> shown;
  void take(const json& update) {
    for (const std::string& id : ids(update["deletions"])) shown.erase(id);
    shown.merge(ids(update["entities"]));
  }
};

TEST(SceneStream, HoldsEachShapeWithItsPlaceSizeAndColour) {
  using Kind = Shape::Kind;
  const Point3 place{1, 2, 3}, size{4, 5, 6};
  Entity entity{"all", {}};
  for (const Kind kind : {Kind::box, Kind::ball, Kind::cylinder, Kind::arrow, Kind::words, Kind::lines})
    entity.shapes.push_back({.kind = kind,
                             .place = place,
                             .size = size,
                             .heading = std::numbers::pi / 2,
                             .colour = {0.25, 0.5, 0.75, 1},
                             .words = "a word",
                             .points = {{0, 0, 0}, {1, 0, 0}}});
  const json found = update_of({entity})["entities"][0];
  EXPECT_EQ(found["frame_id"], "field");
  EXPECT_EQ(found["id"], "all");
  EXPECT_EQ(found["timestamp"], "1970-01-01T00:00:01Z");
  EXPECT_EQ(found["lifetime"], "0s");
  for (const char* kind : {"cubes", "spheres", "cylinders", "arrows", "texts", "lines"}) {
    ASSERT_EQ(found[kind].size(), 1u) << kind;
    const json& shape = found[kind][0];
    EXPECT_EQ(shape["pose"]["position"], (json{{"x", 1.0}, {"y", 2.0}, {"z", 3.0}})) << kind;
    EXPECT_NEAR(shape["pose"]["orientation"]["z"], std::sqrt(0.5), 1e-12) << kind;
    EXPECT_NEAR(shape["pose"]["orientation"]["w"], std::sqrt(0.5), 1e-12) << kind;
    EXPECT_EQ(shape["color"], (json{{"r", 0.25}, {"g", 0.5}, {"b", 0.75}, {"a", 1.0}})) << kind;
  }
  for (const char* kind : {"cubes", "spheres", "cylinders"})
    EXPECT_EQ(found[kind][0]["size"], (json{{"x", 4.0}, {"y", 5.0}, {"z", 6.0}})) << kind;
  const json& arrow = found["arrows"][0];
  EXPECT_EQ(arrow["shaft_length"].get<double>() + arrow["head_length"].get<double>(), 4);
  EXPECT_EQ(found["texts"][0]["text"], "a word");
  EXPECT_EQ(found["texts"][0]["font_size"], 6);
  EXPECT_EQ(found["lines"][0]["type"], "LINE_LIST");
  EXPECT_EQ(found["lines"][0]["thickness"], 6);
  EXPECT_EQ(found["lines"][0]["points"][1]["x"], 1);
}

TEST(SceneStream, AnEntityThatIsGoneIsDeletedInEveryLaterUpdate) {
  SceneStream stream;
  EXPECT_TRUE(update_of(stream, balls({"a", "b"}))["deletions"].empty());
  EXPECT_EQ(ids(update_of(stream, balls({"a"}))["deletions"]), (std::set<std::string>{"b"}));
  EXPECT_EQ(ids(update_of(stream, balls({"c"}))["deletions"]), (std::set<std::string>{"a", "b"}));
  EXPECT_TRUE(update_of(stream, balls({"a", "b", "c"}))["deletions"].empty());
}

TEST(SceneStream, AClientThatMissedUpdatesAgreesWithOneThatMissedNone) {
  SceneStream stream;
  Watcher all, some;
  const Scene scenes[] = {balls({"a", "b", "c"}), balls({"b", "d"}), balls({}), balls({"a"}), balls({"d", "a"})};
  for (std::size_t i = 0; i < std::size(scenes); ++i) {
    const json update = update_of(stream, scenes[i]);
    all.take(update);
    if (i % 3 == 0) {
      some.take(update);
      EXPECT_EQ(all.shown, some.shown) << i;
    }
  }
  EXPECT_EQ(all.shown, (std::set<std::string>{"a", "d"}));
}

TEST(SceneStream, LeavesOutWhatCannotBeDrawn) {
  for (const double x : {kNan, HUGE_VAL, -1e9}) {
    SceneStream stream;
    EXPECT_EQ(update_of(stream, balls({"a"}))["entities"].size(), 1u);
    const json update = update_of(stream, balls({"a"}, x));
    EXPECT_TRUE(update["entities"].empty()) << x;
    EXPECT_EQ(ids(update["deletions"]), (std::set<std::string>{"a"})) << x;
  }
}

TEST(SceneStream, TwoThingsOfOneNameAreOne) { EXPECT_EQ(update_of(balls({"a", "a"}))["entities"].size(), 1u); }

TEST(FieldScene, HasTheLinesOfTheRules) {
  pb::Field field;
  field.set_length(9);
  field.set_width(6);
  field.set_border(0.7F);
  field.set_line_width(0.05F);
  field.set_centre_circle_radius(0.75F);
  field.set_goal_width(1.6F);
  field.set_penalty_mark(1.3F);
  const json update = update_of(field_scene(field));
  EXPECT_EQ(ids(update["entities"]), (std::set<std::string>{"carpet", "goals", "lines"}));
  for (const json& entity : update["entities"]) {
    EXPECT_EQ(entity["cubes"].size(), entity["id"] == "carpet" ? 1u : entity["id"] == "goals" ? 2u : 0u);
    EXPECT_EQ(entity["cylinders"].size(), entity["id"] == "goals" ? 4u : 0u);
    if (entity["id"] != "lines") continue;
    double most_x = 0, most_y = 0;
    for (const json& point : entity["lines"][0]["points"]) {
      most_x = std::max(most_x, std::abs(point["x"].get<double>()));
      most_y = std::max(most_y, std::abs(point["y"].get<double>()));
    }
    EXPECT_EQ(most_x, 4.5);
    EXPECT_EQ(most_y, 3);
    EXPECT_NEAR(entity["lines"][0]["thickness"], 0.05, 1e-6);
    EXPECT_EQ(entity["lines"][0]["points"].size() % 2, 0u);
  }
}

TEST(TruthScene, ShowsBallAndRobotsWhereTheyAre) {
  pb::GroundTruth truth;
  truth.mutable_ball()->set_x(1.5F);
  truth.mutable_ball()->set_y(-0.5F);
  auto* robot = truth.add_robots();
  robot->set_team(14);
  robot->set_player(2);
  robot->set_x(-2);
  robot->set_y(1);
  robot->set_heading(0);
  const json update = update_of(truth_scene(truth, {.home_team = 14}));
  ASSERT_EQ(ids(update["entities"]), (std::set<std::string>{"ball", "robot 14/2"}));
  const json &ball = update["entities"][0], &body = update["entities"][1];
  EXPECT_EQ(ball["spheres"][0]["pose"]["position"]["x"], 1.5);
  EXPECT_EQ(ball["spheres"][0]["pose"]["position"]["y"], -0.5);
  EXPECT_TRUE(ball["arrows"].empty());
  EXPECT_EQ(body["cylinders"][0]["pose"]["position"]["x"], -2);
  EXPECT_EQ(body["texts"][0]["text"], "2");
}

TEST(TruthScene, AFallenRobotLies) {
  pb::GroundTruth truth;
  for (const bool fallen : {false, true}) {
    auto* robot = truth.add_robots();
    robot->set_team(5);
    robot->set_player(fallen ? 2 : 1);
    robot->set_fallen(fallen);
    robot->set_heading(static_cast<float>(std::numbers::pi / 2));
  }
  const json entities = update_of(truth_scene(truth, {.home_team = 14}))["entities"];
  const json &upright = entities[0], &lying = entities[1];
  const auto head = [](const json& entity) { return entity["spheres"][0]["pose"]["position"]; };
  EXPECT_GT(head(upright)["z"], 0.4);
  EXPECT_LT(head(lying)["z"], 0.2);
  EXPECT_GT(head(lying)["y"], 0.2);  // it fell to the front
  EXPECT_NE(lying["texts"][0]["text"].get<std::string>().find("fallen"), std::string::npos);
  // the away team's robots are boxes; this one's own z points along the field's y
  const json turn = lying["cubes"][0]["pose"]["orientation"];
  const double x = turn["x"], y = turn["y"], z = turn["z"], w = turn["w"];
  EXPECT_NEAR(2 * (x * z + w * y), 0, 1e-6);
  EXPECT_NEAR(2 * (y * z - w * x), 1, 1e-6);
  EXPECT_NEAR(x * x + y * y + z * z + w * w, 1, 1e-9);
}

TEST(TruthScene, NonsenseIsLeftOut) {
  pb::GroundTruth truth;
  truth.mutable_ball()->set_x(static_cast<float>(kNan));
  truth.mutable_ball()->set_velocity_x(HUGE_VALF);
  auto* robot = truth.add_robots();
  robot->set_y(HUGE_VALF);
  auto* turned = truth.add_robots();
  turned->set_heading(static_cast<float>(kNan));
  truth.add_robots();  // without team, number and heading, at (0, 0)
  const json update = update_of(truth_scene(truth, {}));
  EXPECT_EQ(ids(update["entities"]), (std::set<std::string>{"robot 3 without a number"}));
  for (int i = 0; i < 10000; ++i) truth.add_robots();
  EXPECT_LT(update_of(truth_scene(truth, {}))["entities"].size(), 100u);
}

Believed believed() {
  Believed belief{.team = 14, .player = 2};
  belief.pose.set_x(1);
  belief.pose.set_y(2);
  belief.pose.set_heading(static_cast<float>(std::numbers::pi / 2));
  belief.ball.set_x(3);
  belief.ball.set_y(0.5F);
  belief.ball.set_seen_ns(kSecond);
  return belief;
}

json place_of(const json& update, const std::string& id) {
  for (const json& entity : update["entities"])
    if (entity["id"] == id) return entity["spheres"][0]["pose"]["position"];
  return nullptr;
}

TEST(BeliefScene, TheBallIsSeenFromTheBelievedPose) {
  const json ball = place_of(update_of(belief_scene(believed(), {.home_team = 14}, kSecond)), "ball");
  EXPECT_NEAR(ball["x"], 1 - 0.5, 1e-6);
  EXPECT_NEAR(ball["y"], 2 + 3, 1e-6);
}

TEST(BeliefScene, ATeamThatAttacksTheOtherWayIsTurned) {
  Believed belief = believed();
  auto* mate = belief.mates.add_teammates();
  mate->set_player(3);
  mate->set_active(true);
  mate->set_received_ns(kSecond);
  mate->mutable_pose()->set_x(2);
  auto* opponent = belief.opponents.add_opponents();
  opponent->set_y(1);
  opponent->set_seen_ns(kSecond);
  const json straight = update_of(belief_scene(belief, {}, kSecond));
  belief.game.set_attacks_positive_x(false);
  const json turned = update_of(belief_scene(belief, {}, kSecond));
  EXPECT_EQ(ids(straight["entities"]),
            (std::set<std::string>{"ball", "mate 3", "opponent without a number 1", "self"}));
  EXPECT_EQ(ids(straight["entities"]), ids(turned["entities"]));
  for (const std::string& id : ids(straight["entities"]))
    for (const char* axis : {"x", "y"})
      EXPECT_NEAR(place_of(straight, id)[axis].get<double>(), -place_of(turned, id)[axis].get<double>(), 1e-5) << id;
}

TEST(BeliefScene, OldBeliefsFadeAndVanish) {
  const auto alpha = [](std::uint64_t now_ns) {
    const json update = update_of(belief_scene(believed(), {}, now_ns));
    for (const json& entity : update["entities"])
      if (entity["id"] == "ball") return entity["spheres"][0]["color"]["a"].get<double>();
    return 0.0;
  };
  EXPECT_GT(alpha(kSecond), alpha(10 * kSecond));
  EXPECT_GT(alpha(10 * kSecond), 0);
  EXPECT_EQ(alpha(100 * kSecond), 0);
}

TEST(BeliefScene, ARobotWithoutAPlaceShowsNothingThatDependsOnIt) {
  Believed belief = believed();
  belief.pose.set_x(static_cast<float>(kNan));
  EXPECT_TRUE(update_of(belief_scene(belief, {}, kSecond))["entities"].empty());
}

TEST(Liveries, AreTheJerseysIfTheGameControllerTellsThem) {
  pb::GameState game;
  game.mutable_own()->set_number(5);
  game.mutable_own()->set_field_colour(pb::TeamState::COLOUR_RED);
  EXPECT_EQ(liveries_of(14, game).home.red, Liveries().home.red);  // one jersey is not enough
  game.mutable_opponent()->set_field_colour(pb::TeamState::COLOUR_WHITE);
  EXPECT_EQ(liveries_of(14, game).away.red, colour_of(0xe33b2e).red);
  EXPECT_EQ(liveries_of(5, game).home.red, colour_of(0xe33b2e).red);
  game.mutable_opponent()->set_field_colour(pb::TeamState::COLOUR_RED);
  EXPECT_EQ(liveries_of(14, game).away.red, Liveries().away.red);
}

/// The places of a cloud.
std::vector<Point3> points_of(const Scene& scene) {
  const json cloud = tests::decoded(kPointCloud.schema(), point_cloud(scene, kSecond));
  EXPECT_EQ(cloud["frame_id"], "field");
  EXPECT_EQ(cloud["point_stride"], 16);
  EXPECT_EQ(cloud["fields"].size(), 7u);
  const std::string data = *from_base64(cloud["data"].get<std::string>());
  EXPECT_EQ(data.size() % 16, 0u);
  std::vector<Point3> points;
  for (std::size_t at = 0; at + 16 <= data.size(); at += 16) {
    float place[3];
    std::memcpy(place, data.data() + at, sizeof place);
    points.push_back({place[0], place[1], place[2]});
  }
  return points;
}

TEST(PointCloud, LiesOnTheShapes) {
  for (const Shape::Kind kind : {Shape::Kind::ball, Shape::Kind::cylinder, Shape::Kind::box}) {
    const std::vector<Point3> points =
        points_of({{"a", {{.kind = kind, .place = {1, 2, 3}, .size = {0.2, 0.2, 0.2}, .heading = 0.3, .pitch = 0.4}}}});
    EXPECT_GT(points.size(), 20u);
    for (const Point3& point : points) {
      const double away = std::hypot(point.x - 1, point.y - 2, point.z - 3);
      EXPECT_GT(away, 0.06);
      EXPECT_LT(away, 0.18);
    }
  }
  const Shape line{
      .kind = Shape::Kind::lines, .place = {1, 0, 0}, .size = {0, 0, 0.05}, .points = {{0, 0, 0}, {0, 2, 0}}};
  const std::vector<Point3> points = points_of({{"line", {line}}});
  EXPECT_GE(points.size(), 39u);
  for (const Point3& point : points) EXPECT_TRUE(point.x == 1 && point.y >= 0 && point.y <= 2 && point.z == 0);
}

TEST(PointCloud, LeavesOutWhatCannotBeDrawn) {
  EXPECT_TRUE(points_of(balls({"a"}, kNan)).empty());
  EXPECT_TRUE(points_of({}).empty());
}

}  // namespace
}  // namespace robot::net
