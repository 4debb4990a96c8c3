#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "stimuli/alignment/aligner.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/base/milliseconds.hpp"
#include "stimuli/words/word_list.hpp"
#include "synth/voice/voice.hpp"

namespace bimodal::testing_alignment {

/// Words spread over the list of 414.
inline std::vector<Word> words(std::size_t number) {
  std::vector<Diagnostic> diagnostics;
  const auto list =
      read_word_list(asset("stimuli/assets/words/monosyllables-414.json"), diagnostics);
  std::vector<Word> chosen;
  for (std::size_t i = 0; i < number; ++i) {
    chosen.push_back(list.words.at(i * 29 % list.words.size()));
  }
  return chosen;
}

/// Differences of all boundaries, in ms; both must have the same phones.
inline std::vector<double> boundary_errors(const Utterance& found, const Utterance& labelled) {
  EXPECT_EQ(found.phones.size(), labelled.phones.size());
  std::vector<double> errors;
  for (std::size_t i = 1; i < std::min(found.phones.size(), labelled.phones.size()); ++i) {
    EXPECT_EQ(found.phones[i].phone, labelled.phones[i].phone);
    errors.push_back(milliseconds(found.phones[i].start - labelled.phones[i].start));
  }
  return errors;
}

inline double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values.at(values.size() / 2);
}

inline double median_size(const std::vector<double>& errors) {
  std::vector<double> sizes;
  for (const double error : errors) sizes.push_back(std::abs(error));
  return median(sizes);
}

inline double share_within(const std::vector<double>& errors, double limit) {
  const auto within =
      std::ranges::count_if(errors, [&](double error) { return std::abs(error) <= limit; });
  return static_cast<double>(within) / static_cast<double>(errors.size());
}

inline bool has_voice(const std::string& name) {
  const auto names = synth::Voice::installed();
  return std::ranges::find(names, name) != names.end();
}

}  // namespace bimodal::testing_alignment
