#include "robot/truth/sensor/name_time.h"

#include <algorithm>
#include <charconv>
#include <chrono>

#include "robot/core/clock.h"

namespace robot::truth {
namespace {

// the first day of 1990: a lower number is a counter with leading zeros
constexpr std::uint64_t kEarliest_ns = 631'152'000 * kSecond;

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

/// Returns the digits at the beginning of `text`.
std::string_view leading_digits(std::string_view text) {
  return text.substr(0, static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_digit) - text.begin()));
}

/// Returns the number that at most 19 digits spell.
std::uint64_t number_of(std::string_view digits) {
  std::uint64_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

/// Returns a fraction of a second [ns] that is written as ".814212", or nothing for any other text.
std::optional<std::uint64_t> fraction_ns(std::string_view text) {
  if (!text.starts_with('.')) return std::nullopt;
  const std::string_view digits = leading_digits(text.substr(1)).substr(0, 9);
  if (digits.empty()) return std::nullopt;
  std::uint64_t fraction = number_of(digits);
  for (std::size_t i = digits.size(); i < 9; ++i) fraction *= 10;
  return fraction;
}

/// Returns the time of a date such as 20121214T142255.814212, or nothing for any other text.
std::optional<std::uint64_t> date_ns(std::string_view text) {
  if (leading_digits(text).size() != 8 || text.substr(8, 1) != "T" || leading_digits(text.substr(9)).size() != 6)
    return std::nullopt;
  const auto part = [text](std::size_t from, std::size_t digits) { return number_of(text.substr(from, digits)); };
  const std::chrono::year_month_day date{std::chrono::year(static_cast<int>(part(0, 4))),
                                         std::chrono::month(static_cast<unsigned>(part(4, 2))),
                                         std::chrono::day(static_cast<unsigned>(part(6, 2)))};
  const std::uint64_t hour = part(9, 2), minute = part(11, 2), second = part(13, 2);
  if (!date.ok() || hour > 23 || minute > 59 || second > 60) return std::nullopt;
  const auto days = std::chrono::sys_days(date).time_since_epoch().count();
  // times of the years 1970 to 2499 fit into 64 bits
  if (days < 0 || part(0, 4) > 2499) return std::nullopt;
  const std::uint64_t seconds = ((static_cast<std::uint64_t>(days) * 24 + hour) * 60 + minute) * 60 + second;
  return seconds * kSecond + fraction_ns(text.substr(15)).value_or(0);
}

/// Returns the time with which `text` begins.
std::optional<std::uint64_t> leading_time(std::string_view text) {
  const std::string_view digits = leading_digits(text);
  const auto fraction = fraction_ns(text.substr(digits.size()));
  switch (digits.size()) {
    case 8: return date_ns(text);
    case 10: return fraction ? std::optional(number_of(digits) * kSecond + *fraction) : std::nullopt;
    case 13: return number_of(digits) * kMillisecond;
    case 16: return number_of(digits) * 1000;
    case 19: return number_of(digits);
    default: return std::nullopt;
  }
}

}  // namespace

std::optional<std::uint64_t> time_in_name(std::string_view name) {
  while (!name.empty()) {
    if (const auto time = leading_time(name); time && *time >= kEarliest_ns) return time;
    // behind these digits, or behind one other letter
    name.remove_prefix(std::max<std::size_t>(leading_digits(name).size(), 1));
  }
  return std::nullopt;
}

}  // namespace robot::truth
