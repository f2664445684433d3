# The common part of the toolchains of all Naos: this machine's clang, and headers and libraries only of the sysroot.
# The including file sets CMAKE_SYSTEM_PROCESSOR, nao_architecture, nao_triple and nao_flags first.
set(CMAKE_SYSTEM_NAME Linux)
cmake_path(SET CMAKE_SYSROOT NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/../build/sysroot/${nao_architecture})
if(NOT EXISTS ${CMAKE_SYSROOT}.complete)
  message(FATAL_ERROR
    "The sysroot build/sysroot/${nao_architecture} is missing: run toolchain/sysroot ${nao_architecture}")
endif()

set(CMAKE_C_COMPILER clang)
set(CMAKE_CXX_COMPILER clang++)
set(CMAKE_C_COMPILER_TARGET ${nao_triple})
set(CMAKE_CXX_COMPILER_TARGET ${nao_triple})
set(CMAKE_C_FLAGS_INIT "${nao_flags} -ffunction-sections -fdata-sections")
set(CMAKE_CXX_FLAGS_INIT "${nao_flags} -ffunction-sections -fdata-sections")
# Fully static, because the robots' C libraries are of 2011 to 2022. Unused sections and symbols are removed, and of
# equal functions one is kept; nothing of ours compares addresses of functions. That is a fiftieth of a program.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-fuse-ld=lld -static -Wl,--gc-sections -Wl,--icf=all -s")

# The compiler searches the sysroot's usr/include last by itself. `-isystem` would put it first and break the order.
# CMake notices this itself, except when a compiler cache rewrites the paths that the compiler prints.
set(CMAKE_NO_SYSTEM_FROM_IMPORTED ON)

# programs (protoc, node) come from this machine, everything else from the sysroot
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_LIBRARY_ARCHITECTURE ${nao_architecture}-linux-gnu)
if(nao_architecture STREQUAL amd64)
  set(CMAKE_LIBRARY_ARCHITECTURE x86_64-linux-gnu)
endif()
