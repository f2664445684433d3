# Writes the C++ file OUTPUT, which holds the schemas FOLDER/NAME.desc, serialised FileDescriptorSets, for each of NAMES.
set(schemas "")
foreach(name IN LISTS NAMES)
  file(READ ${FOLDER}/${name}.desc hex HEX)
  string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${hex}")
  string(APPEND schemas "constexpr char k${name}Bytes[] = \"${bytes}\";
const EmbeddedSchema k${name}{\"foxglove.${name}\", {k${name}Bytes, sizeof k${name}Bytes - 1}};\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"robot/net/scene/schemas.h\"

namespace robot::net {

${schemas}
memory::Schema EmbeddedSchema::schema() const {
  return {.name = std::string(name), .encoding = \"protobuf\", .bytes = std::string(bytes)};
}

}  // namespace robot::net
")
