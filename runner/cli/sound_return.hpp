#pragma once

#include <functional>
#include <string>

#include "runner/booth/booth.hpp"

namespace bimodal::runner {

/// Shows the participant a quiet page until the machine has a sound output again (a process of its
/// own looks every two seconds: what this one knows of the sound system died with it), or somebody
/// wants to stop: Escape, or `stopped`. True: it is there again.
[[nodiscard]] bool await_sound(const Booth& booth, const std::function<bool()>& stopped);

/// Begins this program anew in this process, with the same arguments and --resume: the session goes
/// on where it was. Everything is stored before. Returns only if that failed: why.
[[nodiscard]] std::string begin_anew_and_resume();

}  // namespace bimodal::runner
