#include "robot/app/services/reasons_service.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "robot/app/recalled_decision.h"
#include "robot/bridge/teams_seen.h"
#include "robot/core/clock.h"
#include "robot/core/encoding.h"
#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "robot/foresight/believed_situation.h"
#include "robot/foresight/game_setting.h"
#include "sim/report/reasons.h"

namespace robot::app {
namespace {

namespace pb = foresight;
using nlohmann::json;

constexpr const char* kWhy = "/decision/why";
constexpr const char* kWhyNot = "/decision/why_not";
constexpr const char* kSituation = "/decision/situation";
constexpr std::uint64_t kSameMomentNs = 200 * kMillisecond;
constexpr std::size_t kMostText = 1000;  // [bytes] of a name or a path in a request

/// The moment that a request is about.
struct Moment {
  std::string robot;
  bridge::Recollection objects;
  std::optional<pb::GroundTruth> truth;
};

Result<std::string> text_in(const json& request, const char* key) {
  const auto found = request.find(key);
  if (found != request.end() && found->is_string() && found->get_ref<const std::string&>().size() <= kMostText)
    return found->get<std::string>();
  return Error{std::string("'") + key + "' must be a text of at most " + std::to_string(kMostText) + " bytes"};
}

template <class Message>
Result<bridge::Remembered<Message>> message_in(const json& object, const std::string& name) {
  const Error wrong{"objects." + name + R"( must be {"capture_ns": "1700…", "data": "base64"})"};
  if (!object.is_object()) return wrong;
  const auto capture_ns = number_in_text<std::uint64_t>(object, "capture_ns");
  const auto data = object.find("data");
  if (!capture_ns || data == object.end() || !data->is_string()) return wrong;
  const auto bytes = from_base64(data->get_ref<const std::string&>());
  if (!bytes) return wrong;
  bridge::Remembered<Message> message{.value = {}, .capture_ns = *capture_ns};
  if (!message.value.ParseFromString(*bytes)) return Error{"objects." + name + ".data is no message of that object"};
  return message;
}

/// Reads the objects that a client sent.
Result<Moment> sent_moment(const memory::Channels& channels, const json& request, std::string robot) {
  Moment moment{.robot = std::move(robot), .objects = {}, .truth = {}};
  const auto at_ns = number_in_text<std::uint64_t>(request, "at_ns");
  if (!at_ns) return Error{"'at_ns' must be a time in nanoseconds as a text, because there are 'objects'"};
  const json& objects = request["objects"];
  if (!objects.is_object()) return Error{"'objects' must be an object"};
  moment.objects.now_ns = *at_ns;
  moment.objects.speed = bridge::moment_of(channels, *at_ns).speed;
  Result<void> read;
  bridge::Recollection::visit(moment.objects,
                              [&]<class Message>(const char* name, std::optional<bridge::Remembered<Message>>& object) {
                                const auto found = objects.find(name);
                                if (!read || found == objects.end()) return;
                                auto message = message_in<Message>(*found, name);
                                if (message)
                                  object = *std::move(message);
                                else
                                  read = message.failure();
                              });
  if (!read) return read.failure();
  if (const auto found = objects.find("truth"); found != objects.end()) {
    auto truth = message_in<pb::GroundTruth>(*found, "truth");
    if (!truth) return truth.failure();
    moment.truth = std::move(truth->value);
  }
  return moment;
}

/// Reads the newest decision in memory, and what the robot knew then.
Result<Moment> newest_moment(const memory::Channels& channels, std::string robot) {
  const auto decision = bridge::newest<pb::DecisionTrace>(channels, "/" + robot + "/decision");
  if (!decision) return Error{"robot '" + printable(robot, 40) + "' has not decided anything"};
  // memory keeps only the newest value of each object: that of the game must be of the same moment
  const auto game = bridge::newest<pb::GameState>(channels, "/" + robot + "/game");
  const std::uint64_t now_ns = std::max(decision->capture_ns, game ? game->capture_ns : 0);
  if (now_ns - decision->capture_ns > kSameMomentNs)
    return Error{"robot '" + printable(robot, 40) +
                 "' decides nothing now: its newest decision is older than its game"};
  Moment moment{.robot = robot, .objects = bridge::recollect(channels, robot, now_ns), .truth = {}};
  if (auto truth = bridge::newest<pb::GroundTruth>(channels, bridge::kTruthTopic))
    moment.truth = std::move(truth->value);
  return moment;
}

/// Answers the questions. Used by the thread that serves questions.
class Reasons {
 public:
  Reasons(const memory::Channels& channels, const ReasonsOptions& options)
      : channels_(channels), rules_(options.rules), trees_(options.strategies) {}

