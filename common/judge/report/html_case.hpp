// The parts of the HTML report that belong to one case.
#pragma once

#include <string>
#include <vector>

#include "judge/report/report_words.hpp"

namespace atelier::judge {

/// The coloured word for a status.
std::string status_html(Status status);

/// The name of a case as a link to the place of that case.
std::string name_link(const std::string& anchor, const CaseResult& result);

/// A remark as a term and its description; a command to rerun can be copied.
std::string remark_html(const Remark& remark);
std::string remarks_html(const std::vector<Remark>& remarks);

/// Text as it is, under a label; nothing for an empty text. `kind` is the class of the block.
std::string text_block(const char* label, const std::string& text, const char* kind = "output");

/// The pictures of a case: yours, the reference and the difference, to which the script adds a slider; and the rest.
/// Both are empty without pictures. `at_once`: the first ones are in sight, so a browser need not load them lazily.
struct PicturesHtml {
  std::string first, rest;
};
PicturesHtml pictures_html(const CaseResult& result, bool at_once = false);

/// What was measured, the inputs and numbers of a probe: what follows the remarks of a case.
std::string numbers_html(const CaseResult& result);

/// A folded case with all that is known about it; its id is `anchor`.
std::string case_html(const std::string& anchor, const CaseResult& result);

/// A case that has passed, with its pictures in sight.
std::string card_html(const std::string& anchor, const CaseResult& result);

}  // namespace atelier::judge
