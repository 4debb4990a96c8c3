#include "stimuli/alignment/acoustic_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"

namespace bimodal {

namespace {

constexpr std::string_view kInstalled = "/usr/share/pocketsphinx/model/en-us/en-us";
constexpr std::size_t kMixture = GaussianCodebook::kStreams * GaussianCodebook::kDensities;

void refuse_other_shapes(const std::filesystem::path& folder,
                         const ModelDefinition& definition,
                         const GaussianTable& means,
                         const GaussianTable& variances,
                         const MixtureTable& mixtures,
                         const TransitionTable& transitions) {
  const auto phones = definition.names.size();
  const auto fits = [&](const GaussianTable& table) {
    return table.codebooks == phones && table.streams == GaussianCodebook::kStreams &&
           table.densities == GaussianCodebook::kDensities &&
           table.dimensions == GaussianCodebook::kDimensions;
  };
  if (fits(means) && fits(variances) && mixtures.streams == GaussianCodebook::kStreams &&
      mixtures.densities == GaussianCodebook::kDensities &&
      std::ranges::max(definition.sequences) < mixtures.senones && transitions.models >= phones &&
      transitions.states == kStates && definition.states == kStates) {
    return;
  }
  throw Error{
      fmt::format("loading the acoustic model '{}': it is not phonetically tied with {} "
                  "states a phone and {} streams of {} densities of {} dimensions; use "
                  "that of the Debian package pocketsphinx-en-us",
                  folder.string(),
                  kStates,
                  GaussianCodebook::kStreams,
                  GaussianCodebook::kDensities,
                  GaussianCodebook::kDimensions)};
}

std::size_t index_in(const ModelDefinition& definition,
                     Phone phone,
                     const std::filesystem::path& folder) {
  const auto name = phone == Phone::Rest ? std::string_view{"SIL"} : symbol(phone);
  const auto found = std::ranges::find(definition.names, name);
  if (found == definition.names.end()) {
    throw Error{
        fmt::format("loading the acoustic model '{}': it does not know the phone {}; use "
                    "one of American English, such as that of the Debian package "
                    "pocketsphinx-en-us",
                    folder.string(),
                    name)};
  }
  return static_cast<std::size_t>(found - definition.names.begin());
}

Transitions transitions_of(const TransitionTable& table, std::size_t model) {
  Transitions made;
  for (std::size_t state = 0; state < kStates; ++state) {
    const auto row =
        std::span{table.values}.subspan((model * kStates + state) * (kStates + 1), kStates + 1);
    const auto sum = row[state] + row[state + 1];
    made.stay.at(state) = std::log(row[state] / sum);
    made.leave.at(state) = std::log(row[state + 1] / sum);
  }
  return made;
}

std::array<std::uint16_t, kStates> senones_of(const ModelDefinition& definition,
                                              std::size_t phone) {
  std::array<std::uint16_t, kStates> made{};
  const auto first = definition.sequence_of_phone.at(phone) * kStates;
  for (std::size_t i = 0; i < kStates; ++i) made.at(i) = definition.sequences.at(first + i);
  return made;
}

/// A unit to be scored, with the weights of its states' mixtures.
struct WeightedUnit {
  std::size_t column = 0;
  PhoneUnit unit;
  std::vector<float> weights;
};

/// Scores units of one phone, which share its Gaussians.
void score_phone(const GaussianCodebook& codebook,
                 std::span<const Cepstra> frames,
                 std::span<const WeightedUnit> wanted,
                 UnitScores& scores) {
  for (std::size_t n = 0; n < frames.size(); ++n) {
    std::optional<GaussianCodebook::Densities> densities;
    for (const auto& [column, unit, weights] : wanted) {
      if (n < unit.first_frame || n >= unit.end_frame) continue;
      if (!densities) densities = codebook.at(frames[n]);
      auto& score = scores.of(column)[n - unit.first_frame];
      for (std::size_t state = 0; state < score.size(); ++state) {
        score.at(state) =
            log_mixture(*densities, std::span{weights}.subspan(state * kMixture, kMixture));
      }
    }
  }
}

}  // namespace

Phone modelled(Phone phone) {
  if (phone == Phone::AX) return Phone::AH;
  if (phone == Phone::WH) return Phone::W;
  return phone;
}

UnitScores::UnitScores(std::size_t frames, std::span<const PhoneUnit> units) : frames_{frames} {
  for (const auto& unit : units) {
    const auto end = std::min(unit.end_frame, frames);
    const auto first = std::min(unit.first_frame, end);
    columns_.push_back({.first = first, .scores = std::vector<States>(end - first)});
  }
}

void UnitScores::complete_from(UnitScores others) {
  for (std::size_t unit = 0; unit < columns_.size(); ++unit) {
    if (!has(unit)) columns_[unit] = std::move(others.columns_[unit]);
  }
}

std::filesystem::path AcousticModel::installed() {
  const char* const chosen = std::getenv("BIMODAL_ACOUSTICS");
  const std::filesystem::path folder{chosen != nullptr ? std::string_view{chosen} : kInstalled};
  if (std::error_code ignored; !std::filesystem::exists(folder / "mdef", ignored)) {
    throw Error{fmt::format("looking for the acoustic model of English: there is no file '{}'; {}",
                            (folder / "mdef").string(),
                            chosen != nullptr
                                ? "correct the environment variable BIMODAL_ACOUSTICS, or unset it"
                                : "install the Debian package pocketsphinx-en-us, or set"
                                  " BIMODAL_ACOUSTICS to the folder of such a model")};
  }
  return folder;
}

AcousticModel::AcousticModel(const std::filesystem::path& folder)
    : definition_{read_definition(folder / "mdef")} {
  const auto means = read_gaussians(folder / "means");
  const auto variances = read_gaussians(folder / "variances");
  const auto mixtures = read_mixtures(folder / "sendump");
  const auto transitions = read_transitions(folder / "transition_matrices");
  refuse_other_shapes(folder, definition_, means, variances, mixtures, transitions);
  for (const Phone phone : all_phones()) {
    const auto at = static_cast<std::size_t>(phone);
    const auto index = index_in(definition_, modelled(phone), folder);
    index_.at(at) = index;
    transitions_.at(at) = transitions_of(transitions, index);
    if (modelled(phone) == phone) codebooks_.at(at) = {means, variances, index};
  }
  codes_.resize(mixtures.codes.size());
  for (std::size_t row = 0; row < kMixture; ++row) {
    for (std::size_t senone = 0; senone < mixtures.senones; ++senone) {
      codes_[senone * kMixture + row] = mixtures.codes[row * mixtures.senones + senone];
    }
  }
  for (std::size_t code = 0; code < weights_.size(); ++code) {
    weights_.at(code) = static_cast<float>(weight_of_code(static_cast<std::uint8_t>(code)));
  }
}

PhoneUnit AcousticModel::unit(Phone phone) const {
  return {.phone = modelled(phone),
          .senones = senones_of(definition_, index_.at(static_cast<std::size_t>(phone)))};
}

PhoneUnit AcousticModel::unit(Phone phone, Phone left, Phone right, PlaceInWord place) const {
  auto made = unit(phone);
  if (phone == Phone::Rest) return made;
  const auto index = [&](Phone one) { return index_.at(static_cast<std::size_t>(one)); };
  auto found = triphone(
      definition_, static_cast<std::size_t>(place), index(phone), index(left), index(right));
  for (std::size_t other = 0; !found && other < kPlacesInWord; ++other) {
    found = triphone(definition_, other, index(phone), index(left), index(right));
  }
  if (found) made.senones = senones_of(definition_, *found);
  return made;
}

std::vector<float> AcousticModel::weights(const PhoneUnit& unit) const {
  std::vector<float> made;
  made.reserve(kStates * kMixture);
  for (const auto senone : unit.senones) {
    for (const auto code : std::span{codes_}.subspan(senone * kMixture, kMixture)) {
      made.push_back(weights_.at(code));
    }
  }
  return made;
}

UnitScores AcousticModel::score(std::span<const Cepstra> frames,
                                std::span<const PhoneUnit> units) const {
  UnitScores scores{frames.size(), units};
  for (const Phone phone : all_phones()) {
    std::vector<WeightedUnit> wanted;
    for (std::size_t i = 0; i < units.size(); ++i) {
      if (units[i].phone == phone) wanted.push_back({i, units[i], weights(units[i])});
    }
    if (!wanted.empty()) {
      score_phone(codebooks_.at(static_cast<std::size_t>(phone)), frames, wanted, scores);
    }
  }
  return scores;
}

const Transitions& AcousticModel::transitions(Phone phone) const {
  return transitions_.at(static_cast<std::size_t>(phone));
}

}  // namespace bimodal
