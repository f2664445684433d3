// fake_runtime LINK [--heard | --wild SEED]: sends the guardian an order with every report until SIGTERM, then a
// goodbye. Prints {"mode", "doing", "reason"} when that changes.
//
// --heard: reports that the GameController has the robot play. --wild: orders are random bytes, also of wrong sizes.

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

#include "robot/nao/guardian/guardian_client.h"

namespace {

using namespace robot;
using namespace robot::nao;

volatile std::sig_atomic_t ended = 0;

void tell(const Report& report) {
  std::printf("{\"mode\": \"%s\", \"doing\": \"%s\", \"reason\": \"%s\", \"problem\": \"%s\", \"taken\": %s}\n",
              name_of(report.mode), name_of(report.doing), sentence_of(report.reason), report.problem.data(),
              report.lola_is_taken ? "true" : "false");
  std::fflush(stdout);
}

Order wild_order(std::mt19937& random) {
  Order order;
  auto* bytes = reinterpret_cast<unsigned char*>(&order);
  for (std::size_t i = sizeof order.layout; i < sizeof order; ++i) bytes[i] = static_cast<unsigned char>(random());
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    order.drives[joint] = random() % 2;
    if (random() % 4) order.position[joint] = static_cast<float>(random() % 8000) / 1000 - 4;
    if (random() % 4) order.stiffness[joint] = static_cast<float>(random() % 2000) / 1000 - 0.5f;
  }
  if (random() % 2) order.posture = Order::Posture::stand;
  return order;
}

int fake_runtime_main(int argc, char** argv) {
  const std::string link = argc > 1 ? argv[1] : "", how = argc > 2 ? argv[2] : "";
  std::signal(SIGTERM, [](int) { ended = 1; });
  std::mt19937 random(argc > 3 ? static_cast<unsigned>(std::atoi(argv[3])) : 0);
  Result<GuardianClient> client = GuardianClient::open(link);
  if (!client) {
    std::fprintf(stderr, "%s\n", client.error().c_str());
    return 2;
  }
  std::string told;
  Order order;
  if (how == "--heard") order.game = {.heard = 1, .state = GameState::playing, .player = 2};
  while (!ended) {
    const auto report = client->next(100);
    if (!report) return 1;
    if (*report) {
      const Report& r = **report;
      const std::string now = std::to_string(static_cast<int>(r.mode)) + "/" +
                              std::to_string(static_cast<int>(r.doing)) + "/" +
                              std::to_string(static_cast<int>(r.reason)) + r.problem.data();
      if (now != told) tell(r);
      told = now;
    }
    if (how == "--wild") order = wild_order(random);
    if (!client->give(order)) return 1;
  }
  return client->ask(Request::What::goodbye) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) { return fake_runtime_main(argc, argv); }
