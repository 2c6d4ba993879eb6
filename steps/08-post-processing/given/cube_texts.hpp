// The texts of .cube files that the cases of read_table use, by their numbers. Given.
#pragma once

#include <string>
#include <vector>

namespace atelier {

struct CubeText {
  std::string text, title;
};

/// The case `read-table`: each is a table.
const std::vector<CubeText>& texts_to_read();

/// The case `read-refuses`: first tables, then what read_table refuses.
const std::vector<std::string>& texts_to_judge();

}  // namespace atelier
