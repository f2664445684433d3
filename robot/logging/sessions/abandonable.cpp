#include "robot/logging/sessions/abandonable.h"

#include <utility>

namespace robot::logging {
namespace {

class Abandonable final : public OutProvider {
 public:
  Abandonable(std::shared_ptr<const std::atomic<bool>> gone, std::unique_ptr<OutProvider> stream)
      : gone_(std::move(gone)), stream_(std::move(stream)) {}

  Result<void> open(const memory::ChannelInfo& info) override {
    abandoned_ = *gone_;
    return abandoned_ ? Result<void>() : stream_->open(info);
  }

  Result<void> write(const memory::VersionPtr& version) override {
    if (abandoned_) return Error{"the folder of the session is gone"};
    return stream_->write(version);
  }

  Result<void> close() override { return abandoned_ ? Result<void>() : stream_->close(); }

  bool wants(const memory::Version& version) override { return stream_->wants(version); }
  Patience patience() const override { return stream_->patience(); }
  std::uint64_t flush_due_ns() const override { return stream_->flush_due_ns(); }
  Result<void> flush() override { return stream_->flush(); }
  std::uint64_t buffered() const override { return stream_->buffered(); }
  std::uint64_t lost_afterwards() const override { return stream_->lost_afterwards(); }
  void cancel() override { stream_->cancel(); }

 private:
  const std::shared_ptr<const std::atomic<bool>> gone_;
  const std::unique_ptr<OutProvider> stream_;
  bool abandoned_ = false;
};

}  // namespace

std::unique_ptr<OutProvider> unless_gone(std::shared_ptr<const std::atomic<bool>> gone,
                                         std::unique_ptr<OutProvider> stream) {
  return std::make_unique<Abandonable>(std::move(gone), std::move(stream));
}

}  // namespace robot::logging
