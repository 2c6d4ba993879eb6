#include "judge/report/preview.hpp"

#include <fmt/format.h>

#include <array>

#include "base/error.hpp"
#include "base/file.hpp"
#include "image/draw.hpp"
#include "image_io/image_io.hpp"
#include "judge/report/report_pictures.hpp"

namespace atelier::judge {

Image preview_image(const Evidence& evidence) {
  if (!evidence.yours.same_size(evidence.reference)) {
    throw Error(fmt::format("preview: yours is {} x {} pixels and the reference {} x {}", evidence.yours.width(),
                            evidence.yours.height(), evidence.reference.width(), evidence.reference.height()));
  }
  const Displayed shown = displayed(evidence.yours, evidence.reference);
  float largest = 0;
  const std::array<Image, 3> row = {shown.yours, shown.reference,
                                    difference_picture(shown.yours, shown.reference, largest)};
  return side_by_side(row);
}

void write_preview(const std::filesystem::path& file, const Evidence& evidence, int longest) {
  const Image picture = shrink_to(preview_image(evidence), longest);
  write_file(file, std::span<const std::byte>(encode_png(picture, {.encoding = Encoding::srgb})));
}

}  // namespace atelier::judge
