#include "runner/cli/continuum_files.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
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

/// The opening of the lips, sampled about a segment.
struct Opening {
  std::vector<double> time_ms;
  std::vector<double> height_mm;
};

Opening opening_about(const synth::ContinuumToken& token,
                      synth::ScoreArticulation& articulation,
                      const synth::Head& head) {
  constexpr double kStep = 4.0;  // ms; between samples the height is taken to run straight
  const auto& segment = token.score.segments[token.segment];
  const double middle = middle_of(token).count();
  const double last = middle + std::max(kOpeningTime.count(), segment.duration.count() / 2);
  Opening opening;
  synth::PosedHead posed;
  // Steps are counted from the middle, so that it is a sample.
  const auto steps_back = static_cast<int>(segment.duration.count() / 2 / kStep);
  for (double time = middle - steps_back * kStep; time <= last; time += kStep) {
    head.pose(articulation.at(Milliseconds{time}), posed);
    opening.time_ms.push_back(time);
    opening.height_mm.push_back(posed.lips.inner_height_mm);
  }
  return opening;
}

/// When a straight line between two samples reaches `height`.
double crossing(const Opening& opening, std::size_t after, double height) {
  const double before = opening.height_mm[after - 1];
  const double rise = opening.height_mm[after] - before;
  const double share = rise == 0 ? 0 : std::clamp((height - before) / rise, 0.0, 1.0);
  return std::lerp(opening.time_ms[after - 1], opening.time_ms[after], share);
}

/// The unbroken stretch of shut lips that holds `middle`, else the one nearest to it.
Milliseconds time_shut(const Opening& opening, double middle, double end) {
  double nearest = std::numeric_limits<double>::infinity();
  Milliseconds shut{};
  std::optional<double> from;
  for (std::size_t i = 0; i < opening.time_ms.size(); ++i) {
    const bool is_shut = opening.height_mm[i] <= kShutGapMm;
    if (is_shut && !from) from = i == 0 ? opening.time_ms[0] : crossing(opening, i, kShutGapMm);
    const bool is_last = i + 1 == opening.time_ms.size();
    if (!from || (is_shut && !is_last)) continue;
    const double to = is_shut ? opening.time_ms[i] : crossing(opening, i, kShutGapMm);
    const double distance = std::max({0.0, *from - middle, middle - to});
    if (distance < nearest && *from <= end) {
      nearest = distance;
      shut = Milliseconds{to - *from};
    }
    from.reset();
  }
  return shut;
}

std::optional<Milliseconds> time_to_half_open(const Opening& opening, double middle) {
  const auto first = static_cast<std::size_t>(
      std::ranges::lower_bound(opening.time_ms, middle - 1e-9) - opening.time_ms.begin());
  double greatest = 0;
  for (std::size_t i = first; i < opening.height_mm.size(); ++i) {
    greatest = std::max(greatest, opening.height_mm[i]);
  }
  const double half = greatest / 2;
  if (greatest <= kShutGapMm || opening.height_mm[first] >= half) return std::nullopt;
  std::size_t after = first + 1;
  while (opening.height_mm[after] < half) ++after;
  return Milliseconds{crossing(opening, after, half) - middle};
}

TokenMiddle middle_face(const synth::ContinuumToken& token,
                        synth::ScoreArticulation& articulation,
                        const synth::Head& head) {
  const auto time = middle_of(token);
  TokenMiddle middle{.pose = articulation.at(time), .lips = {}, .shut = {}, .half_open = {}};
  synth::PosedHead posed;
  head.pose(middle.pose, posed);
  middle.lips = posed.lips;
  const auto opening = opening_about(token, articulation, head);
  const auto end = token.score.segments[token.segment].end().count();
  middle.shut = time_shut(opening, time.count(), end);
  middle.half_open = time_to_half_open(opening, time.count());
  return middle;
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
                     Account account,
                     const synth::Head& head) {
  Continuum continuum{.tokens = std::move(tokens), .claims = {}, .middles = {}, .account = account};
  for (const auto& token : continuum.tokens) {
    continuum.claims.push_back(synth::claims_of(token.score, table));
    synth::ScoreArticulation articulation{continuum.claims.back(), account};
    continuum.middles.push_back(middle_face(token, articulation, head));
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
      "upper_protrusion_mm,lower_protrusion_mm,lips_shut_ms,half_open_ms";
  const auto out = std::back_inserter(text);
  for (const auto& row : synth::controls().first<synth::kSpeechControlCount>()) {
    fmt::format_to(out, ",{}", row.name);
  }
  text += '\n';
  for (std::size_t i = 0; i < continuum.tokens.size(); ++i) {
    const auto& middle = continuum.middles[i];
    const auto& lips = middle.lips;
    fmt::format_to(out,
                   "{},{},{},{},{},{},{},{},{},{},{}",
                   token_name(continuum, i),
                   csv_field(continuum.tokens[i].name),
                   continuum.tokens[i].place,
                   lips.inner_height_mm,
                   lips.inner_width_mm,
                   lips.inner_area_mm2,
                   lips.outer_width_mm,
                   lips.upper_protrusion_mm,
                   lips.lower_protrusion_mm,
                   middle.shut.count(),
                   middle.half_open ? fmt::to_string(middle.half_open->count()) : std::string{});
    for (std::size_t k = 0; k < synth::kSpeechControlCount; ++k) {
      fmt::format_to(out, ",{}", middle.pose.at(k));
    }
    text += '\n';
  }
  write_file(folder / "tokens.csv", text);
}

std::vector<std::string> cautions(const Continuum& continuum) {
  constexpr double kNoticed = 0.02;  // mm: less is rounding in the mesh
  const auto height = [&](std::size_t i) { return continuum.middles[i].lips.inner_height_mm; };
  const double whole = height(continuum.tokens.size() - 1) - height(0);
  std::vector<std::string> found;
  if (std::abs(whole) < kNoticed) return found;
  for (std::size_t i = 1; i < continuum.tokens.size(); ++i) {
    const double step = height(i) - height(i - 1);
    if (step * whole >= 0 || std::abs(step) < kNoticed) continue;
    found.push_back(fmt::format("from {} to {} the lips {} by {:.2f} mm, against the others",
                                token_name(continuum, i - 1),
                                token_name(continuum, i),
                                step > 0 ? "open" : "close",
                                std::abs(step)));
  }
  return found;
}

bool write_token_words(const Continuum& continuum, const std::filesystem::path& folder) {
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
    std::string spelling = token.name;
    std::ranges::transform(spelling, spelling.begin(), [](char letter) {
      return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    });
    words.push_back({{"word", spelling}, {"phones", std::move(phones)}});
  }
  const nlohmann::ordered_json list{{"words", std::move(words)}};
  write_file(folder / "words.json", list.dump(1) + '\n');
  return true;
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
