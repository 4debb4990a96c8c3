#pragma once

#include <cstdint>
#include <optional>

union SDL_Event;

namespace bimodal::runner {

/// The code of linux/input-event-codes.h for what went down in `event`: a key by its place on the
/// keyboard (SDL_KEYDOWN), one of the five mouse buttons (SDL_MOUSEBUTTONDOWN). Absent for other
/// events, for repeats of a held key, and for keys that ordinary keyboards have not got.
[[nodiscard]] std::optional<std::uint32_t> press_code(const SDL_Event& event);

}  // namespace bimodal::runner
