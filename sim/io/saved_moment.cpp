#include "sim/io/saved_moment.h"

#include <charconv>
#include <string_view>

#include "sim/io/json.h"
#include "sim/io/situation.h"

namespace sim::io {
namespace {

constexpr float kLongest = 36000;  // [s]

/// Reads a whole number or a decimal one from the beginning of `text`, and removes it. Returns whether there is one.
template <class Number>
bool take(std::string_view& text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return error == std::errc{};
}

bool take(std::string_view& text, char letter) {
  const bool is_there = text.starts_with(letter);
  if (is_there) text.remove_prefix(1);
  return is_there;
}

/// Reads "2:05:12" as half and seconds.
bool read_clock(std::string_view text, int& half, float& seconds) {
  int minutes = 0;
  float rest = 0;
  if (!take(text, half) || !take(text, ':') || !take(text, minutes) || !take(text, ':') || !take(text, rest))
    return false;
  seconds = 60 * static_cast<float>(minutes) + rest;
  return text.empty() && half >= 1 && half <= 4 && minutes >= 0 && minutes <= 600 && rest >= 0 && rest < 60;
}

}  // namespace

robot::Result<SavedMoment> SavedMoment::parse(const std::string& when) {
  SavedMoment moment;
  std::string_view text = when;
  const bool clock = when.find(':') != when.npos;
  const bool good = clock ? read_clock(text, moment.half_, moment.seconds_)
                          : take(text, moment.seconds_) && text.empty() && moment.seconds_ >= 0;
  if (good && moment.seconds_ <= kLongest) return moment;
  return robot::Error{
      "a moment must be 0 .. 36000 [s] since the first tick, or half:minutes:seconds on the clock such "
      "as 2:05:12, got '" +
      when + "'"};
}

bool SavedMoment::comes_with(const State& state) const {
  if (half_ == 0) return state.world.tick >= ticks(seconds_);
  return state.book.half == half_ && state.book.clock >= ticks(seconds_);
}

void SavedMoment::see(const State& state, const std::string& about) {
  if (!reached() && comes_with(state)) text_ = save_situation(state, about);
}

}  // namespace sim::io
