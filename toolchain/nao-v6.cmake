# Nao V6: four cores of an Intel Atom E3845 (Silvermont: SSE4.2, MOVBE, RDRAND; no AVX), 64 bit.
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(nao_architecture amd64)
set(nao_triple x86_64-linux-gnu)
set(nao_flags "-march=silvermont")
include(${CMAKE_CURRENT_LIST_DIR}/nao.cmake)
