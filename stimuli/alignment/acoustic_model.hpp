#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <vector>

#include "stimuli/alignment/cepstra.hpp"
#include "stimuli/timeline/phone.hpp"

namespace bimodal {

/// Number of states of a phone's model, passed in order; so also the fewest frames of a phone.
inline constexpr std::size_t kStates = 3;

/// The phone as which the acoustic model hears one of ours: AX as AH and WH as W, any other as
/// itself.
[[nodiscard]] Phone modelled(Phone phone);

/// Natural logarithms of the probabilities to stay in a state and to go on to the next one.
struct Transitions {
  std::array<float, kStates> stay{};
  std::array<float, kStates> leave{};
};

/// How well each frame fits each state of each phone: log likelihoods, natural logarithm.
class PhoneScores {
 public:
  explicit PhoneScores(std::size_t frames) : scores_(frames * kPhoneCount) {}

  [[nodiscard]] std::size_t frames() const { return scores_.size() / kPhoneCount; }

  [[nodiscard]] std::array<float, kStates>& at(std::size_t frame, Phone phone) {
    return scores_[frame * kPhoneCount + static_cast<std::size_t>(phone)];
  }

  [[nodiscard]] const std::array<float, kStates>& at(std::size_t frame, Phone phone) const {
    return scores_[frame * kPhoneCount + static_cast<std::size_t>(phone)];
  }

 private:
  std::vector<std::array<float, kStates>> scores_;
};

/// Hidden Markov models of the phones of American English without context, from a phonetically tied
/// mixture model of PocketSphinx ("ptm"): 128 Gaussian densities a phone and feature stream, of
/// which each state is a mixture. Unlike PocketSphinx, which keeps the best four densities in coarse
/// integers relative to whatever else it is considering, all are counted in full, so that the scores
/// of any two paths through the same frames can be compared.
class AcousticModel {
 public:
  /// $BIMODAL_ACOUSTICS, or where Debian's pocketsphinx-en-us puts it. Throws Error saying what to
  /// install if it is not there.
  [[nodiscard]] static std::filesystem::path installed();

  /// Throws Error if the folder does not hold such a model, naming the file.
  explicit AcousticModel(const std::filesystem::path& folder);

  [[nodiscard]] PhoneScores score(std::span<const Cepstra> frames) const;

  [[nodiscard]] const Transitions& transitions(Phone phone) const;

 private:
  struct Codebook {
    Phone phone = Phone::Rest;
    std::vector<float> means;       ///< [stream][dimension][density]
    std::vector<float> precisions;  ///< half the reciprocal variance, likewise
    std::vector<float> constants;   ///< [stream][density]
    std::vector<float> weights;     ///< [stream][state][density]
  };

  std::vector<Codebook> codebooks_;
  std::array<Transitions, kPhoneCount> transitions_{};
};

}  // namespace bimodal
