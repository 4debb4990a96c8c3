#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace bimodal {

enum class Severity { Warning, Error };

/// One mistake in something that the experimenter wrote or brought: where it is, what was found,
/// and how to mend it. Readers collect all of them before anything starts.
struct Diagnostic {
  Severity severity = Severity::Error;
  std::string file;      ///< as the experimenter named it; empty if it concerns no file
  std::size_t line = 0;  ///< from 1; 0 where a line has no meaning
  std::string pointer;  ///< RFC 6901 JSON pointer, e.g. "/conditions/2/snr_db"; empty for the whole
  std::string finding;  ///< what is wrong: `"loud" is not a number`
  std::string remedy;   ///< what to do: `give the ratio in dB, e.g. -8`

  bool operator==(const Diagnostic&) const = default;
};

/// "words414.json:31: /conditions/2/snr_db: "loud" is not a number; give the ratio in dB, e.g. -8",
/// with "warning: " before the finding of a warning.
[[nodiscard]] std::string describe(const Diagnostic& diagnostic);

[[nodiscard]] bool has_errors(std::span<const Diagnostic> diagnostics);

}  // namespace bimodal
