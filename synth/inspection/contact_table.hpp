#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "synth/face/head.hpp"
#include "synth/inspection/mouth_measures.hpp"
#include "synth/speech/segment_table.hpp"

namespace bimodal::synth {

/// How one requirement of the face is met by one group of sounds.
struct ContactRow {
  std::string sounds;       ///< "P B M"
  std::string requirement;  ///< in words, with its limit
  std::size_t cases = 0;    ///< syllables times places in them, at all rates
  std::size_t met = 0;
  double worst = 0;        ///< of the measure in its best picture, over all cases
  std::string worst_case;  ///< "K AA B, first picture at 0 ms, rate 2"
};

/// Contacts and penetrations of the face that an inventory moves.
struct ContactTable {
  std::vector<ContactRow> rows;
  Penetrations deepest;      ///< each at its worst
  std::string deepest_case;  ///< of the worst of all
  std::size_t pictures = 0;  ///< that were looked at for penetrations
};

struct ContactScope {
  std::vector<double> rates{0.5, 1.0, 2.0};
  std::size_t every = 1;    ///< only each n-th of those syllables is looked at
  std::vector<Phone> with;  ///< only syllables with one of these sounds; empty: all
  std::size_t threads = 1;
  std::function<void(double part_done)> progress;  ///< may be empty
};

/// Measures the drawn face in syllables C V C of all consonants and vowels, between pauses, with
/// intrinsic durations at each rate. Each sound that must make a contact is looked at in the
/// pictures of a 60 Hz display in and around it, with the first picture at the syllable's start and
/// again half a refresh later: in each of the two series at least one picture must meet the
/// requirement. Penetrations are looked for in the middle of each sound and at its end.
[[nodiscard]] ContactTable measure_contacts(const Head& head,
                                            const SegmentTable& table,
                                            const ContactScope& scope);

}  // namespace bimodal::synth
