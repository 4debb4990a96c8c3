#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/labels/label_lines.hpp"
#include "stimuli/labels/labels.hpp"

namespace bimodal {

/// How many labels one file may have: it may come from anywhere.
inline constexpr std::size_t kMostLabels = 200'000;

/// Collects the labels of one file, tier by tier, and keeps the promises of Tier: order, no
/// overlap, texts without blanks at their ends. Where a label begins up to kRounding before the end
/// of the one before it, its start is moved there. Labels without text that have a length are gaps
/// and dropped.
class TierBuilder {
 public:
  /// `file` is for messages and must live on.
  explicit TierBuilder(std::string_view file) : file_{file} {}

  /// Begins a tier and returns its index.
  std::size_t add_tier(std::string name);

  /// Throws Error naming the line if the label ends before it begins, overlaps the one before it in
  /// its tier, or is one too many.
  void add(std::size_t tier, Label label, std::size_t line);

  /// The labels of a recording that ends at `end`, or with the last label that was added, with text
  /// or without.
  [[nodiscard]] Labels finish(Duration end = {}) &&;

  [[nodiscard]] std::string_view file() const { return file_; }

 private:
  std::string_view file_;
  std::vector<Tier> tiers_;
  std::vector<Duration> reached_;  ///< for each tier, the end of its last label
  std::size_t count_ = 0;
};

/// "phones" if all labels are phones or silence (see utterance_of), otherwise "words": the name of
/// a tier that has none in its file.
[[nodiscard]] std::string name_by_content(const Tier& tier);

}  // namespace bimodal
