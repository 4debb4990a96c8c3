#pragma once

#include <string>
#include <vector>

#include "protocols/model/protocol.hpp"
#include "protocols/model/talker.hpp"
#include "protocols/reading/read_face.hpp"
#include "stimuli/base/findings.hpp"
#include "stimuli/base/object_reader.hpp"

namespace bimodal::protocols {

/// A condition as it is written: corpora are not looked for yet.
struct WrittenCondition {
  Condition condition;
  std::string pointer;  ///< where it is written
  // Who takes the place of a corpus that is not there; empty: nobody.
  std::string auditory_otherwise;
  std::string visual_otherwise;
  std::string timing_otherwise;
};

/// Reads the key "conditions" and notes every mistake. `usual`: what the protocol says of the face.
[[nodiscard]] std::vector<WrittenCondition> read_conditions(ObjectReader& parent,
                                                            const Face& usual,
                                                            const FaceReader& faces,
                                                            Findings& findings);

/// "#606060" as 0x606060; noted and absent if it is no colour.
[[nodiscard]] std::optional<std::uint32_t> read_colour(ObjectReader& reader,
                                                       std::string_view key,
                                                       Findings& findings);

}  // namespace bimodal::protocols
