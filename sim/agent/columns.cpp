#include "sim/agent/columns.h"

#include <cassert>
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

float value_in(const Column& column, float value) {
  switch (column.form) {
    case Form::linear: return std::isnan(value) ? 0.f : clamp((value - column.offset) * column.factor, -1, 1);
    case Form::squashed: return std::isnan(value) ? 0.f : value / (column.scale + std::abs(value));
    case Form::word: return value == column.word ? 1.f : 0.f;
    case Form::known: return std::isnan(value) ? 0.f : 1.f;
  }
  return 0;
}

/// Returns the number without zeros at its end.
std::string number_text(float value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

std::vector<Column> columns_of(std::span<const Feature> features) {
  std::vector<Column> columns;
  for (const Feature feature : features) {
    const FeatureInfo& info = info_of(feature);
    if (info.kind == FeatureInfo::Kind::name) {
      for (int word = 0; info.names[word]; ++word)
        columns.push_back({.feature = feature, .form = Form::word, .word = static_cast<float>(word)});
    } else if (const float scale = scale_of(info); scale > 0) {
      columns.push_back({.feature = feature, .form = Form::squashed, .scale = scale});
    } else {
      columns.push_back(linear(feature, info));
    }
    if (info.at_times_unknown) columns.push_back({.feature = feature, .form = Form::known});
  }
  return columns;
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

void observe(std::span<const Column> columns, const View& view, float* row) {
  for (const Column& column : columns) *row++ = value_in(column, value_of(column.feature, view));
}

}  // namespace sim::agent
