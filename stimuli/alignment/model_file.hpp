#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace bimodal {

/// Means or variances of Gaussian densities, as a Sphinx model keeps them.
struct GaussianTable {
  std::size_t codebooks = 0;  ///< sets of densities: one for each phone
  std::size_t streams = 0;    ///< parts of the feature vector, scored apart
  std::size_t densities = 0;  ///< in a codebook and stream
  std::size_t dimensions = 0;
  std::vector<float> values;  ///< [codebook][stream][density][dimension]
};

/// Weights of the densities in the mixture of each senone (a state of a phone).
struct MixtureTable {
  std::size_t streams = 0;
  std::size_t densities = 0;
  std::size_t senones = 0;
  std::vector<std::uint8_t> codes;  ///< [stream][density][senone]; see weight_of_code()
};

/// Transition counts from each state of a phone's model to each state and to its end.
struct TransitionTable {
  std::size_t models = 0;
  std::size_t states = 0;
  std::vector<float> values;  ///< [model][state][state, then end]
};

/// exp(-0.1024 code): codes are logarithms to the base 1.0001, divided by -1024.
[[nodiscard]] double weight_of_code(std::uint8_t code);

/// The files of a model of Sphinx-3 and PocketSphinx, little-endian. All throw Error, naming the
/// file and what is wrong with it.
[[nodiscard]] GaussianTable read_gaussians(const std::filesystem::path& file);
[[nodiscard]] MixtureTable read_mixtures(const std::filesystem::path& file);
[[nodiscard]] TransitionTable read_transitions(const std::filesystem::path& file);

/// The names of the phones of a model definition, in the order of its codebooks. Their senones
/// without context are the first of the model, three to a phone in the same order.
[[nodiscard]] std::vector<std::string> read_phone_names(const std::filesystem::path& file);

}  // namespace bimodal
