#include "cli/author/unwritten.hpp"

#include "cli/author/marked_text.hpp"
#include "cli/student/function_text.hpp"

namespace atelier {

std::string with_unwritten(std::string marked, const std::set<std::string>& functions, const std::string& file,
                           const std::string& step) {
  for (const std::string& name : functions)
    if (const auto found = find_function(marked, name))
      marked.replace(marked.find(found->text), found->text.size(), cut_skeleton(found->text, file, step));
  return marked;
}

}  // namespace atelier
