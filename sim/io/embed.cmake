# Writes the C++ file OUTPUT, which holds JSON files as texts. FILES are their paths below FOLDER, without ".json",
# such as "models/match".
set(entries "")
foreach(file IN LISTS FILES)
  file(READ ${FOLDER}/${file}.json text)
  get_filename_component(kind ${file} DIRECTORY)
  if(kind STREQUAL falls)  # the counts are not played
    string(REGEX REPLACE ",\n  \"counts\": .*" "\n}\n" text "${text}")
  endif()
  get_filename_component(name ${file} NAME)
  string(APPEND entries "    {\"${kind}\", \"${name}\", R\"json(${text})json\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"sim/io/embedded.h\"

namespace sim::io {
namespace {

constexpr Embedded kFiles[] = {
${entries}};

}  // namespace

std::span<const Embedded> embedded_files() { return kFiles; }

}  // namespace sim::io
")
