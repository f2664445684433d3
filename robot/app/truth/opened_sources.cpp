#include "robot/app/truth/opened_sources.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <utility>

#include "robot/app/truth/finder.h"
#include "robot/app/truth/simulated_scene.h"
#include "robot/bridge/to_messages.h"
#include "robot/truth/sensor/open_source.h"
#include "robot/truth/synthetic/sensor_poses.h"
#include "robot/truth/synthetic/synthetic_sensor.h"
#include "robot/truth/tags/tag_watcher.h"
#include "sim/io/rules.h"

namespace robot::app {
namespace {

constexpr double kBallRadius = 0.05;  // [m] of the league's ball since 2016

/// The sides of the field on which synthetic sensors stand, by their addresses.
struct Mast {
  const char* address;
  double side;
};
constexpr Mast kMasts[] = {{"synthetic", -1}, {"synthetic:2", 1}};

const Mast* mast_at(const std::string& address) {
  const auto found =
      std::find_if(std::begin(kMasts), std::end(kMasts), [&](const Mast& mast) { return address == mast.address; });
  return found == std::end(kMasts) ? nullptr : found;
}

/// A recording whose answers up to its first image have been read before their turn.
class PeekedSource final : public truth::DepthSource {
 public:
  using Answer = Result<std::optional<truth::DepthFrame>>;

  explicit PeekedSource(std::unique_ptr<truth::DepthSource> source) : source_(std::move(source)) {
    do ahead_.push_back(source_->next());
    while (!ahead_.back());
  }

  /// Returns the capture time of the first image, or nothing of a recording without a usable one.
  std::optional<std::uint64_t> first_ns() const {
    const Answer& first = ahead_.back();
    return *first ? std::optional((*first)->capture_ns) : std::nullopt;
  }

  Answer next() override {
    if (ahead_.empty()) return source_->next();
    Answer answer = std::move(ahead_.front());
    ahead_.pop_front();
    return answer;
  }
  const std::string& address() const override { return source_->address(); }
  bool live() const override { return source_->live(); }

