#include "runner/preparation/film_key.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "runner/preparation/drawn_face.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/base/digest.hpp"
#include "synth/render/opengl_description.hpp"

namespace bimodal::runner {

std::string drawing_identity() {
  const auto assets = asset("synth/assets");
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator{assets}) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  auto text = fmt::format(
      "{}\nprogram {}\n", synth::opengl_description(), sha256_of_file("/proc/self/exe"));
  for (const auto& file : files) {
    text += fmt::format("{} {}\n", file.lexically_relative(assets).string(), sha256_of_file(file));
  }
  return sha256(text);
}

std::string film_key(const FilmOrigin& origin) {
  const auto& [drawing, articulation, table, account, look, quality, layout, rate, cut] = origin;
  const auto& [height, lines, frame_rate, blur_px, background, face] = look;
  const auto& [recording, lead, trail, sound_lead, sound_trail, av_offset, has_sound] = layout;
  auto text = fmt::format(
      "drawing {}\ninventory {}\naccount {}\n", drawing, table, static_cast<int>(account));
  const auto out = std::back_inserter(text);
  fmt::format_to(out,
                 "look {} {} {} {} {} {}\n",
                 height,
                 lines,
                 frame_rate ? frame_rate->count() : 0.0,
                 blur_px,
                 background,
                 static_cast<int>(quality));
  fmt::format_to(out, "face {}\n", face_record(face));
  // Where the sound stands does not move the pictures, but for the frames that it needs.
  fmt::format_to(out,
                 "layout {} {} {} {} {} {} {} at {}\n",
                 recording.count(),
                 lead.count(),
                 trail.count(),
                 sound_lead.count(),
                 sound_trail.count(),
                 av_offset.count(),
                 has_sound,
                 rate.count());
  if (cut) fmt::format_to(out, "cut {} {}\n", cut->at.count(), cut->blank);
  for (const auto& timed : articulation) {
    fmt::format_to(
        out, "{} {} {}\n", symbol(timed.segment), timed.start.count(), timed.duration.count());
  }
  return sha256(text);
}

}  // namespace bimodal::runner
