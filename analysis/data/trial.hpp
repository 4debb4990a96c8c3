#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "stimuli/base/quantity.hpp"
#include "stimuli/timeline/phone.hpp"

namespace bimodal::analysis {

/// What one trial presented, and what was answered: the row that every table is made of.
struct Trial {
  std::size_t session = 0;  ///< index into Dataset::sessions
  std::string participant;
  int trial = 0;      ///< in order of presentation, from 0, practice included
  std::string phase;  ///< "practice" or "main"
  int block = 0;      ///< from 0
  std::string condition;
  std::optional<std::string> auditory_talker;  ///< absent: nothing spoken was heard
  std::optional<std::string> visual_talker;    ///< absent: no face was seen
  std::optional<double> snr_db;                ///< absent: no noise
  std::string word;                            ///< that was heard, or seen if nothing was heard
  std::optional<std::string> visual_word;      ///< that was seen, if it was dubbed onto another
  std::optional<std::string> articulation;     ///< of a face whose sounds are ambiguous
  std::optional<std::string> face;             ///< what it looked like; absent: none, or not stored
  Pronunciation phones;                        ///< as presented
  std::string response;                        ///< as submitted, UTF-8; empty for an omission
  /// Reaction times count from the point that the protocol names: the onset of sound or picture, or
  /// the end of the stimulus. Negative for a key pressed before it.
  std::optional<Duration> first_key;
  std::optional<Duration> submitted;  ///< absent: not known
  bool timed_out = false;
  bool flagged = false;      ///< the timing was not as planned
  bool timing_known = true;  ///< whether; false of tables that do not say
  bool excluded = false;     ///< and by the protocol's rule it is not analysed
  bool simulated = false;    ///< a simulated observer answered, or time was virtual
};

}  // namespace bimodal::analysis
