// Models of reality as JSON: sim/data/models/*.json and what users make of them.
//
// A file has a name and one section per struct of sim::Models; an entry is a value or {"value", "unit", "source"}.
// With "based_on" a file has only the entries that differ from that file. A kick is identified by its name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "sim/io/reader.h"
#include "sim/match/params.h"

namespace sim::io {

/// Loads models by the name of an embedded file, or by path. Behind it may follow changes of effects or of any field:
/// "match,falls=on,walk.forward=0.2". The models have the name in the file, plus the changes. `sources` receives the
/// source of each value; a changed value has none. A changed table of falls needs the effect falls.
robot::Result<Models> load_models(const std::string& name, Sources* sources = nullptr);

/// Loads the models of a team into `team`. Behind the models of all robots may follow those of single robots, by their
/// player number: "match+3=perfect+5=match,walk.forward=0.2". `players` is the number of players.
robot::Result<void> load_team_models(const std::string& name, int players, Team& team);
/// Returns the names of the models in the name of a team's: "match" and "perfect" of "match+3=perfect".
std::vector<std::string> names_of_models(const std::string& name);

/// Returns the tables of falls in the name of a team's: "mine.json" of "match,falls.table=mine.json".
std::vector<std::string> names_of_falls(const std::string& name);
/// Returns the name of the same models of a team, but all robots fall by this table (sim/io/fall_table.h).
std::string with_falls(const std::string& name, const std::string& table);

/// Parses the models described in `text`; `called` opens the sentence of an Error ("models 'match'").
robot::Result<Models> parse_models(std::string_view text, const std::string& called, Sources* sources = nullptr);

/// Returns a description that reads back identically, with the sources that loading found.
std::string print_models(const Models& models, const Sources& sources = {});

}  // namespace sim::io
