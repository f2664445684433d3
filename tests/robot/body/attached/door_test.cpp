// A team's process connects to the door. Its messages enter memory, and it can read memory. Wrong input harms no other
// process.
#include "robot/body/attached/door.h"

#include <fcntl.h>
#include <google/protobuf/descriptor.pb.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <ctime>
#include <functional>
#include <mutex>
#include <random>
#include <string>

#include "proto/foresight/live_parameters.pb.h"
#include "robot/client/foresight.h"
#include "robot/client/foresight_fields.h"
#include "robot/client/foresight_parameters.h"
#include "robot/client/foresight_what_if.h"
#include "robot/memory/memory.h"
#include "robot/memory/schema.h"
#include "tests/support/eventually.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_channel.h"
#include "tests/support/used_up_descriptors.h"

namespace robot::body {
namespace {

using Writer = std::unique_ptr<ForesightWriter, decltype(&foresight_close)>;
using Reader = std::unique_ptr<ForesightReader, decltype(&foresight_end)>;

struct TheDoor : ::testing::Test {
  TheDoor() {
    EXPECT_TRUE(list(memory, channels));
    open();
  }

  void open(std::uint64_t first_frame_ns = DoorOptions().first_frame_ns) {
    auto opened = Door::open({.path = path,
                              .robot = "14/2",
                              .first_frame_ns = first_frame_ns,
                              .on_end =
                                  [this](const std::string& topic) {
                                    const std::lock_guard guard(ended_lock);
                                    ended.push_back(topic);
                                  }},
                             clock, channels, board);
    ASSERT_TRUE(opened) << opened.error();
    door = std::move(*opened);
  }

  Writer announce(const char* topic, const char* type, const std::string& schema = "",
                  const char* encoding = "protobuf") {
    const ForesightObject object{.topic = topic,
                                 .type = type,
                                 .message_encoding = encoding,
                                 .schema_encoding = encoding,
                                 .schema = schema.empty() ? nullptr : schema.data(),
                                 .schema_bytes = schema.size(),
                                 .delivery = FORESIGHT_FIFO};
    return {foresight_announce_as(&object, path.c_str()), &foresight_close};
  }
  Reader want(const char* topic) { return {foresight_want_from(topic, path.c_str()), &foresight_end}; }

  static int write(const Writer& writer, const std::string& bytes, std::uint64_t capture_ns = 1) {
    return foresight_write(writer.get(), capture_ns, bytes.data(), bytes.size());
  }

  memory::VersionPtr newest(const std::string& topic) {
    const auto channel = channels.find(topic);
    return channel ? channel->newest() : nullptr;
  }

  /// Waits for the next message of `reader` and returns it.
  static std::string read(const Reader& reader, ForesightMessage& message) {
    while (!foresight_read(reader.get(), &message)) foresight_wait(reader.get(), 100);
    return {static_cast<const char*>(message.bytes), message.size};
  }

