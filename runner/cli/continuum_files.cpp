#include "runner/cli/continuum_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <tuple>

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

constexpr std::size_t kNotParted = std::numeric_limits<std::size_t>::max();

/// The opening of the lips, sampled from before the closure at the middle of a segment, if there is
/// one, to kOpeningTime after its end.
struct Opening {
  std::vector<double> time_ms;
  std::vector<double> height_mm;
  std::size_t middle = 0;  ///< index of the segment's middle

  /// Index of the first sample from the middle on at which the lips are not shut.
  [[nodiscard]] std::size_t parting() const {
    for (auto i = middle; i < height_mm.size(); ++i) {
      if (height_mm[i] > kShutGapMm) return i;
    }
    return kNotParted;
  }
};

Opening opening_about(const synth::ContinuumToken& token,
                      synth::ScoreArticulation& articulation,
                      const synth::Head& head) {
  constexpr double kStep = 4.0;  // ms; between samples the height is taken to run straight
  const double middle = middle_of(token).count();
  synth::PosedHead posed;
  const auto height_at = [&](double time) {
    head.pose(articulation.at(Milliseconds{time}), posed);
    return posed.lips.inner_height_mm;
  };
  // Steps are counted from the middle, so that it is a sample.
  Opening opening;
  const auto add = [&](double time) {
    opening.time_ms.push_back(time);
    opening.height_mm.push_back(height_at(time));
  };
  for (double time = middle; time > 0; time -= kStep) {
    add(time);
    if (opening.height_mm.back() > kShutGapMm) break;
  }
  std::ranges::reverse(opening.time_ms);
  std::ranges::reverse(opening.height_mm);
  opening.middle = opening.time_ms.size() - 1;
  const double end = token.score.end().count();
  for (double time = middle + kStep; time < end; time += kStep) {
    const bool is_parted = opening.parting() != kNotParted;
    if (is_parted && time > opening.time_ms[opening.parting()] + kOpeningTime.count()) break;
    add(time);
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

Milliseconds time_shut(const Opening& opening) {
  if (opening.height_mm[opening.middle] > kShutGapMm) return {};
  const auto& times = opening.time_ms;
  const bool was_open = opening.height_mm.front() > kShutGapMm;
  const double from = was_open ? crossing(opening, 1, kShutGapMm) : times.front();
  const auto parting = opening.parting();
  const double to = parting == kNotParted ? times.back() : crossing(opening, parting, kShutGapMm);
  return Milliseconds{to - from};
}

/// From the parting of the lips (from the middle, if they are open then) on.
void measure_release(const Opening& opening, TokenMiddle& middle) {
  const auto parting = opening.parting();
  if (parting == kNotParted) return;
  const bool is_shut = parting > opening.middle;
  const auto first = is_shut ? parting - 1 : opening.middle;
  const double begin =
      is_shut ? crossing(opening, parting, kShutGapMm) : opening.time_ms[opening.middle];
  double greatest = 0;
  double fastest = 0;
  for (auto i = first + 1; i < opening.height_mm.size(); ++i) {
    greatest = std::max(greatest, opening.height_mm[i]);
    const double step = opening.time_ms[i] - opening.time_ms[i - 1];
    fastest = std::max(fastest, (opening.height_mm[i] - opening.height_mm[i - 1]) / step * 1e3);
  }
  middle.fastest_opening_mm_per_s = fastest;
  const double half = greatest / 2;
  if (greatest <= kShutGapMm || opening.height_mm[first] >= half) return;
  auto after = first + 1;
  while (opening.height_mm[after] < half) ++after;
  middle.half_open = Milliseconds{crossing(opening, after, half) - begin};
}

TokenMiddle middle_face(const synth::ContinuumToken& token,
                        synth::ScoreArticulation& articulation,
                        const synth::Head& head) {
  const auto time = middle_of(token);
  TokenMiddle middle;
  middle.pose = articulation.at(time);
  middle.released = articulation.at(token.score.segments[token.segment].end() + kReleased);
  synth::PosedHead posed;
  head.pose(middle.pose, posed);
  middle.lips = posed.lips;
  const auto opening = opening_about(token, articulation, head);
  middle.shut = time_shut(opening);
  measure_release(opening, middle);
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
  const auto& token = continuum.tokens.front();
  for (std::size_t i = 0; i < token.score.segments.size(); ++i) {
    const auto& segment = token.score.segments[i];
    panel.stretches.push_back({.from = segment.start.count(),
                               .to = segment.end().count(),
                               .label = i == token.segment ? "_" : segment.symbol});
  }
  return panel;
}

/// Whether the first and the last token move a control differently by a hundredth of its range.
bool is_told_apart(const Panel& panel, synth::Control control) {
  const auto& range = synth::describe(control);
  const auto& first = panel.curves.front().points;
  const auto& last = panel.curves.back().points;
  for (std::size_t i = 0; i < std::min(first.size(), last.size()); ++i) {
    if (std::abs(first[i].y - last[i].y) > 0.01 * (range.highest - range.lowest)) return true;
  }
  return false;
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

void remove_earlier_tokens(const std::filesystem::path& folder) {
  for (const auto& entry : std::filesystem::directory_iterator{folder}) {
    const auto name = entry.path().filename().string();
    const auto stem = entry.path().stem().string();
    const auto ending = entry.path().extension();
    constexpr std::string_view kToken = "token";
    const bool is_numbered =
        stem.size() > kToken.size() && stem.starts_with(kToken) &&
        stem.find_first_not_of("0123456789", kToken.size()) == std::string::npos;
    const bool is_token = is_numbered && (ending == ".csv" || ending == ".mp4");
    if (is_token || name == "words.json") std::filesystem::remove(entry.path());
  }
}

void write_token_table(const Continuum& continuum, const std::filesystem::path& folder) {
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
                   middle.half_open ? fmt::to_string(middle.half_open->count()) : std::string{},
                   middle.fastest_opening_mm_per_s);
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
  Figure movements{
      .title = title + ", over time",
      .caption =
          "From the first token (blue) to the last (red). Controls that go alike are left out.",
      .panels = {}};
  for (const auto control : differing(continuum)) {
    middles.panels.push_back(
        over_tokens(continuum, synth::name_with_unit(control), [=](const TokenMiddle& middle) {
          return shown_value(middle, control);
        }));
  }
  const auto asked = asked_differently(continuum);
  constexpr std::size_t kFew = 4;  // what is varied is always drawn
  for (const auto control : asked) {
    auto panel = over_time(continuum, control);
    if (asked.size() > kFew && !is_told_apart(panel, control)) continue;
    movements.panels.push_back(std::move(panel));
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
  const auto count = continuum.tokens.size();
  auto options = view;
  options.height = std::clamp(static_cast<int>(kWidest / count * 9 / 8), 32, view.height);
  const auto whole = face_view(options);
  auto closer = options;
  closer.view = "mouth";
  const auto scale = std::max<std::int64_t>(1, static_cast<std::int64_t>(whole.width / 150));
  const auto line = 12 * scale;  // the letters are 7 pixels high
  const auto rows =
      std::array{std::tuple{whole, &TokenMiddle::pose, std::string{"in the middle"}},
                 std::tuple{face_view(closer), &TokenMiddle::pose, std::string{"in the middle"}},
                 std::tuple{face_view(closer),
                            &TokenMiddle::released,
                            fmt::format("{:g} ms after its end", kReleased.count())}};
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
