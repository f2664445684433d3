#include "sim/debug/stop.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "robot/core/text.h"
#include "sim/check/event.h"
#include "sim/debug/decision.h"
#include "sim/debug/truth.h"
#include "sim/io/values.h"
#include "sim/io/vocabulary.h"
#include "sim/io/words.h"

namespace sim::debug {

using robot::Error;
using robot::Result;
using robot::split;
using robot::trimmed;

namespace {

constexpr float kMostError = 30;  // [m]

constexpr std::pair<std::string_view, RobotFact::Kind> kPlain[] = {{"skill changes", RobotFact::Kind::skill_changes},
                                                                   {"leaf changes", RobotFact::Kind::leaf_changes},
                                                                   {"role changes", RobotFact::Kind::role_changes},
                                                                   {"decides", RobotFact::Kind::decides},
                                                                   {"falls", RobotFact::Kind::falls}};
constexpr std::pair<std::string_view, RobotFact::Kind> kErrors[] = {{"ball_error", RobotFact::Kind::ball_error},
                                                                    {"pose_error", RobotFact::Kind::pose_error}};

Error unknown_fact(std::string_view text) {
  std::vector<std::string_view> known = io::all_features();
  const auto add = [&](std::string_view word) {
    if (std::ranges::find(known, word) == known.end()) known.push_back(word);
  };
  for (int i = 0; i < check::happening_count(); ++i) add(check::happening(i).name);
  for (int i = 0; i < check::quantity_count(); ++i) add(check::quantity(i).name);
  for (const auto& [word, kind] : kPlain) known.emplace_back(word);
  for (const auto& [word, kind] : kErrors) known.emplace_back(word);
  std::string hint = io::did_you_mean(text, known);
  if (hint.empty()) hint = io::did_you_mean(text.substr(0, text.find(' ')), known);
  return {"expected a fact about the game or a robot, got '" + std::string(text) + "'" + hint};
}

/// Parses "> 0.5 m" for an error of a belief.
Result<io::Term> parse_error_bound(std::string_view text) {
  for (const auto& [sign, comparison] :
       {std::pair<std::string_view, agent::Comparison>{"<=", agent::Comparison::at_most},
        {">=", agent::Comparison::at_least},
        {"<", agent::Comparison::less},
        {">", agent::Comparison::greater}}) {
    if (!text.starts_with(sign)) continue;
    const auto bound = io::Values().read(trimmed(text.substr(sign.size())), {"m", 0, kMostError, nullptr});
    if (!bound) return Error{"the value for an error of a belief " + bound.error()};
    return io::Term{.feature = agent::kNoFeature, .comparison = comparison, .threshold = *bound, .text = {}};
  }
  return Error{"an error of a belief is compared by < <= > >=, got '" + std::string(text) + "'"};
}

/// Parses a fact about a robot. Nothing: `text` begins with none of the words.
std::optional<Result<RobotFact>> parse_robot_fact(std::string_view text, int robot) {
  RobotFact fact;
  fact.robot = robot;
  for (const auto& [word, kind] : kPlain)
    if (text == word) {
      fact.kind = kind;
      return fact;
    }
  for (const auto& [word, kind] : kErrors)
    if (text.starts_with(word)) {
      auto bound = parse_error_bound(trimmed(text.substr(word.size())));
      if (!bound) return bound.failure();
      fact.kind = kind, fact.term = *std::move(bound);
      return fact;
    }
  constexpr std::string_view kSkillIs = "skill is ";
  if (text.starts_with(kSkillIs)) {
    const auto skill = io::skill_named(trimmed(text.substr(kSkillIs.size())));
    if (!skill) return skill.failure();
    fact.kind = RobotFact::Kind::skill_is, fact.skill = *skill;
    return fact;
  }
  const std::string_view word = text.substr(0, text.find_first_of(" <>="));
  if (agent::find_feature(word) == agent::kNoFeature) return {};
  io::Values values;
  auto condition = io::parse_condition(text, values);
  if (!condition) return condition.failure();
  fact.kind = RobotFact::Kind::feature, fact.term = condition->alternatives[0][0];
  return fact;
}

/// Returns whether the text begins with a word of sim/check's facts.
bool is_of_game(std::string_view text) {
  check::Words words(text);
  for (int i = 0; i < check::happening_count(); ++i)
    if (words.take_pair(check::happening(i).name)) return true;
  for (int i = 0; i < check::quantity_count(); ++i)
    if (words.take(check::quantity(i).name)) return true;
  return false;
}

Result<Term> parse_term(std::string_view text, int players, const io::SituationTeams& teams, int focus) {
  constexpr std::string_view kNot = "not ";
  Term term;
  if (text == "not") return Error{"a fact is missing"};
  term.negated = text.starts_with(kNot);
  if (term.negated) text = trimmed(text.substr(kNot.size()));
  if (text.empty()) return Error{"a fact is missing"};
  const std::string_view first = text.substr(0, text.find(' '));
  int robot = focus;
  const bool has_robot = first.find('/') != first.npos;
  if (has_robot) {
    robot = check::robot_named(first, players, teams);
    if (robot == kNobody)
      return Error{"expected " + check::robot_names(players, teams) + ", got '" + std::string(first) + "'"};
    text = trimmed(text.substr(first.size()));
  }
  if (!has_robot && is_of_game(text)) {
    check::Words words(text);
    const auto fact = check::take_fact(words);
    if (!fact) return fact.failure();
    if (!words.at_end()) return Error{"expected 'and' or 'or', got '" + words.rest() + "'"};
    term.game = *fact;
    term.text = std::string(term.negated ? kNot : "") + std::string(text);
    return term;
  }
  const auto fact = parse_robot_fact(text, robot);
  if (!fact) return unknown_fact(text);
  if (!*fact) return fact->failure();
  term.robot = **fact;
  term.text = std::string(term.negated ? kNot : "") + std::to_string(teams.of(side_of(robot))) + "/" +
              std::to_string(player_of(robot)) + " " + std::string(text);
  return term;
}

const char* skill_of(const Params& params, const State& state, int robot) {
  const std::uint16_t leaf = state.robots[robot].mind.leaf;
  const agent::TreeBehaviour* tree = tree_of(params, robot);
  if (leaf == agent::kNoLeaf || !tree || leaf >= tree->tree().leaves.size()) return "";
  return info_of(tree->tree().leaves[leaf].skill).name;
}

float error_of(RobotFact::Kind kind, const State& state, int robot) {
  if (!on_field(state.world.bodies[robot])) return agent::kUnknown;
  const agent::Beliefs& beliefs = state.robots[robot].beliefs;
  const agent::Beliefs truth = true_beliefs(state, robot);
  if (kind == RobotFact::Kind::pose_error) return distance(beliefs.pose.pose.position, truth.pose.pose.position);
  if (beliefs.ball.seen == kNever) return agent::kUnknown;
  return distance(beliefs.ball.position, truth.ball.position);
}

/// Follows a game and knows whether the condition holds.
class Follower {
 public:
  Follower(Timeline& timeline, const Stop& stop) : timeline_(timeline), stop_(stop) {}

