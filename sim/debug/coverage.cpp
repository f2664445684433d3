#include "sim/debug/coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <set>
#include <unordered_map>

#include "sim/debug/setup.h"
#include "sim/foresight/forecast.h"
#include "sim/match/step.h"

namespace sim::debug {
namespace {

/// Calls see(leaf) for each leaf below `at`, those of "yes" first, each once.
template <class See>
void for_each_leaf(const agent::Tree& tree, std::uint16_t at, std::vector<bool>& seen_nodes, See&& see) {
  if (at & agent::kLeafBit) return see(static_cast<std::uint16_t>(at & ~agent::kLeafBit));
  if (seen_nodes[at]) return;
  seen_nodes[at] = true;
  for_each_leaf(tree, tree.nodes[at].yes, seen_nodes, see);
  for_each_leaf(tree, tree.nodes[at].no, seen_nodes, see);
}

/// Returns the ends of the beginnings of a path: "a/b/c" gives 1, 3 and 5.
std::vector<std::size_t> ends_of_names(const std::string& path) {
  std::vector<std::size_t> ends;
  for (std::size_t end = path.find('/'); end != std::string::npos; end = path.find('/', end + 1)) ends.push_back(end);
  ends.push_back(path.size());
  return ends;
}

/// The numbers of a tree's nodes and leaves by their texts in a trace, which point into the tree.
class Numbers {
 public:
  explicit Numbers(const agent::Tree& tree) {
    for (std::size_t i = 0; i < tree.node_words.size(); ++i) add(tree.node_words[i], i);
    for (std::size_t i = 0; i < tree.leaf_words.size(); ++i) add(tree.leaf_words[i], i);
  }
  std::uint16_t of(const agent::Trace::Node& visited) const { return numbers_.at(visited.path); }

 private:
  void add(const agent::Words& words, std::size_t number) {
    numbers_[words.path.c_str()] = static_cast<std::uint16_t>(number);
  }

  std::unordered_map<const char*, std::uint16_t> numbers_;
};

constexpr std::uint16_t kOutside = agent::kNoLeaf;  // the leaf of a robot that does not play

/// Watches one game.
class Watch {
 public:
  Watch(const Params& params, Side side, const Parts& parts)
      : side_(side), parts_(parts), numbers_(parts.tree()), gains_(parts.all().size()), decisions_(parts.all().size()) {
    seen_.games = 1;
    seen_.parts.resize(parts.all().size());
    seen_.comparisons.resize(parts.tree().nodes.size());
    const std::size_t count = parts.all().size();
    for (int player = 0; player < params.rules.players; ++player) {
      const int robot = player + (side == Side::home ? 0 : kMaxPlayers);
      const agent::TreeBehaviour* played = tree_of(params, robot);
      if (played && &played->tree() == &parts.tree())
        players_.push_back(
            {.robot = robot, .begun = std::vector<Tick>(count), .ended = std::vector<Tick>(count, kNever)});
    }
  }

  /// Takes what happened in the tick `now`, which ended with `state`. `traces` are those of the decisions in it,
  /// otherwise clear.
  void look(Tick now, const State& state, const std::array<agent::Trace, kMaxRobots>& traces,
            const referee::Events& events) {
    for (Player& player : players_) {
      const agent::Trace& trace = traces[static_cast<std::size_t>(player.robot)];
      if (!trace.visited.empty()) take(player, trace, now);
      const bool plays =
          state.robots[player.robot].mind.leaf != agent::kNoLeaf && state.schedule.turn[player.robot] != kNever;
      if (!plays) go(player, kOutside, now);
    }
    for (const referee::Event& event : events)
      if (event.kind == referee::Event::Kind::goal) credit(event.side == side_ ? 1 : -1, now);
  }

  /// Ends the game.
  Coverage end(Tick now) {
    for (Player& player : players_) go(player, kOutside, now);
    for (std::size_t part = 0; part < seen_.parts.size(); ++part) {
      Visits& visits = seen_.parts[part];
      const std::int64_t g = gains_[part], n = decisions_[part];
      visits.decisions = n;
      visits.gain = g;
      visits.gain_squares = g * g;
      visits.gain_decisions = g * n;
      visits.decision_squares = n * n;
    }
    return std::move(seen_);
  }

 private:
  struct Player {
    int robot;
    std::uint16_t leaf = kOutside;
    std::vector<Tick> begun, ended;  // of the newest stay in each part
  };
  struct Made {
    Tick tick;
    std::uint16_t leaf;
  };

  void take(Player& player, const agent::Trace& trace, Tick now) {
    for (std::size_t i = 0; i + 1 < trace.visited.size(); ++i) {
      const agent::Trace::Node& visited = trace.visited[i];
      Asked& asked = seen_.comparisons[numbers_.of(visited)];
      ++(visited.result ? asked.yes : asked.no);
      if (std::isnan(visited.value) || std::isnan(visited.threshold)) ++asked.unknown;
    }
    const std::uint16_t leaf = numbers_.of(trace.visited.back());
    go(player, leaf, now);
    for (const std::size_t part : parts_.around(leaf)) ++decisions_[part];
    forget(now);
    made_.push_back({now, leaf});
  }

  void forget(Tick now) {
    while (!made_.empty() && now - made_.front().tick >= ticks(kOutlook)) made_.pop_front();
  }

