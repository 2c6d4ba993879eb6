// Reads an archive that somebody unknown has made: only the members that were asked for, and never more than fits.
//
// Nothing is unpacked to a path that the archive names, so there is nothing to escape from: a member is taken where its
// name is one of the wanted names, and its bytes come back in memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "judge/run/source_file.hpp"

namespace atelier::grade {

/// What an archive may cost. The bytes of a member are counted while it inflates; what its header claims counts for
/// nothing.
struct ZipLimits {
  std::size_t archive_bytes = 64 << 20;
  int members = 10'000;                            ///< listed, wanted or not
  std::size_t member_bytes = judge::source_limit;  ///< of one wanted member, inflated
  std::size_t total_bytes = 16 << 20;              ///< of all wanted members together
  double ratio = 200;  ///< inflated bytes a byte of the archive; text deflates to a tenth at best
};

struct ZipContents {
  std::map<std::string, std::string> files;  ///< bytes by wanted name, "NN-name/FILE"
  judge::NotTaken not_taken;                 ///< wanted members that are there and cannot be taken
  std::vector<std::string> passed_over;      ///< sentences on other members that no honest archive has, printable
  std::vector<std::string> names;            ///< of all members, as they are
};

/// The wanted members of a ZIP. A member may have one folder in front ("submission/02-blinn-phong/blinn_phong.cpp"),
/// the same for all. Wanted members that are links, special files or larger than limits.member_bytes are not taken;
/// members whose path is absolute or climbs ("..") and unwanted links are passed over and told of; what else is not
/// wanted is left alone. Throws Error naming the archive and, where one is at fault, the member: empty, not a ZIP, cut
/// off, encrypted, over another limit, a wanted name twice, two different folders in front.
ZipContents read_zip(const std::filesystem::path& file, const std::set<std::string>& wanted,
                     const ZipLimits& limits = {});

}  // namespace atelier::grade