  void connect(const FileDescriptor& socket) const {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.native().copy(address.sun_path, sizeof address.sun_path - 1);
    EXPECT_EQ(::connect(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  }

  /// Connects and sends `bytes`, with `file`, then disconnects or stays.
  FileDescriptor stranger(std::string_view bytes, int file = -1) {
    FileDescriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    connect(socket);
    iovec piece{.iov_base = const_cast<char*>(bytes.data()), .iov_len = bytes.size()};
    msghdr message{};
    message.msg_iov = &piece;
    message.msg_iovlen = 1;
    alignas(cmsghdr) char extra[CMSG_SPACE(sizeof file)] = {};
    if (file >= 0) {
      message.msg_control = extra;
      message.msg_controllen = sizeof extra;
      cmsghdr* head = CMSG_FIRSTHDR(&message);
      head->cmsg_level = SOL_SOCKET;
      head->cmsg_type = SCM_RIGHTS;
      head->cmsg_len = CMSG_LEN(sizeof file);
      std::memcpy(CMSG_DATA(head), &file, sizeof file);
    }
    if (!bytes.empty()) ::sendmsg(socket.get(), &message, MSG_NOSIGNAL);
    return socket;
  }

  /// Returns the sentence with which the door refuses `client`.
  static std::string refusal(const FileDescriptor& client) {
    logging::FrameParser parser;
    char block[4096];
    for (ssize_t n = 0; (n = ::read(client.get(), block, sizeof block)) > 0;) {
      parser.feed({block, static_cast<std::size_t>(n)});
      for (auto frame = parser.next(); frame && *frame; frame = parser.next())
        if (const auto* refused = std::get_if<logging::Refused>(&**frame)) return refused->sentence;
    }
    return "";
  }

  /// Checks that a correct process can still write and read.
  void expect_all_well() {
    const Writer ball = announce("ball", "foresight.Ball");
    foresight::Ball message;
    message.set_x(++last_x);
    // retries: at first the door may still be full of other connections
    ASSERT_TRUE(tests::eventually([&] {
      write(ball, message.SerializeAsString());
      return memory->ball.read() && memory->ball.read()->value().x() == last_x;
    }));
  }

  const tests::TemporaryFolder folder;
  const std::filesystem::path path = folder / "door";
  const SessionClock clock{5 * kSecond};
  const std::shared_ptr<memory::Memory> memory = std::make_shared<memory::Memory>("14/2", clock);
  memory::Channels channels;
  logging::LoggingBoard board;
  std::mutex ended_lock;
  std::vector<std::string> ended;  // topics that no process writes any more
  std::unique_ptr<Door> door;
  float last_x = 0;
};

/// Returns the processor time of all threads of this process.
std::uint64_t process_cpu_ns() {
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<std::uint64_t>(time.tv_sec) * kSecond + static_cast<std::uint64_t>(time.tv_nsec);
}

std::string integer(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text.push_back(i < 8 ? static_cast<char>(value >> (8 * i)) : char{0});
  return text;
}

std::string frame(int kind, const std::string& body) {
  return integer(static_cast<std::uint64_t>(kind), 1) + integer(body.size(), 4) + body;
}

std::string ball_channel() {
  return logging::channel_frame(
      {.topic = "ball", .schema = {.name = "foresight.Ball", .encoding = "protobuf", .bytes = ""}});
}

/// A process with one parameter of each type, and this test as the runtime that answers it.
struct LiveParametersOfC : TheDoor {
  LiveParametersOfC() {
    EXPECT_TRUE(channels.add(told));
    EXPECT_TRUE(told->write_bytes("", 1));
    add();
  }
  ~LiveParametersOfC() override { foresight_end_parameters(parameters); }

  void add() {
    static const char* const kGaits[] = {"slow", "fast"};
    parameters = foresight_parameters("walk", path.c_str());
    foresight_add_number(parameters, "height", &height, 0, 0.05, "m", "Height of a foot.");
    foresight_add_whole(parameters, "steps", &steps, 0, 0, "", "");
    foresight_add_yes_no(parameters, "arms", &arms, "");
    foresight_add_text(parameters, "name", name, sizeof name, "");
    foresight_add_choice(parameters, "gait", &gait, kGaits, 2, "");
    foresight_add_button(parameters, "kick", &kicks, "Kicks once.");
  }

  /// Polls until the process has announced something new, and returns it.
  foresight::LiveParameters announced() {
    EXPECT_TRUE(tests::eventually([&] {
      foresight_poll_parameters(parameters);
      const auto version = newest("/14/2/live_parameters/walk");
      return version && version->publish_ns() > last_announced_ns;
    }));
    const auto version = newest("/14/2/live_parameters/walk");
    last_announced_ns = version->publish_ns();
    foresight::LiveParameters message;
    EXPECT_TRUE(message.ParseFromString(std::string(version->bytes())));
    return message;
  }

  void tell(foresight::LiveParameters message, const std::string& process = "walk.") {
    for (auto& parameter : *message.mutable_parameter()) parameter.set_name(process + parameter.name());
    EXPECT_TRUE(told->write_bytes(message.SerializeAsString(), 1));
  }

  /// Polls until a variable changes, and returns the number of changes.
  int changes() {
    int changed = 0;
    EXPECT_TRUE(tests::eventually([&] { return (changed = foresight_poll_parameters(parameters)) > 0; }));
    return changed;
  }

  const std::shared_ptr<memory::RawChannel> told = std::make_shared<memory::RawChannel>(
      memory::ChannelInfo{.topic = "/14/2/live_parameters",
                          .schema = memory::schema_of(*foresight::LiveParameters::descriptor())},
      clock);
  double height = 0.02;
  int steps = -3, arms = 5, gait = 1, kicks = 9;
  char name[8] = "ab";
  ForesightParameters* parameters = nullptr;
  std::uint64_t last_announced_ns = 0;
};

TEST_F(LiveParametersOfC, AreAnnouncedWithAllFields) {
  using foresight::LiveParameter;
  const foresight::LiveParameters message = announced();
  ASSERT_EQ(message.parameter_size(), 6);
  EXPECT_EQ(message.parameter(0).ShortDebugString(),
            R"(name: "height" type: TYPE_NUMBER number: 0.02 initial_number: 0.02 max: 0.05 unit: "m" )"
            R"(description: "Height of a foot.")");
  EXPECT_EQ(message.parameter(1).number(), -3);
  EXPECT_EQ(message.parameter(1).min(), -2147483648.0);
  EXPECT_EQ(message.parameter(2).ShortDebugString(), R"(name: "arms" type: TYPE_YES_NO number: 1 initial_number: 1)");
  EXPECT_EQ(message.parameter(3).text(), "ab");
  EXPECT_EQ(message.parameter(4).ShortDebugString(),
            R"(name: "gait" type: TYPE_CHOICE text: "fast" initial_text: "fast" choice: "slow" choice: "fast")");
  EXPECT_EQ(message.parameter(5).ShortDebugString(), R"(name: "kick" type: TYPE_BUTTON description: "Kicks once.")");
  EXPECT_EQ(kicks, 0);
}

TEST_F(LiveParametersOfC, AButtonCountsThePressesOfThisProcessAlone) {
  foresight::LiveParameters message = announced();
  const auto press_to = [&](double presses) {
    message.mutable_parameter(5)->set_number(presses);
    tell(message);
  };
  press_to(7);  // the runtime knows them of a former process
  message.mutable_parameter(1)->set_number(1);
  tell(message);
  EXPECT_EQ(changes(), 1);
  EXPECT_EQ(kicks, 0);
  press_to(8);
  EXPECT_EQ(changes(), 1);
  EXPECT_EQ(kicks, 1);
  press_to(10);
  EXPECT_EQ(changes(), 1);
  EXPECT_EQ(kicks, 3);

  // a runtime that has lost them gets its own count back
  tell({});
  EXPECT_EQ(announced().parameter(5).number(), 10);
  message.mutable_parameter(1)->set_number(2);
  press_to(2);  // somebody has set a smaller number
  EXPECT_EQ(changes(), 1);
  press_to(3);
  EXPECT_EQ(changes(), 1);
  EXPECT_EQ(kicks, 4);
}

TEST_F(LiveParametersOfC, TakeTheValuesThatPeopleSet) {
  foresight::LiveParameters message = announced();
  tell(message, "kick.");
  message.mutable_parameter(0)->set_number(0.1 + 0.2);
  message.mutable_parameter(1)->set_number(7);
  message.mutable_parameter(2)->set_number(0);
  message.mutable_parameter(3)->set_text("longer than its room");
  message.mutable_parameter(4)->set_text("slow");
  tell(message);
  EXPECT_EQ(changes(), 5);
  EXPECT_EQ(height, 0.1 + 0.2);  // to the bit
  EXPECT_EQ(steps, 7);
  EXPECT_EQ(arms, 0);
  EXPECT_STREQ(name, "longer ");
  EXPECT_EQ(gait, 0);
  EXPECT_STREQ(foresight_parameters_problem(parameters), "");
  message.mutable_parameter(0)->set_number(0.04);
  tell(message);
  EXPECT_EQ(changes(), 1);
}

TEST_F(LiveParametersOfC, AFormerProcessIsNotHeard) {
  foresight::LiveParameters message = announced();
  message.mutable_parameter(0)->set_number(0.01);
  message.mutable_parameter(0)->set_initial_number(0.03);  // of a former file
  message.mutable_parameter(1)->set_number(8);
  message.mutable_parameter(1)->set_gone(true);
  message.mutable_parameter(4)->set_text("slow");
  tell(message);
  EXPECT_EQ(changes(), 1);
  EXPECT_EQ(height, 0.02);
  EXPECT_EQ(steps, -3);
  EXPECT_EQ(gait, 0);
}

TEST_F(LiveParametersOfC, AreAnnouncedAgainWithTheirValuesToARuntimeThatHasLostThem) {
  foresight::LiveParameters message = announced();
  message.mutable_parameter(0)->set_number(0.04);
  tell(message);
  EXPECT_EQ(changes(), 1);
  tell({});
  const foresight::LiveParameters again = announced();
  EXPECT_EQ(again.parameter(0).number(), 0.04);
  EXPECT_EQ(again.parameter(0).initial_number(), 0.02);
}

TEST_F(LiveParametersOfC, ARefusalIsTheirProblem) {
  announced();
  foresight::LiveParameters message;
  message.add_problem("kick: no");
  message.add_problem("walk: parameter 'height': expected more");
  tell(message);
  EXPECT_TRUE(tests::eventually([&] {
    foresight_poll_parameters(parameters);
    return *foresight_parameters_problem(parameters) != 0;
  }));
  EXPECT_STREQ(foresight_parameters_problem(parameters), "the runtime refuses: parameter 'height': expected more");
  static double other = 0;
  foresight_add_number(parameters, "long", &other, 0, 0, "", std::string(5000, 'a').c_str());
  EXPECT_STREQ(foresight_parameters_problem(parameters), "parameter 'long': its texts are too long");
}

TEST_F(LiveParametersOfC, AnyMessageLeavesTheVariablesAllowed) {
  foresight::LiveParameters message = announced();
  message.mutable_parameter(4)->set_text("slow");
  for (auto& parameter : *message.mutable_parameter()) parameter.set_name("walk." + parameter.name());
  const std::string bytes = message.SerializeAsString();
  std::mt19937 random(1);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string wrong = bytes;
    wrong[i] = static_cast<char>(random());
    EXPECT_TRUE(told->write_bytes(i % 2 ? wrong : bytes.substr(0, i), 1));
    foresight_poll_parameters(parameters);
    EXPECT_TRUE(gait == 0 || gait == 1);
    EXPECT_LT(std::strlen(name), sizeof name);
  }
}

TEST_F(TheDoor, TellsWhenNoProcessWritesAnObjectAnyMore) {
  const auto told = [this] {
    const std::lock_guard guard(ended_lock);
    return ended;
  };
  Writer first = announce("ball", "foresight.Ball");
  ASSERT_TRUE(tests::eventually([&] { return write(first, "") && newest("/14/2/ball"); }));
  Writer second = announce("ball", "foresight.Ball");
  foresight::Ball seventh;
  seventh.set_x(7);
  ASSERT_TRUE(write(second, seventh.SerializeAsString()));  // waits for its turn
  const Writer pose = announce("pose", "foresight.Pose");
  // the door takes processes in their order: when it has this one, it has the second
  ASSERT_TRUE(tests::eventually([&] { return write(pose, "") && newest("/14/2/pose"); }));
  first.reset();
  ASSERT_TRUE(tests::eventually([&] { return memory->ball.read()->value().x() == 7; }));
  EXPECT_TRUE(told().empty());
  second.reset();
  EXPECT_TRUE(tests::eventually([&] { return told() == std::vector<std::string>{"/14/2/ball"}; }));
}

TEST_F(TheDoor, MessagesOfAProcessEnterMemoryWithTheirCaptureTimeOfTheEpoch) {
  const Writer ball = announce("ball", "foresight.Ball");
  unsigned char room[32];
  ForesightBytes message = foresight_bytes(room, sizeof room);
  foresight_put_float(&message, 2, 1.5f);
  foresight_put_uint(&message, 7, 1);
  const std::uint64_t now_ns = foresight_now_ns();
  ASSERT_TRUE(foresight_write(ball.get(), now_ns, message.bytes, message.size));
  ASSERT_TRUE(tests::eventually([&] { return memory->ball.read() != nullptr; }));
  EXPECT_EQ(memory->ball.read()->value().x(), 1.5f);
  EXPECT_TRUE(memory->ball.read()->value().visible());
  EXPECT_EQ(memory->ball.read()->capture_ns(), now_ns + 5 * kSecond);
  // by now the process knows the offset of the epoch
  ASSERT_TRUE(foresight_write(ball.get(), now_ns, message.bytes, message.size));
  EXPECT_EQ(foresight_epoch_ns(ball.get(), 7), 7 + 5 * kSecond);
}

TEST_F(TheDoor, ATypeUnknownToTheRuntimeIsAccepted) {
  const Writer vortex = announce("/debug/vortex", "team.Vortex", "", "json");
  ASSERT_TRUE(write(vortex, "{\"spin\": 3}"));
  ASSERT_TRUE(tests::eventually([&] { return newest("/debug/vortex") != nullptr; }));
  EXPECT_EQ(newest("/debug/vortex")->bytes(), "{\"spin\": 3}");
  const memory::ChannelInfo info = channels.find("/debug/vortex")->info();
  EXPECT_EQ(info.message_encoding, "json");
  EXPECT_EQ(info.schema.name, "team.Vortex");
  EXPECT_EQ(info.delivery, memory::Delivery::fifo);
}

TEST_F(TheDoor, AMessageOfOursUnderAnotherNameGetsOurSchema) {
  const Writer other = announce("second_ball", "foresight.Ball");
  ASSERT_TRUE(write(other, ""));
  ASSERT_TRUE(tests::eventually([&] { return newest("/14/2/second_ball") != nullptr; }));
  EXPECT_EQ(channels.find("/14/2/second_ball")->info().schema, memory->ball.info().schema);
}

TEST_F(TheDoor, ImagesComeThroughSharedMemoryWholeAndInOrder) {
  const auto arrivals = std::make_shared<tests::Arrivals>();
  const auto kept = board.start_logger(channels.find("/14/2/camera_top"),
                                       std::make_unique<tests::KeepingProvider>(arrivals), 1 << 30);
  const Writer camera = announce("camera_top", "foresight.Image");
  std::string pixels(2 * 640 * 480, '\0');
  constexpr int kImages = 60;
  for (int i = 0; i < kImages; ++i) {
    pixels.assign(pixels.size(), static_cast<char>(i));
    // a place is free again when the runtime has taken an earlier message
    ASSERT_TRUE(tests::eventually([&] {
      return foresight_write_image(camera.get(), static_cast<std::uint64_t>(i + 1), FORESIGHT_YUYV, 640, 480,
                                   pixels.data(), pixels.size()) == 1;
    }));
  }
  arrivals->wait_for(kImages);
  board.stop(kept);
  for (int i = 0; i < kImages; ++i) {
    foresight::Image image;
    const logging::Record& record = arrivals->records[static_cast<std::size_t>(i)];
    ASSERT_TRUE(image.ParseFromString(record.bytes));
    EXPECT_EQ(record.capture_ns, static_cast<std::uint64_t>(i + 1) + 5 * kSecond);
    EXPECT_EQ(image.width(), 640u);
    EXPECT_EQ(image.data(), std::string(pixels.size(), static_cast<char>(i))) << "image " << i;
  }
}

TEST_F(TheDoor, MessagesOfAProcessThatDisconnectedArrive) {
  const std::string image(614'400, 'i');
  for (int i = 1; i <= 20; ++i) {
    Writer camera = announce("camera_top", "foresight.Image");
    ASSERT_TRUE(foresight_write_image(camera.get(), 1, FORESIGHT_YUYV, 640, 480, image.data(), image.size()));
    camera.reset();
    ASSERT_TRUE(tests::eventually([&] {
      return memory->camera_top.read() && memory->camera_top.read()->sequence() == static_cast<std::uint64_t>(i);
    }));
  }
}

TEST_F(TheDoor, MessagesThatGrowFindALargerPlace) {
  const Writer blob = announce("blob", "team.Blob", "", "json");
  for (const std::size_t size : {20'000u, 70'000u, 3'000'000u, 10u, 8u << 20}) {
    const std::string bytes(size, 'b');
    ASSERT_TRUE(write(blob, bytes)) << foresight_problem(blob.get());
    ASSERT_TRUE(tests::eventually([&] { return newest("/14/2/blob") && newest("/14/2/blob")->size_bytes() == size; }));
    EXPECT_EQ(newest("/14/2/blob")->bytes(), bytes);
  }
  EXPECT_FALSE(write(blob, std::string((8 << 20) + 1, 'b')));
}

TEST_F(TheDoor, AProcessReadsTheNewestMessageAndLaterOnes) {
  foresight::MotionCommand command;
  command.mutable_walk_speed()->set_x(0.1f);
  memory->motion_command.write(command, 6 * kSecond);
  const Reader reader = want("motion_command");
  ForesightMessage message;
  EXPECT_EQ(read(reader, message), command.SerializeAsString());
  EXPECT_EQ(message.capture_ns, 1 * kSecond);  // on the monotonic clock
  EXPECT_STREQ(foresight_object(reader.get())->topic, "/14/2/motion_command");
  EXPECT_STREQ(foresight_object(reader.get())->type, "foresight.MotionCommand");
  EXPECT_STREQ(foresight_object(reader.get())->message_encoding, "protobuf");
  command.mutable_walk_speed()->set_x(0.2f);
  memory->motion_command.write(command, 7 * kSecond);
  EXPECT_EQ(read(reader, message), command.SerializeAsString());
  EXPECT_EQ(message.sequence, 2u);
}

TEST_F(TheDoor, AReaderMayBeginBeforeItsObjectExists) {
  const Reader reader = want("/14/2/prophecy");
  ForesightMessage message;
  EXPECT_FALSE(foresight_read(reader.get(), &message));
  const Writer prophecy = announce("prophecy", "team.Prophecy", "", "json");
  ASSERT_TRUE(write(prophecy, "soon"));
  EXPECT_EQ(read(reader, message), "soon");
}

TEST_F(TheDoor, AWaitOfNoTimeOrLessReturnsAtOnce) {
  const Reader reader = want("ball"), nobody(foresight_want_from("ball", "/nowhere"), &foresight_end);
  ForesightMessage message;
  EXPECT_FALSE(foresight_read(reader.get(), &message));
  for (const int timeout_ms : {0, -1, -1000}) {
    foresight_wait(reader.get(), timeout_ms);  // a failure is the test's timeout
    foresight_wait(nobody.get(), timeout_ms);
  }
}

TEST_F(TheDoor, ADeadlineThatHasPassedIsNotWaitedFor) {
  EXPECT_EQ(foresight_ms_until(7'000'000, 5'000'001), 2);
  EXPECT_EQ(foresight_ms_until(7'000'000, 7'000'000), 0);
  EXPECT_EQ(foresight_ms_until(7'000'000, 7'000'001), 0);
  EXPECT_EQ(foresight_ms_until(0, UINT64_MAX), 0);
  EXPECT_EQ(foresight_ms_until(UINT64_MAX, 0), 60'000) << "a longer wait is split, so that it reads the clock again";
}

TEST_F(TheDoor, AQuestionIsAnsweredByItsOwnForecastOrNotAtAll) {
  ForesightAdviser adviser = foresight_adviser(path.c_str());
  const Writer questions(adviser.questions, &foresight_close);
  const Reader forecasts(adviser.forecasts, &foresight_end);
  const char* const strategies[] = {"baseline", "passing"};
  ForesightAdvice advice;
  EXPECT_EQ(foresight_what_if(&adviser, strategies, 2, 30, 0, &advice), 0);
  ASSERT_TRUE(tests::eventually([&] { return memory->what_if.read() != nullptr; }));
  EXPECT_EQ(memory->what_if.read()->value().id(), adviser.asked);

  // now a runtime answers, with a forecast of another question first
  foresight::Forecast forecast;
  forecast.mutable_question()->set_id(adviser.asked - 1);
  memory->forecast.write(forecast, 1);
  forecast.mutable_question()->set_id(adviser.asked);
  forecast.set_advice(foresight::Forecast::ADVICE_CHANGE);
  forecast.set_choice("passing");
  memory->forecast.write(forecast, 2);
  ASSERT_TRUE(tests::eventually([&] { return foresight_answer(&adviser, &advice) == 1; }));
  EXPECT_TRUE(advice.known && advice.change);
  EXPECT_STREQ(advice.choice, "passing");
}

TEST_F(TheDoor, TheNewestMessageIsReadWhole) {
  memory->log.write({}, 1);
  const Reader reader = want("log");
  ForesightMessage message;
  read(reader, message);
  foresight::LogText text;
  for (int i = 0; i < 100; ++i) {
    text.set_line(static_cast<std::uint32_t>(i));
    text.set_text(std::string(20'000, static_cast<char>('a' + i % 26)));
    memory->log.write(text, 1);
  }
  while (message.sequence < 101) {
    foresight_wait(reader.get(), 100);
    if (!foresight_read_newest(reader.get(), &message)) continue;
    foresight::LogText seen;
    ASSERT_TRUE(seen.ParseFromArray(message.bytes, static_cast<int>(message.size)));
    EXPECT_EQ(seen.line() + 2, message.sequence);
  }
}

TEST_F(TheDoor, ARenumberedFieldIsRefusedWithASentence) {
  google::protobuf::FileDescriptorSet files;
  ASSERT_TRUE(files.ParseFromString(memory->ball.info().schema.bytes));
  files.mutable_file(0)->mutable_message_type(0)->mutable_field(1)->set_number(99);
  const Writer ball = announce("ball", "foresight.Ball", files.SerializeAsString());
  ASSERT_TRUE(tests::eventually([&] { return write(ball, "") == 0; }));
  EXPECT_STREQ(foresight_problem(ball.get()),
               "the runtime refuses: /14/2/ball: field x of foresight.Ball: expected number 2, got number 99");
  EXPECT_EQ(memory->ball.read(), nullptr);
}

TEST_F(TheDoor, NamesThePartThatDoesNotFit) {
  const auto sentence = [&](const char* topic, const char* type, const std::string& schema, const char* encoding) {
    const Writer writer = announce(topic, type, schema, encoding);
    EXPECT_TRUE(tests::eventually([&] { return write(writer, "") == 0; }));
    return std::string(foresight_problem(writer.get())).substr(sizeof "the runtime refuses:");
  };
  EXPECT_EQ(sentence("ball", "foresight.Pose", "", "protobuf"),
            "/14/2/ball: expected protobuf messages of type 'foresight.Ball', got 'protobuf' of type 'foresight.Pose'");
  EXPECT_EQ(sentence("runtime", "foresight.RuntimeStatistics", "", "protobuf"),
            "/14/2/runtime: expected an object of the team's, got one that only the runtime writes");
  EXPECT_EQ(
      sentence("../../etc", "a.B", "", "json"),
      "expected a topic of words of letters, digits, '_', '-' and '.' with '/' between them, at most 200 bytes, got "
      "'../../etc'");
  EXPECT_EQ(
      sentence("vortex", "team.Vortex", "", "protobuf"),
      "/14/2/vortex: schema of team.Vortex: expected a description of that message with all it imports, got 0 files "
      "without it");
  const Writer first = announce("thoughts", "team.Thoughts", "{}", "json");
  ASSERT_TRUE(write(first, "{}"));
  ASSERT_TRUE(tests::eventually([&] { return newest("/14/2/thoughts") != nullptr; }));
  EXPECT_EQ(
      sentence("thoughts", "team.Thoughts", "{\"type\": 1}", "json"),
      "/14/2/thoughts: expected the schema of 'team.Thoughts' that was announced first, got another one; a changed "
      "type needs a new start of the runtime");
  expect_all_well();
}

TEST_F(TheDoor, ATimeOfAnotherClockIsRefused) {
  const Writer ball = announce("ball", "foresight.Ball");
  const std::uint64_t wrong_ns = system_ns();
  ASSERT_TRUE(tests::eventually([&] { return write(ball, "", wrong_ns) == 0; }));
  EXPECT_EQ(std::string(foresight_problem(ball.get()))
                .find("the runtime refuses: /14/2/ball: expected capture times of the "
                      "monotonic clock, now "),
            0u)
      << foresight_problem(ball.get());
}

TEST_F(TheDoor, ASecondWriterWaitsUntilTheFirstHasGone) {
  const auto arrivals = std::make_shared<tests::Arrivals>();
  Writer first = announce("steps", "team.Step", "", "json");
  ASSERT_TRUE(write(first, "first"));
  ASSERT_TRUE(tests::eventually([&] { return newest("/14/2/steps") != nullptr; }));
  const auto kept =
      board.start_logger(channels.find("/14/2/steps"), std::make_unique<tests::KeepingProvider>(arrivals));
  const Writer second = announce("steps", "team.Step", "", "json");
  for (int i = 0; i < 20; ++i) {
    ASSERT_TRUE(write(second, "second"));
    ASSERT_TRUE(write(first, "first"));
  }
  first.reset();
  arrivals->wait_for(41);
  board.stop(kept);
  for (std::size_t i = 0; i < 41; ++i) EXPECT_EQ(arrivals->records[i].bytes, i < 21 ? "first" : "second") << i;
}

TEST_F(TheDoor, LostMessagesAreCounted) {
  const std::string message =
      ball_channel() + frame(2, integer(1, 8) + integer(1, 16)) + frame(2, integer(5, 8) + integer(1, 16));
  const FileDescriptor process = stranger(message);
  ASSERT_TRUE(tests::eventually([&] { return !board.statuses().empty() && board.statuses().front().messages == 2; }));
  EXPECT_EQ(board.statuses().front().dropped, 3u);
  EXPECT_EQ(board.statuses().front().topic, "/14/2/ball");
}

TEST_F(TheDoor, IsUsableByItsUserOnly) {
  struct stat status {};
  ASSERT_EQ(::stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
}

TEST_F(TheDoor, IsNotTakenFromALivingRuntimeNorFromAFile) {
  const auto second = Door::open({.path = path, .robot = "14/3"}, clock, channels, board);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error(), "door: expected nobody to listen at " + path.string() +
                                ", another runtime does; end it, or choose another --door");
  const auto file = folder / "file";
  ASSERT_TRUE(replace_file(file, "precious"));
  EXPECT_FALSE(Door::open({.path = file, .robot = "14/3"}, clock, channels, board));
  EXPECT_EQ(*read_file(file, 100), "precious");
  expect_all_well();
}

TEST_F(TheDoor, ReplacesASocketThatAKilledRuntimeLeft) {
  const std::filesystem::path left = folder / "left";
  {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    left.native().copy(address.sun_path, sizeof address.sun_path - 1);
    const FileDescriptor socket(::socket(AF_UNIX, SOCK_STREAM, 0));
    ASSERT_EQ(::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  }
  EXPECT_TRUE(Door::open({.path = left, .robot = "14/2"}, clock, channels, board));
}

TEST_F(TheDoor, AWriterGoesOnWhenTheRuntimeIsThereAgain) {
  const Writer ball = announce("ball", "foresight.Ball");
  const Reader reader = want("ball");
  ForesightMessage message;
  ASSERT_TRUE(write(ball, ""));
  read(reader, message);
  door.reset();
  ASSERT_TRUE(tests::eventually([&] { return write(ball, "") == 0; }));
  EXPECT_GE(foresight_lost(ball.get()), 1u);
  EXPECT_EQ(foresight_problem(ball.get()), "cannot connect to " + path.string() + ": No such file or directory");
  open();
  foresight::Ball there;
  there.set_x(42);
  ASSERT_TRUE(tests::eventually([&] { return write(ball, there.SerializeAsString()) == 1; }));
  ASSERT_TRUE(tests::eventually([&] { return memory->ball.read()->value().x() == 42; }));
  while (read(reader, message) != there.SerializeAsString()) {
  }
}

TEST_F(TheDoor, AWriterNeverWaitsForARuntimeThatDoesNotRead) {
  // this listener never accepts, like a stopped runtime
  door.reset();
  const FileDescriptor stopped(::socket(AF_UNIX, SOCK_STREAM, 0));
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.native().copy(address.sun_path, sizeof address.sun_path - 1);
  ASSERT_EQ(::bind(stopped.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  ASSERT_EQ(::listen(stopped.get(), 0), 0);
  const Writer small = announce("joints", "foresight.Joints"), large = announce("camera_top", "foresight.Image"),
               third = announce("ball", "foresight.Ball");
  const Reader reader = want("game");
  const std::string bytes(500, 'j'), image(614'400, 'i');
  ForesightMessage message;
  const std::uint64_t cpu_before_ns = thread_cpu_ns(), before_ns = monotonic_ns();
  for (int i = 0; i < 2000; ++i) {
    write(small, bytes);
    write(large, image);
    write(third, bytes);
    EXPECT_FALSE(foresight_read(reader.get(), &message));
  }
  // the writer may wait for the processor only
  EXPECT_LT(monotonic_ns() - before_ns, thread_cpu_ns() - cpu_before_ns + 5 * kSecond);
  EXPECT_GE(foresight_lost(large.get()), 1900u);
  EXPECT_GT(foresight_lost(small.get()), 0u);
  EXPECT_EQ(foresight_problem(small.get()), "cannot write to " + path.string() + ": the runtime does not read");
}

TEST_F(TheDoor, SurvivesEveryTruncation) {
  const std::string whole = ball_channel() + frame(2, integer(1, 8) + integer(1, 16));
  for (std::size_t size = 0; size <= whole.size(); ++size) stranger(std::string_view(whole).substr(0, size));
  ASSERT_TRUE(tests::eventually([&] { return memory->ball.read() != nullptr; }));  // the last message was complete
  EXPECT_EQ(memory->ball.read()->sequence(), 1u);
  expect_all_well();
}

TEST_F(TheDoor, SurvivesRandomBytes) {
  std::mt19937 random(1);  // the fixed seed makes a failure repeatable
  for (int i = 0; i < 300; ++i) {
    std::string bytes = i % 2 ? ball_channel() : "";
    for (int n = 0; n < 60; ++n) {
      // mostly frames with a valid kind and length
      if (random() % 3 == 0) bytes += frame(static_cast<int>(random() % 9), std::string(random() % 50, '\3'));
      bytes.push_back(static_cast<char>(random()));
    }
    stranger(bytes);
  }
  expect_all_well();
}

TEST_F(TheDoor, NamesTheErrorInSharedMemory) {
  const std::string shared = frame(6, integer(1, 8) + integer(1, 16) + integer(0, 8) + integer(100, 8));
  EXPECT_EQ(refusal(stranger(ball_channel() + shared)),
            "/14/2/ball: expected a file before the first message that lies in it, got none");
  EXPECT_EQ(refusal(stranger(ball_channel() + frame(5, ""))),
            "/14/2/ball: expected a file together with its frame, got none");
  int pipe[2];
  ASSERT_EQ(::pipe(pipe), 0);
  const FileDescriptor out(pipe[0]), in(pipe[1]);
  EXPECT_EQ(refusal(stranger(ball_channel() + frame(5, "") + shared, out.get())),
            "/14/2/ball: expected an ordinary file to share messages in, got something else");
  const auto file = folder / "short";
  ASSERT_TRUE(replace_file(file, std::string(60, 's')));
  const FileDescriptor truncated(::open(file.c_str(), O_RDONLY));
  EXPECT_EQ(refusal(stranger(ball_channel() + frame(5, "") + shared, truncated.get())),
            "/14/2/ball: expected a shared message of 100 bytes at 0, got 60");
  expect_all_well();
}

TEST_F(TheDoor, ManyProcessesConnectUpToTheLimit) {
  std::vector<FileDescriptor> crowd;
  for (std::size_t i = 0; i < Door::kMaxConnections; ++i) crowd.push_back(stranger(""));
  EXPECT_EQ(refusal(stranger("")), "expected at most 128 streams at once, got one more");
  crowd.clear();
  expect_all_well();
}

TEST_F(TheDoor, ConnectionsThatSayNothingKeepNoOtherProcessOut) {
  door.reset();
  open(200 * kMillisecond);
  std::vector<FileDescriptor> silent;
  for (std::size_t i = 0; i < Door::kMaxConnections; ++i) silent.push_back(stranger(""));
  const FileDescriptor slow = stranger(ball_channel().substr(0, 3));
  expect_all_well();
  EXPECT_EQ(refusal(silent.front()), "expected a first frame within 200 ms, got none");
  // a process that waits for an object has said so
  const Reader reader = want("/14/2/prophecy");
  ForesightMessage message;
  EXPECT_FALSE(foresight_read(reader.get(), &message));
  const FileDescriptor later = stranger("");
  EXPECT_EQ(refusal(later), "expected a first frame within 200 ms, got none");
  const Writer prophecy = announce("prophecy", "team.Prophecy", "", "json");
  ASSERT_TRUE(write(prophecy, "soon"));
  EXPECT_EQ(read(reader, message), "soon");
}

TEST_F(TheDoor, WithoutFileDescriptorsItRefusesWithASentenceAndDoesNotSpin) {
  if (!tests::kCanUseUpDescriptors) GTEST_SKIP() << "the sanitizer itself needs file descriptors";
  std::vector<FileDescriptor> clients;
  for (int i = 0; i < 5; ++i) clients.emplace_back(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  {
    const tests::UsedUpDescriptors none;
    const std::uint64_t before_ns = monotonic_ns(), cpu_before_ns = process_cpu_ns();
    for (const FileDescriptor& client : clients) connect(client);
    for (const FileDescriptor& client : clients)
      EXPECT_EQ(refusal(client),
                "expected a free file descriptor for one more stream, got none: raise the limit of open files (ulimit "
                "-n)");
    const std::uint64_t elapsed_ns = monotonic_ns() - before_ns;
    EXPECT_GE(elapsed_ns, 400 * kMillisecond);  // ten refusals a second
    EXPECT_LT(process_cpu_ns() - cpu_before_ns, elapsed_ns / 2);
  }
  expect_all_well();
}

}  // namespace
}  // namespace robot::body
