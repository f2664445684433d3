#include "robot/lab/import/label_rows.h"

#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "robot/core/text.h"

namespace robot::lab::labels {
namespace {

constexpr std::string_view kHeader = "filename,label,x_min,y_min,x_max,y_max,color,number";
constexpr std::size_t kMostRows = 1'000'000;
constexpr std::int64_t kLastMs = 1'000'000'000;  // 11 days
constexpr double kFarthest = 10'000;             // [px]

std::optional<std::int64_t> whole(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<double> pixels(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(std::abs(value) <= kFarthest)) return std::nullopt;
  return value;
}

/// Returns the time in a name such as "064731.jpg" or "half1_064731.jpg".
std::optional<std::int64_t> time_of(std::string_view name) {
  name = name.substr(0, name.find('.'));
  if (const std::size_t before = name.rfind('_'); before != name.npos) name.remove_prefix(before + 1);
  const auto time = whole(name);
  return time && *time >= 0 && *time <= kLastMs ? time : std::nullopt;
}

std::optional<std::array<std::string_view, 8>> cells_of(std::string_view line) {
  std::array<std::string_view, 8> cells;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::size_t end = line.find(',');
    if ((end == line.npos) != (i + 1 == cells.size())) return std::nullopt;
    cells[i] = line.substr(0, end);
    line.remove_prefix(end == line.npos ? line.size() : end + 1);
  }
  return cells;
}

std::optional<Box> box_of(const std::array<std::string_view, 8>& cells) {
  const auto left = pixels(cells[2]), top = pixels(cells[3]), right = pixels(cells[4]), bottom = pixels(cells[5]);
  if (!left || !top || !right || !bottom || *right < *left || *bottom < *top) return std::nullopt;
  return Box{.left = *left, .top = *top, .right = *right, .bottom = *bottom};
}

int small_number(std::string_view text) {
  const auto value = whole(text);
  return value && *value >= 0 && *value <= 20 ? static_cast<int>(*value) : -1;
}

/// Adds the box of a row. Returns false for a wrong row.
bool add_row(std::string_view line, std::map<std::int64_t, Frame>& frames) {
  const auto cells = cells_of(line);
  if (!cells) return false;
  const auto time = time_of((*cells)[0]);
  const auto box = box_of(*cells);
  if (!time || !box) return false;
  Frame& frame = frames[*time];
  frame.time_ms = *time;
  if ((*cells)[1] == "1")
    frame.balls.push_back(*box);
  else if ((*cells)[1] == "0")
    frame.robots.push_back({.box = *box, .colour = small_number((*cells)[6]), .number = small_number((*cells)[7])});
  return true;
}

}  // namespace

bool is_label_file(std::string_view text) { return text.starts_with(kHeader); }

Result<Rows> read_rows(std::string_view text) {
  const std::string_view header = take_line(text);
  if (header != kHeader)
    return Error{"expected the header '" + std::string(kHeader) + "', got '" + std::string(header.substr(0, 80)) + "'"};
  Rows rows;
  std::map<std::int64_t, Frame> frames;
  for (std::size_t number = 2; !text.empty() && rows.damage.empty(); ++number) {
    if (number > kMostRows) return Error{"expected at most 1000000 rows"};
    const std::string_view line = take_line(text);
    if (!line.empty() && !add_row(line, frames))
      rows.damage = "line " + std::to_string(number) + ": expected a time, a label and a box in pixels, got '" +
                    std::string(line.substr(0, 80)) + "'";
  }
  for (auto& [time, frame] : frames) rows.frames.push_back(std::move(frame));
  return rows;
}

}  // namespace robot::lab::labels
