#include "stimuli/alignment/model_file.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal {

namespace {

static_assert(std::endian::native == std::endian::little, "the files are read as they are");

constexpr std::int32_t kByteOrder = 0x11223344;
constexpr std::int32_t kDefinition = 0x46444d42;  // "BMDF"
constexpr std::size_t kMost = 10'000'000;         ///< of anything that a header counts

/// A file, read from its beginning to its end.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& file)
      : name_{file.string()}, content_{read_file(file)} {}

  [[noreturn]] void fail(std::string_view finding) const {
    throw Error{
        fmt::format("reading the acoustic model '{}': {}; reinstall the Debian package "
                    "pocketsphinx-en-us, or correct BIMODAL_ACOUSTICS",
                    name_,
                    finding)};
  }

  [[nodiscard]] std::size_t left() const { return content_.size() - at_; }

  std::string_view take(std::size_t bytes) {
    if (bytes > left()) fail("it ends too early");
    at_ += bytes;
    return std::string_view{content_}.substr(at_ - bytes, bytes);
  }

  std::int32_t number() {
    std::int32_t value = 0;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }

  std::int16_t short_number() {
    std::int16_t value = 0;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }

  std::size_t count() {
    const auto value = number();
    if (value < 1 || static_cast<std::size_t>(value) > kMost) {
      fail(fmt::format("it counts {} of something", value));
    }
    return static_cast<std::size_t>(value);
  }

  std::vector<float> floats(std::size_t number) {
    if (number > left() / sizeof(float)) fail("it ends too early");
    std::vector<float> values(number);
    const auto bytes = take(number * sizeof(float));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    if (!std::ranges::all_of(values, [](float value) { return std::isfinite(value); })) {
      fail("it holds what is no number");
    }
    return values;
  }

  /// Floats that are preceded by their number, which the dimensions demand too.
  std::vector<float> counted_floats(std::size_t demanded) {
    const auto total = count();
    if (total != demanded) {
      fail(
          fmt::format("it says that it holds {} numbers, which is not the product of its "
                      "dimensions",
                      total));
    }
    return floats(total);
  }

  /// Up to and with `end`.
  void skip_past(std::string_view end) {
    const auto found = content_.find(end, at_);
    if (found == std::string::npos) fail("it is of another kind");
    at_ = found + end.size();
  }

  /// The text before the next zero byte.
  std::string_view text() {
    const auto taken = take(std::min(content_.find('\0', at_), content_.size()) - at_);
    (void)take(1);
    return taken;
  }

  /// On to a multiple of 4 bytes from the beginning.
  void align() { (void)take((4 - at_ % 4) % 4); }

  void expect(std::int32_t value) {
    if (number() != value) fail("it is of another kind or byte order");
  }

 private:
  std::string name_;
  std::string content_;
  std::size_t at_ = 0;
};

Reader parameters(const std::filesystem::path& file) {
  Reader reader{file};
  reader.skip_past("endhdr\n");
  reader.expect(kByteOrder);
  return reader;
}

}  // namespace

double weight_of_code(std::uint8_t code) {
  return std::exp(-std::log(1.0001) * 1024.0 * code);
}

GaussianTable read_gaussians(const std::filesystem::path& file) {
  auto reader = parameters(file);
  GaussianTable read;
  read.codebooks = reader.count();
  read.streams = reader.count();
  read.densities = reader.count();
  read.dimensions = reader.count();
  for (std::size_t i = 1; i < read.streams; ++i) {
    if (reader.count() != read.dimensions) reader.fail("its streams are of different length");
  }
  read.values =
      reader.counted_floats(read.codebooks * read.streams * read.densities * read.dimensions);
  return read;
}

