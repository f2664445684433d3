// Parser of WebSocket frames, and writer of a server's frames (RFC 6455, section 5). No sockets.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace robot::net {

enum class Opcode : std::uint8_t { continuation = 0, text = 1, binary = 2, close = 8, ping = 9, pong = 10 };

/// The close codes we send (RFC 6455, section 7.4.1).
enum CloseCode : std::uint16_t {
  kNormalClosure = 1000,
  kGoingAway = 1001,
  kProtocolError = 1002,
  kNotUtf8 = 1007,
  kPolicyViolation = 1008,
  kMessageTooBig = 1009,
  kNoCodeGiven = 1005,  // only received, never sent
};

/// A violation of the protocol by the peer, with the close code for it.
struct Violation {
  std::uint16_t close_code = kProtocolError;
  std::string sentence;
};

/// The sender of parsed frames. A client must mask its frames, a server must not.
enum class Sender { client, server };

/// A parser that takes the bytes of a connection in any portions and returns whole messages. It joins fragments and
/// removes masks. Control frames may come between the fragments of a message.
class FrameParser {
 public:
  /// Called with text, binary, ping, pong or close and the payload. Returning false ends the parsing.
  using Sink = std::function<bool(Opcode, std::string payload)>;

  /// A message of more than `max_message_bytes` is a violation.
  FrameParser(Sender sender, std::size_t max_message_bytes);

  /// Takes the next bytes. After a violation, or when `sink` has returned false, all further bytes are ignored.
  std::optional<Violation> feed(std::string_view bytes, const Sink& sink);

 private:
  std::size_t header_size() const;
  std::optional<Violation> take_header();
  std::optional<Violation> check_header(std::uint64_t length) const;
  void take_payload(std::string_view& bytes);
  std::optional<Violation> finish_frame(const Sink& sink);
  bool is_control() const { return opcode_ >= 8; }

  Sender sender_;
  std::size_t max_message_bytes_;
  bool ended_ = false;

  std::array<unsigned char, 14> header_{};
  std::size_t header_filled_ = 0;
  bool in_payload_ = false;

  // the frame being read
  std::uint8_t opcode_ = 0;
  bool final_ = false;
  std::array<unsigned char, 4> mask_{};
  std::uint64_t payload_size_ = 0, payload_read_ = 0;

  // the message so far, and a control frame that may come between its fragments
  std::optional<Opcode> message_opcode_;
  std::string message_, control_;
};

/// Appends the header of an unfragmented, unmasked frame (a server's); the payload follows.
void append_frame_header(std::string& out, Opcode opcode, std::uint64_t payload_bytes);

/// Appends a whole unfragmented, unmasked frame (a server's).
void append_frame(std::string& out, Opcode opcode, std::string_view payload);

/// Returns the payload of a close frame. Cuts `reason` to the 123 bytes that fit.
std::string close_payload(std::uint16_t code, std::string_view reason);

/// Returns a whole close frame of a server.
std::string close_frame(std::uint16_t code, std::string_view reason);

/// The peer's reason for closing: the code (1005 if it gave none) and a text.
struct CloseInfo {
  std::uint16_t code = kNoCodeGiven;
  std::string reason;
};

/// Parses the payload of a close frame that FrameParser has accepted.
CloseInfo parse_close(std::string_view payload);

}  // namespace robot::net
