#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

struct _TTF_Font;  // SDL_ttf's

namespace bimodal::runner {

/// Coverage of text, one byte a pixel, rows from the top: 0 background, 255 ink.
struct TextPixels {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> coverage;
};

/// Sets captions in DejaVu Sans: UTF-8, lines centred, long ones wrapped at spaces. Owns its part
/// of SDL_ttf. For one thread.
class CaptionFont {
 public:
  /// Throws DeviceError, naming the Debian package, when the font is not installed.
  CaptionFont();
  CaptionFont(const CaptionFont&) = delete;
  CaptionFont& operator=(const CaptionFont&) = delete;
  CaptionFont(CaptionFont&&) = delete;
  CaptionFont& operator=(CaptionFont&&) = delete;
  ~CaptionFont();

  /// `line_height` and `wrap_width` in pixels, > 0. Nothing for text without ink.
  [[nodiscard]] TextPixels draw(const std::string& text, int line_height, int wrap_width);

 private:
  _TTF_Font* font(int line_height);

  std::string path_;
  std::map<int, _TTF_Font*> fonts_;  ///< by line height
};

}  // namespace bimodal::runner
