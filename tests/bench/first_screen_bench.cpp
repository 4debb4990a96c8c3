// From the start of `run` to the first page of instructions on the screen: reading the protocol
// with its word list, opening the window, setting and drawing the text. (The display's refresh is
// measured while that page stands there; the first trials are prepared meanwhile.)

#include <benchmark/benchmark.h>

#include "protocols/reading/read_protocol.hpp"
#include "runner/booth/participant_screens.hpp"
#include "runner/devices/device_error.hpp"
#include "runner/devices/sdl/screen_painter.hpp"
#include "runner/devices/sdl/sdl_window.hpp"
#include "stimuli/base/asset.hpp"

namespace bimodal::runner {
namespace {

void first_instruction_screen(benchmark::State& state) {
  for (auto _ : state) {
    const auto read = protocols::read_protocol(asset("protocols/library/words414.json"),
                                               {.cast = {.without = {"V_nat"}}});
    try {
      SdlWindow window{{}};
      ScreenPainter painter{window.background()};
      painter.draw(page_screen(read.protocol.instructions.at(0)), window.size());
      window.swap();
      state.SetLabel(SdlWindow::driver());
      state.PauseTiming();
    } catch (const DeviceError& error) {
      state.SkipWithError(error.what());
      return;
    }
    state.ResumeTiming();
  }
}

BENCHMARK(first_instruction_screen)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace bimodal::runner
