// Names of the programs that hold a socket or a device.
#pragma once

#include <filesystem>
#include <string>

namespace robot::nao {

/// Returns the other program that is connected to the local socket that listens at `path`, as "bhuman (process 123)".
/// Returns an empty string if there is none or the system does not show it. Asks the kernel (sock_diag) and /proc.
std::string who_is_connected_to(const std::filesystem::path& path);

/// Returns the other program that has the device `path` open, in the same form.
std::string who_has_open(const std::filesystem::path& path);

}  // namespace robot::nao
