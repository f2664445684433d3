#include "robot/fit/figure.h"

#include "robot/core/text.h"

namespace robot::fit {
namespace {

std::string quoted(const std::string& text) {
  std::string all = "\"";
  for (const char c : text) {
    if (c == '"') all += '"';
    all += c;
  }
  return all + '"';
}

}  // namespace

std::string to_text(const Figure& figure) {
  return formatted("%.4g%s%s (95 %%: %.4g .. %.4g), %zu %s of %zu recording%s, %s %.2f .. %.2f %s", figure.value,
                   figure.unit.empty() ? "" : " ", figure.unit.c_str(), figure.low, figure.high, figure.events,
                   figure.kind.c_str(), figure.recordings.size(), figure.recordings.size() == 1 ? "" : "s",
                   figure.domain.quantity.c_str(), figure.domain.from, figure.domain.to, figure.domain.unit.c_str());
}

std::string to_csv(const Table& table) {
  std::string text = "recording";
  for (const std::string& column : table.columns) text += ',' + quoted(column);
  text += "\r\n";
  for (const Table::Row& row : table.rows) {
    text += quoted(table.names[row.recording]);
    for (const double value : row.values) text += formatted(",%.9g", value);
    text += "\r\n";
  }
  return text;
}

}  // namespace robot::fit
