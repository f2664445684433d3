#include "robot/core/lock.h"

#include <algorithm>
#include <cassert>
#include <ctime>

#include "robot/core/clock.h"

namespace robot {
namespace {

// the calls below fail only if we misuse them, which is a bug
void check([[maybe_unused]] int error) { assert(error == 0); }

}  // namespace

Mutex::Mutex() {
  pthread_mutexattr_t attributes;
  check(pthread_mutexattr_init(&attributes));
  check(pthread_mutexattr_setprotocol(&attributes, PTHREAD_PRIO_INHERIT));
  check(pthread_mutex_init(&mutex_, &attributes));
  check(pthread_mutexattr_destroy(&attributes));
}

Mutex::~Mutex() { pthread_mutex_destroy(&mutex_); }

void Mutex::lock() { check(pthread_mutex_lock(&mutex_)); }
void Mutex::unlock() { check(pthread_mutex_unlock(&mutex_)); }
bool Mutex::try_lock() { return pthread_mutex_trylock(&mutex_) == 0; }

Condition::Condition() {
  pthread_condattr_t attributes;
  check(pthread_condattr_init(&attributes));
  check(pthread_condattr_setclock(&attributes, CLOCK_MONOTONIC));
  check(pthread_cond_init(&condition_, &attributes));
  check(pthread_condattr_destroy(&attributes));
}

Condition::~Condition() { pthread_cond_destroy(&condition_); }

void Condition::wait(Mutex& mutex) { check(pthread_cond_wait(&condition_, &mutex.mutex_)); }

void Condition::wait_until(Mutex& mutex, std::uint64_t deadline_ns) {
  // a time_t of 32 bits ends in 2038, so one wait lasts at most an hour; the caller checks and waits again
  deadline_ns = std::min(deadline_ns, monotonic_ns() + 3600 * kSecond);
  const timespec deadline{.tv_sec = static_cast<time_t>(deadline_ns / kSecond),
                          .tv_nsec = static_cast<long>(deadline_ns % kSecond)};
  pthread_cond_timedwait(&condition_, &mutex.mutex_, &deadline);
}

void Condition::notify_one() { pthread_cond_signal(&condition_); }
void Condition::notify_all() { pthread_cond_broadcast(&condition_); }

}  // namespace robot
