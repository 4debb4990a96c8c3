#include "runner/monitor/request_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "stimuli/base/utf8.hpp"
#include "tests/support/damage.hpp"

namespace bimodal::runner {
namespace {

using ::testing::HasSubstr;
using ::testing::VariantWith;

TEST(RequestLine, IsReadAsItIsWritten) {
  for (const auto request : {Request::Pause, Request::Resume, Request::Stop}) {
    EXPECT_THAT(read_request(request_line(request)), VariantWith<Request>(request));
  }
}

TEST(RequestLine, ThatAsksForNothingWeKnowIsToldWhatThereIs) {
  for (const auto* const line :
       {"pause", "[]", "{}", R"({"ask":1})", R"({"ask":"explode"})", "null", "{", "\xff"}) {
    const auto read = read_request(line);
    ASSERT_TRUE(std::holds_alternative<LineFault>(read)) << line;
    const auto answer = nlohmann::json::parse(error_line(std::get<LineFault>(read)));
    EXPECT_EQ(answer.at("kind"), "error");
  }
  EXPECT_THAT(std::get<LineFault>(read_request(R"({"ask":"explode"})")).finding,
              HasSubstr(R"({"ask":"pause"})"));
}

TEST(RequestLine, MayBeAnyBytes) {
  int faults = 0;
  for (std::uint32_t seed = 0; seed < 3'000; ++seed) {
    const auto read = read_request(Damage{seed}(R"({"ask":"resume","more":[1,2,{"a":"\u00e9"}]})"));
    if (const auto* const fault = std::get_if<LineFault>(&read)) {
      ++faults;
      const auto answer = error_line(*fault);
      EXPECT_TRUE(is_utf8(answer));
      EXPECT_EQ(answer.find('\n'), std::string::npos);
    }
  }
  EXPECT_GT(faults, 1'000);
}

}  // namespace
}  // namespace bimodal::runner
