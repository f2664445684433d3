#include "robot/app/recorded_moment.h"

#include "robot/app/recorded_beliefs.h"
#include "robot/core/text.h"
#include "robot/foresight/believed_situation.h"
#include "robot/logging/sessions/read_all.h"
#include "sim/io/matchup.h"

namespace robot::app {

Result<std::uint64_t> time_in(const logging::Session& session, double at) {
  const double length = static_cast<double>(session.end_ns - session.start_ns) / 1e9;  // [s]
  if (!(at >= -length && at <= length))
    return Error{formatted("--at: the session is %.3f s long, got %.9g", length, at)};
  return (at < 0 ? session.end_ns : session.start_ns) + static_cast<std::uint64_t>(static_cast<std::int64_t>(at * 1e9));
}

foreseeing::GameSetting recorded_setting(const logging::Session& session, const std::string& robot,
                                         const std::string& rules) {
  const auto simulations = logging::read_in_order<foresight::Simulation>(session, memory::kSimulationTopic);
  return foreseeing::setting_of(simulations.empty() ? nullptr : &simulations.front().value, robot, rules);
}

Result<std::string> situation_at(const logging::Session& session, const RecordedMoment& moment) {
  const auto at_ns = time_in(session, moment.at);
  if (!at_ns) return at_ns.failure();
  const std::string robot = moment.robot.empty() ? session.info.robot : moment.robot;
  RecordedBeliefs beliefs(session, robot);
  if (const char* missing = beliefs.missing())
    return Error{session.id() + " has no object " + missing + " of robot " + robot + ", and a situation needs it"};

  const foreseeing::GameSetting setting = recorded_setting(session, robot, moment.rules);
  const auto game = sim::io::prepare({.rules = setting.rules, .models = {setting.models, setting.opponent_models}});
  if (!game) return game.failure();
  const double seconds = static_cast<double>(*at_ns - session.start_ns) / 1e9;
  auto situation = foreseeing::believed_situation(
      beliefs.at(*at_ns), game->params,
      formatted("what robot %s believed %.3f s into %s", robot.c_str(), seconds,
                session.info.name.empty() ? session.id().c_str() : session.info.name.c_str()));
  if (!situation) return situation.failure("robot " + robot);
  return situation;
}

}  // namespace robot::app
