#include "robot/truth/sensor/pcl_camera.h"

#include <charconv>
#include <optional>
#include <string>

#include "robot/core/text.h"

namespace robot::truth {
namespace {

/// Returns the text between <tag> and </tag>, or nothing if there is no such pair.
std::optional<std::string_view> element(std::string_view xml, const std::string& tag) {
  const std::size_t start = xml.find("<" + tag + ">");
  if (start == std::string_view::npos) return std::nullopt;
  const std::string_view rest = xml.substr(start + tag.size() + 2);
  const std::size_t end = rest.find("</" + tag + ">");
  if (end == std::string_view::npos) return std::nullopt;
  return rest.substr(0, end);
}

/// Reads the number between <tag> and </tag> into `number`.
Result<void> read_element(std::string_view xml, const char* tag, double least, double most, double& number) {
  const std::string_view text = trimmed(element(xml, tag).value_or(""));
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  // not-a-number fails both comparisons
  if (error != std::errc() || end != text.data() + text.size() || !(number >= least && number <= most))
    return Error{formatted("<%s> within <depth> must be a number from %g to %g, got \"", tag, least, most) +
                 printable(text, 40) + "\""};
  return {};
}

}  // namespace

Result<PclCamera> parse_pcl_camera(std::string_view xml) {
  const std::optional<std::string_view> depth = element(xml, "depth");
  if (!depth) return Error{"expected intrinsics within <depth> and </depth>, got none"};
  PclCamera camera;
  const auto read = [&](const char* tag, double least, double most, double& number) {
    return read_element(*depth, tag, least, most, number);
  };
  if (const auto done = read("focal_length_x", 1, 100000, camera.focal_x); !done) return done.failure();
  if (const auto done = read("focal_length_y", 1, 100000, camera.focal_y); !done) return done.failure();
  if (const auto done = read("principal_point_x", -100000, 100000, camera.centre_x); !done) return done.failure();
  if (const auto done = read("principal_point_y", -100000, 100000, camera.centre_y); !done) return done.failure();
  if (element(*depth, "z_multiplication_factor"))
    if (const auto done = read("z_multiplication_factor", 1e-6, 1, camera.unit); !done) return done.failure();
  return camera;
}

}  // namespace robot::truth
