# Writes build_id.h when the commit has changed. Runs at every build, and leaves the file alone if nothing changed.
execute_process(COMMAND git -C ${SOURCE_DIR} rev-parse --short=12 HEAD
  OUTPUT_VARIABLE FORESIGHT_BUILD_ID OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed ERROR_QUIET)
if(failed)
  set(FORESIGHT_BUILD_ID unknown)
else()
  execute_process(COMMAND git -C ${SOURCE_DIR} status --porcelain --untracked-files=no
    OUTPUT_VARIABLE changes ERROR_QUIET)
  if(changes)
    string(APPEND FORESIGHT_BUILD_ID +)
  endif()
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/build_id.h.in ${OUTPUT} @ONLY)
