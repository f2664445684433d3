#include "robot/core/thread.h"

#include <pthread.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <string>
#include <system_error>
#include <utility>

namespace robot {

Result<void> start_thread(std::thread& thread, std::string_view purpose, std::function<void()> run) {
  try {
    thread = std::thread(std::move(run));
    return {};
  } catch (const std::system_error& error) {
    return Error{"cannot start the thread '" + std::string(purpose) + "': " + error.code().message()};
  }
}

void name_thread(std::string_view name) { pthread_setname_np(pthread_self(), std::string(name.substr(0, 15)).c_str()); }

void become_background_thread(std::string_view name) {
  name_thread(name);
  // on Linux a nice value belongs to a thread; lowering the priority needs no rights
  setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), 10);
}

}  // namespace robot
