# Nao V5: one core of an Intel Atom Z530 (Bonnell: SSSE3, MOVBE), 32 bit. Files may be larger than 2 GB.
set(CMAKE_SYSTEM_PROCESSOR i686)
set(nao_architecture i386)
set(nao_triple i686-linux-gnu)
# with a frame pointer and unwind tables for calls only, exceptions need half as much space
string(CONCAT nao_flags "-march=bonnell -mfpmath=sse -D_FILE_OFFSET_BITS=64 "
  "-fno-omit-frame-pointer -fno-asynchronous-unwind-tables")
include(${CMAKE_CURRENT_LIST_DIR}/nao.cmake)
