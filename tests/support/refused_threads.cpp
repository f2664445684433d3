#include "tests/support/refused_threads.h"

#include <dlfcn.h>
#include <pthread.h>

#include <atomic>
#include <cerrno>

namespace tests {
namespace {

std::atomic<int> to_refuse = 0, refused = 0;

}  // namespace

void refuse_threads(int count) { to_refuse = count; }
int refused_threads() { return refused; }

}  // namespace tests

#ifndef TESTS_WITH_SANITIZER
// stands before the function of the C library, also for the C++ library
extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*),
                              void* argument) {
  for (int left = tests::to_refuse; left > 0;)
    if (tests::to_refuse.compare_exchange_weak(left, left - 1)) {
      ++tests::refused;
      return EAGAIN;
    }
  using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
  static const auto create = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "pthread_create"));
  return create(thread, attributes, run, argument);
}
#endif
