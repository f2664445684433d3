#include "sim/report/btlog.h"

#include <gtest/gtest.h>

#include <map>
#include <regex>

#include "robot/core/little_endian.h"
#include "sim/debug/decision_log.h"
#include "sim/debug/setup.h"
#include "tests/sim/support/games.h"

namespace sim::report {
namespace {

/// A log, read as the description in btlog.h says.
struct ReadLog {
  std::string xml;
  struct Change {
    std::uint64_t us;
    std::uint16_t uid;
    int status;
  };
  std::vector<Change> changes;
};

ReadLog read(const std::string& bytes) {
  ReadLog log;
  robot::ByteReader reader(bytes);
  EXPECT_EQ(reader.take(18), "BTCPP4-FileLogger2");
  EXPECT_EQ(reader.number<std::uint8_t>(), 1);
  log.xml = reader.text();
  EXPECT_EQ(reader.number<std::uint64_t>(), 0u);
  while (reader.ok() && !reader.rest().empty()) {
    const std::uint64_t us = reader.number(6);
    const auto uid = reader.number<std::uint16_t>();
    log.changes.push_back({us, uid, reader.number<std::uint8_t>()});
  }
  EXPECT_TRUE(reader.finished());
  return log;
}

/// Returns the elements of the XML by number: what they are and what they say.
std::map<int, std::pair<std::string, std::string>> elements_of(const std::string& xml) {
  static const std::regex element("<(IfThenElse|Condition|Action)[^>]* name=\"([^\"]*)\" _uid=\"(\\d+)\"");
  std::map<int, std::pair<std::string, std::string>> all;
  for (std::sregex_iterator found(xml.begin(), xml.end(), element), end; found != end; ++found)
    EXPECT_TRUE(all.emplace(std::stoi((*found)[3]), std::pair((*found)[1].str(), (*found)[2].str())).second);
  return all;
}

TEST(BtLog, TheChangesGiveThePathOfEveryDecisionBack) {
  const debug::SharedSetup setup = debug::prepare({}).value();
  const agent::TreeBehaviour& behaviour = *debug::tree_of(setup->params, 1);
  BtLog log = BtLog::of(behaviour.tree()).value();
  struct Made {
    Tick tick;
    std::vector<std::string> conditions;  // on the path, with their answers
    std::string skill;
  };
  std::vector<Made> made;
  debug::for_each_decision(setup->params, test::begun(setup->params, 3), 1, behaviour, ticks(120),
                           [&](const debug::LoggedDecision& logged, const State&) {
                             Made one{.tick = logged.decision.tick, .conditions = {}, .skill = ""};
                             if (logged.evaluation) {
                               log.decided(logged.decision.tick, *logged.evaluation);
                               for (const std::uint16_t node : logged.evaluation->path)
                                 one.conditions.push_back(behaviour.tree().node_words[node].condition +
                                                          (logged.evaluation->nodes[node].result ? " yes" : " no"));
                               one.skill = behaviour.tree().leaf_words[logged.evaluation->leaf].name;
                             } else {
                               log.rests(logged.decision.tick);
                             }
                             made.push_back(std::move(one));
                           });
  ASSERT_GT(made.size(), 500u);

  const ReadLog seen = read(log.bytes());
  const auto elements = elements_of(seen.xml);
  std::map<int, int> statuses;  // of all elements that are not idle
  std::size_t next = 0;
  for (const Made& one : made) {
    for (; next < seen.changes.size() && seen.changes[next].us == one.tick * std::uint64_t{1'000'000} / 30; ++next) {
      const ReadLog::Change& change = seen.changes[next];
      ASSERT_TRUE(elements.contains(change.uid));
      EXPECT_NE(statuses[change.uid], change.status) << "only changes are written";
      statuses[change.uid] = change.status;
    }
    std::vector<std::string> conditions;
    std::string skill;
    for (const auto& [uid, status] : statuses) {  // numbers grow along a path
      const auto& [kind, name] = elements.at(uid);
      if (status == 0) continue;
      if (kind == "Action") skill += name;
      if (kind == "Condition") {
        static const std::regex less("&lt;"), greater("&gt;");
        const std::string plain = std::regex_replace(std::regex_replace(name, less, "<"), greater, ">");
        conditions.push_back(plain + (status == 2 ? " yes" : " no"));
      }
    }
    EXPECT_EQ(conditions, one.conditions);
    EXPECT_EQ(skill, one.skill);
  }
  EXPECT_EQ(next, seen.changes.size()) << "no change belongs to no decision";
}

TEST(BtLog, RefusesATreeWithMoreElementsThanNumbers) {
  agent::Tree tree{.name = "wide",
                   .about = "",
                   .settings = {},
                   .nodes = {},
                   .leaves = {{}},
                   .node_words = {},
                   .leaf_words = {{"wide/stand", "stand", ""}},
                   .root = agent::kLeafBit};
  EXPECT_TRUE(BtLog::of(tree));
  // each comparison goes on at the one before with both answers: twice as many elements
  for (std::uint16_t i = 0; i < 40; ++i) {
    const std::uint16_t before = i == 0 ? agent::kLeafBit : static_cast<std::uint16_t>(i - 1);
    tree.nodes.push_back({.feature = agent::find_feature("ball_known"),
                          .comparison = agent::Comparison::equal,
                          .yes = before,
                          .no = before,
                          .threshold = 1});
    tree.node_words.push_back({"wide", "wide", "ball_known"});
    tree.root = i;
  }
  const auto refused = BtLog::of(tree);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().find("at most 65535 elements, and 'wide' has more"), std::string::npos) << refused.error();
}

}  // namespace
}  // namespace sim::report
