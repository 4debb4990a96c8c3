#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/data/dataset.hpp"
#include "analysis/report/benefits.hpp"
#include "analysis/report/confusions.hpp"
#include "analysis/report/face_comparison.hpp"
#include "analysis/report/feature_profiles.hpp"
#include "analysis/report/proportions.hpp"

namespace bimodal::analysis {

/// What a condition was, and what became of its trials.
struct ConditionSummary {
  std::string name;
  std::string meaning;  ///< "heard festival:kal at -8 dB S/N; seen face"
  std::int64_t participants = 0;
  std::int64_t words = 0;
  std::int64_t trials = 0;
  std::int64_t correct = 0;     ///< spelled as the word
  std::int64_t homophones = 0;  ///< correct by sound
  std::int64_t tolerated = 0;   ///< correct by a rule of tolerance
  std::int64_t wrong = 0;
  std::int64_t unknown = 0;  ///< not in the dictionary
  std::int64_t omissions = 0;
};

/// Where answers were looked up.
struct DictionarySource {
  std::string file;
  std::string sha256;
};

/// Who did worse is left out of everything: of words correct (homophones too) in a condition.
struct Criterion {
  std::string condition;
  double least = 0.0;  ///< proportion
};

/// Conditions that show the natural and the synthetic face: the one is what the other is measured
/// by.
struct FaceConditions {
  std::string natural;
  std::string synthetic;
};

struct AnalysisOptions {
  ScoringRules rules;
  CrossedBootstrap::Options bootstrap;
  std::vector<Criterion> criteria;
  std::optional<FaceConditions> faces;  ///< absent: nobody said which they are
  Resampling comparison;                ///< of the two faces
  /// Told what is being done; for a progress display.
  std::function<void(std::string_view step)> progress = [](std::string_view) {};
};

/// Everything that any table, figure or page shows; computed once.
struct Results {
  Dataset dataset;
  DictionarySource dictionary;
  ScoringRules rules;
  CrossedBootstrap::Options bootstrap;
  std::optional<FaceConditions> faces;  ///< as named
  Resampling comparison;
  std::vector<Score> scores;                 ///< of dataset.trials, one by one
  std::vector<std::string> participants;     ///< with trials, by their numbers
  std::vector<ConditionSummary> conditions;  ///< heard, seen, both; then by S/N and name
  std::vector<Proportion> pooled;            ///< measures within conditions
  std::vector<Proportion> individual;        ///< measures within participants within conditions
  std::vector<UnitConfusions> confusions;    ///< conditions within units
  std::vector<ConditionLikeness> likeness;
  std::vector<BenefitRow> benefits;           ///< bimodal conditions in the order of conditions
  std::vector<FeatureProfileTable> features;  ///< conditions within consonants
  std::vector<FaceComparison> comparisons;    ///< of the faces named, by units
  std::vector<ShareRow> shares;               ///< of natural benefits
  std::vector<std::string> warnings;          ///< the dataset's, and those of the numbers
};

[[nodiscard]] Results analyse(Dataset dataset,
                              const Dictionary& dictionary,
                              DictionarySource source,
                              const AnalysisOptions& options = {});

}  // namespace bimodal::analysis
