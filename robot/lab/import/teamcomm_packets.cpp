#include "robot/lab/import/teamcomm_packets.h"

#include <cmath>
#include <cstring>
#include <map>
#include <utility>

namespace robot::lab::teamcomm {
namespace {

// type codes of Java's serialisation
constexpr std::uint8_t kNull = 0x70, kReference = 0x71, kClass = 0x72, kObject = 0x73, kString = 0x74, kArray = 0x75,
                       kBlock = 0x77, kEndOfClass = 0x78;
constexpr std::size_t kStreamHead = 4, kBlockBytes = 9, kMostClasses = 8;
constexpr std::size_t kLeastPacket = 48;  // [bytes] up to the ball's place
constexpr std::uint8_t kVersion = 6;

/// A reader of Java's serialisation. After a failure it reads zeros.
class JavaStream {
 public:
  explicit JavaStream(std::string_view bytes) : bytes_(bytes), offset_(std::min(bytes.size(), kStreamHead)) {}

  bool at_end() const { return offset_ == bytes_.size(); }
  std::size_t offset() const { return offset_; }
  const std::string& failure() const { return failure_; }

  std::string_view take(std::size_t count) {
    if (!failure_.empty()) return {};
    if (bytes_.size() - offset_ < count) {
      fail("expected " + std::to_string(count) + " bytes, the file has " + std::to_string(bytes_.size() - offset_) +
           " more");
      return {};
    }
    const std::string_view part = bytes_.substr(offset_, count);
    offset_ += count;
    return part;
  }

  std::uint64_t number(std::size_t bytes) {
    std::uint64_t value = 0;
    for (const char byte : take(bytes)) value = value << 8 | static_cast<std::uint8_t>(byte);
    return value;
  }

  std::uint8_t code() { return static_cast<std::uint8_t>(number(1)); }
  void expect(std::uint8_t code, const char* what) {
    if (this->code() != code) fail(std::string("expected ") + what);
  }

  void skip_string() {
    const std::uint8_t kind = code();
    if (kind == kReference) return void(take(4));
    if (kind == kString) return void(take(number(2)));
    fail("expected a string");
  }

  /// Skips the description of a class and of its parents.
  void skip_class() {
    for (std::size_t depth = 0; depth < kMostClasses; ++depth) {
      const std::uint8_t kind = code();
      if (kind == kNull) return;
      if (kind == kReference) return void(take(4));
      if (kind != kClass) return fail("expected a class");
      take(number(2));  // name
      take(9);          // version, flags
      for (std::uint64_t field = number(2); field > 0 && failure_.empty(); --field) skip_field();
      expect(kEndOfClass, "the end of a class");
    }
    fail("a class has too many parents");
  }

  void fail(const std::string& why) {
    if (failure_.empty()) failure_ = "at byte " + std::to_string(offset_) + ": " + why;
  }

 private:
  void skip_field() {
    const std::uint8_t type = code();
    take(number(2));  // name
    if (type == 'L' || type == '[') skip_string();
  }

  std::string_view bytes_;
  std::size_t offset_;
  std::string failure_;
};

/// A record of the log: the time [ms] and the bytes of the packet.
struct LogEntry {
  std::uint64_t time_ms = 0;
  std::string_view bytes;
};

LogEntry entry_of(JavaStream& stream) {
  LogEntry record;
  stream.expect(kBlock, "a time");
  if (stream.number(1) != kBlockBytes) stream.fail("expected a time of 9 bytes");
  record.time_ms = stream.number(8);
  stream.take(1);
  stream.expect(kObject, "a packet");
  stream.skip_class();
  stream.take(4);        // team
  stream.skip_string();  // address
  stream.expect(kArray, "the bytes of a packet");
  stream.skip_class();
  record.bytes = stream.take(stream.number(4));
  return record;
}

std::optional<Packet> packet_of(const LogEntry& record) {
  const std::string_view bytes = record.bytes;
  if (bytes.size() < kLeastPacket || !bytes.starts_with("SPL ") || bytes[4] != kVersion) return std::nullopt;
  float numbers[10];
  std::memcpy(numbers, bytes.data() + 8, sizeof(numbers));
  for (const float number : numbers)
    if (!std::isfinite(number)) return std::nullopt;
  const auto byte = [bytes](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(bytes[i])); };
  return Packet{.time_ms = record.time_ms,
                .player = byte(5),
                .team = byte(6),
                .fallen = byte(7) != 0,
                .x = numbers[0],
                .y = numbers[1],
                .heading = numbers[2],
                .ball_age = numbers[7],
                .ball_x = numbers[8],
                .ball_y = numbers[9]};
}

}  // namespace

Log read_log(std::string_view file_bytes) {
  Log log;
  JavaStream stream(file_bytes);
  std::map<std::pair<unsigned, unsigned>, std::string_view> last;  // bytes by team and player
  for (std::size_t count = 0; !stream.at_end(); ++count) {
    const LogEntry record = entry_of(stream);
    if (!stream.failure().empty()) {
      log.damage = "packet " + std::to_string(count) + ' ' + stream.failure();
      return log;
    }
    const std::optional<Packet> packet = packet_of(record);
    if (!packet) {
      ++log.unreadable;
      continue;
    }
    const std::string_view before = std::exchange(last[{packet->team, packet->player}], record.bytes);
    if (before == record.bytes)
      ++log.repeated;
    else
      log.packets.push_back(*packet);
  }
  return log;
}

}  // namespace robot::lab::teamcomm
