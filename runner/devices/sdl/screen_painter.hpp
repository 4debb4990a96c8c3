#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runner/devices/display.hpp"
#include "runner/devices/sdl/caption_font.hpp"
#include "runner/devices/sdl/sdl_window.hpp"

namespace bimodal::runner {

/// Draws a Screen into the current OpenGL 3.3 context. Pictures are shown pixel by pixel, neither
/// scaled nor corrected; captions are set once and kept. Drawing what was drawn before allocates
/// nothing.
class ScreenPainter {
 public:
  explicit ScreenPainter(const Colour& background);
  ScreenPainter(const ScreenPainter&) = delete;
  ScreenPainter& operator=(const ScreenPainter&) = delete;
  ScreenPainter(ScreenPainter&&) = delete;
  ScreenPainter& operator=(ScreenPainter&&) = delete;
  ~ScreenPainter();

  /// Throws DeviceError when the picture is larger than the window: cropped, it would be another
  /// stimulus.
  void draw(const Screen& screen, SdlWindow::Size window);

 private:
  /// In pixels of the window, from its upper left corner.
  struct Box {
    int left = 0;
    int top = 0;
    int width = 0;
    int height = 0;
  };

  /// A caption that was set, as a texture of coverage.
  struct SetCaption {
    std::string text;
    int line_height = 0;
    SdlWindow::Size window;
    std::uint32_t texture = 0;  ///< 0: no ink
    int width = 0;
    int height = 0;
    std::uint64_t last_used = 0;
  };

  void warm_up();
  static void use(std::uint32_t program, int window_place, SdlWindow::Size window);
  static void fill(const Box& box, std::uint32_t texture);
  void draw_picture(const Picture& picture, SdlWindow::Size window);
  void draw_caption(const Caption& caption, SdlWindow::Size window);
  void draw_fixation(SdlWindow::Size window) const;
  void draw_mark(const Mark& mark, SdlWindow::Size window) const;
  void draw_progress(double done, SdlWindow::Size window) const;
  const SetCaption& set(const Caption& caption, SdlWindow::Size window);
  void upload(const Picture& picture);

  Colour background_;
  CaptionFont font_;
  std::vector<SetCaption> captions_;
  std::uint64_t use_ = 0;
  std::uint32_t picture_program_ = 0;
  std::uint32_t ink_program_ = 0;
  std::uint32_t vertices_ = 0;
  std::uint32_t layout_ = 0;
  int picture_window_ = -1;  ///< where the programs take the window's size
  int ink_window_ = -1;
  int ink_colour_ = -1;              ///< where the program of ink takes its colour
  std::uint32_t full_coverage_ = 0;  ///< texture of one pixel: ink everywhere
  std::uint32_t disc_coverage_ = 0;  ///< texture of a disc
  std::uint32_t picture_texture_ = 0;
  std::size_t texture_width_ = 0;
  std::size_t texture_height_ = 0;
  const std::uint8_t* uploaded_ = nullptr;  ///< whose pixels the texture holds; null: unknown
};

}  // namespace bimodal::runner
