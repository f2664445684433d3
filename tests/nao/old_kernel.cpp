// old_kernel 2.6.33|4.4 PROGRAM [ARGUMENT…]: runs a program as if the kernel were that old. System calls that it did not
// have yet are answered with "not implemented", as it would. Other differences are not emulated.
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <iterator>

namespace {

/// The last system call of a kernel, in the numbers of 64-bit and of 32-bit programs.
struct Kernel {
  const char* name;
  unsigned last_64, last_32;
};
constexpr Kernel kKernels[] = {
    {"2.6.33", 299, 337},  // recvmmsg: NAOqi OS of the V4 and V5
    {"4.4", 325, 376},     // mlock2: NAOqi OS of the V6
};

bool grow_old(const Kernel& kernel) {
  constexpr unsigned kAllow = SECCOMP_RET_ALLOW, kNotImplemented = SECCOMP_RET_ERRNO | ENOSYS;
  sock_filter program[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, AUDIT_ARCH_I386, 2, 0),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JGT | BPF_K, kernel.last_64, 3, 2),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JGT | BPF_K, kernel.last_32, 1, 0),
      BPF_STMT(BPF_RET | BPF_K, kAllow),
      BPF_STMT(BPF_RET | BPF_K, kNotImplemented),
  };
  const sock_fprog filter{.len = static_cast<unsigned short>(std::size(program)), .filter = program};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

}  // namespace

int main(int argc, char** argv) {
  const Kernel* const end = std::end(kKernels);
  const Kernel* kernel = std::begin(kKernels);
  while (kernel != end && (argc < 3 || std::strcmp(argv[1], kernel->name) != 0)) ++kernel;
  if (kernel == end) {
    std::fprintf(stderr, "old_kernel: expected 2.6.33 or 4.4 and a program, got '%s'\n", argc < 2 ? "" : argv[1]);
    return 2;
  }
  if (!grow_old(*kernel)) {
    std::fprintf(stderr, "old_kernel: this kernel does not let its calls be filtered: %s\n", std::strerror(errno));
    return 2;
  }
  execvp(argv[2], argv + 2);
  std::fprintf(stderr, "old_kernel: '%s' cannot be run: %s\n", argv[2], std::strerror(errno));
  return 2;
}
