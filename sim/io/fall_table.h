// Tables of falls as JSON: sim/data/falls/*.json and what bench_walk makes of a walk.
//
// A table has the sections collisions, alone, stiff_rates, stiff_standing, stiff_walking, stiff_getting_up, and likewise
// soft_…. A push to the front comes from behind. The entries about, made_by and counts tell where the figures come from; no
// game reads them.
#pragma once

#include "sim/io/reader.h"
#include "sim/motion/fall_table.h"

namespace sim::io {

/// Reads the table at `path`: the name of an embedded table, the path of a file, or false for none. An object is a whole table,
/// or changes one that is given.
void read_fall_table(Reader& reader, const Json& entry, const std::string& path, motion::FallTable& into);

/// Returns the object at `path` that `read_fall_table` reads back.
Json written_fall_table(const motion::FallTable& table, const std::string& path, const Sources& sources);

}  // namespace sim::io
