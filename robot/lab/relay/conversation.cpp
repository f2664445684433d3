#include "robot/lab/relay/conversation.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <mutex>
#include <utility>

#include "proto/foresight/camera.pb.h"
#include "proto/foxglove/CompressedImage.pb.h"
#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "robot/core/report.h"
#include "robot/image/image_codec.h"
#include "robot/logging/sessions/profile.h"
#include "robot/net/foxglove/from_client.h"

namespace robot::lab {
namespace {

using net::Opcode;
using Json = nlohmann::json;

constexpr std::uint32_t kFirstRounds = 8;  // the shortest round trip of these counts
constexpr std::uint64_t kRoundsEvery = 10 * kSecond;
constexpr std::uint64_t kAnswerNs = 3 * kSecond;
constexpr std::uint64_t kIntroductionNs =
    kSecond;                            // within this time a server has offered its services, clock_sync among them
constexpr std::size_t kMostTold = 100;  // sentences about one robot's items that are left out
constexpr std::string_view kJpeg = "/jpeg", kCompressedImage = "foxglove.CompressedImage";

/// Converts a foxglove.CompressedImage to our own message.
Result<std::string> as_image(std::string_view bytes) {
  foxglove::CompressedImage compressed;
  if (!compressed.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())) || compressed.format() != "jpeg")
    return Error{"expected a JPEG in a foxglove.CompressedImage, got " + std::to_string(bytes.size()) +
                 " bytes of something else"};
  const auto size = image::size_of_jpeg(compressed.data());
  if (!size) return size.failure();
  foresight::Image image;
  image.set_encoding(foresight::Image::ENCODING_JPEG);
  image.set_width(static_cast<std::uint32_t>(size->width));
  image.set_height(static_cast<std::uint32_t>(size->height));
  image.set_data(std::move(*compressed.mutable_data()));
  return image.SerializeAsString();
}

std::string text_at(const std::map<std::string, std::string>& texts, const char* key) {
  const auto found = texts.find(key);
  return found == texts.end() ? std::string() : found->second;
}

std::string text_at(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

}  // namespace

void Conversation::update(const std::function<void(LinkStatus&)>& change) {
  const std::lock_guard guard(link_.lock_);
  change(link_.status_);
}

Result<void> Conversation::hear(const net::WebSocketClient::Message& message) {
  return message.opcode == Opcode::text ? hear_text(message.payload) : hear_binary(message.payload);
}

Result<std::uint64_t> Conversation::go_on() {
  const std::uint64_t now_ns = monotonic_ns();
  if (sent_ns_ != 0 && now_ns >= asked_ns_ + kAnswerNs) {
    if (!agreed_) return Error{"its clock cannot be measured: clock_sync does not answer within 3 s"};
    sent_ns_ = 0;
    next_call_ns_ = now_ns + kRoundsEvery;
  }
  if (clock_service_ && sent_ns_ == 0 && now_ns >= next_call_ns_)
    if (Result<void> asked = ask_time(); !asked) return asked.failure();
  if (!agreed_ && introduced_ && !clock_service_ && now_ns >= began_ns_ + kIntroductionNs)
    if (Result<void> agreed = agree(); !agreed) return agreed.failure();
  if (!agreed_ && !clock_service_) return std::max(began_ns_ + kIntroductionNs, now_ns + kMillisecond);
  return sent_ns_ == 0 && clock_service_ ? next_call_ns_ : now_ns + kSecond;
}

Result<void> Conversation::hear_text(std::string_view text) {
  auto said = net::foxglove::parse_server_text(text);
  if (!said) {
    leave_out(said.error());
    return {};
  }
  for (const std::string& problem : said->problems) leave_out(problem);
  if (said->info) introduce(*said->info);
  for (auto& channel : said->channels) offered_.push_back(std::move(channel));
  for (const auto& service : said->services)
    if (service.name == "clock_sync") clock_service_ = service.id;
  if (const auto& failed = said->failed_call;
      failed && sent_ns_ != 0 && failed->service == clock_service_ && failed->call == call_)
    return give_up_clock("clock_sync: expected an answer, got '" + failed->message.substr(0, 100) + "'");
  if (agreed_ && !said->channels.empty()) return subscribe();
  return {};
}

/// Reports an item that is left out, once in the life of the link.
void Conversation::leave_out(const std::string& problem) {
  std::set<std::string>& told = link_.past_->told;
  if (told.size() < kMostTold && told.insert(problem).second)
    report(Level::warning, "relay", link_.options_.robot.name + ": " + problem + "; it is left out");
}

