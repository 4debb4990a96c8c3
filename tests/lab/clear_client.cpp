/// The least that a program can do on a screen: clears a window to another grey at every refresh.
/// The refreshes that it misses are those that this machine misses by itself.
///
///   clear_client REFRESHES
#include <cstdio>
#include <cstdlib>

#include <SDL.h>
#include <epoxy/gl.h>

int main(int count, char** arguments) {
  if (count != 2) return 2;
  constexpr int kLevels = 4;
  SDL_Init(SDL_INIT_VIDEO);
  SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
  auto* const window = SDL_CreateWindow("clear", 0, 0, 1280, 1024, SDL_WINDOW_OPENGL);
  if (window == nullptr || SDL_GL_CreateContext(window) == nullptr) return 4;
  SDL_GL_SetSwapInterval(1);
  const int refreshes = std::atoi(arguments[1]);
  for (int i = 0; i < refreshes; ++i) {
    SDL_PumpEvents();
    const float grey = static_cast<float>(i % kLevels) / (kLevels - 1);
    glClearColor(grey, grey, grey, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    SDL_GL_SwapWindow(window);
    glFinish();
  }
  return 0;
}
