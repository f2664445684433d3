// The families of printed tags that are told apart safely.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace robot::truth::tags {

/// Returns the number of tags in a family, or nothing if the family is not one of family_names(). The family tag16h5 is
/// not among them: of 500 random squares one looks like one of its tags.
std::optional<int> tags_in_family(std::string_view family);

/// Returns the names for a sentence: "tag36h11, tag36h10 or tag25h9".
std::string family_names();

}  // namespace robot::truth::tags
