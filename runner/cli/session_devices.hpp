#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "protocols/model/protocol.hpp"
#include "runner/booth/booth.hpp"
#include "runner/devices/monotonic_clock.hpp"
#include "runner/devices/patched_display.hpp"
#include "runner/devices/right_of_way.hpp"
#include "runner/devices/sdl/sdl_window.hpp"
#include "runner/devices/triggers/trigger_sender.hpp"
#include "runner/store/records.hpp"
#include "runner/timing/start_up_gate.hpp"
#include "stimuli/corpus/corpus.hpp"

namespace bimodal::runner {

/// Which devices a session is to use.
struct DeviceChoice {
  std::string display = "window";  ///< or "headless"
  std::string audio = "default";   ///< or a device, or "none"
  bool simulated_answers = false;
  bool windowed = false;    ///< whatever the protocol says
  std::string calibration;  ///< its name; empty: none
};

/// The devices of a session, and what its timing rests on. Members are in the order in which they
/// must be closed.
struct SessionDevices {
  MonotonicClock clock;
  std::optional<RightOfWay> right_of_way;  ///< absent: nothing is shown
  std::unique_ptr<SdlWindow> window;
  std::unique_ptr<Display> screen;
  std::unique_ptr<Display> display;  ///< the screen, with a patch if one is asked for
  std::unique_ptr<Keyboard> keyboard;
  std::unique_ptr<AudioOutput> audio;
  std::vector<std::unique_ptr<TriggerSender>> trigger_lines;
  Gate gate;
  TimingRecord timing;
  OnsetReference reference;
};

/// Opens them and measures the screen, on which the protocol's first page is meanwhile. Throws
/// DeviceError, and Error for a calibration that is missing or of other devices.
[[nodiscard]] std::unique_ptr<SessionDevices> open_session_devices(
    const protocols::Protocol& protocol, const DeviceChoice& choice);

/// Lets visual onsets refer to the line of the screen that the protocol names, and notes that with
/// the timing. A calibration by instruments goes before it: it holds where the sensor was.
void settle_visual_line(SessionDevices& devices,
                        const protocols::Protocol& protocol,
                        const std::map<std::string, Corpus>& corpora);

/// As the loop borrows them.
[[nodiscard]] Booth booth_of(SessionDevices& devices);

/// Tells the verdict on the screen. Where it is not for timing, `strict` refuses (throws
/// DeviceError); else, if `ask`, the screen asks whether to go on, and false means no. One that
/// shows nothing is not judged.
[[nodiscard]] bool may_go_on(SessionDevices& devices, bool strict, bool ask);

}  // namespace bimodal::runner