MixtureTable read_mixtures(const std::filesystem::path& file) {
  Reader reader{file};
  MixtureTable read;
  std::size_t clusters = 0;
  for (auto length = reader.number(); length > 0; length = reader.number()) {
    const auto line = reader.take(static_cast<std::size_t>(length));
    constexpr std::string_view kStreams = "feature_count ";
    constexpr std::string_view kClusters = "cluster_count ";
    const auto value = [&](std::string_view key) {
      std::size_t number = 0;
      std::from_chars(line.data() + key.size(), line.data() + line.size(), number);
      return std::min(number, kMost);
    };
    if (line.starts_with(kStreams)) read.streams = value(kStreams);
    if (line.starts_with(kClusters)) clusters = value(kClusters);
  }
  if (clusters != 0) reader.fail("its weights are clustered, which is not supported");
  read.densities = reader.count();
  read.senones = reader.count();
  const auto bytes = reader.take(read.streams * read.densities * read.senones);
  read.codes.assign(bytes.begin(), bytes.end());
  return read;
}

TransitionTable read_transitions(const std::filesystem::path& file) {
  auto reader = parameters(file);
  TransitionTable read;
  read.models = reader.count();
  read.states = reader.count();
  if (reader.count() != read.states + 1) reader.fail("its models do not end in one state");
  read.values = reader.counted_floats(read.models * read.states * (read.states + 1));
  return read;
}

ModelDefinition read_definition(const std::filesystem::path& file) {
  Reader reader{file};
  reader.expect(kDefinition);
  (void)reader.number();              // version
  (void)reader.take(reader.count());  // what the format is, in words
  ModelDefinition read;
  const auto names = reader.count();
  const auto phones = reader.count();
  read.states = reader.count();
  (void)reader.count();  // senones without context
  const auto senones = reader.count();
  (void)reader.count();  // transition matrices
  const auto sequences = reader.count();
  (void)reader.count();  // phones of context
  const auto nodes = reader.count();
  (void)reader.number();  // which phone is silence
  for (std::size_t i = 0; i < names; ++i) read.names.emplace_back(reader.text());
  reader.align();
  for (std::size_t i = 0; i < nodes; ++i) {
    const auto key = reader.short_number();
    const auto branches = reader.short_number();
    read.tree.push_back({key, branches, reader.number()});
    const auto& node = read.tree.back();
    const auto end = std::int64_t{node.next} + std::max<std::int64_t>(node.branches, 1);
    const bool leaf = node.branches == 0;
    if (node.branches < 0 || node.next < (leaf ? -1 : 0) ||
        end > static_cast<std::int64_t>(leaf ? phones : nodes)) {
      reader.fail(fmt::format("node {} of its tree leads nowhere", i));
    }
  }
  for (std::size_t i = 0; i < phones; ++i) {
    const auto sequence = static_cast<std::size_t>(reader.number());
    if (sequence >= sequences) reader.fail(fmt::format("phone {} has no senones", i));
    read.sequence_of_phone.push_back(sequence);
    (void)reader.take(2 * sizeof(std::int32_t));  // transition matrix and attributes
  }
  if (reader.count() != sequences * read.states) reader.fail("its senones are not complete");
  for (std::size_t i = 0; i < sequences * read.states; ++i) {
    const auto senone = static_cast<std::uint16_t>(reader.short_number());
    if (senone >= senones) reader.fail(fmt::format("there is no senone {}", senone));
    read.sequences.push_back(senone);
  }
  return read;
}

std::optional<std::size_t> triphone(const ModelDefinition& definition,
                                    std::size_t place,
                                    std::size_t phone,
                                    std::size_t left,
                                    std::size_t right) {
  constexpr std::size_t kPlaces = 4;
  auto branches = std::span{definition.tree}.first(std::min(kPlaces, definition.tree.size()));
  for (const std::size_t key : {place, phone, left, right}) {
    const auto found =
        std::ranges::find(branches, static_cast<std::int16_t>(key), &TriphoneNode::key);
    if (found == branches.end()) return std::nullopt;
    if (found->branches == 0) {
      return found->next < 0 ? std::nullopt : std::optional{static_cast<std::size_t>(found->next)};
    }
    branches = std::span{definition.tree}.subspan(static_cast<std::size_t>(found->next),
                                                  static_cast<std::size_t>(found->branches));
  }
  return std::nullopt;
}

}  // namespace bimodal
