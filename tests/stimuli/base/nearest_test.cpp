#include "stimuli/base/nearest.hpp"

#include <array>

#include <gtest/gtest.h>

namespace bimodal {
namespace {

constexpr std::array<std::string_view, 5> kKeys{
    "snr_db", "auditory", "visual", "name", "speech_level_dbfs"};

TEST(EditDistance, CountsInsertionsDeletionsReplacementsAndExchanges) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);  // the textbook's
  EXPECT_EQ(edit_distance("snr_bd", "snr_db"), 1U);
  EXPECT_EQ(edit_distance("ca", "abc"), 3U);  // optimal string alignment, not Damerau's 2
}

TEST(EditDistance, IsSymmetric) {
  EXPECT_EQ(edit_distance("visual", "casual"), edit_distance("casual", "visual"));
  EXPECT_EQ(edit_distance("snr", "snr_db"), edit_distance("snr_db", "snr"));
}

TEST(Nearest, FindsWhatWasMeant) {
  EXPECT_EQ(nearest("snrdb", kKeys), "snr_db");
  EXPECT_EQ(nearest("snr", kKeys), "snr_db");
  EXPECT_EQ(nearest("SNR_dB", kKeys), "snr_db");
  EXPECT_EQ(nearest("auditroy", kKeys), "auditory");
  EXPECT_EQ(nearest("nmae", kKeys), "name");
  EXPECT_EQ(nearest("speech_level_dbfs_", kKeys), "speech_level_dbfs");
}

TEST(Nearest, SaysNothingWhereNothingIsNear) {
  EXPECT_EQ(nearest("colour", kKeys), std::nullopt);
  EXPECT_EQ(nearest("", kKeys), std::nullopt);
  EXPECT_EQ(nearest("name", {}), std::nullopt);
  EXPECT_EQ(nearest(std::string(1'000'000, 'n'), kKeys), std::nullopt);
}

}  // namespace
}  // namespace bimodal
