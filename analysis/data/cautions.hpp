#pragma once

#include "analysis/data/dataset.hpp"

namespace bimodal::analysis {

/// Appends to the dataset's warnings what makes its numbers less than they seem: sessions that did
/// not end, more than one protocol, a condition that means two things, people and simulations
/// mixed, words met twice, trials whose timing was not as planned, dubbed trials, answers cut off
/// by the clock.
void add_cautions(Dataset& dataset);

}  // namespace bimodal::analysis
