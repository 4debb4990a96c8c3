#include "runner/booth/visual_line.hpp"

#include <cmath>

#include "protocols/model/talker.hpp"
#include "runner/preparation/drawn_face.hpp"
#include "runner/preparation/shown_look.hpp"

namespace bimodal::runner {

namespace {

constexpr double kMouthOfRecordings = 2.0 / 3.0;

}  // namespace

double height_in_window(const PicturePlace& place, double part) {
  const auto window = static_cast<double>(place.window_height);
  const auto picture = static_cast<double>(place.picture_height);
  return (0.5 * (window - picture) + part * picture) / window;
}

Duration drawn_after(double part, Duration period) {
  return Duration{std::llround(part * static_cast<double>(period.count()))};
}

double mouth_height(const protocols::Condition& condition) {
  if (condition.visual_talker && protocols::is_corpus(*condition.visual_talker)) {
    return kMouthOfRecordings;
  }
  constexpr std::size_t kLines = 720;  // the part is the same for any
  return synth::lips_height(view_of(condition.face, kLines, 0));
}

VisualLineReference visual_line_of(const protocols::Protocol& protocol,
                                   const std::map<std::string, Corpus>& corpora,
                                   int window_height,
                                   Duration period) {
  if (protocol.timing.visual_line == protocols::VisualLine::First) return {};
  double sum = 0.0;
  int seen = 0;
  for (const auto& condition : protocol.conditions) {
    if (!condition.visual_talker) continue;
    const auto look = decide_look(condition, protocol.window, corpora);
    sum +=
        height_in_window({window_height, static_cast<int>(look.height)}, mouth_height(condition));
    ++seen;
  }
  if (seen == 0) return {};
  return {.name = "mouth", .after = drawn_after(sum / seen, period)};
}

}  // namespace bimodal::runner
