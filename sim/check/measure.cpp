#include "sim/check/measure.h"

#include <algorithm>
#include <cmath>

namespace sim::check {

using robot::Error;
using robot::Result;
namespace {

Result<Metric> fact_metric(Metric::Kind kind, Words& words) {
  const Result<Fact> fact = take_fact(words);
  if (!fact) return fact.failure();
  if (kind == Metric::Kind::count_of && fact->happening < 0)
    return Error{"'count of' takes a happening, got a comparison"};
  return Metric{.kind = kind, .condition = {}, .fact = *fact};
}

Result<Metric> quantity_metric(Metric::Kind kind, Words& words) {
  const Result<int> quantity = take_quantity(words);
  if (!quantity) return quantity.failure();
  return Metric{.kind = kind, .condition = {}, .fact = {}, .quantity = *quantity};
}

Result<Metric> share_metric(Words& words) {
  Result<Condition> condition = take_condition(words);
  if (!condition) return condition.failure();
  return Metric{.kind = Metric::Kind::share, .condition = std::move(*condition), .fact = {}};
}

Result<Metric> take_metric(Words& words) {
  if (words.take_pair("time of")) return fact_metric(Metric::Kind::time_of, words);
  if (words.take_pair("count of")) return fact_metric(Metric::Kind::count_of, words);
  if (words.take("least")) return quantity_metric(Metric::Kind::least, words);
  if (words.take("most")) return quantity_metric(Metric::Kind::most, words);
  if (words.take("final")) return quantity_metric(Metric::Kind::final_value, words);
  return share_metric(words);
}

}  // namespace

Result<Metric> parse_metric(std::string_view text) {
  if (text.size() > kMaxConditionBytes)
    return Error{"must have at most " + std::to_string(kMaxConditionBytes) + " bytes, got " +
                 std::to_string(text.size())};
  Words words(text);
  Result<Metric> metric = take_metric(words);
  if (metric && !words.at_end()) return Error{"expected the end of the metric, got '" + words.rest() + "'"};
  return metric;
}

void Measure::see(const Glance& glance) {
  if (metric_.kind == Metric::Kind::share) return watch_.see(glance);
  if (metric_.quantity < 0) {
    if (!holds(metric_.fact, glance)) return;
    ++count_;
    if (metric_.kind == Metric::Kind::time_of && !value_) value_ = static_cast<double>(glance.time());
    return;
  }
  const double now = static_cast<double>(quantity(metric_.quantity).compute(glance));
  if (std::isnan(now)) return;
  if (!value_ || metric_.kind == Metric::Kind::final_value) value_ = now;
  value_ = metric_.kind == Metric::Kind::least  ? std::min(*value_, now)
           : metric_.kind == Metric::Kind::most ? std::max(*value_, now)
                                                : *value_;
}

std::optional<double> Measure::value() const {
  if (metric_.kind == Metric::Kind::share) return watch_.holds() ? 1 : 0;
  if (metric_.kind == Metric::Kind::count_of) return count_;
  return value_;
}

}  // namespace sim::check
