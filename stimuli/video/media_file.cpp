#include "stimuli/video/media_file.hpp"

#include "stimuli/video/survey.hpp"

namespace bimodal {

Media examine_media(const std::filesystem::path& file) {
  return libav::survey_of(file).media;
}

}  // namespace bimodal
