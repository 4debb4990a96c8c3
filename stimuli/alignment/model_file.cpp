#include "stimuli/alignment/model_file.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string_view>

#include <fmt/format.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal {

namespace {

static_assert(std::endian::native == std::endian::little, "the files are read as they are");

constexpr std::int32_t kByteOrder = 0x11223344;
constexpr std::int32_t kDefinition = 0x46444d42;  // "BMDF"
constexpr std::size_t kMost = 10'000'000;           ///< of anything that a header counts

/// A file, read from its beginning to its end.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& file)
      : name_{file.string()}, content_{read_file(file)}, rest_{content_} {}

  [[noreturn]] void fail(std::string_view finding) const {
    throw Error{fmt::format("reading the acoustic model '{}': {}; reinstall the Debian package "
                            "pocketsphinx-en-us, or correct BIMODAL_ACOUSTICS",
                            name_,
                            finding)};
  }

  std::string_view take(std::size_t bytes) {
    if (bytes > rest_.size()) fail("it ends too early");
    const auto taken = rest_.substr(0, bytes);
    rest_.remove_prefix(bytes);
    return taken;
  }

  std::int32_t number() {
    std::int32_t value = 0;
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
    if (number > rest_.size() / sizeof(float)) fail("it ends too early");
    std::vector<float> values(number);
    const auto bytes = take(number * sizeof(float));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    if (!std::ranges::all_of(values, [](float value) { return std::isfinite(value); })) {
      fail("it holds what is no number");
    }
    return values;
  }

  /// Up to and with `end`.
  void skip_past(std::string_view end) {
    const auto at = rest_.find(end);
    if (at == std::string_view::npos) fail("it is of another kind");
    rest_.remove_prefix(at + end.size());
  }

  /// The text before the next zero byte.
  std::string_view text() {
    const auto taken = take(std::min(rest_.find('\0'), rest_.size()));
    (void)take(1);
    return taken;
  }

  void expect(std::int32_t value) {
    if (number() != value) fail("it is of another kind or byte order");
  }

 private:
  std::string name_;
  std::string content_;
  std::string_view rest_;
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
  const auto total = reader.count();
  if (total != read.codebooks * read.streams * read.densities * read.dimensions) {
    reader.fail(fmt::format("it says that it holds {} numbers, which is not the product of its "
                            "dimensions",
                            total));
  }
  read.values = reader.floats(total);
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
  const auto total = reader.count();
  if (total != read.models * read.states * (read.states + 1)) {
    reader.fail(fmt::format("it says that it holds {} numbers, which is not the product of its "
                            "dimensions",
                            total));
  }
  read.values = reader.floats(total);
  return read;
}

std::vector<std::string> read_phone_names(const std::filesystem::path& file) {
  Reader reader{file};
  reader.expect(kDefinition);
  (void)reader.number();           // version
  (void)reader.take(reader.count());  // what the format is, in words
  const auto phones = reader.count();
  (void)reader.number();  // phones in context
  const auto states = reader.count();
  if (reader.count() != phones * states) reader.fail("phones without context share states");
  constexpr std::size_t kOtherCounts = 6;
  (void)reader.take(kOtherCounts * sizeof(std::int32_t));
  std::vector<std::string> names;
  for (std::size_t i = 0; i < phones; ++i) names.emplace_back(reader.text());
  return names;
}

}  // namespace bimodal
