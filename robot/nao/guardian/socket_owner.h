// Who holds what we would like to have.
#pragma once

#include <filesystem>
#include <string>

namespace robot::nao {

/// The program that is connected to the local socket that listens at `path`, as "bhuman (process 123)"; empty if there is
/// none but us, or the system does not tell. Asks the kernel (sock_diag) and /proc.
std::string who_is_connected_to(const std::filesystem::path& path);

/// The program that has `path` (a device) open, likewise.
std::string who_has_open(const std::filesystem::path& path);

}  // namespace robot::nao
