// A thread for jobs that the thread of a caller must not wait for.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "robot/core/lock.h"

namespace robot::logging {

/// A thread that does jobs with names, one after the other. It starts with the first job. If the system refuses it, the
/// caller does the jobs. Any thread.
class JobThread {
 public:
  explicit JobThread(std::function<void(const std::string&)> job) : job_(std::move(job)) {}

  /// Ends the thread after its present job.
  ~JobThread();
  JobThread(const JobThread&) = delete;
  JobThread& operator=(const JobThread&) = delete;

  /// Adds a job for each name that does not wait for one yet. Waits until these are done, at most `wait_ns`.
  void add(const std::vector<std::string>& names, std::uint64_t wait_ns);

 private:
  void run();
  bool is_done(const std::vector<std::string>& names) const;

  const std::function<void(const std::string&)> job_;
  Mutex lock_;
  Condition changed_;
  std::deque<std::string> waiting_;  // names
  std::string present_;              // name of the running job, or empty
  bool ended_ = false;
  std::thread thread_;
};

}  // namespace robot::logging
