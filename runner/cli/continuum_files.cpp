#include "runner/cli/continuum_files.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <tuple>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "stimuli/base/csv.hpp"
#include "stimuli/base/draft.hpp"
#include "stimuli/base/lower_case.hpp"
#include "stimuli/picture/drawing.hpp"
#include "stimuli/video/video_writer.hpp"
#include "synth/render/head_renderer.hpp"
#include "synth/speech/score_articulation.hpp"
#include "synth/speech/tracks.hpp"

namespace bimodal::runner {

void remove_earlier_tokens(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder / "tokens.csv")) return;
  for (const auto& entry : std::filesystem::directory_iterator{folder}) {
    const auto name = entry.path().filename().string();
    const auto stem = entry.path().stem().string();
    const auto ending = entry.path().extension();
    constexpr std::string_view kToken = "token";
    const bool is_numbered =
        stem.size() > kToken.size() && stem.starts_with(kToken) &&
        stem.find_first_not_of("0123456789", kToken.size()) == std::string::npos;
    const bool is_token = is_numbered && (ending == ".csv" || ending == ".mp4");
    if (is_token || name == "tokens.json") std::filesystem::remove(entry.path());
  }
}

void write_token_table(const synth::Continuum& continuum, const std::filesystem::path& folder) {
  std::string text =
      "token,name,place,inner_height_mm,inner_width_mm,inner_area_mm2,outer_width_mm,"
      "upper_protrusion_mm,lower_protrusion_mm,lips_shut_ms,half_open_ms,fastest_opening_mm_per_s";
  const auto out = std::back_inserter(text);
  for (const auto& row : synth::controls().first<synth::kSpeechControlCount>()) {
    fmt::format_to(out, ",{}", row.name);
  }
  text += '\n';
  for (std::size_t i = 0; i < continuum.tokens.size(); ++i) {
    const auto& middle = continuum.middles[i];
    const auto& lips = middle.lips;
    fmt::format_to(out,
                   "{},{},{},{},{},{},{},{},{},{},{},{}",
                   synth::token_name(continuum, i),
                   csv_field(continuum.tokens[i].name),
                   continuum.tokens[i].place,
                   lips.inner_height_mm,
                   lips.inner_width_mm,
                   lips.inner_area_mm2,
                   lips.outer_width_mm,
                   lips.upper_protrusion_mm,
                   lips.lower_protrusion_mm,
                   middle.shut.count(),
                   middle.half_open ? fmt::to_string(middle.half_open->count()) : std::string{},
                   middle.fastest_opening_mm_per_s);
    for (std::size_t k = 0; k < synth::kSpeechControlCount; ++k) {
      fmt::format_to(out, ",{}", middle.pose.at(k));
    }
    text += '\n';
  }
  write_file(folder / "tokens.csv", text);
}

bool write_token_words(const synth::Continuum& continuum, const std::filesystem::path& folder) {
  auto words = nlohmann::ordered_json::array();
  for (const auto& token : continuum.tokens) {
    auto phones = nlohmann::ordered_json::array();
    const auto& segments = token.score.segments;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const bool is_rest = segments[i].segment == Segment{Phone::Rest};
      const bool is_margin = i == 0 || i + 1 == segments.size();
      if (is_rest && is_margin) continue;
      if (is_rest || !segments[i].segment) return false;
      phones.push_back(symbol(*segments[i].segment));
    }
    words.push_back({{"word", lower_case(token.name)}, {"phones", std::move(phones)}});
  }
  const nlohmann::ordered_json list{{"words", std::move(words)}};
  write_file(folder / "tokens.json", list.dump(1) + '\n');
  return true;
}

void write_token_tracks(const synth::Continuum& continuum, const std::filesystem::path& folder) {
  for (std::size_t i = 0; i < continuum.tokens.size(); ++i) {
    const auto tracks = synth::sample(continuum.claims[i], {.account = continuum.account});
    write_file(folder / (synth::token_name(continuum, i) + ".csv"), synth::csv_of(tracks));
  }
}

void write_token_strip(const synth::Continuum& continuum,
                       const synth::Head& head,
                       const ViewOptions& view,
                       const std::filesystem::path& folder) {
  constexpr std::size_t kWidest = 16'000;
  constexpr Colour kGround{32, 34, 38};
  constexpr Colour kInk{235, 235, 235};
  const auto count = continuum.tokens.size();
  auto options = view;
  options.height = std::clamp(static_cast<int>(kWidest / count * 9 / 8), 32, view.height);
  const auto whole = face_view(options);
  auto closer = options;
  closer.view = "mouth";
  const auto scale = std::max<std::int64_t>(1, static_cast<std::int64_t>(whole.width / 150));
  const auto line = 12 * scale;  // the letters are 7 pixels high
  const auto rows = std::array{
      std::tuple{whole, &synth::TokenMiddle::pose, std::string{"in the middle"}},
      std::tuple{face_view(closer), &synth::TokenMiddle::pose, std::string{"in the middle"}},
      std::tuple{face_view(closer),
                 &synth::TokenMiddle::released,
                 fmt::format("{:g} ms after its end", synth::kReleased.count())}};
  auto strip =
      blank_image(whole.width * count,
                  rows.size() * whole.height + static_cast<std::size_t>(line) * (rows.size() + 1),
                  kGround);
  Image picture;
  std::int64_t top = line;
  const auto left_of = [&](std::size_t i) { return static_cast<std::int64_t>(i * whole.width); };
  for (std::size_t i = 0; i < count; ++i) {
    draw_text(strip, {left_of(i) + 6, 3}, continuum.tokens[i].name, kInk, scale);
  }
  for (const auto& [seen, pose, caption] : rows) {
    synth::HeadRenderer renderer{head, seen};
    for (std::size_t i = 0; i < count; ++i) {
      renderer.draw(continuum.middles[i].*pose, picture);
      paste(strip, {left_of(i), top}, picture);
    }
    top += static_cast<std::int64_t>(whole.height);
    draw_text(strip, {6, top + 3}, caption, kInk, scale);
    top += line;
  }
  write_png(strip, folder / "strip.png");
}

void write_token_videos(const synth::Continuum& continuum,
                        const synth::Head& head,
                        const ViewOptions& view,
                        const FrameRate& rate,
                        const std::filesystem::path& folder) {
  const auto seen = face_view(view);
  synth::HeadRenderer renderer{head, seen};
  const bool tells = isatty(STDERR_FILENO) == 1;
  Image picture;
  for (std::size_t i = 0; i < continuum.tokens.size(); ++i) {
    if (tells) fmt::print(stderr, "\rvideo {} of {} ", i + 1, continuum.tokens.size());
    VideoWriter video{folder / (synth::token_name(continuum, i) + ".mp4"),
                      {.width = seen.width, .height = seen.height, .rate = rate}};
    synth::ScoreArticulation face{continuum.claims[i], continuum.account};
    const auto frames = rate.frames_before(continuum.claims[i].end);
    for (std::int64_t frame = 0; frame < frames; ++frame) {
      renderer.draw(face.at(rate.time_of(frame)), picture);
      video.add(picture);
    }
    video.finish();
  }
  if (tells) fmt::print(stderr, "\r{:30}\r", "");
}

}  // namespace bimodal::runner
