#include "robot/app/services/reasons_service.h"

#include <memory>
#include <utility>

#include "robot/app/asked_moment.h"
#include "robot/app/known_game.h"
#include "robot/app/recalled_decision.h"
#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "robot/foresight/believed_situation.h"
#include "sim/report/reasons.h"

namespace robot::app {
namespace {

using nlohmann::json;

constexpr const char* kWhy = "/decision/why";
constexpr const char* kWhyNot = "/decision/why_not";
constexpr const char* kSituation = "/decision/situation";

/// Answers the questions. Used by the thread that serves questions.
class Reasons {
 public:
  Reasons(const memory::Channels& channels, const ReasonsOptions& options)
      : channels_(channels), game_(channels, options.rules), trees_(options.strategies) {}

  Result<json> why(const json& request) {
    const auto moment = asked_moment(channels_, request);
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
    const auto moment = asked_moment(channels_, request);
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
    const auto moment = asked_moment(channels_, request);
    if (!moment) return moment.failure();
    const auto game = game_.of(moment->robot);
    if (!game) return game.failure();
    const std::string robot = printable(moment->robot, 40);
    const auto text =
        foreseeing::believed_situation(moment->objects, game->params, "what robot " + robot + " believed");
    if (!text) return text.failure("robot " + robot);
    return json{{"ok", true}, {"situation", *text}};
  }

 private:
  Result<RecalledDecision> recall(const AskedMoment& moment) {
    const auto game = game_.of(moment.robot);
    if (!game) return game.failure();
    auto recalled = explain(moment.objects, moment.truth, *game, trees_);
    if (!recalled) return recalled.failure("robot " + printable(moment.robot, 40));
    return recalled;
  }

  const memory::Channels& channels_;
  KnownGame game_;
  KnownTrees trees_;
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
