#include <algorithm>
#include <filesystem>
#include <optional>
#include <span>
#include <sstream>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "runner/cli/face_view.hpp"
#include "runner/cli/verbs.hpp"
#include "runner/preparation/repertoire.hpp"
#include "stimuli/audio/sound_file.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/lower_case.hpp"
#include "stimuli/picture/drawing.hpp"
#include "stimuli/timeline/ambiguous_word.hpp"
#include "stimuli/words/dictionary.hpp"
#include "synth/face/head.hpp"
#include "synth/render/head_renderer.hpp"
#include "synth/speech/articulation.hpp"

namespace bimodal::runner {

namespace {

struct RenderOptions {
  std::string word;
  std::string phones;
  std::string voice = "kal";
  std::string strip;
  std::string frames;
  std::string sound;
  ViewOptions view;
  double rate_hz = 60.0;
};

SpelledSegments pronunciation(const RenderOptions& options) {
  if (options.phones.empty()) {
    const Dictionary dictionary{Dictionary::installed()};
    const auto found = dictionary.pronunciations(lower_case(options.word));
    if (found.empty()) {
      throw Error{
          fmt::format("the dictionary has no pronunciation of '{}'; give one: "
                      "--phones \"S T UW\"",
                      options.word)};
    }
    return {.phones = found.front(), .articulation = {}};
  }
  std::vector<Segment> segments;
  std::istringstream symbols{options.phones};
  for (std::string one; symbols >> one;) {
    const auto read = parse_sound(one);
    if (const auto* const fault = std::get_if<SegmentFault>(&read)) {
      throw Error{fmt::format("{}; {}", fault->finding, fault->remedy)};
    }
    segments.push_back(std::get<Segment>(read));
  }
  if (segments.empty()) throw Error{"--phones is empty; give e.g. --phones \"S T UW\""};
  return spelled(segments);
}

/// Pictures of one size side by side.
Image beside(const std::vector<Image>& pictures) {
  const auto width = pictures.front().width;
  auto strip = blank_image(width * pictures.size(), pictures.front().height, {});
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    paste(strip, {static_cast<std::int64_t>(i * width), 0}, pictures[i]);
  }
  return strip;
}

void write_strip(const RenderOptions& options,
                 std::span<const TimedSegment> segments,
                 const synth::Articulation& articulation,
                 synth::HeadRenderer& renderer) {
  std::vector<Image> pictures;
  for (const auto& timed : segments) {
    renderer.draw(articulation.at(timed.centre()), pictures.emplace_back());
    fmt::print("  {:<5} {:>7.1f} ms\n", symbol(timed.segment), timed.centre().count());
  }
  write_png(beside(pictures), options.strip);
  fmt::print("{}: {} pictures, one at the centre of each phone\n", options.strip, pictures.size());
}

void write_frames(const RenderOptions& options,
                  const synth::Articulation& articulation,
                  synth::HeadRenderer& renderer) {
  std::filesystem::create_directories(options.frames);
  const auto poses = articulation.sample(Hertz{options.rate_hz});
  Image image;
  for (std::size_t frame = 0; frame < poses.size(); ++frame) {
    renderer.draw(poses[frame], image);
    write_png(image, std::filesystem::path{options.frames} / fmt::format("frame{:04}.png", frame));
  }
  fmt::print("{}: {} frames at {:g} frames/s\n", options.frames, poses.size(), options.rate_hz);
}

ExitCode render(const RenderOptions& options) {
  if (options.strip.empty() && options.frames.empty() && options.sound.empty()) {
    throw Error{"nothing to write; give --strip FILE.png, --frames FOLDER or --sound FILE.wav"};
  }
  const std::map<std::string, Corpus> no_corpora;
  Repertoire repertoire{Hertz{48'000}, no_corpora};
  const auto said = pronunciation(options);
  if (!options.sound.empty() && !said.articulation.empty()) {
    throw Error{
        fmt::format("the voice cannot say \"{}\", which has ambiguous sounds; leave --sound out",
                    spell(said.articulation))};
  }
  const auto& spoken = repertoire.perform("festival:" + options.voice,
                                          SeenWord{options.word, said.phones, said.articulation});
  if (!options.sound.empty()) {
    write_wav(options.sound, spoken.sound);
    fmt::print("{}: spoken by {}\n", options.sound, options.voice);
  }
  if (options.strip.empty() && options.frames.empty()) return ExitCode::Done;
  const synth::SegmentTable segments{asset("synth/assets/segments/english.json")};
  const auto articulated = bimodal::articulated(spoken.utterance, said.articulation);
  const synth::Articulation articulation{articulated, segments};
  const synth::Head head{asset("synth/assets/head")};
  synth::HeadRenderer renderer{head, face_view(options.view)};
  if (!options.strip.empty()) write_strip(options, articulated, articulation, renderer);
  if (!options.frames.empty()) write_frames(options, articulation, renderer);
  return ExitCode::Done;
}

}  // namespace

void add_render(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand(
      "render",
      "Lets the face say a word, as pictures.\n\n"
      "Examples:\n"
      "  bimodal render stew --strip stew.png            one picture a phone\n"
      "  bimodal render stew --frames stew --sound stew.wav\n"
      "  bimodal render blick --phones \"B L IH K\" --strip blick.png --view mouth\n"
      "  bimodal render between --phones \"B~W:3/8 AA\" --strip between.png");
  auto options = std::make_shared<RenderOptions>();
  verb->add_option("WORD", options->word, "a word of the dictionary, or any name with --phones")
      ->required();
  verb->add_option("--phones",
                   options->phones,
                   "its pronunciation in ARPAbet; \"B~W:3/8\" is step 3 of 8 from B to W");
  verb->add_option("--voice", options->voice, "Festival's voice that times it: kal (default), slt")
      ->check(CLI::IsMember({"kal", "slt"}));
  verb->add_option("--strip", options->strip, "PNG file: one picture at the centre of each phone");
  verb->add_option("--frames", options->frames, "folder for one PNG a frame");
  verb->add_option("--sound", options->sound, "WAV file of the spoken word");
  verb->add_option("--rate", options->rate_hz, "frames a second (60)")->check(CLI::Range(1, 1000));
  add_view_options(*verb, options->view);
  verb->callback([options, &chosen] { chosen = [options] { return render(*options); }; });
}

}  // namespace bimodal::runner
