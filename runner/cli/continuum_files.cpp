#include "runner/cli/continuum_files.hpp"

#include <algorithm>
#include <iterator>
#include <span>

#include <fmt/format.h>
#include <unistd.h>

#include "stimuli/base/csv.hpp"
#include "stimuli/base/draft.hpp"
#include "stimuli/figures/figure.hpp"
#include "stimuli/picture/drawing.hpp"
#include "stimuli/video/video_writer.hpp"
#include "synth/render/head_renderer.hpp"
#include "synth/speech/score_articulation.hpp"
#include "synth/speech/tracks.hpp"

namespace bimodal::runner {

namespace {

Milliseconds middle_of(const synth::ContinuumToken& token) {
  const auto& segment = token.score.segments[token.segment];
  return segment.start + segment.duration / 2;
}

/// What the face does: controls are clamped to their ranges.
double shown_value(const TokenMiddle& middle, synth::Control control) {
  const auto& range = synth::describe(control);
  return std::clamp(synth::value(middle.pose, control), range.lowest, range.highest);
}

/// Controls that the face shows differently in the middle from token to token.
std::vector<synth::Control> differing(const Continuum& continuum) {
  std::vector<synth::Control> controls;
  for (const auto& row : synth::controls().first<synth::kSpeechControlCount>()) {
    const auto [lowest, highest] =
        std::ranges::minmax(continuum.middles, {}, [&](const TokenMiddle& middle) {
          return shown_value(middle, row.control);
        });
    if (shown_value(highest, row.control) - shown_value(lowest, row.control) > 1e-6)
      controls.push_back(row.control);
  }
  return controls;
}

/// Controls of which the first and the last token ask something else.
std::vector<synth::Control> asked_differently(const Continuum& continuum) {
  const auto& first = continuum.claims.front();
  const auto& last = continuum.claims.back();
  std::vector<synth::Control> controls;
  for (std::size_t i = 0; i < first.controls.size(); ++i) {
    const auto control = synth::control_from_name(first.controls[i]);
    if (control && first.claims[i] != last.claims[i]) controls.push_back(*control);
  }
  return controls;
}

/// From blue to red over the tokens.
FigureColour shade(double place) {
  const auto red = static_cast<FigureColour>(0x20 + place * 0xC0);
  const auto blue = static_cast<FigureColour>(0xD0 - place * 0xB0);
  return (red << 16U) | (0x50U << 8U) | blue;
}

Panel over_tokens(const Continuum& continuum,
                  const std::string& label,
                  const std::function<double(const TokenMiddle&)>& value) {
  Panel panel{.title = label, .x_label = "token", .y_label = label};
  Curve curve{.colour = figure_colour(2)};
  Marks marks{.colour = figure_colour(2), .is_filled = true};
  for (std::size_t i = 0; i < continuum.tokens.size(); ++i) {
    const PlotPoint point{static_cast<double>(i), value(continuum.middles[i])};
    curve.points.push_back(point);
    marks.points.push_back(point);
  }
  panel.curves.push_back(std::move(curve));
  panel.marks.push_back(std::move(marks));
  return panel;
}

Panel over_time(const Continuum& continuum, synth::Control control) {
  const std::string name{synth::describe(control).name};
  Panel panel{.title = name, .x_label = "time (ms)", .y_label = synth::name_with_unit(control)};
  for (std::size_t i = 0; i < continuum.tokens.size(); ++i) {
    const auto tracks =
        synth::sample(continuum.claims[i],
                      {.rate = Hertz{500}, .account = continuum.account, .controls = {name}});
    const bool is_end = i == 0 || i + 1 == continuum.tokens.size();
    Curve curve{.colour = shade(continuum.tokens[i].place),
                .width = is_end ? 1.8 : 0.9,
                .label = is_end ? continuum.tokens[i].name : ""};
    for (std::size_t k = 0; k < tracks.time_ms.size(); ++k) {
      curve.points.push_back({tracks.time_ms[k], tracks.values.front()[k]});
    }
    panel.curves.push_back(std::move(curve));
  }
  const auto& segment = continuum.tokens.front().score.segments[continuum.tokens.front().segment];
  panel.stretches.push_back(
      {.from = segment.start.count(), .to = segment.end().count(), .label = "_"});
  return panel;
}

}  // namespace

Continuum worked_out(std::vector<synth::ContinuumToken> tokens,
                     const synth::SegmentTable& table,
                     synth::Account account,
                     const synth::Head& head) {
  Continuum continuum{.tokens = std::move(tokens), .claims = {}, .middles = {}, .account = account};
  synth::PosedHead posed;
  for (const auto& token : continuum.tokens) {
    continuum.claims.push_back(synth::claims_of(token.score, table));
    auto& middle = continuum.middles.emplace_back();
    middle.pose = synth::ScoreArticulation{continuum.claims.back(), account}.at(middle_of(token));
    head.pose(middle.pose, posed);
    middle.lips = posed.lips;
  }
  return continuum;
}

std::string token_name(const Continuum& continuum, std::size_t token) {
  const auto digits = fmt::to_string(continuum.tokens.size() - 1).size();
  return fmt::format("token{:0{}}", token, digits);
}

void write_token_table(const Continuum& continuum, const std::filesystem::path& folder) {
  std::string text =
      "token,name,place,inner_height_mm,inner_width_mm,inner_area_mm2,outer_width_mm,"
      "upper_protrusion_mm,lower_protrusion_mm";
  const auto out = std::back_inserter(text);
  for (const auto& row : synth::controls().first<synth::kSpeechControlCount>()) {
    fmt::format_to(out, ",{}", row.name);
  }
  text += '\n';
  for (std::size_t i = 0; i < continuum.tokens.size(); ++i) {
    const auto& [pose, lips] = continuum.middles[i];
    fmt::format_to(out,
                   "{},{},{},{},{},{},{},{},{}",
                   token_name(continuum, i),
                   csv_field(continuum.tokens[i].name),
                   continuum.tokens[i].place,
                   lips.inner_height_mm,
                   lips.inner_width_mm,
                   lips.inner_area_mm2,
                   lips.outer_width_mm,
                   lips.upper_protrusion_mm,
                   lips.lower_protrusion_mm);
    for (std::size_t k = 0; k < synth::kSpeechControlCount; ++k) {
      fmt::format_to(out, ",{}", pose.at(k));
    }
    text += '\n';
  }
  write_file(folder / "tokens.csv", text);
}

void write_token_tracks(const Continuum& continuum, const std::filesystem::path& folder) {
  for (std::size_t i = 0; i < continuum.tokens.size(); ++i) {
    const auto tracks = synth::sample(continuum.claims[i], {.account = continuum.account});
    write_file(folder / (token_name(continuum, i) + ".csv"), synth::csv_of(tracks));
  }
}

void write_token_plots(const Continuum& continuum,
                       const std::string& title,
                       const std::string& format,
                       const std::filesystem::path& folder) {
  Figure middles{.title = title + ", in the middle of the sound",
                 .caption =
                     "As the face shows it: controls are limited to their ranges (tokens.csv "
                     "has what is asked). Those that look the same in all tokens are left "
                     "out.",
                 .panels = {}};
  middles.panels.push_back(
      over_tokens(continuum, "opening of the lips (mm)", [](const TokenMiddle& middle) {
        return middle.lips.inner_height_mm;
      }));
  Figure movements{.title = title + ", over time",
                   .caption = "From the first token (blue) to the last (red).",
                   .panels = {}};
  for (const auto control : differing(continuum)) {
    middles.panels.push_back(
        over_tokens(continuum, synth::name_with_unit(control), [=](const TokenMiddle& middle) {
          return shown_value(middle, control);
        }));
  }
  for (const auto control : asked_differently(continuum)) {
    movements.panels.push_back(over_time(continuum, control));
  }
  middles.columns = 3;
  middles.panel_width = 270;
  middles.panel_height = 160;
  write_figure(middles, folder / ("controls." + format));
  movements.columns = 2;
  movements.panel_width = 400;
  movements.panel_height = 170;
  write_figure(movements, folder / ("movements." + format));
}

void write_token_strip(const Continuum& continuum,
                       const synth::Head& head,
                       const ViewOptions& view,
                       const std::filesystem::path& folder) {
  constexpr std::size_t kWidest = 16'000;
  constexpr Colour kGround{32, 34, 38};
  constexpr Colour kInk{235, 235, 235};
  constexpr std::int64_t kScale = 2;
  constexpr std::size_t kCaption = 24;
  const auto count = continuum.tokens.size();
  auto options = view;
  options.height = std::clamp(static_cast<int>(kWidest / count * 9 / 8), 32, view.height);
  const auto whole = face_view(options);
  auto closer = options;
  closer.view = "mouth";
  auto strip = blank_image(whole.width * count, 2 * whole.height + kCaption, kGround);
  Image picture;
  std::int64_t top = 0;
  for (const auto& seen : {whole, face_view(closer)}) {
    synth::HeadRenderer renderer{head, seen};
    for (std::size_t i = 0; i < count; ++i) {
      renderer.draw(continuum.middles[i].pose, picture);
      paste(strip, {static_cast<std::int64_t>(i * whole.width), top}, picture);
    }
    top += static_cast<std::int64_t>(whole.height);
  }
  for (std::size_t i = 0; i < count; ++i) {
    draw_text(strip,
              {static_cast<std::int64_t>(i * whole.width) + 6, top + 5},
              continuum.tokens[i].name,
              kInk,
              kScale);
  }
  write_png(strip, folder / "strip.png");
}

void write_token_videos(const Continuum& continuum,
                        const synth::Head& head,
                        const ViewOptions& view,
                        Hertz rate,
                        const std::filesystem::path& folder) {
  const auto seen = face_view(view);
  synth::HeadRenderer renderer{head, seen};
  const bool tells = isatty(STDERR_FILENO) == 1;
  Image picture;
  for (std::size_t i = 0; i < continuum.tokens.size(); ++i) {
    if (tells) fmt::print(stderr, "\rvideo {} of {} ", i + 1, continuum.tokens.size());
    VideoWriter video{folder / (token_name(continuum, i) + ".mp4"), seen.width, seen.height, rate};
    synth::ScoreArticulation face{continuum.claims[i], continuum.account};
    for (std::int64_t frame = 0;; ++frame) {
      const Milliseconds time{static_cast<double>(frame) * 1e3 / rate.count()};
      if (time >= continuum.claims[i].end) break;
      renderer.draw(face.at(time), picture);
      video.add(picture);
    }
    video.finish();
  }
  if (tells) fmt::print(stderr, "\r{:30}\r", "");
}

}  // namespace bimodal::runner
