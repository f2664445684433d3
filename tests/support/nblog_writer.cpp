#include "tests/support/nblog_writer.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>

#include <bit>

namespace tests {
namespace {

std::string big_endian(std::size_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
  return bytes;
}

}  // namespace

void NblogWriter::block(std::string_view type, std::string_view from, std::uint64_t when_us, std::string_view values,
                        std::string_view bytes) {
  contents_ += " ((type " + std::string(type) + ") (from " + std::string(from) + ") (when " + std::to_string(when_us) +
               ") (iindex 151) (nbytes " + std::to_string(bytes.size()) + ") " + std::string(values) + ")";
  payload_ += bytes;
}

std::string NblogWriter::file() const {
  const std::string header = "(nblog (created robot \"17.09.2009 00:18:01\") (version 7) (contents" + contents_ +
                             ") (host_type V4ROBOT))" + std::string(1, '\0');
  return big_endian(header.size()) + header + big_endian(payload_.size()) + payload_;
}

std::string float_fields(const std::vector<float>& values) {
  std::string bytes;
  google::protobuf::io::StringOutputStream buffer(&bytes);
  google::protobuf::io::CodedOutputStream stream(&buffer);
  for (std::size_t i = 0; i < values.size(); ++i) {
    stream.WriteTag(static_cast<std::uint32_t>(i + 1) << 3 | 5);
    stream.WriteLittleEndian32(std::bit_cast<std::uint32_t>(values[i]));
  }
  stream.Trim();
  return bytes;
}

}  // namespace tests
