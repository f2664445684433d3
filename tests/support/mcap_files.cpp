// Many MCAP files of the generator, written and read in one process.
//
//   mcap_files write FOLDER FIRST COUNT   writes FOLDER/<seed>.mcap for each seed
//   mcap_files read FOLDER FIRST COUNT    reads them; one line of JSON for each, of which the sums must match
//   mcap_files many FILE                  writes 60,000 messages in 100 topics, 22 MB
//   mcap_files huge FILE                  writes 10 GB in 320 chunks, most of it holes in the file
//   mcap_files slow FILE                  writes chunks that take a minute to unpack, without an index
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "robot/lab/clocks/session_report.h"
#include "robot/logging/mcap/ordered_reader.h"
#include "tests/support/foreign_frames.h"
#include "tests/support/mcap_bytes.h"
#include "tests/support/mcap_generator.h"

namespace {

using robot::logging::McapFile;
using robot::logging::OrderedReader;
using tests::McapBytes;

constexpr std::uint64_t kStart = 1'764'000'000'000'000'000;
constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};

std::filesystem::path file_of(const std::filesystem::path& folder, std::uint32_t seed) {
  return folder / (std::to_string(seed) + ".mcap");
}

/// Adds a message to the checksum that stands for the order and content of all.
std::uint32_t digest(std::uint32_t before, const robot::logging::McapMessage& message) {
  const McapBytes head = McapBytes()
                             .u16(message.channel_id)
                             .u32(message.record.sequence)
                             .u64(message.record.capture_ns)
                             .u64(message.record.publish_ns);
  const std::string bytes = head.bytes() + message.record.bytes;
  return static_cast<std::uint32_t>(
      ::crc32(before, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

/// Reads a file in both ways that we have, and describes what was found.
nlohmann::json read(const std::filesystem::path& path, const tests::GeneratedMcap& made) {
  std::uint64_t messages = 0;
  std::uint32_t sum = 0;
  const auto file = McapFile::open(path);
  if (!file) return {{"error", file.error()}};
  OrderedReader reader(*file);
  nlohmann::json sentences = nlohmann::json::array();
  while (true) {
    const auto message = reader.next();
    if (message && !*message) break;
    if (!message) {
      sentences.push_back(message.error());
      continue;
    }
    ++messages;
    sum = digest(sum, **message);
  }
  if (!(*file)->index().damage.empty()) sentences.push_back((*file)->index().damage);
  const auto report = robot::lab::inspect(path);
  if (!report) return {{"error", report.error()}};
  std::uint64_t shown = 0, left_out = 0;
  for (const auto& stream : report->streams) shown += stream.messages;
  for (const auto& stream : report->session.streams) {
    left_out += stream.left_out;
    if (!stream.note.empty()) sentences.push_back(stream.note);
  }
  return {{"messages", messages},
          {"digest", sum},
          {"shown", shown},
          {"left_out", left_out},
          {"written", made.messages.size()},
          {"unreadable", made.unreadable},
          {"valid", made.is_valid},
          {"sentences", sentences},
          {"features", made.features}};
}

/// The growing end of a file: its chunks for the summary.
struct Summary {
  McapBytes chunks;
  std::uint64_t count = 0, messages = 0;
};

void add_chunk(Summary& summary, std::uint64_t start_ns, std::uint64_t end_ns, std::uint64_t offset,
               std::uint64_t bytes, std::uint64_t unpacked, const std::string& compression, const McapBytes& indexes,
               std::uint64_t index_bytes) {
  summary.chunks.record(0x08, McapBytes()
                                  .u64(start_ns)
                                  .u64(end_ns)
                                  .u64(offset)
                                  .u64(bytes)
                                  .text(indexes.bytes())
                                  .u64(index_bytes)
                                  .text(compression)
                                  .u64(bytes - 9 - 40 - compression.size())
                                  .u64(unpacked));
  ++summary.count;
}

McapBytes channel_record(unsigned id) {
  return McapBytes().record(0x04,
                            McapBytes().u16(id).u16(0).text("/many/" + std::to_string(id)).text("json").texts({}));
}

/// The bytes after the data, which end at `offset`.
std::string end_of(const Summary& summary, const McapBytes& channels, unsigned topics, std::uint64_t end_ns,
                   std::uint64_t offset) {
  McapBytes counts;
  for (unsigned id = 0; id < topics; ++id) counts.u16(id).u64(summary.messages / topics);
  McapBytes out;
  out.record(0x0f, McapBytes().u32(0)).raw(channels.bytes());
  out.record(0x0b, McapBytes()
                       .u64(summary.messages)
                       .u16(0)
                       .u32(topics)
                       .u32(0)
                       .u32(0)
                       .u32(summary.count)
                       .u64(kStart)
                       .u64(end_ns)
                       .text(counts.bytes()));
  out.raw(summary.chunks.bytes());
  out.record(0x02, McapBytes().u64(offset + 13).u64(0).u32(0)).raw(kMagic);
  return out.bytes();
}

void write_many(const std::filesystem::path& path) {
  constexpr unsigned kTopics = 100, kPerChunk = 3000, kMessages = 60'000;
  std::mt19937 random(1);
  McapBytes file, channels;
  for (unsigned id = 0; id < kTopics; ++id) channels.raw(channel_record(id).bytes());
  file.raw(kMagic).record(0x01, McapBytes().text("").text("somebody else")).raw(channels.bytes());
  Summary summary;
  std::string noise(330, 0);
  std::uint64_t time_ns = kStart;
  for (unsigned at = 0; at < kMessages; at += kPerChunk) {
    McapBytes records;
    std::vector<McapBytes> indexes(kTopics);
    const std::uint64_t start_ns = time_ns;
    for (unsigned i = 0; i < kPerChunk; ++i, time_ns += 1'000'000) {
      for (char& byte : noise) byte = static_cast<char>(random());
      const unsigned channel = i % kTopics;
      indexes[channel].u64(time_ns).u64(records.size());
      records.record(0x05, McapBytes().u16(channel).u32(at + i + 1).u64(time_ns).u64(time_ns).raw(noise));
    }
    const std::string packed = tests::foreign_frames(records.bytes(), {.compression = "zstd"}, random);
    const std::uint64_t offset = file.size();
    file.record(0x06, McapBytes()
                          .u64(start_ns)
                          .u64(time_ns - 1'000'000)
                          .u64(records.size())
                          .u32(0)
                          .text("zstd")
                          .u64(packed.size())
                          .raw(packed));
    const std::uint64_t bytes = file.size() - offset;
    McapBytes offsets;
    for (unsigned channel = 0; channel < kTopics; ++channel) {
      offsets.u16(channel).u64(file.size());
      file.record(0x07, McapBytes().u16(channel).text(indexes[channel].bytes()));
    }
    add_chunk(summary, start_ns, time_ns - 1'000'000, offset, bytes, records.size(), "zstd", offsets,
              file.size() - offset - bytes);
  }
  summary.messages = kMessages;
  std::ofstream(path, std::ios::binary) << file.bytes()
                                        << end_of(summary, channels, kTopics, time_ns - 1'000'000, file.size());
}

/// A file that grows, with holes that take no room on the disk.
class SparseFile {
 public:
  explicit SparseFile(const std::filesystem::path& path)
      : file_(::open(path.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0600)) {}
  ~SparseFile() { ::close(file_); }
  void put(const std::string& bytes) {
    if (::pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(at_)) != static_cast<ssize_t>(bytes.size()))
      std::perror("cannot write"), std::exit(1);
    at_ += bytes.size();
  }
  void skip(std::uint64_t bytes) { at_ += bytes; }
  std::uint64_t size() const { return at_; }

 private:
  int file_;
  std::uint64_t at_ = 0;
};

/// Each chunk has a small message of the first topic and one of the second topic whose data are a hole.
void write_huge(const std::filesystem::path& path) {
  constexpr std::uint64_t kHole = 32 << 20, kChunks = 320;
  SparseFile file(path);
  const McapBytes channels = McapBytes().raw(channel_record(0).bytes()).raw(channel_record(1).bytes());
  McapBytes head;
  head.raw(kMagic).record(0x01, McapBytes().text("").text("somebody else")).raw(channels.bytes());
  file.put(head.bytes());
  Summary summary;
  std::uint64_t time_ns = kStart;
  for (std::uint64_t i = 0; i < kChunks; ++i, time_ns += 1'000'000'000) {
    const auto message = [&](unsigned channel) {
      return McapBytes().u16(channel).u32(i + 1).u64(time_ns).u64(time_ns);
    };
    McapBytes records;
    records.record(0x05, message(0).raw("{\"i\": " + std::to_string(i) + "}"));
    const std::uint64_t second = records.size();
    records.u8(0x05).u64(22 + kHole).raw(message(1).bytes());
    const std::uint64_t offset = file.size(), unpacked = records.size() + kHole;
    const McapBytes fields = McapBytes().u64(time_ns).u64(time_ns).u64(unpacked).u32(0).text("").u64(unpacked);
    file.put(McapBytes().u8(0x06).u64(fields.size() + unpacked).raw(fields.bytes()).raw(records.bytes()).bytes());
    file.skip(kHole);
    const std::uint64_t bytes = file.size() - offset;
    McapBytes offsets, indexes;
    for (const unsigned channel : {0u, 1u}) {
      offsets.u16(channel).u64(file.size() + indexes.size());
      const McapBytes entries = McapBytes().u64(time_ns).u64(channel == 0 ? 0 : second);
      indexes.record(0x07, McapBytes().u16(channel).text(entries.bytes()));
    }
    file.put(indexes.bytes());
    add_chunk(summary, time_ns, time_ns, offset, bytes, unpacked, "", offsets, indexes.size());
  }
  summary.messages = 2 * kChunks;
  file.put(end_of(summary, channels, 2, time_ns - 1'000'000'000, file.size()));
}

/// Chunks of 60 MB of zeros that take a few kilobytes each, without indexes: a reader must unpack all of them.
void write_slow(const std::filesystem::path& path) {
  constexpr std::uint64_t kZeros = 60 << 20, kChunks = 1000;
  std::mt19937 random(1);
  SparseFile file(path);
  McapBytes head;
  head.raw(kMagic).record(0x01, McapBytes().text("").text("somebody else")).raw(channel_record(0).bytes());
  file.put(head.bytes());
  McapBytes records;
  records.record(0x05, McapBytes().u16(0).u32(1).u64(kStart).u64(kStart).raw(std::string(kZeros, 0)));
  const std::string packed = tests::foreign_frames(records.bytes(), {.compression = "zstd"}, random);
  const McapBytes chunk =
      McapBytes().u64(kStart).u64(kStart).u64(records.size()).u32(0).text("zstd").u64(packed.size()).raw(packed);
  for (std::uint64_t i = 0; i < kChunks; ++i) file.put(McapBytes().record(0x06, chunk).bytes());
}

}  // namespace

int main(int argc, char** argv) {
  const std::string mode = argc > 2 ? argv[1] : "";
  if (mode == "many" && argc == 3) return write_many(argv[2]), 0;
  if (mode == "huge" && argc == 3) return write_huge(argv[2]), 0;
  if (mode == "slow" && argc == 3) return write_slow(argv[2]), 0;
  if (argc != 5 || (mode != "write" && mode != "read"))
    return std::fprintf(stderr, "mcap_files: expected write|read FOLDER FIRST COUNT, or many|huge|slow FILE\n"), 2;
  const auto first = static_cast<std::uint32_t>(std::atoi(argv[3]));
  for (std::uint32_t seed = first; seed < first + static_cast<std::uint32_t>(std::atoi(argv[4])); ++seed) {
    const tests::GeneratedMcap made = tests::generate_mcap(seed);
    if (mode == "write")
      std::ofstream(file_of(argv[2], seed), std::ios::binary) << made.bytes;
    else
      std::printf(
          "%s\n",
          read(file_of(argv[2], seed), made).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
  }
  return 0;
}
