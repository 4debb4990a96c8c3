#include "stimuli/alignment/acoustic_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

#include "stimuli/alignment/model_file.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal {

namespace {

constexpr std::string_view kInstalled = "/usr/share/pocketsphinx/model/en-us/en-us";
constexpr std::size_t kStreams = 3;
constexpr std::size_t kDensities = 128;
constexpr std::size_t kDimensions = 13;
constexpr float kSmallestVariance = 1e-4F;
/// Densities whose logarithm is that much below the best one's change nothing.
constexpr float kNegligible = 16.0F;
/// Of a mixture, so that its logarithm is finite.
constexpr float kSmallestMixture = 1e-30F;

void refuse_other_shapes(const std::filesystem::path& folder,
                         const GaussianTable& means,
                         const GaussianTable& variances,
                         const MixtureTable& mixtures,
                         const TransitionTable& transitions,
                         std::size_t phones) {
  const auto fits = [&](const GaussianTable& table) {
    return table.codebooks == phones && table.streams == kStreams &&
           table.densities == kDensities && table.dimensions == kDimensions;
  };
  if (fits(means) && fits(variances) && mixtures.streams == kStreams &&
      mixtures.densities == kDensities && mixtures.senones >= phones * kStates &&
      transitions.models >= phones && transitions.states == kStates) {
    return;
  }
  throw Error{fmt::format("loading the acoustic model '{}': it is not phonetically tied with {} "
                          "streams of {} densities of {} dimensions; use that of the Debian "
                          "package pocketsphinx-en-us",
                          folder.string(),
                          kStreams,
                          kDensities,
                          kDimensions)};
}

Transitions transitions_of(const TransitionTable& table, std::size_t model) {
  Transitions made;
  for (std::size_t state = 0; state < kStates; ++state) {
    const auto* const row = &table.values[(model * kStates + state) * (kStates + 1)];
    const auto sum = row[state] + row[state + 1];
    made.stay.at(state) = std::log(row[state] / sum);
    made.leave.at(state) = std::log(row[state + 1] / sum);
  }
  return made;
}

/// Of one stream and frame: the largest log density, and all densities relative to it.
float densities(const float* x,
                const float* means,
                const float* precisions,
                const float* constants,
                std::array<float, kDensities>& density) {
  std::copy_n(constants, kDensities, density.begin());
  for (std::size_t i = 0; i < kDimensions; ++i) {
    const float value = x[i];
    for (std::size_t k = 0; k < kDensities; ++k) {
      const float distance = value - means[i * kDensities + k];
      density[k] -= distance * distance * precisions[i * kDensities + k];
    }
  }
  const float best = *std::ranges::max_element(density);
  for (float& one : density) one = one > best - kNegligible ? std::exp(one - best) : 0.0F;
  return best;
}

}  // namespace

Phone modelled(Phone phone) {
  if (phone == Phone::AX) return Phone::AH;
  if (phone == Phone::WH) return Phone::W;
  return phone;
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

AcousticModel::AcousticModel(const std::filesystem::path& folder) {
  const auto names = read_phone_names(folder / "mdef");
  const auto means = read_gaussians(folder / "means");
  const auto variances = read_gaussians(folder / "variances");
  const auto mixtures = read_mixtures(folder / "sendump");
  const auto transitions = read_transitions(folder / "transition_matrices");
  refuse_other_shapes(folder, means, variances, mixtures, transitions, names.size());
  for (std::size_t index = 0; index < names.size(); ++index) {
    const auto phone = phone_from_symbol(names[index]);
    if (!phone) continue;  // noises
    Codebook book{.phone = *phone};
    constexpr std::size_t kSize = kStreams * kDensities * kDimensions;
    book.means.resize(kSize);
    book.precisions.resize(kSize);
    book.constants.resize(kStreams * kDensities);
    book.weights.resize(kStreams * kStates * kDensities);
    for (std::size_t stream = 0; stream < kStreams; ++stream) {
      for (std::size_t k = 0; k < kDensities; ++k) {
        const std::size_t row = (index * kStreams + stream) * kDensities + k;
        double constant = 0.0;
        for (std::size_t i = 0; i < kDimensions; ++i) {
          const float variance = std::max(variances.values[row * kDimensions + i], kSmallestVariance);
          const std::size_t to = (stream * kDimensions + i) * kDensities + k;
          book.means[to] = means.values[row * kDimensions + i];
          book.precisions[to] = 0.5F / variance;
          constant -= 0.5 * std::log(2.0 * std::numbers::pi * static_cast<double>(variance));
        }
        book.constants[stream * kDensities + k] = static_cast<float>(constant);
        for (std::size_t state = 0; state < kStates; ++state) {
          const auto senone = index * kStates + state;
          book.weights[(stream * kStates + state) * kDensities + k] = static_cast<float>(
              weight_of_code(mixtures.codes[(stream * kDensities + k) * mixtures.senones + senone]));
        }
      }
    }
    codebooks_.push_back(std::move(book));
    transitions_.at(static_cast<std::size_t>(*phone)) = transitions_of(transitions, index);
  }
}

PhoneScores AcousticModel::score(std::span<const Cepstra> frames) const {
  PhoneScores scores{frames.size()};
  std::array<float, kDensities> density{};
  for (const auto& book : codebooks_) {
    for (std::size_t n = 0; n < frames.size(); ++n) {
      auto& score = scores.at(n, book.phone);
      for (std::size_t stream = 0; stream < kStreams; ++stream) {
        const float best = densities(&frames[n].at(stream * kDimensions),
                                     &book.means[stream * kDimensions * kDensities],
                                     &book.precisions[stream * kDimensions * kDensities],
                                     &book.constants[stream * kDensities],
                                     density);
        for (std::size_t state = 0; state < kStates; ++state) {
          const auto* const weights = &book.weights[(stream * kStates + state) * kDensities];
          float mixture = kSmallestMixture;
          for (std::size_t k = 0; k < kDensities; ++k) mixture += density[k] * weights[k];
          score.at(state) += best + std::log(mixture);
        }
      }
    }
  }
  return scores;
}

const Transitions& AcousticModel::transitions(Phone phone) const {
  return transitions_.at(static_cast<std::size_t>(modelled(phone)));
}

}  // namespace bimodal
