#pragma once

#include <string>

#include "protocols/model/protocol.hpp"
#include "protocols/reading/read_protocol.hpp"
#include "runner/calibration/speech_level.hpp"
#include "runner/devices/audio_output.hpp"

namespace bimodal::runner {

/// What is known of the level of speech on one sound output.
struct SessionLevel {
  std::string text;    ///< "speech at -30 dB FS is 65.2 dB SPL on ..."; empty: nothing is known
  std::string record;  ///< as JSON, for the data; empty: nothing is known
};

/// Where the protocol's speech is heard if `device` plays it.
[[nodiscard]] Listening listening_at(const protocols::Sound& sound, const std::string& device);

/// Looks the device up, and where the protocol asks for dB SPL sets `sound.speech_level` from it.
/// Throws Error, with the remedy, if that needs a calibration which is not there, or a level beyond
/// full scale.
[[nodiscard]] SessionLevel settle_level(protocols::Sound& sound,
                                        const std::string& device,
                                        const LevelTable& table);

/// The same where nothing is heard, or nobody listens: the level stays at its default; the text
/// says so if the protocol asks for another.
[[nodiscard]] SessionLevel unheard_level(const protocols::Sound& sound);

/// The one or the other: by the measurements that are kept on this machine, or `--audio none`.
[[nodiscard]] SessionLevel level_on(const AudioOutput& audio, protocols::Sound& sound);

/// The same for `check`, on the device that `run` takes without --audio: what cannot be settled is
/// added to `found` as a warning.
[[nodiscard]] SessionLevel checked_level(protocols::ReadProtocol& read,
                                         const std::string& file,
                                         std::vector<Diagnostic>& found);

}  // namespace bimodal::runner
