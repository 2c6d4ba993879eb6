// Names of the folders that the students' results go to.
#pragma once

#include <set>
#include <string>

namespace atelier::grade {

/// A file name of [a-z0-9.-] that is like `text`: letters with accents lose them ("Müller" is "mueller"), other
/// characters become '-'. At most 60 bytes; begins and ends with a letter or digit; no name that Windows reserves
/// ("con", "com1"). Empty if nothing is left.
std::string file_name_of(const std::string& text);

/// A student's id: "name-identifier" as far as they are known, or "student"; with "-2", "-3" ... if it is in `used`,
/// where it is added.
std::string new_student_id(const std::string& name, const std::string& identifier, std::set<std::string>& used);

}  // namespace atelier::grade
