# Writes the C++ file OUTPUT, which holds the schemas FOLDER/NAME.desc, serialised FileDescriptorSets, for each of NAMES.
set(arrays "")
set(cases "")
foreach(name IN LISTS NAMES)
  file(READ ${FOLDER}/${name}.desc hex HEX)
  string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${hex}")
  string(APPEND arrays "constexpr char k${name}[] = \"${bytes}\";\n")
  string(APPEND cases "  if (name == \"${name}\") return {k${name}, sizeof k${name} - 1};\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"robot/net/scene/schemas.h\"

namespace robot::net {
namespace {

${arrays}
}  // namespace

std::string_view embedded_schema(std::string_view name) {
${cases}  return {};
}

}  // namespace robot::net
")
