#include "sim/io/fall_table.h"

#include "sim/io/source.h"

namespace sim::io {
namespace {

constexpr std::string_view kEvidence[] = {"about", "made_by", "counts"};

/// Calls see(name, struct) for each section.
template <class AnyTable, class See>
void visit_table(AnyTable& table, See&& see) {
  see("collisions", table.collisions);
  see("alone", table.alone);
  see("stiff_rates", table.stiff.rates);
  see("stiff_standing", table.stiff.standing);
  see("stiff_walking", table.stiff.walking);
  see("stiff_getting_up", table.stiff.getting_up);
  see("soft_rates", table.soft.rates);
  see("soft_standing", table.soft.standing);
  see("soft_walking", table.soft.walking);
  see("soft_getting_up", table.soft.getting_up);
}

void read_table(Reader& reader, const Json& object, const std::string& path, Fields fields, motion::FallTable& into) {
  std::vector<std::string_view> known(std::begin(kEvidence), std::end(kEvidence));
  visit_table(into, [&](const char* name, auto& section) {
    known.push_back(name);
    const std::string place = Reader::below(path, name);
    if (const auto found = object.find(name); found != object.end())
      reader.read(*found, place, fields, section);
    else if (fields == Fields::all)
      reader.refuse(place + " is missing");
  });
  reader.refuse_unknown(object, path, known);
  into.given = true;
  if (const float share = into.alone.front + into.alone.back; share > 1.001f)
    reader.refuse(Reader::below(path, "alone") + ": front and back must be at most 1 together, got " +
                  short_text(share));
}

void read_named(Reader& reader, const std::string& name, const std::string& path, motion::FallTable& into) {
  const auto source = find_source("falls", "table of falls", name);
  if (!source) return reader.refuse(source.error());
  const auto json = parse_object(source->text, source->called);
  if (!json) return reader.refuse(json.error());
  Sources sources;
  Reader own(source->called, &sources);
  read_table(own, *json, "", Fields::all, into);
  if (!own.good()) return reader.refuse(own.error().sentence);
  reader.add_sources(path, sources);
}

}  // namespace

void read_fall_table(Reader& reader, const Json& entry, const std::string& path, motion::FallTable& into) {
  if (entry == false) {
    into = {};
  } else if (entry.is_string()) {
    read_named(reader, entry.get<std::string>(), path, into);
  } else if (entry.is_object()) {
    read_table(reader, entry, path, into.given ? Fields::some : Fields::all, into);
  } else {
    reader.refuse(path + " must be a table of falls, its name or its path, or false, got " + shown(entry));
  }
}

Json written_fall_table(const motion::FallTable& table, const std::string& path, const Sources& sources) {
  Json object = Json::object();
  visit_table(table, [&](const char* name, const auto& section) {
    object[name] = written(section, Reader::below(path, name), sources);
  });
  return object;
}

}  // namespace sim::io
