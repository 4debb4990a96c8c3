# Fails if a source file includes something its layer must not know. Run by CTest as
#   cmake -DSOURCE_DIR=<root> -P check_layers.cmake
# Each rule: <folder> followed by the regular expression of forbidden includes.
set(rules
  "stimuli/base"        "\"(stimuli/[^b]|synth|protocols|runner|analysis)/"
  "stimuli"             "\"(runner|synth|protocols|analysis)/|<(SDL|portaudio|GL/|epoxy|sqlite3)"
  "stimuli/timeline"    "\"stimuli/[^bt]|<(sndfile|soxr|nlohmann)"
  "stimuli/picture"     "\"stimuli/[^bp]|<(libav|libsw|nlohmann)"
  "stimuli/figures"     "\"stimuli/[^bf]|<(nlohmann|png)"
  "stimuli/labels"      "\"stimuli/[^btl]|<(sndfile|soxr|nlohmann)"
  "stimuli/words"       "\"stimuli/[^btw]|<(sndfile|soxr)"
  "stimuli/audio"       "\"stimuli/[^bta]|\"stimuli/alignment|<(nlohmann|libav|libsw)"
  "stimuli/video"       "\"stimuli/(words|labels|alignment|corpus)/|<(nlohmann|pocketsphinx|sndfile)"
  "stimuli/alignment"   "\"stimuli/(words|labels|video|corpus)/|<(nlohmann|libav|libsw|sndfile)"
  "stimuli/corpus"      "<(libav|libsw|pocketsphinx|sphinxbase|sndfile|png)"
  "synth"               "\"(runner|protocols|analysis)/|<(SDL|portaudio|sndfile|sqlite3)"
  "synth/speech"        "\"synth/(face|voice|render|image|studio|fitting|figures|inspection)/|<(OpenMesh|epoxy|GL/|festival)"
  "synth/figures"       "\"synth/(face|voice|render|image|studio|fitting)/|<(cairo|nlohmann)"
  "synth/inspection"    "\"synth/(voice|render|image|studio)/"
  "synth/fitting"       "\"synth/(face|voice|render|image|studio)/|<(OpenMesh|epoxy|GL/|festival)"
  "synth/face"          "\"synth/(voice|render|studio|fitting)/|<(epoxy|GL/|festival)"
  "synth/voice"         "\"synth/(face|render|studio|fitting)/|<(OpenMesh|epoxy|GL/)"
  "protocols"           "\"(runner|synth|analysis)/|<(SDL|portaudio|sndfile|GL/|sqlite3)"
  "protocols/model"     "\"protocols/(reading|design|observers)/|<nlohmann"
  "protocols/design"    "\"protocols/(reading|observers)/|<nlohmann"
  "runner"              "\"analysis/"
  "runner/session"      "\"(synth/(voice|render|face)|runner/(devices/(sdl|portaudio|wayland|x11|evdev)|store|preparation|booth|cli))/|<(SDL|portaudio|GL/|epoxy|sqlite3)|<(thread|mutex|iostream|fstream)>"
  "runner/monitor"      "\"(synth|runner/(devices|preparation|booth|cli|store/sqlite))/|\"runner/store/sqlite|<(SDL|portaudio|GL/|epoxy|sqlite3)|<(thread|mutex|iostream|fstream)>"
  "runner/timing"       "\"runner/(devices|store|preparation|booth|cli)/|<(SDL|portaudio|GL/|thread|mutex|iostream|fstream)"
  "runner/realtime"     "<(SDL|portaudio|mutex|condition_variable|iostream|fstream|string|map)"
  "runner/store"        "\"(synth|protocols|runner/(devices|session|preparation|booth|cli))/|<(SDL|portaudio|GL/)"
  "runner/devices"      "\"(synth|protocols|runner/(store|preparation|booth|cli))/|<sqlite3"
  "runner/calibration"  "\"(synth|protocols|runner/[^c]|runner/cli)/|<(SDL|portaudio|GL/|sqlite3)"
  "runner/preparation"  "\"runner/(devices/(sdl|portaudio|wayland|x11|evdev|serial)|store/sqlite|booth|cli)/|<(SDL|portaudio|libserialport|GL/|epoxy|sqlite3)"
  "runner/booth"        "\"(runner/(devices/(sdl|portaudio|wayland|x11|evdev|serial)|store/sqlite|cli)|synth)/|<(SDL|portaudio|libserialport|GL/|epoxy|sqlite3)"
  "analysis"            "\"(runner/(devices|session|preparation|booth|cli|realtime|timing)|synth)/|<(SDL|portaudio|sndfile|GL/|sqlite3)"
  "analysis/statistics" "\"analysis/(data|scoring|report|cli)/|<(nlohmann|iostream|fstream)"
  "analysis/scoring"    "\"analysis/(report|cli)/"
  "analysis/data"       "\"analysis/(scoring|report|cli)/|<(cairo|pango|librsvg|libxml|gdk)"
  "analysis/cli"        "<(cairo|pango|librsvg|libxml|gdk)"
  "analysis/report/figures" "\"analysis/(cli|report/print)/|<(cairo|pango|librsvg|libxml|gdk|nlohmann)")

set(violations "")
while(rules)
  list(POP_FRONT rules folder forbidden)
  file(GLOB_RECURSE sources "${SOURCE_DIR}/${folder}/*.hpp" "${SOURCE_DIR}/${folder}/*.cpp")
  foreach(source IN LISTS sources)
    file(STRINGS "${source}" includes REGEX "^#include")
    foreach(include IN LISTS includes)
      if(include MATCHES "${forbidden}")
        file(RELATIVE_PATH shown "${SOURCE_DIR}" "${source}")
        string(APPEND violations "\n  ${shown}: ${include}")
      endif()
    endforeach()
  endforeach()
endwhile()
if(violations)
  message(FATAL_ERROR "These includes break the layering:${violations}")
endif()
