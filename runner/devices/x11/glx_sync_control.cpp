#include "runner/devices/x11/glx_sync_control.hpp"

#include <epoxy/gl.h>
#include <epoxy/glx.h>

namespace bimodal::runner {
namespace {

class GlxSyncControl final : public SyncControl {
 public:
  GlxSyncControl(::Display* display, GLXDrawable window) : display_{display}, window_{window} {}

  std::optional<SyncCounters> counters() override {
    SyncCounters now;
    if (glXGetSyncValuesOML(display_, window_, &now.ust, &now.msc, &now.sbc) == 0) {
      return std::nullopt;
    }
    return now;
  }

  std::optional<SyncCounters> await_swap(std::int64_t swap) override {
    SyncCounters done;
    if (glXWaitForSbcOML(display_, window_, swap, &done.ust, &done.msc, &done.sbc) == 0) {
      return std::nullopt;
    }
    return done;
  }

 private:
  ::Display* display_;  ///< borrowed from the window
  GLXDrawable window_;
};

}  // namespace

FoundSyncControl find_sync_control() {
  auto* const display = glXGetCurrentDisplay();
  const auto window = glXGetCurrentDrawable();
  if (display == nullptr || window == None) {
    return {.control = nullptr, .refusal = "OpenGL is not used through GLX"};
  }
  if (!epoxy_has_glx_extension(display, DefaultScreen(display), "GLX_OML_sync_control")) {
    return {.control = nullptr, .refusal = "the driver does not offer it"};
  }
  auto control = std::make_unique<GlxSyncControl>(display, window);
  if (!control->counters()) {
    return {.control = nullptr, .refusal = "the driver offers it, but does not answer"};
  }
  return {.control = std::move(control), .refusal = {}};
}

}  // namespace bimodal::runner
