#include "image_io/exact_gif.hpp"

#include <fmt/format.h>
#include <gif_lib.h>

#include <map>
#include <memory>

#include "base/error.hpp"

namespace atelier::image_io {

std::optional<IndexedFrame> indexed(const Samples& samples) {
  constexpr std::size_t most = 256;
  IndexedFrame frame{.width = samples.width, .height = samples.height};
  std::map<std::array<std::uint8_t, 3>, std::uint8_t> index_of;
  for (std::size_t i = 0; i < samples.bytes.size(); i += std::size_t(samples.channels)) {
    const std::array colour = {samples.bytes[i], samples.bytes[i + 1], samples.bytes[i + 2]};
    const auto [known, is_new] = index_of.try_emplace(colour, std::uint8_t(frame.palette.size()));
    if (is_new) {
      if (frame.palette.size() == most) return {};
      frame.palette.push_back(colour);
    }
    frame.indices.push_back(known->second);
  }
  return frame;
}

Samples samples_of(const IndexedFrame& frame) {
  Samples samples{.width = frame.width, .height = frame.height, .channels = 3, .type = Samples::Type::bits8};
  for (const std::uint8_t index : frame.indices)
    samples.bytes.insert(samples.bytes.end(), frame.palette[index].begin(), frame.palette[index].end());
  samples.srgb = true;
  return samples;
}

namespace {

using Bytes = std::vector<std::byte>;

int append(GifFileType* gif, const GifByteType* from, int count) {
  const auto* const first = reinterpret_cast<const std::byte*>(from);
  auto& bytes = *static_cast<Bytes*>(gif->UserData);
  bytes.insert(bytes.end(), first, first + count);
  return count;
}

void require(int result, int error) {
  if (result == GIF_OK) return;
  const char* const words = GifErrorString(error);
  throw Error(words ? words : "giflib gives no reason");
}

/// The number of colours must be a power of two, at least 2.
std::unique_ptr<ColorMapObject, decltype(&GifFreeMapObject)> colour_map_of(const IndexedFrame& frame) {
  int size = 2;
  while (size < int(frame.palette.size())) size *= 2;
  std::unique_ptr<ColorMapObject, decltype(&GifFreeMapObject)> map(GifMakeMapObject(size, nullptr), GifFreeMapObject);
  if (!map) throw Error("giflib has no memory for a palette");
  for (std::size_t i = 0; i < frame.palette.size(); ++i)
    map->Colors[i] = {frame.palette[i][0], frame.palette[i][1], frame.palette[i][2]};
  return map;
}

void put_loop_forever(GifFileType* gif) {
  static constexpr GifByteType forever[] = {1, 0, 0};
  require(EGifPutExtensionLeader(gif, APPLICATION_EXT_FUNC_CODE), gif->Error);
  require(EGifPutExtensionBlock(gif, 11, "NETSCAPE2.0"), gif->Error);
  require(EGifPutExtensionBlock(gif, sizeof forever, forever), gif->Error);
  require(EGifPutExtensionTrailer(gif), gif->Error);
}

void put_frame(GifFileType* gif, const IndexedFrame& frame, int delay) {
  const GraphicsControlBlock control{.DisposalMode = DISPOSAL_UNSPECIFIED,
                                     .UserInputFlag = false,
                                     .DelayTime = delay,
                                     .TransparentColor = NO_TRANSPARENT_COLOR};
  GifByteType extension[4];
  require(EGifPutExtension(gif, GRAPHICS_EXT_FUNC_CODE, int(EGifGCBToExtension(&control, extension)), extension),
          gif->Error);
  const auto map = colour_map_of(frame);
  require(EGifPutImageDesc(gif, 0, 0, frame.width, frame.height, false, map.get()), gif->Error);
  std::vector<std::uint8_t> indices = frame.indices;  // giflib masks the bits of what it writes in place
  for (int y = 0; y < frame.height; ++y)
    require(EGifPutLine(gif, &indices[std::size_t(y) * std::size_t(frame.width)], frame.width), gif->Error);
}

}  // namespace

std::vector<std::byte> encode_exact_gif(const std::vector<IndexedFrame>& frames, int delay) {
  Bytes bytes;
  int error = 0;
  GifFileType* const gif = EGifOpen(&bytes, append, &error);
  if (!gif) require(GIF_ERROR, error);
  // Closes what an exception leaves open.
  const auto close = [](GifFileType* open) { EGifCloseFile(open, nullptr); };
  std::unique_ptr<GifFileType, decltype(close)> open(gif, close);
  EGifSetGifVersion(gif, true);
  require(EGifPutScreenDesc(gif, frames.front().width, frames.front().height, 8, 0, nullptr), gif->Error);
  put_loop_forever(gif);
  for (const IndexedFrame& frame : frames) put_frame(gif, frame, delay);
  require(EGifCloseFile(open.release(), &error), error);
  return bytes;
}

}  // namespace atelier::image_io
