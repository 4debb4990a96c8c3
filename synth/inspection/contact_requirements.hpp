#pragma once

#include <span>
#include <string_view>

#include "stimuli/timeline/phone.hpp"
#include "synth/inspection/mouth_measures.hpp"
#include "synth/speech/control.hpp"

namespace bimodal::synth {

/// What a group of sounds must show. A measure meets the requirement if least <= measure <= most.
struct ContactRequirement {
  std::string_view sounds;  ///< "P B M"
  std::string_view words;
  Control control;  ///< farthest in the pictures to be looked at
  double sign;      ///< of "farthest": 1 or -1
  double least;     ///< in the measure's unit, mm or mm2, as the words say
  double most;      ///< so too; may be infinite
  double (*measure)(MouthRuler& ruler);
};

[[nodiscard]] std::span<const ContactRequirement> contact_requirements();

/// Whether the sound is one of the requirement's.
[[nodiscard]] bool concerns(const ContactRequirement& requirement, Phone phone);

/// How far outside the limits a measure lies; 0 inside.
[[nodiscard]] double distance_to(const ContactRequirement& requirement, double measure);

/// How far inside its limits a measure lies; negative: outside. Limits that no sound can miss in
/// one direction do not count.
[[nodiscard]] double margin(const ContactRequirement& requirement, double measure);

}  // namespace bimodal::synth
