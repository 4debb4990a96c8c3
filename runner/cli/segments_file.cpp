#include "runner/cli/segments_file.hpp"

#include <fmt/format.h>

#include "stimuli/base/asset.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

std::filesystem::path segments_file(const std::string& chosen) {
  if (std::filesystem::exists(chosen)) return chosen;
  try {
    return asset(fmt::format("synth/assets/segments/{}.json", chosen));
  } catch (const Error&) {
    throw Error{fmt::format(
        "there is neither a file '{}' nor an inventory of that name; give a file, or one that "
        "ships: english, turkish-plateau",
        chosen)};
  }
}

}  // namespace bimodal::runner