void Conversation::introduce(const net::foxglove::ServerInfo& info) {
  const RobotLink::Past& past = *link_.past_;
  // a new session id within a connection is another time line of the same run
  if (!introduced_) new_run_ = info.session_id.empty() || info.session_id != past.session;
  session_ = info.session_id;
  introduced_ = true;
  hears_time_ = std::ranges::find(info.capabilities, "time") != info.capabilities.end();
  robot_ = text_at(info.metadata, "robots");
  update([&](LinkStatus& status) { status.robot = robot_; });
  const std::string rules = text_at(info.metadata, "rules");
  if (!rules.empty() && link_.options_.on_rules) link_.options_.on_rules(rules);
  if (!link_.claims_.introduce(robot_, link_.id_))
    report(Level::warning, "relay",
           link_.options_.robot.name + ": " + robot_ + " is relayed from another address already");
}

Result<void> Conversation::hear_binary(std::string_view bytes) {
  const auto answer = net::foxglove::parse_service_answer(bytes);
  const auto data = net::foxglove::parse_message_data(bytes);
  for (const std::string& problem : {answer ? "" : answer.error(), data ? "" : data.error()})
    if (!problem.empty()) leave_out(problem);
  if (answer && *answer) {
    const bool waited_for = sent_ns_ != 0 && (*answer)->service == clock_service_ && (*answer)->call == call_;
    return waited_for ? hear_time((*answer)->payload) : Result<void>();
  }
  return data && *data ? take(**data) : Result<void>();
}

/// Calls clock_sync. The request carries our last measurement, so that the robot records it too.
Result<void> Conversation::ask_time() {
  sent_ns_ = link_.clock_.now_ns();
  asked_ns_ = monotonic_ns();
  Json request = {{"sent_ns", std::to_string(sent_ns_)}};
  if (last_) {
    request["offset_ns"] = std::to_string(-last_->offset_ns);
    request["round_trip_ns"] = std::to_string(2 * last_->error_ns);
  }
  net::foxglove::ServiceCall call;
  call.service = *clock_service_;
  call.call = ++call_;
  call.encoding = "json";
  call.payload = request.dump();
  return client_.send(Opcode::binary, to_bytes(call));
}

Result<void> Conversation::hear_time(std::string_view answer) {
  const std::uint64_t returned_ns = link_.clock_.now_ns(), sent_ns = std::exchange(sent_ns_, 0);
  const Result<Json> json = parse_json(answer);
  const std::string text = json && json->is_object() ? text_at(*json, "received_ns") : std::string();
  std::uint64_t theirs_ns = 0;
  if (const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), theirs_ns);
      error != std::errc() || end != text.data() + text.size())
    return give_up_clock("clock_sync: expected 'received_ns', got " + std::string(answer.substr(0, 100)));

  last_ = offset_by(sent_ns, theirs_ns, returned_ns);
  best_ = better(best_, *last_);
  next_call_ns_ = monotonic_ns() + (++rounds_ < kFirstRounds ? 0 : kRoundsEvery);
  if (rounds_ < kFirstRounds) return {};
  if (!agreed_) return agree();
  link_.on_clock_(robot_, *last_);
  const std::int64_t moved_ns = last_->offset_ns + link_.past_->shift_ns;
  static Throttle throttle;
  if (static_cast<std::uint64_t>(std::abs(moved_ns)) > last_->error_ns + 2 * kAgreeNs)
    throttle.report(Level::warning, "relay",
                    link_.status().name + ": its clock has drifted and is " + to_text(*last_) +
                        "; its times are shifted by " +
                        std::to_string(link_.past_->shift_ns / static_cast<std::int64_t>(kMillisecond)) + " ms");
  return {};
}

/// Goes on without measurements of the clock, as with a server that does not offer clock_sync.
Result<void> Conversation::give_up_clock(const std::string& problem) {
  leave_out(problem);
  clock_service_.reset();
  sent_ns_ = 0;
  return agreed_ ? Result<void>() : agree();
}

/// Decides on the shift of times, and begins to carry messages. Called when the clocks are compared or cannot be.
Result<void> Conversation::agree() {
  RobotLink::Past& past = *link_.past_;
  std::int64_t shift_ns = 0;
  if (best_) {
    const auto found = correction(*best_, link_.options_.most_offset_ns, "its");
    if (!found) {
      update([&](LinkStatus& status) {
        status.state = LinkStatus::State::refused;
        status.clock = best_;
      });
      return found.failure();
    }
    // within one run of the robot a new measurement does not change the shift
    const bool as_before =
        static_cast<std::uint64_t>(std::abs(best_->offset_ns + past.shift_ns)) <= best_->error_ns + kAgreeNs;
    shift_ns = !new_run_ && as_before ? past.shift_ns : *found;
    link_.on_clock_(robot_, *best_);
  }
  // set only here: the channels have not seen the new run if a connection ended earlier
  past.session = session_;
  past.shift_ns = shift_ns;
  agreed_ = true;
  for (auto& [topic, channel] : past.carried) channel.connected(new_run_, shift_ns);
  update([&](LinkStatus& status) {
    status.state = LinkStatus::State::connected;
    ++status.connections;
    status.clock = best_;
    status.shift_ns = shift_ns;
    status.problem.clear();
  });
  const std::string clock = !best_          ? "its clock cannot be measured"
                            : shift_ns == 0 ? "its clock agrees with ours"
                                            : "its clock is " + to_text(*best_) + ": its times are shifted";
  report(Level::info, "relay",
         link_.options_.robot.name + ": connected to " + (robot_.empty() ? "it" : robot_) + "; " + clock);
  return subscribe();
}

