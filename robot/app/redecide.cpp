#include "robot/app/redecide.h"

#include <algorithm>
#include <charconv>

#include "robot/agent/agent.h"
#include "robot/app/recorded_beliefs.h"
#include "robot/app/recorded_moment.h"
#include "robot/core/csv.h"
#include "robot/core/text.h"
#include "robot/logging/sessions/read_all.h"
#include "sim/io/vocabulary.h"

namespace robot::app {
namespace {

namespace pb = foresight;

constexpr double kHalfFrame = 1. / 60;  // [s] a printed time is rounded

const std::string& leaf_of(const pb::DecisionTrace& trace) {
  static const std::string none;
  return trace.visited_size() > 0 ? trace.visited(trace.visited_size() - 1).path() : none;
}

/// Returns the skill, with those arguments that `other` has not: "kick (tolerance 0.52)".
std::string deed_of(const pb::DecisionTrace& trace, const pb::DecisionTrace& other) {
  std::string text;
  for (const auto& argument : trace.arguments()) {
    const bool is_common = std::ranges::any_of(other.arguments(), [&](const auto& one) {
      return one.name() == argument.name() && one.value() == argument.value();
    });
    if (is_common) continue;
    text += (text.empty() ? "" : ", ") + argument.name() + formatted(" %.3g", static_cast<double>(argument.value()));
  }
  return trace.skill() + (text.empty() ? "" : " (" + text + ")");
}

std::string value_of(const pb::DecisionTrace::Node& node) {
  return node.has_value() ? formatted("%.3g", static_cast<double>(node.value())) : "unknown";
}

const char* yes_or_no(bool result) { return result ? "yes" : "no"; }

/// Reads "12.5" at the front of `text`, and the blanks behind it.
std::optional<double> take_seconds(std::string_view& text) {
  double seconds = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
  if (error != std::errc{} || !(seconds >= 0 && seconds <= 1e6)) return {};
  text = trimmed(text.substr(static_cast<std::size_t>(end - text.data())));
  return seconds;
}

bool take(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text = trimmed(text.substr(word.size()));
  return true;
}

Result<Expectation> parse_expectation(std::string_view line) {
  const Error wrong{"expected 'at 12.5 s: SKILL or SKILL' or '12 .. 14 s: not SKILL', got '" + printable(line, 80) +
                    "'"};
  Expectation expectation{.text = std::string(line)};
  std::string_view rest = line;
  const bool is_moment = take(rest, "at ");
  const auto from = take_seconds(rest);
  if (!from) return wrong;
  expectation.from = expectation.to = *from;
  if (!is_moment) {
    if (!take(rest, "..")) return wrong;
    const auto to = take_seconds(rest);
    if (!to || *to < *from) return wrong;
    expectation.to = *to;
  }
  if (!take(rest, "s") || !take(rest, ":")) return wrong;
  expectation.negated = take(rest, "not ");
  for (const std::string_view part : split(rest, " or ")) {
    const std::string name(trimmed(part));
    if (const auto skill = sim::io::skill_named(name); !skill) return skill.failure();
    expectation.skills.push_back(name);
  }
  return expectation;
}

std::string seconds_text(double seconds) { return formatted("%.2f", seconds); }

}  // namespace

bool Redecision::differs() const {
  return recorded.skill() != now.skill() ||
         !std::ranges::equal(recorded.arguments(), now.arguments(), [](const auto& one, const auto& other) {
           return one.name() == other.name() && one.value() == other.value();
         });
}

std::int64_t Redecisions::different() const { return std::ranges::count_if(all, &Redecision::differs); }

Result<Redecisions> redecide(const logging::Session& session, const RedecideOptions& options) {
  Redecisions decisions;
  decisions.robot = options.robot;
  if (decisions.robot.empty()) {
    const auto stream = std::ranges::find_if(
        session.streams, [](const logging::StreamFile& file) { return file.topic.ends_with("/decision"); });
    if (stream == session.streams.end()) return Error{session.id() + " has no object decision"};
    decisions.robot = memory::object_name(stream->topic).robot;
  }
  const auto recorded = logging::read_in_order<pb::DecisionTrace>(session, "/" + decisions.robot + "/decision");
  if (recorded.empty()) return Error{session.id() + " has no decisions of robot " + decisions.robot};
  RecordedBeliefs beliefs(session, decisions.robot);
  if (const char* missing = beliefs.missing())
    return Error{session.id() + " has no object " + missing + " of robot " + decisions.robot +
                 ", and a decision needs it"};

  const foreseeing::GameSetting setting = recorded_setting(session, decisions.robot, options.rules);
  auto agent = agent::Agent::load(
      {.behaviour = options.strategy, .strategies = {}, .stale = 0, .rules = setting.rules, .models = options.models});
  if (!agent) return agent.failure();

  decisions.strategy = options.strategy;
  for (const auto& old : recorded) {
    if (decisions.recorded_strategy.empty()) decisions.recorded_strategy = old.value.strategy();
    agent::Agent::Decision made = agent->decide(beliefs.at(old.capture_ns));
    if (old.value.visited_size() == 0) continue;  // the tree was not asked
    const double seconds =
        old.capture_ns > session.start_ns ? static_cast<double>(old.capture_ns - session.start_ns) / 1e9 : 0;
    decisions.all.push_back({.at_ns = old.capture_ns,
                             .seconds = seconds,
                             .recorded = old.value,
                             .now = made.trace ? *std::move(made.trace) : pb::DecisionTrace(),
                             .problem = std::move(made.problem)});
  }
  if (decisions.all.empty()) return Error{"robot " + decisions.robot + " made no decision in play"};
  return decisions;
}

std::string parting(const Redecision& decision) {
  if (!decision.problem.empty()) return decision.problem;
  const auto &recorded = decision.recorded.visited(), &now = decision.now.visited();
  for (int i = 0; i < std::min(recorded.size(), now.size()); ++i) {
    const pb::DecisionTrace::Node &one = recorded[i], &other = now[i];
    if (one.condition() != other.condition())
      return "where '" + one.condition() + "' was asked, it asks '" + other.condition() + "'";
    if (one.result() == other.result()) continue;
    const std::string was = value_of(one), is = value_of(other);
    return formatted("%s: recorded %s (%s), now %s (%s)", one.condition().c_str(), yes_or_no(one.result()), was.c_str(),
                     yes_or_no(other.result()), is.c_str());
  }
  return now.empty() ? "the tree was not asked" : "another skill or other arguments at the same place of the tree";
}

std::string to_text(const Redecisions& decisions) {
  const std::int64_t different = decisions.different();
  const auto count = static_cast<std::int64_t>(decisions.all.size());
  std::string text = formatted(
      "%s: %lld decisions in play by %s; %s decides %lld of them (%.1f %%) otherwise\n", decisions.robot.c_str(),
      static_cast<long long>(count), decisions.recorded_strategy.c_str(), decisions.strategy.c_str(),
      static_cast<long long>(different), 100 * static_cast<double>(different) / static_cast<double>(count));
  const Redecision* begin = nullptr;  // of the stretch
  const Redecision* last = nullptr;
  const auto deeds = [](const Redecision& one) {
    return one.recorded.skill() == one.now.skill()
               ? deed_of(one.recorded, one.now) + " -> " + deed_of(one.now, one.recorded)
               : one.recorded.skill() + " -> " + (one.now.skill().empty() ? "nothing" : one.now.skill());
  };
  const auto tell = [&] {
    if (begin)
      text += formatted("%9.2f .. %-9.2f s  %s; %s\n", begin->seconds, last->seconds, deeds(*begin).c_str(),
                        parting(*begin).c_str());
    begin = nullptr;
  };
  for (const Redecision& decision : decisions.all) {
    if (!begin || !decision.differs() || deeds(decision) != deeds(*begin)) tell();
    if (decision.differs() && !begin) begin = &decision;
    last = &decision;
  }
  tell();
  return text;
}

std::string to_csv(const Redecisions& decisions) {
  std::string text = "time [s],recorded skill,recorded leaf,skill,leaf,where they part\n";
  for (const Redecision& decision : decisions.all)
    text += formatted("%.4f", decision.seconds) + "," + csv_cell(decision.recorded.skill()) + "," +
            csv_cell(leaf_of(decision.recorded)) + "," + csv_cell(decision.now.skill()) + "," +
            csv_cell(leaf_of(decision.now)) + "," + (decision.differs() ? csv_cell(parting(decision)) : "") + "\n";
  return text;
}

Result<std::vector<Expectation>> parse_expectations(std::string_view text) {
  std::vector<Expectation> expectations;
  int number = 0;
  for (const std::string_view part : split(text, "\n")) {
    ++number;
    const std::string_view line = trimmed(part);
    if (line.empty() || line.starts_with('#')) continue;
    auto expectation = parse_expectation(line);
    if (!expectation) return expectation.failure("line " + std::to_string(number));
    expectation->line = number;
    expectations.push_back(*std::move(expectation));
  }
  return expectations;
}

std::vector<std::string> broken(const std::vector<Expectation>& expectations, const Redecisions& decisions) {
  std::vector<std::string> sentences;
  for (const Expectation& expectation : expectations) {
    const std::string begin = "line " + std::to_string(expectation.line) + ", '" + expectation.text + "': ";
    auto first = std::ranges::lower_bound(decisions.all, expectation.from - kHalfFrame, {}, &Redecision::seconds);
    const auto end = std::ranges::upper_bound(decisions.all, expectation.to + kHalfFrame, {}, &Redecision::seconds);
    if (expectation.from == expectation.to && end != decisions.all.begin()) first = end - 1;
    if (first >= end) {
      sentences.push_back(begin + "there is no decision in play");
      continue;
    }
    const auto wrong = std::find_if(first, end, [&](const Redecision& decision) {
      const bool is_named = std::ranges::find(expectation.skills, decision.now.skill()) != expectation.skills.end();
      return is_named == expectation.negated;
    });
    if (wrong != end)
      sentences.push_back(begin + "at " + seconds_text(wrong->seconds) + " s it plays " +
                          (wrong->now.skill().empty() ? "nothing, " + wrong->problem : wrong->now.skill()));
  }
  return sentences;
}

}  // namespace robot::app
