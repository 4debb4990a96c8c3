#include "runner/devices/sdl/screen_painter.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <epoxy/gl.h>
#include <fmt/format.h>

#include "runner/devices/device_error.hpp"
#include "runner/devices/sdl/screen_programs.hpp"

namespace bimodal::runner {
namespace {

constexpr std::size_t kKeptCaptions = 128;  ///< more than any screen has
constexpr double kCaptionWidth = 0.86;      ///< of the window's width, then it wraps
constexpr double kCaptionShrink = 0.9;      ///< per attempt, for a caption higher than the window
constexpr double kFixationSize = 0.03;      ///< of the window's height
constexpr double kProgressWidth = 0.4;      ///< of the window's width
constexpr double kProgressHeight = 0.008;   ///< of the window's height
constexpr double kProgressPlace = 0.965;    ///< of the window's height, from the top

/// Black on light, white on dark (Rec. 709 luma).
Colour ink_on(const Colour& background) {
  const auto luma = 0.2126F * background[0] + 0.7152F * background[1] + 0.0722F * background[2];
  return luma > 0.4F ? Colour{0.0F, 0.0F, 0.0F} : Colour{1.0F, 1.0F, 1.0F};
}

int part_of(int whole, double part) {
  return static_cast<int>(std::lround(whole * part));
}

}  // namespace

ScreenPainter::ScreenPainter(const Colour& background)
    : background_{background},
      picture_program_{linked_picture_program()},
      ink_program_{linked_ink_program()},
      picture_window_{glGetUniformLocation(picture_program_, "window")},
      ink_window_{glGetUniformLocation(ink_program_, "window")},
      ink_colour_{glGetUniformLocation(ink_program_, "ink")},
      full_coverage_{new_texture()} {
  captions_.reserve(kKeptCaptions);
  glGenVertexArrays(1, &layout_);
  glBindVertexArray(layout_);
  glGenBuffers(1, &vertices_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  glBufferData(GL_ARRAY_BUFFER, 16 * sizeof(float), nullptr, GL_STREAM_DRAW);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 4 * sizeof(float), nullptr);
  constexpr auto kAfterPlace = 2 * sizeof(float);
  const auto* after_place = reinterpret_cast<const void*>(kAfterPlace);
  glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, 4 * sizeof(float), after_place);
  glEnableVertexAttribArray(0);
  glEnableVertexAttribArray(1);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  constexpr std::uint8_t kInk = 255;
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, 1, 1, 0, GL_RED, GL_UNSIGNED_BYTE, &kInk);
  disc_coverage_ = disc_texture();
  warm_up();
}

/// Drivers translate a shader when it first draws, which may take longer than a refresh.
void ScreenPainter::warm_up() {
  constexpr std::array<std::uint8_t, 4> kPixel{};
  const Picture picture{.width = 1, .height = 1, .pixels = kPixel};
  draw({.picture = &picture, .fixation = true}, {.width = 16, .height = 16});
  glFinish();
}

ScreenPainter::~ScreenPainter() {
  for (const auto& caption : captions_) glDeleteTextures(1, &caption.texture);
  glDeleteTextures(1, &picture_texture_);
  glDeleteBuffers(1, &vertices_);
  glDeleteVertexArrays(1, &layout_);
  glDeleteTextures(1, &full_coverage_);
  glDeleteTextures(1, &disc_coverage_);
  glDeleteProgram(picture_program_);
  glDeleteProgram(ink_program_);
}

