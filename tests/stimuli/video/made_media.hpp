#pragma once

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "stimuli/base/error.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal::made_media {

inline double seconds(Duration time) {
  return std::chrono::duration<double>{time}.count();
}

inline Duration from_seconds(double time) {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>{time});
}

inline std::string message_of(const std::function<void()>& deed) {
  try {
    deed();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

/// What a shell command prints.
inline std::string printed(const std::string& command) {
  const auto close = [](std::FILE* pipe) { pclose(pipe); };
  const std::unique_ptr<std::FILE, decltype(close)> pipe{popen(command.c_str(), "r"), close};
  std::string text;
  std::array<char, 4096> block{};
  std::size_t got = 0;
  while (pipe && (got = std::fread(block.data(), 1, block.size(), pipe.get())) > 0) {
    text.append(block.data(), got);
  }
  return text;
}

inline bool have(const std::string& program) {
  return std::system(("command -v " + program + " > /dev/null 2>&1").c_str()) == 0;
}

/// A folder of one test's own for media that the ffmpeg program makes; gone afterwards.
class MadeMedia : public ::testing::Test {
 public:
  MadeMedia()
      : folder_{std::filesystem::path{::testing::TempDir()} /
                ("bimodal_media_" + std::to_string(::getpid()))} {
    std::filesystem::create_directories(folder_);
  }

  MadeMedia(const MadeMedia&) = delete;
  MadeMedia& operator=(const MadeMedia&) = delete;
  MadeMedia(MadeMedia&&) = delete;
  MadeMedia& operator=(MadeMedia&&) = delete;

  ~MadeMedia() override { std::filesystem::remove_all(folder_); }

 protected:
  void SetUp() override {
    if (!have("ffmpeg") || !have("ffprobe")) GTEST_SKIP() << "the programs of FFmpeg are absent";
  }

  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  [[nodiscard]] std::filesystem::path holding(const std::string& name,
                                              const std::string& content) const {
    std::ofstream{path(name), std::ios::binary} << content;
    return path(name);
  }

  /// `arguments` of ffmpeg without the file to be written.
  [[nodiscard]] std::filesystem::path made(const std::string& name,
                                           const std::string& arguments) const {
    const auto file = path(name);
    const auto command =
        "ffmpeg -nostdin -v error -y " + arguments + " '" + file.string() + "' 2>&1 < /dev/null";
    const auto complaint = printed(command);
    EXPECT_TRUE(std::filesystem::exists(file)) << command << '\n' << complaint;
    return file;
  }

 private:
  std::filesystem::path folder_;
};

/// A source of ffmpeg, 160 x 64 pixels, in which frame N shows the bits of N as ten bars, the
/// lowest at the left.
inline std::string numbered_frames(const std::string& rate, const std::string& seconds) {
  return "-f lavfi -i \"nullsrc=s=160x64:r=" + rate + ":d=" + seconds +
         ",geq=lum='if(mod(floor(N/pow(2,floor(X/16))),2),235,16)':cb=128:cr=128,format=yuv420p\"";
}

/// A sound of silence with one sample of full scale, 1 s from its beginning.
inline std::string click(const std::string& rate, const std::string& seconds) {
  return "-f lavfi -i \"aevalsrc='if(eq(n," + rate + "),0.9,0)':s=" + rate + ":d=" + seconds + "\"";
}

}  // namespace bimodal::made_media
