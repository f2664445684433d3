#include <gtest/gtest.h>

#include "robot/core/json_library.h"
#include "robot/net/foxglove/from_client.h"
#include "robot/net/foxglove/to_client.h"

namespace robot::net::foxglove {
namespace {

std::string hex(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    char pair[3];
    std::snprintf(pair, sizeof pair, "%02x", static_cast<unsigned char>(c));
    text += pair;
  }
  return text;
}

const std::string kKeyValue = R"({"key": "value"})";

// golden vectors: those of the Foxglove SDK's own tests

TEST(Foxglove, ServerBytesMatchTheGoldenVectors) {
  EXPECT_EQ(hex(time(1234567890)), "02d202964900000000");
  EXPECT_EQ(hex(service_response(10, 12, "json", kKeyValue)),
            "030a0000000c000000040000006a736f6e7b226b6579223a202276616c7565227d");
  EXPECT_EQ(hex(asset_response(10, std::string("data"))), "040a000000000000000064617461");
  EXPECT_EQ(hex(asset_response(10, Error{"oh no"})), "040a00000001050000006f68206e6f");
  EXPECT_EQ(hex(playback_state(Playback::playing, 12345, 1, false, "")), "050039300000000000000000803f0000000000");
  EXPECT_EQ(hex(playback_state(Playback::playing, 12345, 1, true, "")), "050039300000000000000000803f0100000000");
  std::string message;
  append_message_data_header(message, 7, 1700000000123456789);
  EXPECT_EQ(message.size(), kMessageDataHeaderBytes);
  EXPECT_EQ(hex(message + "\x08\x01\x2a"), "010700000015cd853dfe9c971708012a");
}

TEST(Foxglove, ClientBytesMatchTheGoldenVectors) {
  EXPECT_EQ(hex(to_bytes(ClientPublish{30, kKeyValue})), "011e0000007b226b6579223a202276616c7565227d");
  EXPECT_EQ(hex(to_bytes(ServiceCall{10, 12, "json", kKeyValue})),
            "020a0000000c000000040000006a736f6e7b226b6579223a202276616c7565227d");
  EXPECT_EQ(hex(to_bytes(PlaybackControl{true, 1, {}, "some-id"})),
            "03000000803f00000000000000000007000000736f6d652d6964");
  EXPECT_EQ(hex(to_bytes(PlaybackControl{false, 1, {}, "some-id"})),
            "03010000803f00000000000000000007000000736f6d652d6964");
  EXPECT_EQ(hex(to_bytes(PlaybackControl{true, 1, 123456789, "some-id"})),
            "03000000803f0115cd5b070000000007000000736f6d652d6964");
}

TEST(Foxglove, ClientBytesAreReadBack) {
  const auto call = parse_client_binary(to_bytes(ServiceCall{10, 12, "json", kKeyValue}));
  ASSERT_TRUE(call);
  EXPECT_EQ(std::get<ServiceCall>(*call).call, 12u);
  EXPECT_EQ(std::get<ServiceCall>(*call).payload, kKeyValue);
  const auto control = parse_client_binary(to_bytes(PlaybackControl{false, 0.5f, 99, "some-id"}));
  ASSERT_TRUE(control);
  EXPECT_EQ(std::get<PlaybackControl>(*control).seek_ns, 99u);
  EXPECT_EQ(std::get<PlaybackControl>(*control).speed, 0.5f);
  EXPECT_EQ(std::get<PlaybackControl>(*control).request_id, "some-id");
}

TEST(Foxglove, ClientBytesSurviveEveryTruncation) {
  for (const std::string& whole :
       {to_bytes(ServiceCall{10, 12, "json", ""}), to_bytes(PlaybackControl{true, 1, 5, "id"})})
    for (std::size_t n = 0; n < whole.size(); ++n) EXPECT_FALSE(parse_client_binary(whole.substr(0, n)));
  EXPECT_EQ(parse_client_binary("\x02\x01").error(), "request: a binary message with opcode 2 is cut short at 2 bytes");
  EXPECT_EQ(parse_client_binary("\x09").error(), "request: the binary opcode 9 is not known");
}

TEST(Foxglove, ClientTextsAreRead) {
  const auto subscribe =
      parse_client_text(R"({"op":"subscribe","subscriptions":[{"id":0,"channelId":3},{"id":1,"channelId":4}]})");
  ASSERT_TRUE(subscribe);
  EXPECT_EQ(std::get<Subscribe>(*subscribe).subscriptions.at(1).channel, 4u);
  const auto set = parse_client_text(
      R"({"op":"setParameters","id":"x","parameters":[{"name":"a","value":1},{"name":"b","value":true},{"name":"c","value":"t"},{"name":"d","value":0.5},{"name":"e"}]})");
  ASSERT_TRUE(set);
  const auto& parameters = std::get<SetParameters>(*set).parameters;
  EXPECT_EQ(parameters.at(0).value, ParameterValue(std::int64_t{1}));
  EXPECT_EQ(parameters.at(1).value, ParameterValue(true));
  EXPECT_EQ(parameters.at(2).value, ParameterValue("t"));
  EXPECT_EQ(parameters.at(3).value, ParameterValue(0.5));
  EXPECT_EQ(parameters.at(4).value, std::nullopt);
  const auto unwatch = parse_client_text(R"({"op":"unsubscribeParameterUpdates","parameterNames":["a"]})");
  ASSERT_TRUE(unwatch);
  EXPECT_FALSE(std::get<WatchParameters>(*unwatch).watch);
  const auto asset = parse_client_text(R"({"op":"fetchAsset","uri":"package://x","requestId":1})");
  ASSERT_TRUE(asset);
  EXPECT_EQ(std::get<Unsupported>(*asset).op, "fetchAsset");
}

TEST(Foxglove, IdsOfAClientMayBeSpelledAsDecimalFractions) {
  const auto subscribe = parse_client_text(R"({"op":"subscribe","subscriptions":[{"id":1.0,"channelId":4e0}]})");
  ASSERT_TRUE(subscribe) << subscribe.error();
  EXPECT_EQ(std::get<Subscribe>(*subscribe).subscriptions.at(0).subscription, 1u);
  EXPECT_EQ(std::get<Subscribe>(*subscribe).subscriptions.at(0).channel, 4u);
  const auto unsubscribe = parse_client_text(R"({"op":"unsubscribe","subscriptionIds":[7.0]})");
  ASSERT_TRUE(unsubscribe) << unsubscribe.error();
  EXPECT_EQ(std::get<Unsubscribe>(*unsubscribe).subscriptions, std::vector<std::uint32_t>{7});
}

TEST(Foxglove, ASubscribeOfOurClientIsRead) {
  const auto message = parse_client_text(to_text(Subscribe{{{7, 9}}}));
  ASSERT_TRUE(message);
  EXPECT_EQ(std::get<Subscribe>(*message).subscriptions.at(0).subscription, 7u);
}

TEST(Foxglove, AChoiceOfAPlayheadIsRead) {
  for (const bool own : {true, false}) {
    const auto message = parse_client_text(playhead(own));
    ASSERT_TRUE(message) << message.error();
    EXPECT_EQ(std::get<ChoosePlayhead>(*message).own, own);
  }
  EXPECT_EQ(parse_client_text(R"({"op":"playhead","own":1})").error(), "request: 'own' must be true or false");
}

TEST(Foxglove, WrongTextsAreNamed) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "request: expected JSON, got something else"},
      {"[1]", "request: expected a JSON object with 'op', got something else"},
      {"{\"op\":", "request: expected JSON, got something else"},
      {"{}", "request: expected a JSON object with 'op', got one without"},
      {R"({"op":7})", "request: expected a JSON object with 'op', got one without"},
      {R"({"op":"dance"})", "request: the op 'dance' is not known"},
      {R"({"op":"subscribe"})",
       "request: 'subscriptions' must be an array of {id, channelId}, both numbers 0 .. 4294967295"},
      {R"({"op":"subscribe","subscriptions":[{"id":-1,"channelId":1}]})",
       "request: 'subscriptions' must be an array of {id, channelId}, both numbers 0 .. 4294967295"},
      {R"({"op":"subscribe","subscriptions":[{"id":4294967296,"channelId":1}]})",
       "request: 'subscriptions' must be an array of {id, channelId}, both numbers 0 .. 4294967295"},
      {R"({"op":"subscribe","subscriptions":[{"id":1.5,"channelId":1}]})",
       "request: 'subscriptions' must be an array of {id, channelId}, both numbers 0 .. 4294967295"},
      {R"({"op":"subscribe","subscriptions":[{"id":NaN,"channelId":1}]})",
       "request: expected JSON, got something else"},
      {R"({"op":"unsubscribe","subscriptionIds":["a"]})",
       "request: 'subscriptionIds' must be an array of numbers 0 .. 4294967295"},
      {R"({"op":"getParameters","parameterNames":[1]})", "request: 'parameterNames' must be an array of texts"},
      {R"({"op":"setParameters","parameters":[{}]})", "request: 'parameters' must be an array of {name, value}"},
  };
  for (const auto& [text, sentence] : cases) {
    const auto message = parse_client_text(text);
    ASSERT_FALSE(message) << text;
    EXPECT_EQ(message.error(), sentence);
  }
}

