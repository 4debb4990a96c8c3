#include "analysis/report/attachment.hpp"

#include <array>

#include <fmt/format.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::analysis {

namespace {

struct Format {
  Attachment::Kind kind;
  std::string_view signature;  ///< first bytes
  std::string_view media_type;
};

constexpr std::array kFormats = std::to_array<Format>({
    {Attachment::Kind::Picture, "\x89PNG\r\n", "image/png"},
    {Attachment::Kind::Picture, "\xff\xd8\xff", "image/jpeg"},
    {Attachment::Kind::Sound, "RIFF", "audio/wav"},
    {Attachment::Kind::Sound, "fLaC", "audio/flac"},
});

std::string_view file_name(std::string_view file_and_caption) {
  for (auto colon = file_and_caption.find(':'); colon != std::string_view::npos;
       colon = file_and_caption.find(':', colon + 1)) {
    std::error_code ignored;
    const auto name = file_and_caption.substr(0, colon);
    if (std::filesystem::is_regular_file(name, ignored)) return name;
  }
  std::error_code ignored;
  if (std::filesystem::is_regular_file(file_and_caption, ignored)) return file_and_caption;
  return file_and_caption.substr(0, file_and_caption.find(':'));
}

}  // namespace

Attachment read_attachment(Attachment::Kind kind, std::string_view file_and_caption) {
  const auto file = file_name(file_and_caption);
  Attachment attachment;
  attachment.kind = kind;
  attachment.bytes = read_file(file);
  const bool captioned = file.size() < file_and_caption.size();
  attachment.caption = captioned ? file_and_caption.substr(file.size() + 1)
                                 : std::filesystem::path{file}.filename().string();
  for (const auto& format : kFormats) {
    if (format.kind == kind && attachment.bytes.starts_with(format.signature)) {
      attachment.media_type = format.media_type;
      return attachment;
    }
  }
  throw Error{
      fmt::format("attaching '{}' to the report: it is no {}; convert it",
                  file,
                  kind == Attachment::Kind::Picture ? "PNG or JPEG picture" : "WAV or FLAC sound")};
}

}  // namespace bimodal::analysis
