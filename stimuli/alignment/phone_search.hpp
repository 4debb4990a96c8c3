#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "stimuli/base/quantity.hpp"
#include "stimuli/timeline/phone.hpp"

namespace bimodal {

/// The phone as which the acoustic model hears one of ours: AX as AH and WH as W, any other as
/// itself.
[[nodiscard]] Phone modelled(Phone phone);

/// What an arc of a grammar consumes: a phone, and whether a word begins with it. The mark lets a
/// path through alternative pronunciations be read back word by word.
struct PhoneToken {
  Phone phone = Phone::Rest;
  bool begins_word = false;

  bool operator==(const PhoneToken&) const = default;
};

struct PhoneArc {
  std::size_t from = 0;
  std::size_t to = 0;
  std::optional<PhoneToken> token;  ///< absent: passes without sound
};

/// Which sequences of phones may be heard: a finite-state grammar from state 0 to the last state.
struct PhoneGrammar {
  std::size_t states = 0;
  std::vector<PhoneArc> arcs;
};

/// One phone of a path, as modelled.
struct FoundPhone {
  PhoneToken token;
  std::size_t first_frame = 0;
  std::size_t frames = 0;
  double log_likelihood = 0.0;  ///< of all its frames, natural logarithm, up to a constant a frame
};

/// Sequences of phones in sound, by PocketSphinx: continuous-density hidden Markov models of three
/// states a phone, so a phone lasts at least three frames.
/// One object may be used by one thread at a time; objects do not share anything.
class PhoneSearch {
 public:
  static constexpr Hertz kRate{16'000};
  static constexpr Duration kFrame = std::chrono::milliseconds{10};       ///< from frame to frame
  static constexpr Duration kWindow = std::chrono::microseconds{25'625};  ///< heard by a frame
  static constexpr std::size_t kFewestFrames = 3;                         ///< of a phone

  /// Throws Error naming the Debian package if the acoustic model is not there ($BIMODAL_ACOUSTICS
  /// or where pocketsphinx-en-us puts it).
  PhoneSearch();
  ~PhoneSearch();
  PhoneSearch(PhoneSearch&&) noexcept;
  PhoneSearch& operator=(PhoneSearch&&) noexcept;
  PhoneSearch(const PhoneSearch&) = delete;
  PhoneSearch& operator=(const PhoneSearch&) = delete;

  /// The likeliest path through the grammar, from the first frame to the last one; empty if the
  /// search has lost every path that ends in the last state. `samples` are at kRate.
  [[nodiscard]] std::vector<FoundPhone> best_path(const PhoneGrammar& grammar,
                                                  std::span<const std::int16_t> samples);

  /// The likeliest sequence of any phones.
  [[nodiscard]] std::vector<FoundPhone> free_path(std::span<const std::int16_t> samples);

 private:
  struct Decoder;
  std::unique_ptr<Decoder> decoder_;
};

}  // namespace bimodal