void ScreenPainter::draw(const Screen& screen, SdlWindow::Size window) {
  glViewport(0, 0, window.width, window.height);
  glClearColor(background_[0], background_[1], background_[2], 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  if (screen.picture != nullptr) {
    draw_picture(*screen.picture, window);
  } else {
    uploaded_ = nullptr;  // the pixels may be gone, and others may come to lie at their address
  }
  use(ink_program_, ink_window_, window);
  glEnable(GL_BLEND);
  for (const auto& mark : screen.marks) draw_mark(mark, window);
  const auto ink = ink_on(background_);
  glUniform3fv(ink_colour_, 1, ink.data());
  if (screen.fixation) draw_fixation(window);
  for (const auto& caption : screen.captions) draw_caption(caption, window);
  if (screen.progress >= 0.0) draw_progress(std::min(screen.progress, 1.0), window);
  glDisable(GL_BLEND);
}

void ScreenPainter::use(std::uint32_t program, int window_place, SdlWindow::Size window) {
  glUseProgram(program);
  glUniform2f(window_place, static_cast<float>(window.width), static_cast<float>(window.height));
}

void ScreenPainter::fill(const Box& box, std::uint32_t texture) {
  glBindTexture(GL_TEXTURE_2D, texture);
  const auto left = static_cast<float>(box.left);
  const auto top = static_cast<float>(box.top);
  const auto right = static_cast<float>(box.left + box.width);
  const auto bottom = static_cast<float>(box.top + box.height);
  const std::array<float, 16> corners{left,
                                      top,
                                      0.0F,
                                      0.0F,
                                      right,
                                      top,
                                      1.0F,
                                      0.0F,
                                      left,
                                      bottom,
                                      0.0F,
                                      1.0F,
                                      right,
                                      bottom,
                                      1.0F,
                                      1.0F};
  glBufferSubData(GL_ARRAY_BUFFER, 0, sizeof(corners), corners.data());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void ScreenPainter::draw_picture(const Picture& picture, SdlWindow::Size window) {
  const auto width = static_cast<int>(picture.width);
  const auto height = static_cast<int>(picture.height);
  if (width > window.width || height > window.height) {
    throw DeviceError{fmt::format(
        "display: the picture of {} x {} pixels does not fit into the window of {} x {}; make the "
        "window larger (or use the full screen), or the pictures smaller",
        width,
        height,
        window.width,
        window.height)};
  }
  upload(picture);
  use(picture_program_, picture_window_, window);
  fill({(window.width - width) / 2, (window.height - height) / 2, width, height}, picture_texture_);
}

void ScreenPainter::upload(const Picture& picture) {
  assert(picture.pixels.size() == picture.width * picture.height * 4);
  const auto width = static_cast<GLsizei>(picture.width);
  const auto height = static_cast<GLsizei>(picture.height);
  if (picture_texture_ == 0) picture_texture_ = new_texture();
  glBindTexture(GL_TEXTURE_2D, picture_texture_);
  if (picture.width != texture_width_ || picture.height != texture_height_) {
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    texture_width_ = picture.width;
    texture_height_ = picture.height;
    uploaded_ = nullptr;
  }
  if (uploaded_ == picture.pixels.data()) return;
  glTexSubImage2D(
      GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, picture.pixels.data());
  uploaded_ = picture.pixels.data();
}

void ScreenPainter::draw_caption(const Caption& caption, SdlWindow::Size window) {
  const auto& set_caption = set(caption, window);
  if (set_caption.texture == 0) return;
  const auto top = part_of(window.height, caption.centre_y) - set_caption.height / 2;
  const auto left = part_of(window.width, caption.centre_x) - set_caption.width / 2;
  fill({left,  // lines stand in the middle of a texture that may be as wide as they could be
        std::clamp(top, 0, std::max(0, window.height - set_caption.height)),
        set_caption.width,
        set_caption.height},
       set_caption.texture);
}

const ScreenPainter::SetCaption& ScreenPainter::set(const Caption& caption,
                                                    SdlWindow::Size window) {
  ++use_;
  const auto line_height = std::max(1, part_of(window.height, caption.size));
  for (auto& known : captions_) {
    if (known.line_height != line_height || known.window.width != window.width ||
        known.window.height != window.height || known.text != caption.text) {
      continue;
    }
    known.last_used = use_;
    return known;
  }
  if (captions_.size() == kKeptCaptions) {
    const auto oldest = std::ranges::min_element(captions_, {}, &SetCaption::last_used);
    glDeleteTextures(1, &oldest->texture);
    captions_.erase(oldest);
  }
  const auto wrap_width = std::max(1, part_of(window.width, kCaptionWidth));
  auto height = line_height;
  auto pixels = font_.draw(caption.text, height, wrap_width);
  while (pixels.height > window.height && height > 1) {
    height = std::min(height - 1, part_of(height, kCaptionShrink));
    pixels = font_.draw(caption.text, height, wrap_width);
  }
  auto& added = captions_.emplace_back(SetCaption{.text = caption.text,
                                                  .line_height = line_height,
                                                  .window = window,
                                                  .texture = 0,
                                                  .width = pixels.width,
                                                  .height = pixels.height,
                                                  .last_used = use_});
  if (pixels.coverage.empty()) return added;
  added.texture = new_texture();
  glTexImage2D(GL_TEXTURE_2D,
               0,
               GL_R8,
               pixels.width,
               pixels.height,
               0,
               GL_RED,
               GL_UNSIGNED_BYTE,
               pixels.coverage.data());
  return added;
}

void ScreenPainter::draw_fixation(SdlWindow::Size window) const {
  const auto half = std::max(4, part_of(window.height, kFixationSize / 2));
  const auto thick = std::max(2, half / 5 / 2 * 2);
  const auto x = window.width / 2;
  const auto y = window.height / 2;
  fill({x - half, y - thick / 2, 2 * half, thick}, full_coverage_);
  fill({x - thick / 2, y - half, thick, 2 * half}, full_coverage_);
}

void ScreenPainter::draw_mark(const Mark& mark, SdlWindow::Size window) const {
  const bool is_disc = mark.shape == Mark::Shape::Disc;
  const auto height = part_of(window.height, mark.height);
  const auto width = is_disc ? height : part_of(window.width, mark.width);
  glUniform3fv(ink_colour_, 1, mark.colour.data());
  fill({part_of(window.width, mark.centre_x) - width / 2,
        part_of(window.height, mark.centre_y) - height / 2,
        width,
        height},
       is_disc ? disc_coverage_ : full_coverage_);
}

void ScreenPainter::draw_progress(double done, SdlWindow::Size window) const {
  const auto width = part_of(window.width, kProgressWidth);
  const auto height = std::max(4, part_of(window.height, kProgressHeight));
  const auto left = (window.width - width) / 2;
  const auto top = part_of(window.height, kProgressPlace);
  fill({left, top, width, 1}, full_coverage_);
  fill({left, top + height - 1, width, 1}, full_coverage_);
  fill({left, top, 1, height}, full_coverage_);
  fill({left + width - 1, top, 1, height}, full_coverage_);
  fill({left, top, part_of(width, done), height}, full_coverage_);
}

}  // namespace bimodal::runner
