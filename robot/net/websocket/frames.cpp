#include "robot/net/websocket/frames.h"

#include <algorithm>
#include <utility>

#include "robot/core/encoding.h"

namespace robot::net {
namespace {

constexpr std::size_t kMaxControlBytes = 125;

Violation broken(std::string sentence) { return {kProtocolError, std::move(sentence)}; }

// returns whether a close frame may carry the code: RFC 6455, sections 7.4.1 and 7.4.2, and its registry
bool may_be_sent(std::uint16_t code) {
  if (code >= 3000) return code < 5000;
  return code >= 1000 && code <= 1014 && code != 1004 && code != 1005 && code != 1006;
}

std::optional<Violation> check_close(std::string_view payload) {
  if (payload.empty()) return std::nullopt;
  if (payload.size() == 1) return broken("a close frame has 1 byte, expected none or a code of 2 bytes");
  const CloseInfo info = parse_close(payload);
  if (!may_be_sent(info.code))
    return broken("a close frame has the code " + std::to_string(info.code) + ", which none may have");
  if (!is_utf8(info.reason)) return Violation{kNotUtf8, "the reason in a close frame is not UTF-8"};
  return std::nullopt;
}

}  // namespace

FrameParser::FrameParser(Sender sender, std::size_t max_message_bytes)
    : sender_(sender), max_message_bytes_(max_message_bytes) {}

std::optional<Violation> FrameParser::feed(std::string_view bytes, const Sink& sink) {
  while (!ended_) {
    if (!in_payload_) {
      // the first two bytes give the header's size
      while (header_filled_ < header_size() && !bytes.empty()) {
        header_[header_filled_++] = static_cast<unsigned char>(bytes.front());
        bytes.remove_prefix(1);
      }
      if (header_filled_ < header_size()) return std::nullopt;
      if (auto violation = take_header()) return violation;
    }
    take_payload(bytes);
    if (payload_read_ < payload_size_) return std::nullopt;
    if (auto violation = finish_frame(sink)) return violation;
  }
  return std::nullopt;
}

std::size_t FrameParser::header_size() const {
  if (header_filled_ < 2) return 2;
  const unsigned length = header_[1] & 0x7f;
  return 2u + (length == 126 ? 2u : length == 127 ? 8u : 0u) + ((header_[1] & 0x80) != 0 ? 4u : 0u);
}

std::optional<Violation> FrameParser::take_header() {
  opcode_ = header_[0] & 0x0f;
  final_ = (header_[0] & 0x80) != 0;

  std::uint64_t length = header_[1] & 0x7f;
  std::size_t at = 2;
  if (length >= 126) {
    const std::size_t end = length == 126 ? 4 : 10;
    length = 0;
    for (; at < end; ++at) length = length << 8 | header_[at];
  }
  if (auto violation = check_header(length)) {
    ended_ = true;
    return violation;
  }
  mask_ = {};
  if ((header_[1] & 0x80) != 0) std::copy_n(header_.begin() + static_cast<std::ptrdiff_t>(at), 4, mask_.begin());

  payload_size_ = length;
  payload_read_ = 0;
  header_filled_ = 0;
  in_payload_ = true;
  if (!is_control() && opcode_ != 0) message_opcode_ = Opcode{opcode_};
  return std::nullopt;
}

std::optional<Violation> FrameParser::check_header(std::uint64_t length) const {
  const unsigned length_form = header_[1] & 0x7f;
  if ((header_[0] & 0x70) != 0) return broken("a reserved bit is set, no extension was agreed on");
  if ((opcode_ > 2 && opcode_ < 8) || opcode_ > 10)
    return broken("the opcode " + std::to_string(opcode_) + " is not defined");

  const bool masked = (header_[1] & 0x80) != 0;
  if (masked != (sender_ == Sender::client))
    return broken(masked ? "a server must not mask its frames" : "a client must mask its frames");
  if ((length_form == 126 && length < 126) || (length_form == 127 && length < 65536))
    return broken("a payload length is written longer than needed");
  if (length >> 63 != 0) return broken("a payload length has its highest bit set");

  if (is_control()) {
    if (!final_) return broken("a control frame is fragmented");
    if (length > kMaxControlBytes)
      return broken("a control frame has " + std::to_string(length) + " bytes, expected at most 125");
    return std::nullopt;
  }
  if (opcode_ == 0 && !message_opcode_) return broken("a continuation frame comes without a message to continue");
  if (opcode_ != 0 && message_opcode_) return broken("a new message begins before the last one ended");
  const std::uint64_t size = message_.size() + length;
  if (size > max_message_bytes_)
    return Violation{kMessageTooBig, "a message has " + std::to_string(size) + " bytes or more, expected at most " +
                                         std::to_string(max_message_bytes_)};
  return std::nullopt;
}

void FrameParser::take_payload(std::string_view& bytes) {
  // do not reserve the announced size: a peer must send bytes to make us use memory
  const std::size_t n = static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), payload_size_ - payload_read_));
  std::string& target = is_control() ? control_ : message_;
  const std::size_t begin = target.size();
  target.append(bytes.substr(0, n));
  if (sender_ == Sender::client)
    for (std::size_t i = 0; i < n; ++i)
      target[begin + i] = static_cast<char>(target[begin + i] ^ mask_[(payload_read_ + i) & 3]);
  payload_read_ += n;
  bytes.remove_prefix(n);
}

std::optional<Violation> FrameParser::finish_frame(const Sink& sink) {
  in_payload_ = false;
  if (!is_control() && !final_) return std::nullopt;

  std::optional<Violation> violation;
  Opcode opcode{opcode_};
  std::string payload = std::exchange(is_control() ? control_ : message_, {});
  if (!is_control()) {
    opcode = *std::exchange(message_opcode_, std::nullopt);
    if (opcode == Opcode::text && !is_utf8(payload)) violation = Violation{kNotUtf8, "a text message is not UTF-8"};
  } else if (opcode == Opcode::close) {
    violation = check_close(payload);
  }
  if (violation || !sink(opcode, std::move(payload))) ended_ = true;
  return violation;
}

void append_frame_header(std::string& out, Opcode opcode, std::uint64_t payload_bytes) {
  out += static_cast<char>(0x80 | static_cast<unsigned char>(opcode));
  const int bytes = payload_bytes < 126 ? 0 : payload_bytes < 65536 ? 2 : 8;  // of the length, if it is long
  out += static_cast<char>(bytes == 0 ? payload_bytes : bytes == 2 ? 126 : 127);
  for (int i = bytes - 1; i >= 0; --i) out += static_cast<char>((payload_bytes >> (8 * i)) & 0xff);
}

void append_frame(std::string& out, Opcode opcode, std::string_view payload) {
  append_frame_header(out, opcode, payload.size());
  out += payload;
}

std::string close_payload(std::uint16_t code, std::string_view reason) {
  reason = reason.substr(0, kMaxControlBytes - 2);
  while (!is_utf8(reason)) reason.remove_suffix(1);  // not in the middle of a character
  return {std::string{static_cast<char>(code >> 8), static_cast<char>(code & 0xff)}.append(reason)};
}

std::string close_frame(std::uint16_t code, std::string_view reason) {
  std::string frame;
  append_frame(frame, Opcode::close, close_payload(code, reason));
  return frame;
}

CloseInfo parse_close(std::string_view payload) {
  if (payload.size() < 2) return {};
  const unsigned code = static_cast<unsigned char>(payload[0]) * 256u + static_cast<unsigned char>(payload[1]);
  return {static_cast<std::uint16_t>(code), std::string(payload.substr(2))};
}

}  // namespace robot::net
