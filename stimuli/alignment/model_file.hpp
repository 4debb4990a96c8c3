#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
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

/// A node of the tree in which triphones are looked up: word position, phone, left, right.
struct TriphoneNode {
  std::int16_t key = 0;
  std::int16_t branches = 0;  ///< none: a triphone
  std::int32_t next = 0;      ///< its first branch, or the triphone
};

/// Which senones make up each phone in each context.
struct ModelDefinition {
  std::vector<std::string> names;  ///< of the phones, in the order of their codebooks
  std::size_t states = 0;          ///< of a phone's model
  std::vector<TriphoneNode> tree;
  std::vector<std::size_t> sequence_of_phone;  ///< of the phones, then of all triphones
  std::vector<std::uint16_t> sequences;        ///< [sequence][state]: senones
};

[[nodiscard]] ModelDefinition read_definition(const std::filesystem::path& file);

/// Which of all phones and triphones is `phone` between `left` and `right` at `place` of its word
/// (0 inside, 1 first, 2 last, 3 alone); absent if the model does not know it.
[[nodiscard]] std::optional<std::size_t> triphone(const ModelDefinition& definition,
                                                  std::size_t place,
                                                  std::size_t phone,
                                                  std::size_t left,
                                                  std::size_t right);

}  // namespace bimodal
