#pragma once

#include <string>
#include <vector>

#include "protocols/reading/read_protocol.hpp"

namespace bimodal::runner {

/// Looks at every recording that the protocol needs: it must be there, be the very file that the
/// manifest means (SHA-256), have the sound and the picture that are to be presented, last as long
/// as its items say, and its picture must fit into the window in the look of each condition. Judges
/// the inventories of segments that faces articulate, too. `file` names the protocol in the
/// diagnostics.
[[nodiscard]] std::vector<Diagnostic> check_media(const protocols::ReadProtocol& read,
                                                  const std::string& file);

}  // namespace bimodal::runner