  /// Ends the stays in the parts that the robot leaves, and begins those in the parts that it enters.
  void go(Player& player, std::uint16_t leaf, Tick now) {
    if (leaf == player.leaf) return;
    static const std::vector<std::size_t> none;
    const std::vector<std::size_t>& from = player.leaf == kOutside ? none : parts_.around(player.leaf);
    const std::vector<std::size_t>& to = leaf == kOutside ? none : parts_.around(leaf);
    const auto common = std::mismatch(from.begin(), from.end(), to.begin(), to.end());
    for (auto part = common.first; part != from.end(); ++part) {
      player.ended[*part] = now;
      seen_.parts[*part].ticks += now - player.begun[*part];
    }
    for (auto part = common.second; part != to.end(); ++part) {
      const Tick ended = player.ended[*part];
      player.begun[*part] = now;
      ++seen_.parts[*part].stays;
      if (ended != kNever && now - ended < ticks(kInterrupted)) ++seen_.parts[*part].interrupted;
    }
    player.leaf = leaf;
  }

  /// A goal counts for all decisions of the last seconds.
  void credit(int gain, Tick now) {
    forget(now);
    for (const Made& made : made_)
      for (const std::size_t part : parts_.around(made.leaf)) gains_[part] += gain;
  }

  Side side_;
  const Parts& parts_;
  Numbers numbers_;
  std::vector<Player> players_;
  std::deque<Made> made_;                        // decisions, until they are older than the outlook
  std::vector<std::int64_t> gains_, decisions_;  // of this game, by part
  Coverage seen_;
};

}  // namespace

Parts::Parts(const agent::Tree& tree) : tree_(tree), around_(tree.leaves.size()) {
  std::unordered_map<std::string, std::size_t> numbers;
  std::vector<std::vector<std::size_t>> places;  // of each part: the numbers of the parts around it, itself last
  std::vector<bool> seen_nodes(tree.nodes.size());
  for_each_leaf(tree, tree.root, seen_nodes, [&](std::uint16_t leaf) {
    if (!around_[leaf].empty()) return;
    const std::string& path = tree.leaf_words[leaf].path;
    std::size_t begin = 0;
    for (const std::size_t end : ends_of_names(path)) {
      const auto [found, is_new] = numbers.try_emplace(path.substr(0, end), all_.size());
      around_[leaf].push_back(found->second);
      if (is_new) {
        all_.push_back({.path = found->first, .name = path.substr(begin, end - begin), .depth = 0, .skill = {}});
        places.push_back(around_[leaf]);
      }
      begin = end + 1;
    }
    all_[around_[leaf].back()].skill = agent::info_of(tree.leaves[leaf].skill).name;
  });

  // a part with only one part in it is that part, with the outer name
  std::vector<std::set<std::size_t>> inside(all_.size());
  for (const std::vector<std::size_t>& around : around_)
    for (std::size_t i = 1; i < around.size(); ++i) inside[around[i - 1]].insert(around[i]);
  for (std::size_t outer = all_.size(); outer-- > 0;) {
    if (inside[outer].size() != 1) continue;
    const std::size_t inner = *inside[outer].begin();
    inside[outer] = inside[inner];
    all_[outer].path = all_[inner].path, all_[outer].skill = all_[inner].skill;
    for (std::vector<std::size_t>& around : around_) std::erase(around, inner);
    for (std::vector<std::size_t>& place : places) std::erase(place, inner);
    places[inner].clear();
  }

  // the tree may return to a part that it has left: all that lies in a part comes together
  std::vector<std::size_t> order, number(all_.size());
  for (std::size_t i = 0; i < all_.size(); ++i)
    if (!places[i].empty()) order.push_back(i);
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return places[a] < places[b]; });
  std::vector<Part> sorted;
  for (const std::size_t old : order) {
    number[old] = sorted.size();
    sorted.push_back(std::move(all_[old]));
    sorted.back().depth = static_cast<int>(places[old].size()) - 1;
  }
  all_ = std::move(sorted);
  for (std::vector<std::size_t>& around : around_)
    for (std::size_t& part : around) part = number[part];
}

void Visits::add(const Visits& other) {
  decisions += other.decisions;
  ticks += other.ticks;
  stays += other.stays;
  interrupted += other.interrupted;
  gain += other.gain;
  gain_squares += other.gain_squares;
  gain_decisions += other.gain_decisions;
  decision_squares += other.decision_squares;
}

void Coverage::add(const Coverage& other) {
  games += other.games;
  parts.resize(other.parts.size());
  comparisons.resize(other.comparisons.size());
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i].add(other.parts[i]);
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    comparisons[i].yes += other.comparisons[i].yes;
    comparisons[i].no += other.comparisons[i].no;
    comparisons[i].unknown += other.comparisons[i].unknown;
  }
}

MeanGain gain_of(const Visits& visits, std::int64_t games) {
  if (visits.decisions == 0) return {.mean = 0, .half_width = std::numeric_limits<double>::infinity()};
  const double n = static_cast<double>(visits.decisions), mean = static_cast<double>(visits.gain) / n;
  if (games < kFewGames) return {.mean = mean, .half_width = std::numeric_limits<double>::infinity()};
  const double squares = static_cast<double>(visits.gain_squares) -
                         2 * mean * static_cast<double>(visits.gain_decisions) +
                         mean * mean * static_cast<double>(visits.decision_squares);
  const double g = static_cast<double>(games), error = std::sqrt(std::max(0., squares) * g / (g - 1)) / n;
  return {.mean = mean, .half_width = foresight::student(0.975, g - 1) * error};
}

Coverage watch_game(const Params& params, State& state, Side side, const Parts& parts, Tick most) {
  Watch watch(params, side, parts);
  std::array<agent::Trace, kMaxRobots> traces;
  referee::Events events;
  const Tick begun = state.world.tick;
  while (!finished(state) && state.world.tick - begun < most) {
    for (agent::Trace& trace : traces) trace.clear();
    const Tick now = state.world.tick;
    step(params, state, events, kEverybody, traces.data());
    watch.look(now, state, traces, events);
  }
  return watch.end(state.world.tick);
}

}  // namespace sim::debug
