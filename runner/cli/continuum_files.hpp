#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "runner/cli/face_view.hpp"
#include "synth/face/head.hpp"
#include "synth/speech/continuum.hpp"

namespace bimodal::runner {

/// The face of one token in the middle of the varied segment, and how its lips move about it.
struct TokenMiddle {
  synth::Pose pose{};
  synth::Pose released{};  ///< kReleased after the end of the segment
  synth::LipMeasures lips;
  /// How long the lips are shut (a gap of at most kShutGapMm) without a break about the middle,
  /// also beyond the segment; 0 if they are not shut there.
  Milliseconds shut{};
  /// From the parting of the lips (from the middle, if they are open then) until they are half as
  /// far open as they come to be within kOpeningTime; absent if they are at once, or never open.
  std::optional<Milliseconds> half_open;
  double fastest_opening_mm_per_s = 0;  ///< of the inner height in that time
};

inline constexpr double kShutGapMm = 0.05;
inline constexpr Milliseconds kOpeningTime{300};
inline constexpr Milliseconds kReleased{30};

/// A continuum worked out: what its files are written from.
struct Continuum {
  std::vector<synth::ContinuumToken> tokens;
  std::vector<synth::ScoreClaims> claims;  ///< one per token
  std::vector<TokenMiddle> middles;        ///< one per token
  Account account = Account::Dominance;
};

[[nodiscard]] Continuum worked_out(std::vector<synth::ContinuumToken> tokens,
                                   const synth::SegmentTable& table,
                                   Account account,
                                   const synth::Head& head);

/// "token0" ... with as many digits as the last one needs.
[[nodiscard]] std::string token_name(const Continuum& continuum, std::size_t token);

/// Removes what an earlier continuum left in the folder and this one may not write: token*.csv,
/// token*.mp4, words.json.
void remove_earlier_tokens(const std::filesystem::path& folder);

/// tokens.csv: a row per token with its name, its place, the lips' measures in the middle, how long
/// they are shut, how soon half open, how fast, and every control in the middle.
void write_token_table(const Continuum& continuum, const std::filesystem::path& folder);

/// What a user of the tokens should know: steps by which the lips open less than by the one before,
/// though on the whole they open more (or the other way round).
[[nodiscard]] std::vector<std::string> cautions(const Continuum& continuum);

/// words.json: the tokens between two sounds as a word list for protocols, each under its name in
/// lower case. False if the context has rests, which words have not.
[[nodiscard]] bool write_token_words(const Continuum& continuum,
                                     const std::filesystem::path& folder);

/// token0.csv ...: every control at 1000 Hz.
void write_token_tracks(const Continuum& continuum, const std::filesystem::path& folder);

/// controls.svg: the opening of the lips and every control that differs, in the middle, over the
/// tokens. movements.svg: every control that is
/// asked differently over time. `format`: "svg", "pdf" or "png".
void write_token_plots(const Continuum& continuum,
                       const std::string& title,
                       const std::string& format,
                       const std::filesystem::path& folder);

/// strip.png: the tokens side by side: whole face and mouth in the middle, and the mouth at
/// kReleased.
void write_token_strip(const Continuum& continuum,
                       const synth::Head& head,
                       const ViewOptions& view,
                       const std::filesystem::path& folder);

/// token0.mp4 ...: silent videos. Tells on standard error how far it has come.
void write_token_videos(const Continuum& continuum,
                        const synth::Head& head,
                        const ViewOptions& view,
                        Hertz rate,
                        const std::filesystem::path& folder);

}  // namespace bimodal::runner
