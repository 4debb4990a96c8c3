#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace bimodal::analysis {

/// A picture or sound that stands in the report itself: the stimulus of one trial.
struct Attachment {
  enum class Kind { Picture, Sound };

  Kind kind = Kind::Picture;
  std::string media_type;  ///< "image/png", "image/jpeg", "audio/wav", "audio/flac"
  std::string caption;
  std::string bytes;
};

/// Reads "FILE:caption" or "FILE"; the caption begins after the first colon that ends the name of
/// an existing file. Throws Error if there is none, or if its content is not of a format that
/// browsers show (told by its first bytes, not by its name).
[[nodiscard]] Attachment read_attachment(Attachment::Kind kind, std::string_view file_and_caption);

}  // namespace bimodal::analysis
