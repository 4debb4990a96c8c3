#pragma once

#include <array>
#include <cstddef>

#include "stimuli/timeline/phone.hpp"

namespace bimodal::protocols {

/// A number for each pair of a stimulus phone (row) and a response phone (column): probabilities or
/// counts. Zero at first.
class PhoneTable {
 public:
  [[nodiscard]] double operator()(Phone stimulus, Phone response) const {
    return cells_[index(stimulus)][index(response)];
  }

  double& operator()(Phone stimulus, Phone response) {
    return cells_[index(stimulus)][index(response)];
  }

  [[nodiscard]] double row_sum(Phone stimulus) const;

  bool operator==(const PhoneTable&) const = default;

 private:
  static constexpr std::size_t index(Phone phone) { return static_cast<std::size_t>(phone); }

  std::array<std::array<double, kPhoneCount>, kPhoneCount> cells_{};
};

/// Whether the two are both consonants or both vowels; rest is neither.
[[nodiscard]] bool same_kind(Phone one, Phone other);

// Confusion tables: P(response | stimulus) between phones of the same kind, so that every row but
// that of rest sums to 1.

/// Every phone is recognised.
[[nodiscard]] PhoneTable identity_confusions();

/// Nothing is perceived: each phone of the stimulus's kind is as likely.
[[nodiscard]] PhoneTable uniform_confusions();

/// (1 - weight) one + weight other; weight in [0, 1].
[[nodiscard]] PhoneTable mixture(const PhoneTable& one, const PhoneTable& other, double weight);

/// The fuzzy logical model of perception (Oden & Massaro 1978, Psychological Review 85, 172-191;
/// Massaro 1998, Perceiving Talking Faces): for each stimulus phone,
/// P(r) = a(r) v(r) / sum over k of a(k) v(k). Each row must have a response that is possible in
/// both.
[[nodiscard]] PhoneTable fuzzy_product(const PhoneTable& auditory, const PhoneTable& visual);

}  // namespace bimodal::protocols
