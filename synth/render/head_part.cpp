#include "synth/render/head_part.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace bimodal::synth {

namespace {

using enum HeadPart;

constexpr unsigned long long bits(std::initializer_list<HeadPart> parts) {
  unsigned long long set = 0;
  for (const HeadPart part : parts) set |= 1ULL << static_cast<unsigned>(part);
  return set;
}

struct NamedParts {
  std::string_view name;
  unsigned long long parts;
};

constexpr std::array<NamedParts, 13> kNames{{{"skin", bits({Skin})},
                                             {"ears", bits({Ear})},
                                             {"lips", bits({Lips})},
                                             {"brows", bits({Brow})},
                                             {"hair", bits({Hair})},
                                             {"eyes", bits({Eye, Lash, Cornea})},
                                             {"mouth_walls", bits({MouthWall})},
                                             {"teeth", bits({UpperTooth, LowerTooth})},
                                             {"upper_teeth", bits({UpperTooth})},
                                             {"lower_teeth", bits({LowerTooth})},
                                             {"gums", bits({Gum})},
                                             {"palate", bits({Palate})},
                                             {"tongue", bits({Tongue})}}};

}  // namespace

std::vector<std::string_view> part_names() {
  std::vector<std::string_view> names;
  for (const NamedParts& row : kNames) names.push_back(row.name);
  return names;
}

std::optional<PartSet> parts_named(std::string_view name) {
  const auto* const found = std::ranges::find(kNames, name, &NamedParts::name);
  if (found == kNames.end()) return std::nullopt;
  return PartSet{found->parts};
}

}  // namespace bimodal::synth
