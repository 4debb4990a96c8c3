#pragma once

#include <string>
#include <vector>

#include "stimuli/figures/figure.hpp"
#include "synth/speech/score.hpp"

namespace bimodal::synth {

/// One control of one score, as one account moves it.
struct Trace {
  std::string label;
  Score score;  ///< complete: every segment has the control "p"
  Account account = Account::Dominance;
};

/// Traces that are drawn over each other.
struct PaperPanel {
  std::string title;
  std::string y_label;
  std::vector<Trace> traces;
  bool shows_dominance = true;  ///< in a panel above
  std::vector<Line> lines;      ///< times of interest, in ms
};

/// A figure of Cohen & Massaro (1993), made anew from the parameters that the paper gives; what it
/// does not give is chosen by us, as the caption says.
struct PaperFigure {
  std::string name;   ///< "figure4"
  std::string title;  ///< what it shows
  std::string caption;
  std::vector<PaperPanel> panels;
  std::size_t columns = 1;
};

/// Figures 1 and 4 to 11, and one of equation 7.
[[nodiscard]] std::vector<PaperFigure> paper_figures();

/// The value of a trace's control "p" at a time.
[[nodiscard]] double value_at(const Trace& trace, Milliseconds time);

/// Dominance above, control below, segments named at the top, targets as circles.
[[nodiscard]] Figure drawn(const PaperFigure& figure);

}  // namespace bimodal::synth
