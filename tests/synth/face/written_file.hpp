#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace bimodal::synth {

/// A file that lives as long as the test that wrote it.
class WrittenFile {
 public:
  explicit WrittenFile(std::string_view text)
      : path_{std::filesystem::path{testing::TempDir()} /
              testing::UnitTest::GetInstance()->current_test_info()->name()} {
    std::ofstream{path_} << text;
  }

  ~WrittenFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }

  WrittenFile(const WrittenFile&) = delete;
  WrittenFile& operator=(const WrittenFile&) = delete;
  WrittenFile(WrittenFile&&) = delete;
  WrittenFile& operator=(WrittenFile&&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace bimodal::synth
