#include "stimuli/alignment/model_file.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "stimuli/alignment/acoustic_model.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/random.hpp"

namespace bimodal {
namespace {

using ::testing::HasSubstr;

class ModelFile : public ::testing::Test {
 public:
  ModelFile()
      : folder_{std::filesystem::path{testing::TempDir()} /
                ("bimodal_model_file_" + std::to_string(::getpid()))} {
    std::filesystem::create_directories(folder_);
  }

  ModelFile(const ModelFile&) = delete;
  ModelFile& operator=(const ModelFile&) = delete;
  ModelFile(ModelFile&&) = delete;
  ModelFile& operator=(ModelFile&&) = delete;

  ~ModelFile() override { std::filesystem::remove_all(folder_); }

 protected:
  [[nodiscard]] std::filesystem::path holding(const std::string& content) const {
    std::ofstream{folder_ / "file", std::ios::binary} << content;
    return folder_ / "file";
  }

  [[nodiscard]] static std::filesystem::path installed(const char* name) {
    return AcousticModel::installed() / name;
  }

 private:
  std::filesystem::path folder_;
};

template <typename T>
std::string bytes(std::initializer_list<T> values) {
  std::string made;
  for (const T value : values) {
    made.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  return made;
}

const std::string kHeader = "s3\nversion 1.0\nendhdr\n" + bytes<std::int32_t>({0x11223344});

TEST_F(ModelFile, ReadsGaussiansByteByByte) {
  const auto read = read_gaussians(holding(kHeader + bytes<std::int32_t>({1, 2, 1, 2, 2, 4}) +
                                           bytes<float>({1.0F, 2.0F, 3.0F, 4.0F})));
  EXPECT_EQ(read.codebooks, 1U);
  EXPECT_EQ(read.streams, 2U);
  EXPECT_EQ(read.densities, 1U);
  EXPECT_EQ(read.dimensions, 2U);
  EXPECT_EQ(read.values, (std::vector{1.0F, 2.0F, 3.0F, 4.0F}));
}

TEST_F(ModelFile, ReadsTheInstalledModel) {
  const auto definition = read_definition(installed("mdef"));
  EXPECT_EQ(definition.names.size(), 42U);
  EXPECT_EQ(definition.names.at(2), "AA");
  // The format promises that phones without context have the first senones, in their order.
  for (std::size_t phone = 0; phone < definition.names.size(); ++phone) {
    for (std::size_t state = 0; state < definition.states; ++state) {
      const auto at = definition.sequence_of_phone.at(phone) * definition.states + state;
      EXPECT_EQ(definition.sequences.at(at), phone * definition.states + state);
    }
  }
  const auto mixtures = read_mixtures(installed("sendump"));
  for (std::size_t senone = 0; senone < mixtures.senones; senone += 97) {
    for (std::size_t stream = 0; stream < mixtures.streams; ++stream) {
      double sum = 0.0;
      for (std::size_t k = 0; k < mixtures.densities; ++k) {
        sum += weight_of_code(
            mixtures.codes.at((stream * mixtures.densities + k) * mixtures.senones + senone));
      }
      EXPECT_NEAR(sum, 0.95, 0.05);  // codes are rounded up, by 5 % of the weight on average
    }
  }
}

TEST_F(ModelFile, KnowsTriphonesByPlaceAndNeighbours) {
  const auto definition = read_definition(installed("mdef"));
  const auto phone = [&](const char* name) {
    return static_cast<std::size_t>(std::ranges::find(definition.names, name) -
                                    definition.names.begin());
  };
  const auto found = triphone(definition, 0, phone("AE"), phone("K"), phone("T"));
  ASSERT_TRUE(found);
  EXPECT_GE(*found, definition.names.size());
  EXPECT_NE(found, triphone(definition, 0, phone("AE"), phone("B"), phone("T")));
  EXPECT_FALSE(triphone(definition, 7, phone("AE"), phone("K"), phone("T")));
}

TEST_F(ModelFile, RefusesWhatIsNoModel) {
  const auto fault = [](const std::function<void()>& deed) -> std::string {
    try {
      deed();
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(fault([&] { (void)read_gaussians(holding("nothing")); }), HasSubstr("another kind"));
  EXPECT_THAT(fault([&] { (void)read_gaussians(holding(kHeader)); }), HasSubstr("too early"));
  EXPECT_THAT(fault([&] {
                (void)read_gaussians(holding(kHeader + bytes<std::int32_t>({1, 1, 1, 1, 9})));
              }),
              HasSubstr("not the product"));
  EXPECT_THAT(fault([&] { (void)read_mixtures(holding("x")); }), HasSubstr("too early"));
  EXPECT_THAT(fault([&] { (void)read_definition(holding("not a model")); }),
              HasSubstr("another kind"));
}

TEST_F(ModelFile, SurvivesDamagedFiles) {
  const auto honest = read_file(installed("mdef")).substr(0, 20'000);
  const auto table =
      kHeader + bytes<std::int32_t>({1, 2, 1, 2, 2, 4}) + bytes<float>({1.0F, 2.0F, 3.0F, 4.0F});
  Random random{21};
  const auto damaged = [&](std::string content, std::size_t where) {
    for (int k = 0; k < 3; ++k)
      content.at(random.below(where)) = static_cast<char>(random.below(256));
    return content;
  };
  for (int i = 0; i < 300; ++i) {
    try {
      (void)read_definition(holding(damaged(honest, 2000)));
    } catch (const Error&) {
    }
    try {
      (void)read_gaussians(holding(damaged(table, table.size())));
      (void)read_transitions(holding(damaged(table, table.size())));
    } catch (const Error&) {
    }
  }
}

}  // namespace
}  // namespace bimodal
