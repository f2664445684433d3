#include "robot/truth/sensor/fakenect.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string>

#include "robot/core/clock.h"
#include "robot/core/files.h"
#include "robot/core/text.h"
#include "robot/truth/sensor/kinect.h"
#include "robot/truth/sensor/name_time.h"
#include "robot/truth/sensor/netpbm.h"
#include "robot/truth/sensor/recording.h"

namespace robot::truth {
namespace {

constexpr std::size_t kMaxIndexBytes = 64'000'000;  // seven hours of depth and colour
constexpr std::uint64_t kSameMoment_ns = 50 * kMillisecond;

struct FakenectColour {
  std::uint64_t capture_ns = 0;
  std::string name;
};

/// The files of a recording.
struct FakenectFolder {
  std::filesystem::path path;
  std::vector<std::string> depths;      // in the order of the index; a name may be damaged
  std::vector<FakenectColour> colours;  // by time

  Result<DepthFrame> read(std::size_t number) const;
  Result<ColourImage> colour_at(std::uint64_t capture_ns) const;
};

std::uint64_t distance_ns(std::uint64_t a, std::uint64_t b) { return a > b ? a - b : b - a; }

/// Returns the colour image of this moment, or an empty one if the recording has none.
Result<ColourImage> FakenectFolder::colour_at(std::uint64_t capture_ns) const {
  const auto nearer = [&](const FakenectColour& a, const FakenectColour& b) {
    return distance_ns(a.capture_ns, capture_ns) < distance_ns(b.capture_ns, capture_ns);
  };
  auto after =
      std::lower_bound(colours.begin(), colours.end(), capture_ns,
                       [](const FakenectColour& colour, std::uint64_t time) { return colour.capture_ns < time; });
  const auto first = after == colours.begin() ? after : after - 1;
  const auto last = after == colours.end() ? after : after + 1;
  const auto nearest = std::min_element(first, last, nearer);
  if (nearest == last || distance_ns(nearest->capture_ns, capture_ns) > kSameMoment_ns) return ColourImage{};
  return read_image(path / nearest->name, read_ppm);
}

Result<DepthFrame> FakenectFolder::read(std::size_t number) const {
  const Result<FakenectName> name = parse_fakenect_name(depths[number]);
  if (!name) return name.failure((path / "INDEX.txt").string());
  const Result<GreyImage> disparities = read_image(path / depths[number], read_fakenect_pgm);
  if (!disparities) return disparities.failure();
  const Result<ColourImage> colour = colour_at(name->capture_ns);
  if (!colour) return colour.failure();
  Result<DepthFrame> frame = kinect_frame(*disparities, colour->rgb.empty() ? nullptr : &*colour);
  if (!frame) return frame.failure((path / depths[number]).string());
  frame->capture_ns = name->capture_ns;
  return frame;
}

FakenectFolder sorted_files(const std::filesystem::path& folder, std::string_view index) {
  FakenectFolder files{.path = folder};
  for (const std::string_view line : parse_fakenect_index(index)) {
    const Result<FakenectName> name = parse_fakenect_name(line);
    // a damaged line stands for a depth image, so that the person learns of it
    if (!name || name->kind == 'd')
      files.depths.emplace_back(line);
    else if (name->kind == 'r')
      files.colours.push_back({name->capture_ns, std::string(line)});
  }
  std::stable_sort(files.colours.begin(), files.colours.end(),
                   [](const FakenectColour& a, const FakenectColour& b) { return a.capture_ns < b.capture_ns; });
  return files;
}

}  // namespace

Result<FakenectName> parse_fakenect_name(std::string_view name) {
  struct Kind {
    std::string_view start, end;
  };
  constexpr std::array<Kind, 3> kinds = {{{"d-", ".pgm"}, {"r-", ".ppm"}, {"a-", ".dump"}}};
  const bool known = std::any_of(kinds.begin(), kinds.end(), [name](const Kind& kind) {
    return name.starts_with(kind.start) && name.ends_with(kind.end);
  });
  const auto time = known ? time_in_name(name.substr(2)) : std::nullopt;
  // a slash would lead out of the folder
  if (!time || name.find('/') != std::string_view::npos)
    return Error{"expected a name such as d-1294851097.453589-2279103905.pgm, got \"" + printable(name, 60) + "\""};
  return FakenectName{name.front(), *time};
}

std::vector<std::string_view> parse_fakenect_index(std::string_view text) {
  std::vector<std::string_view> names;
  for (const std::string_view line : split(text, "\n"))
    if (const std::string_view name = trimmed(line); !name.empty()) names.push_back(name);
  return names;
}

Result<std::unique_ptr<DepthSource>> open_fakenect(const std::string& address, const std::filesystem::path& folder) {
  const Result<std::string> index = read_file(folder / "INDEX.txt", kMaxIndexBytes);
  if (!index) return index.failure("expected a recording of fakenect-record");
  const auto files = std::make_shared<const FakenectFolder>(sorted_files(folder, *index));
  if (files->depths.empty())
    return Error{(folder / "INDEX.txt").string() + ": expected names of depth images, got none"};
  return std::unique_ptr<DepthSource>(std::make_unique<Recording>(
      address, files->depths.size(), [files](std::size_t number) { return files->read(number); }));
}

}  // namespace robot::truth