 private:
  const std::unique_ptr<truth::DepthSource> source_;
  std::deque<Answer> ahead_;  // Errors of damaged images, then the first image or the end
};

}  // namespace

std::string describe_all_sources() {
  return "  synthetic        a depth camera that looks at a simulated game; synthetic:2 is on the other side\n" +
         truth::describe_sources() + truth::tags::describe_tags();
}

OpenedSources::OpenedSources(const TruthOptions& options, const std::vector<std::string>& sensors,
                             const sim::field::Rules& rules)
    : options_(options),
      addresses_(sensors),
      rules_(rules),
      ball_radius_(options.ball_radius > 0 ? options.ball_radius
                   : rules.ball_radius > 0 ? double{rules.ball_radius}
                                           : kBallRadius) {}

Result<OpenedSources> OpenedSources::open(const TruthOptions& options, const std::vector<std::string>& sensors) {
  if (sensors.size() > truth::kMostSensors)
    return Error{"--source: expected at most " + std::to_string(truth::kMostSensors) + " sensors, got " +
                 std::to_string(sensors.size())};
  const auto rules = sim::io::load_rules(options.rules);
  if (!rules) return rules.failure("--rules");
  OpenedSources opened(options, sensors, *rules);
  const auto synthetic = std::count_if(sensors.begin(), sensors.end(),
                                       [](const std::string& address) { return mast_at(address) != nullptr; });
  if (synthetic > 0 && synthetic < static_cast<std::ptrdiff_t>(sensors.size()))
    return Error{"--source: expected synthetic sensors only, or none"};
  Result<void> all = synthetic > 0 ? opened.open_synthetic() : opened.open_recordings_and_sensors();
  if (!all) return all.failure("--source");
  return opened;
}

Result<void> OpenedSources::open_synthetic() {
  clock_ = std::make_unique<SessionClock>();
  const std::uint64_t begin_ns = clock_->now_ns();
  auto game = WatchedGame::open({.matchup = {.rules = options_.rules,
                                             .strategies = {options_.home, options_.away},
                                             .models = {options_.models, options_.models}},
                                 .seed = options_.seed,
                                 .begin_ns = begin_ns});
  if (!game) return game.failure();
  game_ = std::move(*game);
  ball_radius_ = double{game_->ball_radius()};
  for (const std::string& address : addresses_) {
    const truth::SensorPose pose = truth::mast(rules_.field, mast_at(address)->side);
    auto scene_at = [&looked = *game_, width = double{rules_.field.width}, radius = ball_radius_](
                        std::uint64_t capture_ns) { return scene_of(looked.at(capture_ns), radius, width); };
    const truth::Surroundings surroundings{.field = rules_.field};
    const truth::SyntheticOptions at{
        .address = address, .first_capture_ns = begin_ns, .now_ns = [clock = clock_.get()] { return clock->now_ns(); }};
    auto source = std::make_unique<truth::SyntheticSensor>(pose, surroundings, std::move(scene_at), at);
    const bool exact = options_.calibration.empty();
    sources_.push_back(
        {.source = std::move(source), .placed = exact ? std::optional(PlacedSensor{.pose = pose}) : std::nullopt});
  }
  return {};
}

Result<void> OpenedSources::open_recordings_and_sensors() {
  std::uint64_t first_ns = std::numeric_limits<std::uint64_t>::max();
  for (const std::string& address : addresses_) {
    auto source = truth::open_source(address);
    if (!source) return source.failure();
    if (!sources_.empty() && sources_.front().source->live() != (*source)->live())
      return Error{"expected live sensors only, or recordings only, got " + addresses_.front() + " and " + address};
    if (!(*source)->live()) {
      auto peeked = std::make_unique<PeekedSource>(std::move(*source));
      first_ns = std::min(first_ns, peeked->first_ns().value_or(first_ns));
      *source = std::move(peeked);
    }
    sources_.push_back({.source = std::move(*source), .placed = {}});
  }
  live_ = sources_.empty() || sources_.front().source->live();
  const bool recorded = first_ns != std::numeric_limits<std::uint64_t>::max();
  clock_ = recorded ? std::make_unique<SessionClock>(first_ns - monotonic_ns()) : std::make_unique<SessionClock>();
  return {};
}

void OpenedSources::show_game_in(memory::MemoryObject<foresight::GroundTruth>& simulated) {
  if (!game_) return;
  game_->tell_ticks([&simulated](const sim::World& world, std::uint64_t capture_ns) {
    auto message = simulated.draft();
    bridge::to_proto(world, bridge::TeamNumbers{}, *message);
    simulated.write(std::move(message), capture_ns);
  });
}

Result<truth::DepthFrame> OpenedSources::first_image(std::uint64_t longest_ns) {
  truth::DepthSource& source = *sources_.front().source;
  const std::uint64_t end_ns = monotonic_ns() + longest_ns;
  while (true) {
    auto frame = source.next();
    if (frame && *frame) return std::move(**frame);
    if (frame) return Error{source.address() + " has no image that can be read"};
    if (source.live() && monotonic_ns() > end_ns) return frame.failure();
  }
}

std::vector<std::unique_ptr<SensorWatch>> OpenedSources::watches(const Calibrations& calibrations, TruthWriter& writer,
                                                                 const std::optional<truth::tags::TagPlan>& tags) {
  truth::DetectorOptions detection{.ball_radius = ball_radius_, .orange_ball = options_.orange_ball};
  if (game_) detection.colour_shift_x = 1;  // the colours of a synthetic sensor are shifted by a pixel
  const auto ball = options_.orange_ball ? std::optional(truth::tags::BallLook{.radius = ball_radius_}) : std::nullopt;
  std::vector<std::unique_ptr<SensorWatch>> watches;
  for (Opened& opened : sources_) {
    const bool by_tags = truth::is_ordinary_camera(opened.source->address());
    const bool paced = game_ != nullptr || !opened.source->live();
    watches.push_back(std::make_unique<SensorWatch>(
        SensorWatchOptions{.index = watches.size(),
                           .finder = by_tags ? tag_finder(*tags, ball) : depth_finder(rules_.field, detection),
                           .paced = paced},
        std::move(opened.source), *clock_, calibrations, writer));
    if (opened.placed) watches.back()->place(*opened.placed);
  }
  return watches;
}

}  // namespace robot::app
