#include "stimuli/labels/tier_builder.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "stimuli/labels/label_time.hpp"

namespace bimodal {

std::size_t TierBuilder::add_tier(std::string name) {
  tiers_.push_back({.name = std::move(name), .labels = {}});
  reached_.emplace_back();
  return tiers_.size() - 1;
}

void TierBuilder::add(std::size_t tier, Label label, std::size_t line) {
  const LabelLine place{file_, line};
  if (label.end < label.start) {
    refuse(place,
           fmt::format("the label {} begins at {} s and ends before, at {} s",
                       in_quotes(label.text),
                       seconds_text(label.start),
                       seconds_text(label.end)),
           "write its start before its end");
  }
  auto& reached = reached_.at(tier);
  if (label.start < reached - kRounding) {
    refuse(place,
           fmt::format("the label {} begins at {} s, before the end of the one before it, {} s",
                       in_quotes(label.text),
                       seconds_text(label.start),
                       seconds_text(reached)),
           "put the labels in order of time, without overlap");
  }
  label.start = std::max(label.start, reached);
  label.end = std::max(label.end, label.start);
  reached = label.end;
  label.text = trimmed(label.text);
  if (label.text.empty() && label.start < label.end) return;
  if (++count_ > kMostLabels) {
    refuse(place, fmt::format("more than {} labels", kMostLabels), "cut the recording into parts");
  }
  tiers_.at(tier).labels.push_back(std::move(label));
}

Labels TierBuilder::finish(Duration end) && {
  for (const Duration reached : reached_) end = std::max(end, reached);
  return {.end = end, .tiers = std::move(tiers_)};
}

std::string name_by_content(const Tier& tier) {
  return not_phones(tier).empty() ? "phones" : "words";
}

}  // namespace bimodal