  bool holds(const check::Glance& glance, const State& before, const State& after) {
    return std::ranges::any_of(stop_.alternatives, [&](const std::vector<Term>& terms) {
      // every term sees every tick, because features are remembered
      bool all = true;
      for (const Term& term : terms) {
        const bool is_so = term.game ? check::holds(*term.game, glance) : holds(term.robot, before, after);
        all &= is_so != term.negated;
      }
      return all;
    });
  }

 private:
  bool holds(const RobotFact& fact, const State& before, const State& after) {
    const Params& params = timeline_.setup_at(before.world.tick)->params;
    const int robot = fact.robot;
    switch (fact.kind) {
      case RobotFact::Kind::feature: return feature_holds(fact, params, before);
      case RobotFact::Kind::ball_error:
      case RobotFact::Kind::pose_error:
        return agent::holds(fact.term.comparison, error_of(fact.kind, after, robot), fact.term.threshold);
      case RobotFact::Kind::skill_is:
        return std::string_view(skill_of(params, after, robot)) == info_of(fact.skill).name;
      case RobotFact::Kind::skill_changes:
        return std::string_view(skill_of(params, before, robot)) != skill_of(params, after, robot);
      case RobotFact::Kind::leaf_changes: return before.robots[robot].mind.leaf != after.robots[robot].mind.leaf;
      case RobotFact::Kind::role_changes: return before.robots[robot].mind.role != after.robots[robot].mind.role;
      case RobotFact::Kind::decides: return decides(before, robot);
      case RobotFact::Kind::falls: return is_down(after, robot) && !is_down(before, robot);
    }
    return false;
  }