TEST(Foxglove, DeeplyNestedTextIsRefused) {
  EXPECT_FALSE(parse_client_text(std::string(500'000, '[')));
  EXPECT_FALSE(
      parse_client_text(R"({"op":"subscribe","x":)" + std::string(300'000, '[') + std::string(300'000, ']') + "}"));
}

TEST(Foxglove, AnAdvertisementIsReadBack) {
  const Advertised channel{
      .id = 5,
      .info = {.topic = "/14/2/game",
               .schema = {.name = "foresight.GameState", .encoding = "protobuf", .bytes = std::string("\0\1\xff", 3)},
               .delivery = memory::Delivery::reliable},
      .metadata = {{"delivery", "reliable"}, {"robot", "14/2"}}};
  const auto channels = parse_advertise(advertise({advertised_channel(channel)}));
  ASSERT_TRUE(channels);
  ASSERT_EQ(channels->size(), 1u);
  EXPECT_EQ(channels->at(0).id, 5u);
  EXPECT_EQ(channels->at(0).info, channel.info);
  EXPECT_EQ(channels->at(0).metadata, channel.metadata);
  EXPECT_TRUE(parse_advertise(server_info({.name = "x"}))->empty());
  EXPECT_FALSE(parse_advertise("no"));
}

TEST(Foxglove, ServerTextsHaveTheFieldsOfTheProtocol) {
  using Json = nlohmann::json;
  EXPECT_EQ(Json::parse(status(StatusLevel::warning, "slow", "drops")),
            (Json{{"op", "status"}, {"level", 1}, {"message", "slow"}, {"id", "drops"}}));
  EXPECT_EQ(Json::parse(remove_status("drops")), (Json{{"op", "removeStatus"}, {"statusIds", {"drops"}}}));
  const Json values = Json::parse(parameter_values({{"rate", 15.0}, {"on", true}}, "7"));
  EXPECT_EQ(values["id"], "7");
  EXPECT_EQ(values["parameters"][0], (Json{{"name", "rate"}, {"value", 15.0}, {"type", "float64"}}));
  EXPECT_EQ(values["parameters"][1], (Json{{"name", "on"}, {"value", true}}));
  const Json services = Json::parse(advertise_services({{1, "clock_sync"}}));
  EXPECT_EQ(services["services"][0]["request"]["encoding"], "json");
  // a text that is not UTF-8 does not throw
  EXPECT_TRUE(Json::accept(status(StatusLevel::error, "\xff\xfe")));
}

TEST(Foxglove, TextsOfAServerAreReadBack) {
  const auto info = parse_server_text(server_info({.name = "x",
                                                   .capabilities = {"time"},
                                                   .encodings = {"json"},
                                                   .metadata = {{"robots", "14/2"}},
                                                   .session_id = "5"}));
  ASSERT_TRUE(info && info->info);
  EXPECT_EQ(info->info->capabilities, std::vector<std::string>{"time"});
  EXPECT_EQ(info->info->metadata.at("robots"), "14/2");
  EXPECT_EQ(info->info->session_id, "5");
  const auto services = parse_server_text(advertise_services({{1, "clock_sync"}, {2, "other"}}));
  ASSERT_TRUE(services);
  EXPECT_EQ(services->services.at(1).name, "other");
  EXPECT_EQ(services->services.at(1).id, 2u);
  EXPECT_TRUE(parse_server_text(status(StatusLevel::info, "hello")));
  EXPECT_FALSE(parse_server_text("[]"));
  const auto none = parse_server_text(R"({"op":"advertiseServices"})");
  ASSERT_TRUE(none);
  EXPECT_EQ(none->problems, std::vector<std::string>{"advertiseServices: expected an array as 'services', got null"});

  const auto unsubscribe = parse_client_text(to_text(Unsubscribe{{7, 9}}));
  ASSERT_TRUE(unsubscribe);
  EXPECT_EQ(std::get<Unsubscribe>(*unsubscribe).subscriptions, (std::vector<std::uint32_t>{7, 9}));
}

TEST(Foxglove, OneWrongItemOfAServerTakesNoOtherWithIt) {
  const auto read = parse_server_text(R"({"op":"advertise","channels":[
    {"id":1,"topic":"/1/1/a","encoding":"json"},
    {"id":2,"topic":"/1/1/b","schemaEncoding":"protobuf","schema":"%%%"},
    {"id":"three","topic":"/1/1/c"},
    {"id":NaN,"topic":"/1/1/d"},
    {"id":5,"topic":7},
    7,
    {"id":7.0,"topic":"/1/1/NaN","encoding":"json","metadata":{"rate":-Infinity,"quote":"\"nan"}}]})");
  ASSERT_TRUE(read) << read.error();
  ASSERT_EQ(read->channels.size(), 2u);
  EXPECT_EQ(read->channels[0].info.topic, "/1/1/a");
  EXPECT_EQ(read->channels[1].id, 7u);
  EXPECT_EQ(read->channels[1].info.topic, "/1/1/NaN");
  EXPECT_EQ(read->channels[1].metadata, (std::map<std::string, std::string>{{"quote", "\"nan"}}));
  ASSERT_EQ(read->problems.size(), 5u);
  EXPECT_EQ(read->problems[0].find("advertise: the schema of \"/1/1/b\": "), 0u) << read->problems[0];
  EXPECT_EQ(read->problems[1],
            "advertise: expected a whole number 0 .. 4294967295 as 'id' of \"/1/1/c\", got \"three\"");
  EXPECT_EQ(read->problems[2], "advertise: expected a whole number 0 .. 4294967295 as 'id' of \"/1/1/d\", got null");
  EXPECT_EQ(read->problems[3], "advertise: expected a text as 'topic' of channel 5, got 7");
  EXPECT_EQ(read->problems[4], "advertise: expected an object, got 7");

  const auto services =
      parse_server_text(R"({"op":"advertiseServices","services":[{"id":"x","name":"bad"},{"id":2,"name":"good"}]})");
  ASSERT_TRUE(services);
  ASSERT_EQ(services->services.size(), 1u);
  EXPECT_EQ(services->services[0].name, "good");
  EXPECT_EQ(services->problems.size(), 1u);
  EXPECT_TRUE(parse_server_text(R"({"op":"parameterValues","parameters":[{"name":"x","value":NaN}]})"));
  EXPECT_TRUE(parse_server_text(R"({"op":"serverInfo","capabilities":7,"metadata":[1]})"));
  const auto failed = parse_server_text(service_call_failure(3, 4, "no"));
  ASSERT_TRUE(failed && failed->failed_call);
  EXPECT_EQ(failed->failed_call->service, 3u);
  EXPECT_EQ(failed->failed_call->call, 4u);
  EXPECT_EQ(failed->failed_call->message, "no");
}

TEST(Foxglove, BinaryMessagesOfAServerAreReadBackAndSurviveEveryTruncation) {
  const std::string answer = service_response(10, 12, "json", "{}");
  const auto read = parse_service_answer(answer);
  ASSERT_TRUE(read && *read);
  EXPECT_EQ((*read)->service, 10u);
  EXPECT_EQ((*read)->call, 12u);
  EXPECT_EQ((*read)->payload, "{}");
  for (std::size_t n = 1; n + 2 < answer.size(); ++n) EXPECT_FALSE(parse_service_answer(answer.substr(0, n)));

  std::string numbered;
  append_numbered_data_header(numbered, 7, 5, {.sequence = 3, .publish_ns = 6});
  ASSERT_EQ(numbered.size(), kNumberedDataHeaderBytes);
  for (std::size_t n = 1; n < numbered.size(); ++n) EXPECT_FALSE(parse_message_data(numbered.substr(0, n)));
  const std::string frame = numbered + "abc";
  const auto data = parse_message_data(frame);
  ASSERT_TRUE(data && *data && (*data)->published);
  EXPECT_EQ((*data)->log_time_ns, 5u);
  EXPECT_EQ((*data)->published->sequence, 3u);
  EXPECT_EQ((*data)->published->publish_ns, 6u);
  EXPECT_EQ((*data)->payload, "abc");
  EXPECT_FALSE(parse_service_answer(numbered)->has_value());
}

}  // namespace
}  // namespace robot::net::foxglove
