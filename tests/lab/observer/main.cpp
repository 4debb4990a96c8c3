/// Watches a screen and a sound card from outside and writes down what happened there, as one JSON
/// object a line: {"kind": "refresh", "at_ns", "levels"}, {"kind": "sound", "channel", "at_ns",
/// "first"}, {"kind": "xrun", "at_ns"}; instants are CLOCK_MONOTONIC. Runs until its standard input
/// ends. It shares no code with the presenter.
///
///   observer FILE X Y WIDTH HEIGHT COLUMNS CHANNELS
///
/// The region is watched in so many columns; the first column's brightness is played as that of a
/// photodiode. So many channels of the sound are listened to.
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <sys/select.h>
#include <unistd.h>

#include "screen_watch.hpp"
#include "sound_watch.hpp"

namespace {

void write(const std::string& file,
           const std::vector<lab::SeenRefresh>& refreshes,
           const lab::SoundWatch& sound) {
  auto* const out = std::fopen(file.c_str(), "w");
  if (out == nullptr) throw std::runtime_error{"cannot write " + file};
  for (const auto& refresh : refreshes) {
    std::fprintf(out,
                 "{\"kind\": \"refresh\", \"at_ns\": %ld, \"levels\": [%u, %u, %u, %u]}\n",
                 refresh.at_ns,
                 refresh.levels & 255U,
                 (refresh.levels >> 8U) & 255U,
                 (refresh.levels >> 16U) & 255U,
                 refresh.levels >> 24U);
  }
  for (const auto& heard : sound.sounds()) {
    std::fprintf(out,
                 "{\"kind\": \"sound\", \"channel\": %d, \"at_ns\": %ld, \"first\": %.9g}\n",
                 heard.channel,
                 heard.at_ns,
                 static_cast<double>(heard.first));
  }
  for (const auto& trouble : sound.troubles()) {
    std::fprintf(out, "{\"kind\": \"xrun\", \"at_ns\": %ld}\n", trouble.at_ns);
  }
  if (std::fclose(out) != 0) throw std::runtime_error{"cannot write " + file};
}

int observe(const std::vector<std::string>& arguments) {
  const auto number = [&](std::size_t index) { return std::stoi(arguments.at(index)); };
  const lab::Region region{number(1), number(2), number(3), number(4)};
  lab::ScreenWatch screen{region, number(5)};
  lab::SoundWatch sound{{.channels = number(6)}};
  std::vector<lab::SeenRefresh> refreshes;
  refreshes.reserve(1U << 20U);
  std::atomic<bool> stopped{false};
  std::thread until_input_ends{[&] {
    char byte = 0;
    for (;;) {
      sound.connect("PortAudio");
      // Standard input is polled between connections; its end is the end.
      fd_set readable;
      FD_ZERO(&readable);
      FD_SET(STDIN_FILENO, &readable);
      timeval patience{0, 50'000};
      if (select(STDIN_FILENO + 1, &readable, nullptr, nullptr, &patience) > 0 &&
          read(STDIN_FILENO, &byte, 1) <= 0) {
        stopped = true;
        return;
      }
    }
  }};
  std::puts("watching");
  std::fflush(stdout);
  screen.run([&] { return stopped.load(); },
             [&](const lab::SeenRefresh& seen) {
               sound.show(seen.at_ns, static_cast<float>(seen.levels & 255U) / 255.0F);
               if (refreshes.size() < refreshes.capacity()) refreshes.push_back(seen);
             });
  until_input_ends.join();
  write(arguments.at(0), refreshes, sound);
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> given(arguments + 1, arguments + count);
  if (given.size() != 7) {
    std::fputs("usage: observer FILE X Y WIDTH HEIGHT COLUMNS CHANNELS\n", stderr);
    return 2;
  }
  try {
    return observe(given);
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "observer: %s\n", failure.what());
    return 4;
  }
}
