// A reader of the messages of an MCAP file in the order of their times, however the file orders them.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "robot/core/result.h"
#include "robot/logging/mcap/mcap_file.h"
#include "robot/logging/mcap/reader.h"

namespace robot::logging {

/// The messages of any number of channels, merged by log time. Messages of one time come in the order of the file.
/// Each chunk is opened once if the open ones fit into kOpenBytes. If chunks overlap so much that they do not fit, the
/// reader holds a part of each and unpacks it again for the next part. Used by one thread.
///
/// The reader trusts the times in the index of a chunk. Messages before the start of their chunk come later than their
/// time says. It reports each damaged chunk once, by an Error, and continues with the rest.
class OrderedReader {
 public:
  /// The memory for open chunks beyond the largest one [bytes].
  static constexpr std::uint64_t kOpenBytes = 16 << 20;

  /// `channels` selects the channels by their ids; nothing: all that are described. When `cancelled` becomes true, the
  /// running call and all later ones end.
  explicit OrderedReader(std::shared_ptr<const McapFile> file, std::optional<std::set<std::uint16_t>> channels = {},
                         const std::atomic<bool>* cancelled = nullptr, std::uint64_t open_bytes = kOpenBytes);

  /// Returns the next message, or nothing at the end of the file or when it was cancelled.
  Result<std::optional<McapMessage>> next();

  /// Continues with the messages captured at `capture_ns` or later. May move backwards.
  void seek(std::uint64_t capture_ns);

  /// Continues with the messages captured after `capture_ns`. Returns the newest message until then of each channel, as
  /// newest_until() does.
  std::vector<McapMessage> move_to(std::uint64_t capture_ns);

  /// Returns the newest message captured at `capture_ns` or before of each channel that has one, in the order of time.
  /// Passes over damaged chunks, which next() then reports.
  std::vector<McapMessage> newest_until(std::uint64_t capture_ns);

 private:
  /// The place of a message in the order of delivery.
  struct Place {
    std::uint64_t time_ns = 0;
    std::uint64_t piece_offset = 0;  // of its chunk in the file
    std::uint64_t offset = 0;        // in the unpacked chunk

    bool operator<(const Place& other) const {
      return std::tie(time_ns, piece_offset, offset) < std::tie(other.time_ns, other.piece_offset, other.offset);
    }
  };

  /// A message of an open chunk. 32 bits suffice, because a chunk has at most kMaxRecordBytes.
  struct Entry {
    std::uint64_t time_ns;
    std::uint32_t offset;  // in the unpacked chunk
    std::uint32_t at;      // in Open::records
  };

  /// An open chunk, or the part of it that comes next.
  struct Open {
    std::size_t piece = 0;  // index in pieces_
    std::string records;
    std::vector<Entry> entries;  // in the order of delivery
    std::size_t next = 0;        // the first entry that was not delivered
    bool has_more = false;       // messages after the last entry

    std::uint64_t size_bytes() const { return records.capacity() + entries.capacity() * sizeof(Entry); }
  };

  struct Newest;

  bool ended() const { return file_->ended() || (cancelled_ && cancelled_->load(std::memory_order_relaxed)); }
  template <class Which>
  bool has_any(const ChunkInfo& piece, Which&& which) const;
  void list_pieces();
  Place place_of(std::size_t piece, const Entry& entry) const;
  std::optional<Open> load(std::size_t piece, const Place& from);
  void open(std::size_t piece, const Place& from);
  void open_due();
  void cut(Open& open) const;
  McapMessage take_first();
  void note(std::size_t piece, const std::string& sentence);
  static mcap::Message message_at(const Open& open, const Entry& entry);

  const std::shared_ptr<const McapFile> file_;
  std::set<std::uint16_t> channels_;
  const std::atomic<bool>* const cancelled_;
  const std::uint64_t open_bytes_;

  std::vector<const ChunkInfo*> pieces_;  // chunks and runs with wanted messages, by start time
  std::uint64_t largest_bytes_ = 0;       // of the unpacked pieces
  std::size_t most_open_ = 1;             // pieces that overlap at one time

  Place from_;                        // the first place to deliver
  std::size_t next_piece_ = 0;        // not opened yet
  std::map<Place, Open> opened_;      // by the place of the next message
  std::uint64_t held_bytes_ = 0;      // by opened_
  std::set<std::size_t> damaged_;     // pieces whose damage was noted
  std::vector<std::string> damages_;  // noted, but not returned yet; the last one first
};

}  // namespace robot::logging