  Result<json> why(const json& request) {
    const auto moment = moment_of(request);
    if (!moment) return moment.failure();
    auto recalled = recall(*moment);
    if (!recalled) return recalled.failure();
    find_sources(recalled->game.params, recalled->tree->tree(), recalled->why);
    return json{
        {"ok", true},
        {"reasons", sim::report::to_json(recalled->why, recalled->tree->tree(), moment->robot, recalled->has_truth)},
        {"has_truth", recalled->has_truth},
        {"agrees", recalled->agrees}};
  }

  Result<json> why_not(const json& request) {
    const auto what = text_in(request, "what");
    if (!what) return what.failure();
    const auto moment = moment_of(request);
    if (!moment) return moment.failure();
    const auto recalled = recall(*moment);
    if (!recalled) return recalled.failure();
    const sim::agent::Tree& tree = recalled->tree->tree();
    const auto goal = sim::debug::goal_of(*what, tree);
    if (!goal) return goal.failure();
    const auto answer =
        sim::debug::alternative_to(recalled->game.params, tree, recalled->why.decision, *goal, moment->robot);
    if (!answer) return answer.failure();
    return json{{"ok", true},
                {"alternative", sim::report::to_json(*answer, tree, moment->robot, *what)},
                {"agrees", recalled->agrees}};
  }

  Result<json> situation(const json& request) {
    const auto moment = moment_of(request);
    if (!moment) return moment.failure();
    const auto game = game_of(*moment);
    if (!game) return game.failure();
    const std::string robot = printable(moment->robot, 40);
    const auto text =
        foreseeing::believed_situation(moment->objects, game->params, "what robot " + robot + " believed");
    if (!text) return text.failure("robot " + robot);
    return json{{"ok", true}, {"situation", *text}};
  }

 private:
  Result<Moment> moment_of(const json& request) const {
    auto robot = text_in(request, "robot");
    if (!robot) return robot.failure();
    return request.contains("objects") ? sent_moment(channels_, request, *std::move(robot))
                                       : newest_moment(channels_, *std::move(robot));
  }

  Result<sim::io::PreparedGame> game_of(const Moment& moment) {
    const auto simulation = bridge::simulation_of(channels_);
    return prepared(foreseeing::setting_of(simulation ? &simulation->value : nullptr, moment.robot, rules_));
  }

  Result<RecalledDecision> recall(const Moment& moment) {
    const auto game = game_of(moment);
    if (!game) return game.failure();
    auto recalled = explain(moment.objects, moment.truth, *game, trees_);
    if (!recalled) return recalled.failure("robot " + printable(moment.robot, 40));
    return recalled;
  }

  /// Reads rules and models again only for another game than the last one.
  Result<sim::io::PreparedGame> prepared(const foreseeing::GameSetting& setting) {
    if (setting == setting_) return game_;
    auto game = sim::io::prepare({.rules = setting.rules, .models = {setting.models, setting.opponent_models}});
    if (!game) return game.failure();
    setting_ = setting;
    return game_ = *std::move(game);
  }

  const memory::Channels& channels_;
  const std::string rules_;
  KnownTrees trees_;
  foreseeing::GameSetting setting_;  // of `game_`
  sim::io::PreparedGame game_;
};

}  // namespace

void add_reasons_service(net::Services& services, const memory::Channels& channels, const ReasonsOptions& options) {
  const auto reasons = std::make_shared<Reasons>(channels, options);
  const auto add = [&](const char* name, Result<json> (Reasons::*ask)(const json&)) {
    services.add(name, net::Services::For::questions,
                 [reasons, name, ask](const json& request, const net::ClientContext&) {
                   auto answer = ((*reasons).*ask)(request);
                   return answer ? *std::move(answer) : net::failure(std::string(name) + ": " + answer.error());
                 });
  };
  add(kWhy, &Reasons::why);
  add(kWhyNot, &Reasons::why_not);
  add(kSituation, &Reasons::situation);
}

}  // namespace robot::app
