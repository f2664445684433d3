#include "sim/agent/columns.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace sim::agent {
namespace {

using Form = Column::Form;

/// Returns the value [in the feature's unit] that becomes a half, or 0 for a feature with a linear column.
float scale_of(const FeatureInfo& info) {
  const std::string_view unit = info.unit;
  if (unit == "m" || unit == "m/s" || unit == "goals") return 1;
  if (unit == "s" || unit == "decisions") return 5;
  return 0;
}

Column linear(Feature feature, const FeatureInfo& info) {
  // a range with two signs keeps its 0
  const bool signs = info.least < 0;
  return {.feature = feature,
          .form = Form::linear,
          .offset = signs ? 0 : info.least,
          .factor = 1 / (signs ? info.most : info.most - info.least)};
}

/// Returns the number without zeros at its end.
std::string number_text(float value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

Columns::Columns(std::span<const Feature> features) {
  for (const Feature feature : features) {
    const FeatureInfo& info = info_of(feature);
    features_.push_back(&info);
    if (info.kind == FeatureInfo::Kind::name) {
      for (int word = 0; info.names[word]; ++word)
        add({.feature = feature, .form = Form::word, .word = static_cast<float>(word)});
    } else if (const float scale = scale_of(info); scale > 0) {
      add({.feature = feature, .form = Form::squashed, .scale = scale});
    } else {
      add(linear(feature, info));
    }
    if (info.at_times_unknown) add({.feature = feature, .form = Form::known});
  }
}

void Columns::add(const Column& column) {
  const int number = count(), lane = number % kLanes;
  list_.push_back(column);
  feature_of_.push_back(static_cast<std::uint16_t>(features_.size() - 1));
  if (lane == 0) blocks_.push_back({});
  Block& block = blocks_.back();
  block.offset[lane] = column.offset, block.factor[lane] = column.factor;
  block.base[lane] = column.scale, block.slope[lane] = column.form == Form::squashed ? 1.f : 0.f;
  if (column.form == Form::word) words_.push_back(number);
  if (column.form == Form::known) known_.push_back(number);
}

std::vector<Feature> built_in_features() {
  std::vector<Feature> all;
  for (int i = 0; i < built_in_feature_count(); ++i) all.push_back(static_cast<Feature>(i));
  return all;
}

std::string name_of(const Column& column) {
  const FeatureInfo& info = info_of(column.feature);
  std::string name = info.name;
  if (column.form == Form::word) name.append("=").append(info.names[static_cast<int>(column.word)]);
  if (column.form == Form::known) name.append(" known");
  return name;
}

std::string formula_of(const Column& column) {
  const FeatureInfo& info = info_of(column.feature);
  switch (column.form) {
    case Form::linear:
      return "(value - " + number_text(column.offset) + ") / " + number_text(1 / column.factor) +
             (info.unit[0] ? " " : "") + info.unit;
    case Form::squashed: return "value / (" + number_text(column.scale) + " " + info.unit + " + |value|)";
    case Form::word: return std::string("1 for ") + info.names[static_cast<int>(column.word)] + ", otherwise 0";
    case Form::known: return "1 while the value is known, otherwise 0";
  }
  return {};
}

void Columns::observe(const View& view, float* row) const {
  float known[kMaxFeatures], values[kMaxColumns + kLanes], results[kMaxColumns + kLanes];
  for (std::size_t i = 0; i < features_.size(); ++i) {
    const FeatureInfo& info = *features_[i];
    known[i] = info.needs_ball && !view.ball_known ? kUnknown : info.compute(view);
  }
  const std::size_t all = list_.size();
  for (std::size_t i = 0; i < all; ++i) values[i] = known[feature_of_[i]];
  std::fill_n(values + all, kLanes, 0.f);

  for (std::size_t block = 0; block < blocks_.size(); ++block) {
    const auto& [offset, factor, base, slope] = blocks_[block];
    const float* const value = values + kLanes * block;
    float* const result = results + kLanes * block;
    SIM_FOR_LANES(i) {
      const float x = (value[i] - offset[i]) * factor[i];
      const float ratio = x / (base[i] + slope[i] * std::abs(x));
      const float number = ratio == ratio ? ratio : 0.f;  // NaN is not equal to itself
      const float low = number < -1.f ? -1.f : number;
      result[i] = low > 1.f ? 1.f : low;
    }
  }
  std::copy_n(results, all, row);
  for (const int i : words_) row[i] = values[i] == list_[static_cast<std::size_t>(i)].word ? 1.f : 0.f;
  for (const int i : known_) row[i] = values[i] == values[i] ? 1.f : 0.f;
}

}  // namespace sim::agent
