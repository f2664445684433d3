#include "robot/foresight/believed_situation.h"

#include "sim/foresight/situation.h"
#include "sim/io/situation.h"

namespace robot::foreseeing {

Result<std::string> believed_situation(const bridge::Recollection& recollection, const sim::Params& params,
                                       const std::string& about) {
  const auto knowledge = bridge::knowledge_of(recollection, params);
  if (!knowledge) return knowledge.failure();
  const sim::foresight::Believed believed = sim::foresight::believe(params, *knowledge);
  if (!believed.refusal.empty()) return Error{believed.refusal};
  const foresight::GameState& game = recollection.game->value;
  const sim::io::SituationTeams teams{.home = static_cast<int>(game.own_team()),
                                      .away = static_cast<int>(game.opponent().number())};
  return sim::io::save_situation(believed.situation, teams, about);
}

}  // namespace robot::foreseeing
