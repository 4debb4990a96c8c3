#include "runner/cli/session_level.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "runner/devices/portaudio/output_name.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/json_lines.hpp"

namespace bimodal::runner {

namespace {

constexpr double kSoftest = -80.0;  ///< dB FS, as of /sound/speech_level_dbfs
constexpr double kTolerance = 1.0;  ///< dB between channels, above which it is told

void require_within_full_scale(const protocols::Sound& sound, const std::string& device) {
  const double level = sound.speech_level.count();
  if (level >= kSoftest && level <= 0.0) return;
  throw Error{fmt::format(
      "speech of {:g} dB SPL would need {:.1f} dB FS on '{}', and it must lie between {:g} and 0; "
      "change /sound/speech_level_dbspl, or the amplifier, and then measure again",
      sound.speech_spl->count(),
      level,
      device,
      kSoftest)};
}

std::string record_of(const SpeechCalibration& calibration,
                      const protocols::Sound& sound,
                      const std::string& device) {
  const auto measured = LevelTable{calibration.measured}.text();
  nlohmann::ordered_json json{{"device", device},
                              {"speech_dbfs", sound.speech_level.count()},
                              {"speech_dbspl", calibration.spl_at(sound.speech_level).count()},
                              {"wanted_dbspl", nullptr},
                              {"measured", nlohmann::json::parse(measured).at("levels")}};
  if (sound.speech_spl) json["wanted_dbspl"] = sound.speech_spl->count();
  return json.dump();
}

std::string text_of(const SpeechCalibration& calibration,
                    const protocols::Sound& sound,
                    const std::string& device) {
  auto text = fmt::format("speech at {:.1f} dB FS is {:.1f} dB SPL on '{}'",
                          sound.speech_level.count(),
                          calibration.spl_at(sound.speech_level).count(),
                          device);
  const auto& date = calibration.measured.front().date;
  if (!date.empty()) text += fmt::format(", as measured on {}", date);
  if (calibration.spread.count() > kTolerance) {
    text += fmt::format("; its channels differ by {:.1f} dB", calibration.spread.count());
  }
  return text;
}

}  // namespace

Listening listening_at(const protocols::Sound& sound, const std::string& device) {
  return {.device = device,
          .rate_hz = static_cast<int>(std::lround(sound.rate.count())),
          .low_hz = sound.noise.band_low.count(),
          .high_hz = sound.noise.band_high.count(),
          .channels = sound.channels};
}

SessionLevel settle_level(protocols::Sound& sound,
                          const std::string& device,
                          const LevelTable& table) {
  const auto listening = listening_at(sound, device);
  const auto found = calibration_for(table, listening);
  if (const auto* const missing = std::get_if<NotCalibrated>(&found)) {
    if (!sound.speech_spl) return {};
    throw Error{fmt::format("the protocol asks for speech of {:g} dB SPL, but {}; {}",
                            sound.speech_spl->count(),
                            missing->finding,
                            calibration_remedy(listening))};
  }
  const auto& calibration = std::get<SpeechCalibration>(found);
  if (sound.speech_spl) {
    sound.speech_level = calibration.level_for(*sound.speech_spl);
    require_within_full_scale(sound, device);
  }
  return {.text = text_of(calibration, sound, device),
          .record = record_of(calibration, sound, device)};
}

SessionLevel unheard_level(const protocols::Sound& sound) {
  if (!sound.speech_spl) return {};
  return {.text = fmt::format("nothing is heard: speech is mixed at {:g} dB FS instead of the {:g} "
                              "dB SPL that the protocol asks for",
                              sound.speech_level.count(),
                              sound.speech_spl->count()),
          .record = {}};
}

SessionLevel level_on(const AudioOutput& audio, protocols::Sound& sound) {
  if (audio.kind() == "none") return unheard_level(sound);
  return settle_level(sound, audio.device_name(), read_levels(level_file()));
}

SessionLevel checked_level(protocols::ReadProtocol& read,
                           const std::string& file,
                           std::vector<Diagnostic>& found) {
  auto& sound = read.protocol.sound;
  try {
    const auto table = read_levels(level_file());
    if (!sound.speech_spl && table.levels().empty()) return {};
    return settle_level(sound, output_name(""), table);
  } catch (const Error& error) {
    if (!sound.speech_spl) return {};  // of a machine that will not run it, perhaps
    const JsonLines lines{read.text};
    const std::string pointer = "/sound/speech_level_dbspl";
    found.push_back({.severity = Severity::Warning,
                     .file = file,
                     .line = lines.line_of(pointer),
                     .pointer = pointer,
                     .finding = fmt::format("cannot be settled here: {}", describe(error)),
                     .remedy = fmt::format("`run` refuses it; sounds were tried at {:g} dB FS",
                                           protocols::Sound{}.speech_level.count())});
    sound.speech_level = protocols::Sound{}.speech_level;
    return {};
  }
}

}  // namespace bimodal::runner
