#include "robot/truth/feeds/csv_time.h"

#include <chrono>

#include "robot/core/clock.h"

namespace robot::truth {
namespace {

constexpr std::int64_t kBillion = 1'000'000'000;
constexpr int kLastYear = 2262;  // the last one whose nanoseconds an int64 can hold

/// A reader of a text from front to back. After the first part that does not fit, ok() is false.
class TextReader {
 public:
  explicit TextReader(std::string_view text) : rest_(text) {}

  /// Reads a number of exactly `digits` digits that is in [least, most].
  int number(std::size_t digits, int least, int most) {
    const std::string_view part = rest_.substr(0, digits);
    int value = 0;
    for (const char digit : part) {
      ok_ &= digit >= '0' && digit <= '9';
      value = 10 * value + (digit - '0');
    }
    ok_ &= part.size() == digits && value >= least && value <= most;
    rest_.remove_prefix(part.size());
    return value;
  }
  /// Reads one of `characters`. Returns false if another one comes.
  bool maybe(std::string_view characters) {
    if (rest_.empty() || characters.find(rest_.front()) == characters.npos) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void expect(std::string_view characters) { ok_ &= maybe(characters); }

  /// Reads the digits after a decimal point as nanoseconds.
  std::int64_t fraction_ns() {
    std::int64_t value = 0, unit = kBillion;
    while (!rest_.empty() && rest_.front() >= '0' && rest_.front() <= '9') {
      unit /= 10;
      value += unit * (rest_.front() - '0');
      rest_.remove_prefix(1);
    }
    ok_ &= unit < kBillion;
    return value;
  }
  char next() const { return rest_.empty() ? '\0' : rest_.front(); }
  bool finished() const { return ok_ && rest_.empty(); }

 private:
  std::string_view rest_;
  bool ok_ = true;
};

/// Reads the offset of a zone from UTC [s]; absent: 0.
std::int64_t zone_of(TextReader& text) {
  if (text.maybe("Zz")) return 0;
  const int sign = text.next() == '-' ? -1 : 1;
  if (!text.maybe("+-")) return 0;
  const int hours = text.number(2, 0, 14);
  text.maybe(":");
  return sign * 60 * (60 * hours + text.number(2, 0, 59));
}

}  // namespace

std::optional<std::uint64_t> parse_iso_time(std::string_view written) {
  TextReader text(written);
  const int year = text.number(4, 1970, kLastYear - 1);
  text.expect("-");
  const int month = text.number(2, 1, 12);
  text.expect("-");
  const int day = text.number(2, 1, 31);
  text.expect("Tt ");
  const int hour = text.number(2, 0, 23);
  text.expect(":");
  const int minute = text.number(2, 0, 59);
  text.expect(":");
  const int second = text.number(2, 0, 60);
  const std::int64_t fraction_ns = text.maybe(".,") ? text.fraction_ns() : 0;
  const std::int64_t zone = zone_of(text);
  const std::chrono::year_month_day date(std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day)));
  if (!text.finished() || !date.ok()) return std::nullopt;
  const std::int64_t days = std::chrono::sys_days(date).time_since_epoch().count();
  const std::int64_t seconds = ((days * 24 + hour) * 60 + minute) * 60 + second - zone;
  if (seconds < 0) return std::nullopt;
  return static_cast<std::uint64_t>(seconds * kBillion + fraction_ns);
}

}  // namespace robot::truth
