#include "robot/net/foxglove/stream_control.h"

#include <utility>

namespace robot::net {

std::uint64_t StreamControl::start(std::uint32_t channel, std::shared_ptr<memory::Channel> source,
                                   const Derived* derived) {
  const std::uint64_t stream = ++last_stream_;
  std::unique_ptr<logging::OutProvider> provider = std::make_unique<WebSocketOutProvider>(inbox_, channel, stream);
  if (derived)
    provider = std::make_unique<ConvertingOutProvider>(std::move(provider), derived->info, derived->make_convert());

  // std::function needs a copyable target
  auto shared = std::make_shared<std::unique_ptr<logging::OutProvider>>(std::move(provider));
  worker_.post([this, stream, source = std::move(source), shared] {
    running_[stream] = streams_.start(source, std::move(*shared));
  });
  return stream;
}

void StreamControl::stop(std::uint64_t stream) {
  worker_.post([this, stream] {
    if (const auto found = running_.extract(stream)) streams_.stop(found.mapped());
  });
}

void StreamControl::discard(std::shared_ptr<void> thing) {
  worker_.post([thing = std::move(thing)]() mutable { thing.reset(); });
}

void StreamControl::finish() {
  worker_.post([this] {
    for (const auto& [stream, id] : std::exchange(running_, {})) streams_.stop(id);
  });
  worker_.finish();
}

}  // namespace robot::net
