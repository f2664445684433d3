#include "robot/nao/lola/sensors.h"

#include <cmath>
#include <cstring>
#include <optional>

#include "robot/core/text.h"

namespace robot::nao {
namespace {

constexpr const char* kIdentityKey = "RobotConfig";
constexpr std::size_t kIdentityTexts = 4;
constexpr std::size_t kMaxTextBytes = 20;  // of an id or a version

/// A field to find: its key and the indices of its numbers.
struct Field {
  std::string_view key;
  std::size_t first, count;
  bool found = false;
};

std::vector<Field> fields() {
  std::vector<Field> list;
  std::size_t first = 0;
  Sensors().visit([&](std::string_view key, const auto& numbers) {
    list.push_back({key, first, numbers.size()});
    first += numbers.size();
  });
  return list;
}

Error wrong(std::string_view key, const std::string& expected, const std::string& got) {
  return Error{"LoLA: " + std::string(key) + ": expected " + expected + ", got " + got};
}

/// Returns the bits of the marker that all numbers of this encoding share.
std::uint8_t fixed_bits(std::uint8_t marker, NumberSlot slot) {
  if (slot.kind != NumberSlot::Kind::in_marker) return 0xff;
  return marker < 0x80 ? 0x80 : 0xe0;
}

/// Returns `bytes` as words of eight bytes; the last one is padded with zeroes.
std::vector<std::uint64_t> words_of(std::string_view bytes) {
  std::vector<std::uint64_t> words((bytes.size() + 7) / 8);
  std::memcpy(words.data(), bytes.data(), bytes.size());
  return words;
}

}  // namespace

bool SensorFrames::fits(std::string_view frame) const {
  if (frame.size() != bytes_) return false;
  std::uint64_t differences = 0;
  const std::size_t whole = bytes_ / 8;
  for (std::size_t i = 0; i < whole; ++i) {
    std::uint64_t word = 0;
    std::memcpy(&word, frame.data() + 8 * i, 8);
    differences |= (word ^ known_[i]) & fixed_[i];
  }
  if (whole < known_.size()) {
    std::uint64_t word = 0;
    std::memcpy(&word, frame.data() + 8 * whole, bytes_ - 8 * whole);
    differences |= (word ^ known_[whole]) & fixed_[whole];
  }
  return differences == 0;
}

Result<std::size_t> SensorFrames::size_of_first(std::string_view bytes) const {
  if (bytes_ != 0 && bytes.size() >= bytes_ && fits(bytes.substr(0, bytes_))) return bytes_;
  const std::string_view within = bytes.substr(0, kMaxBytes);
  MessagePackReader reader(within);
  const std::uint32_t pairs = reader.map();
  for (std::uint32_t i = 0; i < pairs && reader.state() == MessagePackReader::State::good; ++i) {
    reader.text();
    reader.skip();
  }
  if (reader.state() == MessagePackReader::State::good) return reader.position();
  if (reader.state() == MessagePackReader::State::wrong)
    return Error{"LoLA: expected a MessagePack map with texts as keys, got something else"};
  if (bytes.size() < kMaxBytes) return std::size_t{0};
  return Error{"LoLA: expected a frame of at most " + std::to_string(kMaxBytes) + " bytes, got a longer one"};
}

Result<void> SensorFrames::learn(std::string_view frame) {
  bytes_ = 0;
  RobotIdentity identity;
  bool has_identity = false;
  std::array<NumberSlot, Sensors::kNumbers> slots;
  std::vector<Field> wanted = fields();
  MessagePackReader reader(frame);
  const std::uint32_t pairs = reader.map();
  for (std::uint32_t i = 0; i < pairs && reader.state() == MessagePackReader::State::good; ++i) {
    const std::string_view key = reader.text();
    if (key == kIdentityKey) {
      if (has_identity) return wrong(key, "it once", "it again");
      has_identity = true;
      const std::uint32_t texts = reader.array();
      if (texts != kIdentityTexts) return wrong(key, "4 texts", std::to_string(texts));
      for (std::string* text : {&identity.body_id, &identity.body_version, &identity.head_id, &identity.head_version})
        *text = printable(reader.text(), kMaxTextBytes);
      if (reader.state() == MessagePackReader::State::wrong) return wrong(key, "texts", "something else");
      continue;
    }
    Field* field = nullptr;
    for (Field& candidate : wanted)
      if (candidate.key == key) field = &candidate;
    if (!field) {
      reader.skip();
      continue;
    }
    if (field->found) return wrong(key, "it once", "it again");
    field->found = true;
    const std::uint32_t count = reader.array();
    if (reader.state() != MessagePackReader::State::good || count != field->count)
      return wrong(key, std::to_string(field->count) + " numbers", count == 0 ? "none" : std::to_string(count));
    for (std::size_t k = 0; k < count; ++k) slots[field->first + k] = reader.number();
    if (reader.state() == MessagePackReader::State::wrong) return wrong(key, "numbers", "something else");
  }
  if (reader.state() != MessagePackReader::State::good || reader.position() != frame.size())
    return Error{"LoLA: expected one whole frame, got " + std::to_string(frame.size()) +
                 " bytes that cannot be parsed as one"};
  for (const Field& field : wanted)
    if (!field.found) return wrong(field.key, "it in every frame", "a frame without it");
  if (!has_identity) return wrong(kIdentityKey, "it in every frame", "a frame without it");

  // nothing can fail after this line
  std::string fixed(frame.size(), '\xff');
  for (const NumberSlot& slot : slots) {
    fixed[slot.offset] = static_cast<char>(fixed_bits(static_cast<std::uint8_t>(frame[slot.offset]), slot));
    fixed.replace(slot.offset + 1u, slot.bytes, slot.bytes, '\0');
  }
  identity_ = std::move(identity);
  slots_ = slots;
  known_ = words_of(frame);
  fixed_ = words_of(fixed);
  bytes_ = frame.size();
  return {};
}

Result<void> SensorFrames::read(std::string_view frame, Sensors& sensors) {
  if (frame.size() > kMaxBytes)
    return Error{"LoLA: expected a frame of at most " + std::to_string(kMaxBytes) + " bytes, got " +
                 std::to_string(frame.size())};
  if (bytes_ == 0 || !fits(frame))
    if (Result<void> learnt = learn(frame); !learnt) return learnt;
  Sensors found;
  std::size_t index = 0;
  std::string_view damaged;
  found.visit([&](std::string_view key, auto& numbers) {
    for (float& number : numbers) {
      number = read_number(frame, slots_[index++]);
      if (!std::isfinite(number)) damaged = key;
    }
  });
  if (!damaged.empty()) return wrong(damaged, "finite numbers", "one that is not");
  sensors = found;
  return {};
}

}  // namespace robot::nao
