#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "runner/booth/booth.hpp"
#include "runner/devices/device_error.hpp"
#include "runner/store/store_writer.hpp"

namespace bimodal::runner {

/// What a session does when its sound has been lost: stores the pause and waits (await_sound); when
/// sound is there again the program begins anew and goes on. `tell` talks to the experimenter.
/// Returns if somebody wants to stop instead; throws DeviceError if the program cannot begin anew.
void outlast_lost_sound(const SoundLost& loss,
                        const Booth& booth,
                        StoreWriter& writer,
                        std::int64_t session,
                        const std::function<void(std::string_view)>& tell);

/// Shows the participant a quiet page until the machine has a sound output again (a process of its
/// own looks every two seconds: what this one knows of the sound system died with it), or somebody
/// wants to stop: Escape, or `stopped`. True: it is there again.
[[nodiscard]] bool await_sound(const Booth& booth, const std::function<bool()>& stopped);

/// Begins this program anew in this process, with the same arguments and --resume: the session goes
/// on where it was. Everything is stored before. Returns only if that failed: why.
[[nodiscard]] std::string begin_anew_and_resume();

}  // namespace bimodal::runner
