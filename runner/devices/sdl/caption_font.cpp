#include "runner/devices/sdl/caption_font.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string_view>

#include <SDL_ttf.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "runner/devices/device_error.hpp"

namespace bimodal::runner {
namespace {

constexpr std::array<std::string_view, 4> kFontFiles{
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",  // Debian, Ubuntu
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf",
    "/usr/local/share/fonts/DejaVuSans.ttf"};

/// DejaVu Sans is 1.164 times as high as its nominal size (ascent 0.928, descent 0.236).
constexpr double kLineHeightPerSize = 1.164;

std::string installed_font() {
  for (const auto file : kFontFiles) {
    if (std::filesystem::exists(file)) return std::string{file};
  }
  throw DeviceError{fmt::format(
      "display: no font for the participant's texts: none of {} exists; install the package "
      "fonts-dejavu-core",
      fmt::join(kFontFiles, ", "))};
}

using Surface = std::unique_ptr<SDL_Surface, decltype(&SDL_FreeSurface)>;

}  // namespace

CaptionFont::CaptionFont() : path_{installed_font()} {
  if (TTF_Init() != 0) {
    throw DeviceError{fmt::format("display: cannot start SDL_ttf: {}", TTF_GetError())};
  }
}

CaptionFont::~CaptionFont() {
  for (const auto& [line_height, font] : fonts_) TTF_CloseFont(font);
  TTF_Quit();
}

_TTF_Font* CaptionFont::font(int line_height) {
  const auto known = fonts_.find(line_height);
  if (known != fonts_.end()) return known->second;
  const auto size = std::max(1, static_cast<int>(line_height / kLineHeightPerSize));
  auto* font = TTF_OpenFont(path_.c_str(), size);
  if (font == nullptr) {
    throw DeviceError{
        fmt::format("display: cannot read the font {}: {}; reinstall the package fonts-dejavu-core",
                    path_,
                    TTF_GetError())};
  }
  TTF_SetFontWrappedAlign(font, TTF_WRAPPED_ALIGN_CENTER);
  fonts_.emplace(line_height, font);
  return font;
}

TextPixels CaptionFont::draw(const std::string& text, int line_height, int wrap_width) {
  if (text.find_first_not_of(" \n") == std::string::npos) return {};
  const Surface surface{TTF_RenderUTF8_Blended_Wrapped(font(line_height),
                                                       text.c_str(),
                                                       SDL_Color{255, 255, 255, 255},
                                                       static_cast<Uint32>(wrap_width)),
                        &SDL_FreeSurface};
  if (!surface) {
    throw DeviceError{fmt::format("display: cannot set the text \"{}\": {}", text, TTF_GetError())};
  }
  TextPixels result{.width = surface->w, .height = surface->h, .coverage = {}};
  result.coverage.reserve(static_cast<std::size_t>(surface->w) *
                          static_cast<std::size_t>(surface->h));
  const auto* rows = static_cast<const std::uint8_t*>(surface->pixels);
  for (int y = 0; y < surface->h; ++y) {
    const auto* row = rows + static_cast<std::ptrdiff_t>(y) * surface->pitch;
    for (int x = 0; x < surface->w; ++x) {
      std::uint32_t pixel = 0;
      std::copy_n(
          row + static_cast<std::ptrdiff_t>(x) * 4, 4, reinterpret_cast<std::uint8_t*>(&pixel));
      result.coverage.push_back(
          static_cast<std::uint8_t>((pixel & surface->format->Amask) >> surface->format->Ashift));
    }
  }
  return result;
}

}  // namespace bimodal::runner
