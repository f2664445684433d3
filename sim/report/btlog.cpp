#include "sim/report/btlog.h"

#include <algorithm>

#include "robot/core/little_endian.h"
#include "robot/core/text.h"
#include "sim/report/page.h"

namespace sim::report {
namespace {

using agent::kLeafBit;

/// Returns the number of elements of a tree whose shared parts are written several times; at least `most` + 1 if there
/// are more than `most`.
std::size_t elements_of(const agent::Tree& tree, std::size_t most) {
  if (tree.root & kLeafBit) return 1;
  std::vector<std::size_t> sizes;  // by node; a target has a lower number than its comparison
  const auto size_of = [&](std::uint16_t at) { return at & kLeafBit ? std::size_t{1} : sizes[at]; };
  for (const agent::Node& node : tree.nodes)
    sizes.push_back(std::min(most + 1, 2 + size_of(node.yes) + size_of(node.no)));
  return sizes[tree.root];
}

}  // namespace

robot::Result<BtLog> BtLog::of(const agent::Tree& tree) {
  if (elements_of(tree, kMostElements) > kMostElements)
    return robot::Error{"a log of Groot2 holds trees of at most " + std::to_string(kMostElements) + " elements, and '" +
                        tree.name + "' has more when its shared parts are written for each place"};
  return BtLog(tree);
}

BtLog::BtLog(const agent::Tree& tree) {
  const std::string name = escaped(tree.name);
  std::string xml = "<root BTCPP_format=\"4\" main_tree_to_execute=\"" + name + "\">\n  <BehaviorTree ID=\"" + name +
                    "\" _fullpath=\"\">\n";
  root_ = write(tree, tree.root, 2, xml);
  xml += "  </BehaviorTree>\n</root>\n";
  bytes_ = "BTCPP4-FileLogger2";
  robot::put(bytes_, std::uint8_t{1});
  robot::put_text(bytes_, xml);
  robot::put(bytes_, std::uint64_t{0});
}

std::size_t BtLog::write(const agent::Tree& tree, std::uint16_t at, int depth, std::string& xml) {
  const std::string indent(2 * static_cast<std::size_t>(depth), ' ');
  const auto attributes = [&](const std::string& text, const std::string& path) {
    const std::string uid = std::to_string(++uids_);
    return " name=\"" + escaped(text) + "\" _uid=\"" + uid + "\" _fullpath=\"" + escaped(path) + "/" + uid + "\"";
  };
  Element element{.uid = static_cast<std::uint16_t>(uids_ + 1), .node = at};
  if (at & kLeafBit) {
    const auto leaf = static_cast<std::size_t>(at & ~kLeafBit);
    const agent::Words& words = tree.leaf_words[leaf];
    const agent::SkillInfo& skill = agent::info_of(tree.leaves[leaf].skill);
    xml += indent + "<Action ID=\"" + escaped(skill.name) + "\"" + attributes(words.name, words.path);
    for (int i = 0; i < skill.count; ++i)
      if (const float value = tree.leaves[leaf].arguments[i]; agent::is_given(value))
        xml += robot::formatted(" %s=\"%.9g\"", skill.parameters[i].name, static_cast<double>(value));
    xml += "/>\n";
  } else {
    const agent::Words& words = tree.node_words[at];
    xml += indent + "<IfThenElse" + attributes(words.name, words.path) + ">\n";
    xml += indent + "  <Condition ID=\"Compare\"" + attributes(words.condition, words.path) + "/>\n";
    element.yes = write(tree, tree.nodes[at].yes, depth + 1, xml);
    element.no = write(tree, tree.nodes[at].no, depth + 1, xml);
    xml += indent + "</IfThenElse>\n";
  }
  elements_.push_back(element);
  return elements_.size() - 1;
}

void BtLog::decided(Tick tick, const debug::Evaluation& evaluation) {
  std::vector<State> states;
  std::size_t at = root_;
  while (!(elements_[at].node & kLeafBit)) {
    const Element& element = elements_[at];
    const bool result = evaluation.nodes[element.node].result;
    states.push_back({element.uid, Status::running});
    states.push_back({static_cast<std::uint16_t>(element.uid + 1), result ? Status::success : Status::failure});
    at = result ? element.yes : element.no;
  }
  states.push_back({elements_[at].uid, Status::running});
  become(tick, std::move(states));
}

void BtLog::become(Tick tick, std::vector<State> states) {
  const auto has = [](const std::vector<State>& all, std::uint16_t uid) {
    return std::ranges::find(all, uid, &State::uid) != all.end();
  };
  for (const State& old : now_)
    if (!has(states, old.uid)) append(tick, {old.uid, Status::idle});
  for (const State& state : states)
    if (std::ranges::find(now_, state) == now_.end()) append(tick, state);
  now_ = std::move(states);
}

void BtLog::append(Tick tick, const State& state) {
  robot::put(bytes_, std::uint64_t{tick} * 1'000'000 / 30, 6);
  robot::put(bytes_, state.uid);
  robot::put(bytes_, static_cast<std::uint8_t>(state.status));
}

}  // namespace sim::report