  static bool is_down(const State& state, int robot) { return state.world.bodies[robot].doing == Body::Doing::fallen; }

  /// Between two decisions the last answer holds.
  bool feature_holds(const RobotFact& fact, const Params& params, const State& before) {
    bool& last = last_[&fact];
    const agent::TreeBehaviour* tree = tree_of(params, fact.robot);
    const auto decision = tree ? decision_in(params, before, fact.robot) : std::nullopt;
    if (!decision) return last;
    const Thought thought(params, tree->tree(), *decision);
    const io::Term& term = fact.term;
    const float threshold = term.other == agent::kNoFeature ? term.threshold : value_of(term.other, thought.view());
    return last = agent::holds(term.comparison, value_of(term.feature, thought.view()), threshold);
  }

  Timeline& timeline_;
  const Stop& stop_;
  std::map<const RobotFact*, bool> last_;
};

/// Calls see(tick) for each tick at which the condition has become true, until it returns false.
template <class See>
void for_each_stop(Timeline& timeline, const Stop& stop, Tick end, See&& see) {
  const State start = timeline.at(timeline.first());
  check::Observer observer(start);
  Follower follower(timeline, stop);
  bool was = false;
  // from the first tick on, because touches and passes have a past
  timeline.replay(timeline.first(), end, [&](const State& before, const State& after, const referee::Events& events) {
    const bool is = follower.holds(observer.look(after, events), before, after);
    const bool has_become = is && !was;
    was = is;
    return !has_become || see(after.world.tick);
  });
}

}  // namespace

Result<Stop> parse_stop(std::string_view text, int players, const io::SituationTeams& teams, int focus) {
  if (text.size() > io::kMaxConditionBytes)
    return Error{"a condition must have at most " + std::to_string(io::kMaxConditionBytes) + " bytes, got " +
                 std::to_string(text.size())};
  Stop stop;
  for (const std::string_view alternative : split(text, " or ")) {
    std::vector<Term>& terms = stop.alternatives.emplace_back();
    for (const std::string_view part : split(alternative, " and ")) {
      auto term = parse_term(trimmed(part), players, teams, focus);
      if (!term) return term.failure();
      terms.push_back(*std::move(term));
    }
  }
  return stop;
}

std::string text_of(const Stop& stop) {
  std::vector<std::string> alternatives;
  for (const std::vector<Term>& terms : stop.alternatives) {
    std::vector<std::string> texts;
    for (const Term& term : terms) texts.push_back(term.text);
    alternatives.push_back(robot::joined(texts, " and "));
  }
  return robot::joined(alternatives, " or ");
}

std::optional<int> robot_without_tree(const Stop& stop, const Params& params) {
  using enum RobotFact::Kind;
  for (const std::vector<Term>& terms : stop.alternatives)
    for (const Term& term : terms) {
      const RobotFact::Kind kind = term.robot.kind;
      const bool is_of_tree = kind == feature || kind == skill_is || kind == skill_changes || kind == leaf_changes;
      if (!term.game && is_of_tree && !tree_of(params, term.robot.robot)) return term.robot.robot;
    }
  return {};
}

std::optional<Tick> next_stop(Timeline& timeline, const Stop& stop, Tick now) {
  std::optional<Tick> found;
  for_each_stop(timeline, stop, kNever, [&](Tick tick) {
    if (tick > now) found = tick;
    return !found;
  });
  return found;
}

std::optional<Tick> previous_stop(Timeline& timeline, const Stop& stop, Tick now) {
  std::optional<Tick> found;
  for_each_stop(timeline, stop, now, [&](Tick tick) {
    if (tick < now) found = tick;
    return true;
  });
  return found;
}

}  // namespace sim::debug
