# Nao V4: the computer of the V5.
include(${CMAKE_CURRENT_LIST_DIR}/nao-v5.cmake)
