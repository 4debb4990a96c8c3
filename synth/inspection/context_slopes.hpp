#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "synth/face/head.hpp"
#include "synth/speech/segment_table.hpp"

namespace bimodal::synth {

/// Where one articulator of a consonant goes with the vowels around it: the slope of its place in
/// the consonant's middle on its place in the vowel's, over /a i u/. 0: the consonant decides
/// alone; 1: the vowel does.
struct ContextSlope {
  std::string_view consonants;   ///< "P B M"
  std::string_view articulator;  ///< "lip protrusion"
  double slope = 0;              ///< of this face
  double measured = 0;           ///< of one talker, by magnetic resonance
  std::string_view word;  ///< why they differ by more than kNotableDifference; empty if they do not
};

inline constexpr double kNotableDifference = 0.2;

/// The face's slopes in V C V between pauses (150, 100, 150 ms), V one of AA IY UW, measured on the
/// mesh: lip protrusion (mean of both lips), opening (inner height), jaw (rotation), and the tip of
/// the tongue forward and up. Beside them the slopes of VocalTractLab's speaker JD3 (Birkholz
/// 2013; one German man), computed from its vowels and consonants in context.
[[nodiscard]] std::vector<ContextSlope> context_slopes(const SegmentTable& table, const Head& head);

}  // namespace bimodal::synth
