#include "sim/check/condition.h"

#include <algorithm>

#include "robot/core/json_library.h"
#include "sim/io/json.h"
#include "sim/io/values.h"
#include "sim/io/words.h"

namespace sim::check {

using agent::Comparison;
using robot::Error;
using robot::Result;

namespace {

/// Reads the next word, and the unit behind it, as a value.
Result<float> take_value(Words& words, const io::Expected& expected) {
  std::string text(words.take());
  const std::string_view unit = words.peek();
  if ((!unit.empty() && unit == expected.unit) || unit == "cm" || unit == "min") text.append(" ").append(words.take());
  return io::Values().read(std::string_view(text), expected);
}

Error unknown_fact(const Words& words) {
  std::vector<std::string_view> known;
  for (int i = 0; i < happening_count(); ++i) known.emplace_back(happening(i).name);
  for (int i = 0; i < quantity_count(); ++i) known.emplace_back(quantity(i).name);
  // a happening has two words
  Words ahead = words;
  const std::string first(ahead.take());
  const std::string both = first + " " + std::string(ahead.take());
  std::string similar = io::did_you_mean(both, known);
  if (similar.empty()) similar = io::did_you_mean(first, known);
  std::string all;
  for (const std::string_view name : known) all.append(all.empty() ? "" : ", ").append(name);
  return {"expected a happening or a quantity, got " + io::quoted(words.rest()) +
          (similar.empty() ? "; there are: " + all : similar)};
}

Result<Step> take_step(Words& words) {
  Result<Fact> fact = take_fact(words);
  if (!fact) return fact.failure();
  Step step{.fact = *fact};
  if (words.take("within")) {
    const Result<float> seconds = take_value(words, {"s", 0, 3600, nullptr});
    if (!seconds) return Error{"the time behind 'within' " + seconds.error()};
    step.within = ticks(*seconds);
  }
  return step;
}

Result<Clause> take_clause(Words& words) {
  Clause clause;
  clause.negated = words.take("not");
  clause.always = words.take("always");
  if (!clause.always && words.take("never")) clause.negated = !clause.negated;
  const bool is_fact = clause.always;
  if (!is_fact) words.take("eventually");
  do {
    const Result<Step> step = take_step(words);
    if (!step) return step.failure();
    clause.steps.push_back(*step);
  } while (words.take("then"));
  if (is_fact && (clause.steps.size() > 1 || clause.steps[0].within != kNever))
    return Error{"'always' takes one fact, without 'then' and 'within'"};
  return clause;
}

}  // namespace

bool holds(const Fact& fact, const Glance& glance) {
  if (fact.happening >= 0) return happening(fact.happening).holds(glance);
  return agent::holds(fact.comparison, quantity(fact.quantity).compute(glance), fact.threshold);
}

Result<int> take_quantity(Words& words) {
  for (int i = 0; i < quantity_count(); ++i)
    if (words.take(quantity(i).name)) return i;
  return unknown_fact(words);
}

Result<Fact> take_fact(Words& words) {
  constexpr struct {
    std::string_view text;
    Comparison comparison;
  } kOperators[] = {
      {"<", Comparison::less}, {"<=", Comparison::at_most}, {">", Comparison::greater}, {">=", Comparison::at_least}};
  for (int i = 0; i < happening_count(); ++i)
    if (words.take_pair(happening(i).name)) return Fact{.happening = i};
  const Result<int> number = take_quantity(words);
  if (!number) return number.failure();
  const Quantity& compared = quantity(*number);
  for (const auto& [text, comparison] : kOperators) {
    if (!words.take(text)) continue;
    const Result<float> threshold = take_value(words, {compared.unit, compared.least, compared.most, nullptr});
    if (!threshold) return Error{"the value for " + std::string(compared.name) + " " + threshold.error()};
    return Fact{.quantity = *number, .comparison = comparison, .threshold = *threshold};
  }
  return Error{std::string(compared.name) + " is compared by < <= > >=, got " + io::quoted(words.rest())};
}

Result<Condition> take_condition(Words& words) {
  Condition condition;
  do {
    std::vector<Clause>& clauses = condition.alternatives.emplace_back();
    do {
      Result<Clause> clause = take_clause(words);
      if (!clause) return clause.failure();
      clauses.push_back(std::move(*clause));
    } while (words.take("and"));
  } while (words.take("or"));
  if (!words.at_end()) return Error{"expected 'and', 'or', 'then' or 'within', got " + io::quoted(words.rest())};
  return condition;
}

Result<Condition> parse_condition(std::string_view text) {
  if (text.size() > kMaxConditionBytes)
    return Error{"must have at most " + std::to_string(kMaxConditionBytes) + " bytes, got " +
                 std::to_string(text.size())};
  Words words(text);
  return take_condition(words);
}

Watch::Watch(const Condition& condition) {
  for (const std::vector<Clause>& clauses : condition.alternatives) {
    std::vector<Progress>& all = alternatives_.emplace_back();
    for (const Clause& clause : clauses) {
      all.push_back({.clause = &clause, .complete = std::vector<Tick>(clause.steps.size() + 1, kNever)});
      all.back().complete[0] = 0;
    }
  }
}

void Watch::see(const Glance& glance) {
  const Tick now = glance.now->world.tick - glance.start->world.tick;
  for (std::vector<Progress>& all : alternatives_)
    for (Progress& progress : all) {
      const std::vector<Step>& steps = progress.clause->steps;
      if (progress.clause->always) {
        if (!check::holds(steps[0].fact, glance)) progress.broken = true;
        continue;
      }
      // from the last step to the first, so that one tick completes one step
      for (std::size_t i = steps.size(); i-- > 0;) {
        const Tick before = progress.complete[i];
        if (before == kNever || now - before > steps[i].within) continue;
        if (check::holds(steps[i].fact, glance)) progress.complete[i + 1] = now;
      }
    }
}

bool Watch::holds(const Progress& progress) {
  const bool is_so = progress.clause->always ? !progress.broken : progress.complete.back() != kNever;
  return is_so != progress.clause->negated;
}

bool Watch::holds() const {
  return std::ranges::any_of(alternatives_, [](const std::vector<Progress>& all) {
    return std::ranges::all_of(all, [](const Progress& progress) { return holds(progress); });
  });
}

}  // namespace sim::check
