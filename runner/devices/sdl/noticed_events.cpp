#include "runner/devices/sdl/noticed_events.hpp"

#include <SDL_syswm.h>

namespace bimodal::runner {
namespace {

/// X keycodes of this machine's keyboards are those of evdev and 8.
constexpr std::uint32_t kFirstKeycode = 8;

bool matters(const SDL_Event& event) {
  switch (event.type) {
    case SDL_KEYDOWN:
    case SDL_TEXTINPUT:
    case SDL_MOUSEBUTTONDOWN:
    case SDL_JOYBUTTONDOWN:
    case SDL_JOYDEVICEADDED:
    case SDL_QUIT:
      return true;
    case SDL_WINDOWEVENT:
      return event.window.event == SDL_WINDOWEVENT_FOCUS_LOST;
    default:
      return false;
  }
}

}  // namespace

NoticedEvents::NoticedEvents(const SdlWindow& window, const Clock& clock)
    : window_{window}, clock_{clock} {
  if (SdlWindow::driver() == "x11") SDL_EventState(SDL_SYSWMEVENT, SDL_ENABLE);
  SDL_AddEventWatch(on_event, this);
}

NoticedEvents::~NoticedEvents() {
  SDL_DelEventWatch(on_event, this);
  SDL_EventState(SDL_SYSWMEVENT, SDL_DISABLE);
}

int NoticedEvents::on_event(void* self, SDL_Event* event) {
  static_cast<NoticedEvents*>(self)->notice(*event);
  return 1;
}

void NoticedEvents::notice(const SDL_Event& event) {
  if (event.type == SDL_SYSWMEVENT) hear_server(event);
  if (!matters(event) || count_ == kMost) return;
  const auto now = clock_.now();
  ring_[count_++] = {
      .event = event, .at = now, .unnoticed = now - window_.nothing_before(), .server = server_};
}

/// SDL hands every event of the X server on before it makes its own events of it.
void NoticedEvents::hear_server(const SDL_Event& event) {
  server_.reset();
  const auto* const message = event.syswm.msg;
  if (message == nullptr || message->subsystem != SDL_SYSWM_X11) return;
  const auto& native = message->msg.x11.event;
  if (native.type == KeyPress) {
    server_ = {.milliseconds = static_cast<std::uint32_t>(native.xkey.time),
               .code = native.xkey.keycode - kFirstKeycode,
               .is_key = true};
  } else if (native.type == ButtonPress) {
    server_ = {.milliseconds = static_cast<std::uint32_t>(native.xbutton.time)};
  }
}

}  // namespace bimodal::runner
