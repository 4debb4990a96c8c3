#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/statistics/benefit.hpp"
#include "analysis/statistics/interval.hpp"

namespace bimodal::analysis {

struct Results;

/// One participant's proportions of words correct.
struct ParticipantBenefit {
  std::string participant;
  double auditory = 0.0;  ///< heard alone
  double bimodal = 0.0;   ///< heard and seen
};

/// What a face adds to a voice, in words correct.
struct BenefitRow {
  std::string bimodal;            ///< the condition with voice and face
  std::string auditory;           ///< the same voice at the same S/N, without a face
  std::string visual;             ///< the same face without a voice; empty: there is none
  std::int64_t participants = 0;  ///< in any of these
  std::int64_t words = 0;         ///< different ones in any of these
  std::int64_t n = 0;             ///< trials of the bimodal condition
  std::int64_t n_auditory = 0;
  std::int64_t n_visual = 0;
  double a = 0.0;   ///< proportion correct, voice alone
  double av = 0.0;  ///< proportion correct, both
  std::optional<double> v;
  Benefit benefit;
  std::optional<Interval> gain_interval;      ///< 95 %, of AV - A
  std::optional<Interval> relative_interval;  ///< 95 %, of (AV - A) / (1 - A)
  std::string method;                         ///< of the intervals, or why there are none
  std::vector<ParticipantBenefit> own;        ///< of participants with trials in A and AV
};

/// How much of the natural face's benefit a synthetic one gives to the same voice.
struct ShareRow {
  std::string natural;  ///< the bimodal conditions
  std::string synthetic;
  std::string auditory;
  std::int64_t participants = 0;
  std::int64_t words = 0;
  std::optional<double> share;       ///< absent where the natural face gives none
  std::optional<Interval> interval;  ///< 95 %
  std::string method;                ///< of the interval, or why there is none
};

/// A row for every bimodal condition that has one voice-alone condition with the same talkers at
/// the same S/N; none for words that were dubbed onto others. Needs the trials, scores and
/// conditions of the results. Intervals: participants and words are drawn again with replacement
/// (CrossedBootstrap), the same ones for all conditions of a row.
[[nodiscard]] std::vector<BenefitRow> tabulate_benefits(const Results& results);

/// Of the results' benefits: every natural with every synthetic face of the same voice. Faces of
/// recordings ("corpus:NAME") are natural, others synthetic; where the results name two conditions
/// as natural and synthetic, these conditions' talkers are.
[[nodiscard]] std::vector<ShareRow> tabulate_shares(const Results& results);

}  // namespace bimodal::analysis