/// Returns the channel that takes the messages of an offered channel, or nothing if they are not carried.
std::optional<memory::ChannelInfo> Conversation::wanted(const net::foxglove::Advertised& offered, bool& jpeg) const {
  const Pictures pictures = link_.options_.pictures;
  const std::string& topic = offered.info.topic;
  const std::vector<std::string>& objects = link_.options_.objects;
  if (!objects.empty() && std::ranges::find(objects, memory::object_name(topic).object) == objects.end()) return {};
  jpeg = text_at(offered.metadata, "derived") == "true";
  if (jpeg) {
    if (pictures != Pictures::jpeg || offered.info.schema.name != kCompressedImage || !topic.ends_with(kJpeg))
      return {};
    const auto image = link_.past_->images.find(topic.substr(0, topic.size() - kJpeg.size()));
    if (image == link_.past_->images.end()) return {};
    return image->second;
  }
  if (offered.info.schema.name != logging::kImageSchema || pictures == Pictures::raw) return offered.info;
  link_.past_->images[topic] = offered.info;
  return {};
}

/// Returns the channel of that topic in this process, created if it is new. Returns null if another robot carries the
/// topic, or if there is a channel with another schema.
CarriedChannel* Conversation::channel_for(const memory::ChannelInfo& info) {
  RobotLink::Past& past = *link_.past_;
  if (!link_.claims_.claim(info.topic, link_.id_)) return nullptr;
  std::shared_ptr<memory::Channel> channel = link_.channels_.find(info.topic);
  if (!channel) {
    auto made = std::make_shared<memory::RawChannel>(info, link_.clock_);
    channel = link_.channels_.add(made) ? made
                                        : link_.channels_.find(info.topic);  // another link may have added it meanwhile
  }
  const auto raw = std::dynamic_pointer_cast<memory::RawChannel>(channel);
  if (!raw || raw->info().schema != info.schema || raw->info().message_encoding != info.message_encoding) {
    report(Level::warning, "relay",
           link_.options_.robot.name + ": " + info.topic +
               (raw ? " has another schema than before: it is left out until the relay is restarted"
                    : " is left out: the relay has its own topic of this name"));
    return nullptr;
  }
  const auto [at, is_new] = past.carried.try_emplace(info.topic, CarriedChannel(raw));
  if (is_new) at->second.connected(new_run_, past.shift_ns);
  return &at->second;
}

Result<void> Conversation::subscribe() {
  net::foxglove::Subscribe request;
  for (const net::foxglove::Advertised& offered : std::exchange(offered_, {})) {
    bool jpeg = false;
    const auto info = wanted(offered, jpeg);
    CarriedChannel* const channel = info ? channel_for(*info) : nullptr;
    if (!channel) continue;
    subscriptions_[++last_subscription_] = {.to = channel, .jpeg = jpeg};
    request.subscriptions.push_back({last_subscription_, offered.id});
  }
  return request.subscriptions.empty() ? Result<void>() : client_.send(Opcode::text, to_text(request));
}

Result<void> Conversation::take(const net::foxglove::MessageData& data) {
  const auto found = subscriptions_.find(data.subscription);
  if (found == subscriptions_.end()) return {};
  const auto [to, jpeg] = found->second;
  if (!link_.claims_.holds(to->info().topic, link_.id_)) {
    // the robot that owns the topic has connected
    subscriptions_.erase(found);
    return client_.send(Opcode::text, to_text(net::foxglove::Unsubscribe{{data.subscription}}));
  }
  Arrived message{.capture_ns = data.log_time_ns, .published = data.published, .bytes = {}};
  if (jpeg) {
    auto image = as_image(data.payload);
    if (!image) {
      static Throttle throttle;
      throttle.report(Level::warning, "relay",
                      link_.options_.robot.name + ": " + to->info().topic + ": " + image.error());
      return {};
    }
    message.bytes = std::move(*image);
    message.published.reset();  // the JPEG stream's own number, which starts anew for each subscriber
  } else {
    message.bytes = data.payload;
  }
  const std::uint64_t lost = to->enter(std::move(message));
  update([&](LinkStatus& status) {
    ++status.received;
    status.lost += lost;
  });
  return {};
}

}  // namespace robot::lab
