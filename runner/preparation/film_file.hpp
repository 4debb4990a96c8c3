#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "runner/preparation/frame_source.hpp"

namespace bimodal::runner {

/// A film as bytes, without loss: each picture as its difference from the one before, deflated (a
/// speaking face of 640 x 720 pixels: about 100 KB a picture). A checksum over everything, the key
/// included, stands at the end. `checkpoint` is called before each picture. Precondition: all
/// pictures have one size.
[[nodiscard]] std::string packed(const Film& film,
                                 std::string_view key,
                                 const Checkpoint& checkpoint);

/// So many bytes are at the end of every film, all of them hexadecimal digits.
inline constexpr std::size_t kFilmDigest = 64;

/// The very film; absent if the bytes are not what packed() made under this key. The bytes are not
/// trusted.
[[nodiscard]] std::optional<Film> unpacked(std::string_view bytes,
                                           std::string_view key,
                                           const Checkpoint& checkpoint);

}  // namespace bimodal::runner
