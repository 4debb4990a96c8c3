#pragma once

namespace bimodal {

/// What a program's end tells the shell. The same for every program of the project.
enum class ExitCode : int {
  Done = 0,
  Findings = 1,      ///< it worked, but there is something to look at
  Usage = 2,         ///< the command line was not understood
  InvalidInput = 3,  ///< a protocol, word list or media file is wrong
  Device = 4,        ///< no display, no sound, or one was lost
  Store = 5,         ///< data cannot be kept or read
  Internal = 70,     ///< a mistake of ours
};

}  // namespace bimodal
