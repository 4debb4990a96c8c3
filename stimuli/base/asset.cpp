#include "stimuli/base/asset.hpp"

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"

namespace bimodal {

std::filesystem::path asset(std::string_view path_in_project) {
  std::vector<std::filesystem::path> roots;
  if (const char* root = std::getenv("BIMODAL_ROOT"); root != nullptr) {
    roots.emplace_back(root);
  }
  std::error_code ignored;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  if (!ignored) roots.push_back(program.parent_path().parent_path() / "share" / "bimodal");
  roots.emplace_back(BIMODAL_SOURCE_ROOT);

  std::string tried;
  for (const auto& root : roots) {
    auto file = root / path_in_project;
    if (std::filesystem::exists(file, ignored)) return file;
    tried += fmt::format("\n  {}", file.string());
  }
  throw Error{fmt::format(
      "cannot find '{}', which belongs to the program; set BIMODAL_ROOT to the project's folder."
      " Looked for:{}",
      path_in_project,
      tried)};
}

std::vector<std::string> asset_names(std::string_view folder_in_project,
                                     std::string_view extension) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator{asset(folder_in_project)}) {
    if (entry.path().extension() == extension) names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace bimodal
