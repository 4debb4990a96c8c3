#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/geometric.hpp>

#include "stimuli/base/asset.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/findings.hpp"
#include "stimuli/base/located_reading.hpp"
#include "stimuli/base/object_reader.hpp"
#include "synth/render/material_rows.hpp"

namespace bimodal::synth {

namespace {

constexpr std::string_view kFolder = "synth/assets/materials";
constexpr std::array<std::string_view, 3> kShadings{"smooth", "gouraud", "flat"};

/// Three numbers within `rule`.
std::optional<glm::dvec3> triple(ObjectReader& object,
                                 std::string_view key,
                                 const NumberRule& rule) {
  const auto items = object.items(key, 3, 3);
  if (items.empty()) return std::nullopt;
  glm::dvec3 read{};
  for (int i = 0; i < 3; ++i) {
    const auto& [item, pointer] = items[static_cast<std::size_t>(i)];
    const auto number = object.number_of(*item, pointer, rule);
    if (!number) return std::nullopt;
    read[i] = *number;
  }
  return read;
}

void read_colour(ObjectReader& section, std::string_view key, Colour& colour) {
  const NumberRule rule{0, 255, "red, green and blue, each 0 to 255, e.g. [226, 178, 150]"};
  if (const auto read = triple(section, key, rule)) {
    colour = {static_cast<std::uint8_t>(std::lround(read->x)),
              static_cast<std::uint8_t>(std::lround(read->y)),
              static_cast<std::uint8_t>(std::lround(read->z))};
  }
}

class MaterialsReader {
 public:
  explicit MaterialsReader(Findings& findings) : findings_{findings} {}

  Materials read(const nlohmann::json& root) {
    ObjectReader top{root, "", findings_};
    static_cast<void>(top.text("about", {.meaning = "a sentence about the look"}));
    if (const auto shading = top.choice("shading", kShadings)) {
      materials_.shading = static_cast<Shading>(*shading);
    }
    if (auto background = top.object("background")) {
      read_colour(*background, "centre", materials_.backdrop.centre);
      read_colour(*background, "edge", materials_.backdrop.edge);
      background->refuse_unknown_keys();
    }
    for (const std::string_view name : sections()) {
      if (auto section = top.object(name)) read_section(*section, name);
    }
    top.refuse_unknown_keys();
    return materials_;
  }

 private:
  static std::vector<std::string_view> sections() {
    std::vector<std::string_view> names{"light"};
    const auto add = [&names](std::string_view name) {
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    };
    for (const ColourRow& row : colour_rows()) add(row.section);
    for (const AmountRow& row : amount_rows()) add(row.section);
    return names;
  }

  void read_section(ObjectReader& section, std::string_view name) {
    for (const ColourRow& row : colour_rows()) {
      if (row.section == name) read_colour(section, row.key, materials_.*row.member);
    }
    for (const AmountRow& row : amount_rows()) {
      if (row.section != name) continue;
      const auto number = section.number(row.key, {row.lowest, row.highest, row.meaning});
      if (number) materials_.*row.member = static_cast<float>(*number);
    }
    if (name == "light") {
      for (const LightRow& row : light_rows()) read_light(section, row);
    }
    section.refuse_unknown_keys();
  }

  void read_light(ObjectReader& section, const LightRow& row) {
    if (!row.is_direction) {
      const NumberRule rule{0, 10, "red, green and blue of the light, e.g. [2.15, 2.03, 1.9]"};
      if (const auto light = triple(section, row.key, rule)) materials_.*row.member = *light;
      return;
    }
    constexpr std::string_view kMeaning =
        "the way to the light: to the subject's left, up, forward, e.g. [-0.4, 0.4, 0.8]";
    const auto way = triple(section, row.key, {-1e3, 1e3, kMeaning});
    if (!way) return;
    constexpr double kShortest = 1e-3;
    if (glm::length(*way) < kShortest) {
      findings_.error(
          section.pointer_to(row.key), "this points nowhere", fmt::format("give {}", kMeaning));
      return;
    }
    // What is of unit length as written stays as written.
    constexpr double kRounding = 1e-3;
    const bool is_unit = std::abs(glm::length(*way) - 1.0) < kRounding;
    materials_.*row.member = is_unit ? *way : glm::normalize(*way);
  }

  Findings& findings_;
  Materials materials_;
};

}  // namespace

std::optional<Materials> Materials::parse(std::string_view text,
                                          std::string_view file,
                                          std::vector<Diagnostic>& diagnostics) {
  return read_located(
      text, file, diagnostics, kMostValues, [](const nlohmann::json& tree, Findings& findings) {
        return MaterialsReader{findings}.read(tree);
      });
}

Materials Materials::read(const std::filesystem::path& file) {
  std::vector<Diagnostic> diagnostics;
  if (const auto materials = parse(read_file(file), file.string(), diagnostics)) return *materials;
  std::string message = fmt::format("cannot use the materials '{}':", file.string());
  for (const auto& diagnostic : diagnostics) message += "\n  " + describe(diagnostic);
  throw Error{message};
}

Materials Materials::named(const std::string& name_or_file) {
  const auto presets = asset_names(kFolder, ".json");
  if (std::ranges::find(presets, name_or_file) != presets.end()) {
    return read(asset(fmt::format("{}/{}.json", kFolder, name_or_file)));
  }
  if (std::filesystem::exists(name_or_file)) return read(name_or_file);
  throw Error{fmt::format("there are no materials '{}'; give a file, or one of {}",
                          name_or_file,
                          fmt::join(presets, ", "))};
}

}  // namespace bimodal::synth
