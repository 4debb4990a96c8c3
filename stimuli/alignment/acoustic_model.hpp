#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <span>
#include <vector>

#include "stimuli/alignment/cepstra.hpp"
#include "stimuli/alignment/gaussian_codebook.hpp"
#include "stimuli/alignment/model_file.hpp"
#include "stimuli/timeline/phone.hpp"

namespace bimodal {

/// Number of states of a phone's model, passed in order; so also the fewest frames of a phone.
inline constexpr std::size_t kStates = 3;

/// The phone as which the acoustic model hears one of ours: AX as AH and WH as W, any other as
/// itself.
[[nodiscard]] Phone modelled(Phone phone);

/// Where in its word a phone stands; a word of one phone has it Alone.
enum class PlaceInWord : std::uint8_t { Inside, First, Last, Alone };
inline constexpr std::size_t kPlacesInWord = 4;

/// Natural logarithms of the probabilities to stay in a state and to go on to the next one.
struct Transitions {
  std::array<float, kStates> stay{};
  std::array<float, kStates> leave{};
};

inline constexpr std::size_t kAllFrames = std::numeric_limits<std::size_t>::max();

/// A phone as it is in some context, and the frames for which its scores are wanted.
struct PhoneUnit {
  Phone phone = Phone::Rest;  ///< as modelled
  std::array<std::uint16_t, kStates> senones{};
  std::size_t first_frame = 0;
  std::size_t end_frame = kAllFrames;
};

/// How well each frame fits each state of each unit: log likelihoods, natural logarithm.
class UnitScores {
 public:
  using States = std::array<float, kStates>;

  UnitScores(std::size_t frames, std::span<const PhoneUnit> units);

  [[nodiscard]] std::size_t frames() const { return frames_; }

  /// Minus infinity where no score was wanted.
  [[nodiscard]] const States& at(std::size_t frame, std::size_t unit) const {
    const auto& column = columns_[unit];
    if (frame < column.first || frame >= column.first + column.scores.size()) return kImpossible;
    return column.scores[frame - column.first];
  }

  /// Takes the columns of others, of the same frames and units, that are empty here.
  void complete_from(UnitScores others);

  [[nodiscard]] bool has(std::size_t unit) const { return !columns_[unit].scores.empty(); }

  [[nodiscard]] std::span<States> of(std::size_t unit) { return columns_[unit].scores; }

 private:
  static constexpr float kNo = -std::numeric_limits<float>::infinity();
  static constexpr States kImpossible{kNo, kNo, kNo};

  struct Column {
    std::size_t first = 0;
    std::vector<States> scores;
  };

  std::size_t frames_;
  std::vector<Column> columns_;
};

/// Hidden Markov models of the phones of American English, from a phonetically tied mixture model
/// of PocketSphinx ("ptm"): 128 Gaussian densities a phone and feature stream, of which each state
/// in each context is a mixture. Unlike PocketSphinx, which keeps the best four densities in coarse
/// integers relative to whatever else it is considering, all are counted in full, so that the
/// scores of any two paths through the same frames can be compared.
class AcousticModel {
 public:
  /// $BIMODAL_ACOUSTICS, or where Debian's pocketsphinx-en-us puts it. Throws Error saying what to
  /// install if it is not there.
  [[nodiscard]] static std::filesystem::path installed();

  /// Throws Error if the folder does not hold such a model, naming the file.
  explicit AcousticModel(const std::filesystem::path& folder);

  /// The phone in no particular context.
  [[nodiscard]] PhoneUnit unit(Phone phone) const;

  /// The phone between two others, at some place of its word; the nearest context that the model
  /// knows.
  [[nodiscard]] PhoneUnit unit(Phone phone, Phone left, Phone right, PlaceInWord place) const;

  [[nodiscard]] UnitScores score(std::span<const Cepstra> frames,
                                 std::span<const PhoneUnit> units) const;

  [[nodiscard]] const Transitions& transitions(Phone phone) const;

 private:
  [[nodiscard]] std::vector<float> weights(const PhoneUnit& unit) const;

  ModelDefinition definition_;
  std::array<std::size_t, kPhoneCount> index_{};  ///< of our phones among the model's
  std::array<GaussianCodebook, kPhoneCount> codebooks_;
  std::array<Transitions, kPhoneCount> transitions_{};
  std::vector<std::uint8_t> codes_;   ///< [senone][stream][density]
  std::array<float, 256> weights_{};  ///< of the codes
};

}  // namespace bimodal
