#include "stimuli/timeline/inventory_file.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stimuli/base/asset.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/obstacle.hpp"

namespace bimodal {

std::filesystem::path inventory_file(const std::string& chosen,
                                     const std::filesystem::path& folder) {
  constexpr std::string_view kShipped = "synth/assets/segments";
  auto file = folder / chosen;
  std::error_code ignored;
  const bool is_file =
      std::filesystem::exists(file, ignored) && !std::filesystem::is_directory(file, ignored);
  if (is_file) {
    if (const auto reason = obstacle(file)) {
      throw Error{fmt::format(
          "cannot read the inventory of segments '{}': {}; give another", file.string(), *reason)};
    }
    return file;
  }
  const auto names = asset_names(kShipped, ".json");
  const auto name = chosen.ends_with(".json") ? chosen.substr(0, chosen.size() - 5) : chosen;
  if (std::ranges::find(names, name) == names.end()) {
    throw Error{fmt::format(
        "there is neither a file '{}' nor an inventory of that name; give a file, or one that "
        "ships: {}",
        file.string(),
        fmt::join(names, ", "))};
  }
  return asset(fmt::format("{}/{}.json", kShipped, name));
}

}  // namespace bimodal
