#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "runner/cli/expression_list.hpp"
#include "runner/cli/face_appearance.hpp"
#include "runner/cli/face_view.hpp"
#include "runner/cli/interrupt.hpp"
#include "runner/cli/option_checks.hpp"
#include "runner/cli/render_files.hpp"
#include "runner/cli/render_output.hpp"
#include "runner/cli/seen_speech.hpp"
#include "runner/cli/spoken_score.hpp"
#include "runner/cli/verbs.hpp"
#include "stimuli/audio/sound_file.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/obstacle.hpp"

namespace bimodal::runner {

namespace {

constexpr auto kVoice = "voice";  ///< what --audio without a file stands for

struct RenderOptions {
  SpokenOptions spoken;
  std::string account = "dominance";
  std::vector<std::string> outputs;
  std::optional<std::string> audio;
  std::optional<double> at_ms;
  std::string fps = "60";
  std::optional<int> rate_factor;
  ViewOptions view;
  AppearanceOptions appearance;
  std::vector<std::string> expressions;
};

/// A text that stands behind --audio is taken for its file.
std::string audio_fault(const std::string& text) {
  if (text == kVoice) return {};
  const auto why = obstacle(text);
  return why ? "'" + text + "': " + *why +
                   "; give a WAV or FLAC file, or --audio last for the voice"
             : std::string{};
}

std::string rate_fault(const std::string& text) {
  if (parse_frame_rate(text)) return {};
  return "'" + text + "' is no frame rate from 1 to 1000; give e.g. 60, 29.97 or 30000/1001";
}

/// A folder of frames is made if need be.
std::string place_fault(std::string text) {
  return text.ends_with('/') ? std::string{} : in_a_folder_that_exists()(text);
}

std::vector<RenderOutput> outputs_of(const RenderOptions& options) {
  std::vector<RenderOutput> outputs;
  for (const auto& name : options.outputs) {
    outputs.push_back(render_output(name, options.at_ms.has_value()));
  }
  return outputs;
}

bool has(const std::vector<RenderOutput>& outputs, RenderOutput::Kind kind) {
  return std::ranges::find(outputs, kind, &RenderOutput::kind) != outputs.end();
}

/// What was asked for in vain is told before long work begins.
void refuse_idle_options(const RenderOptions& options, const std::vector<RenderOutput>& outputs) {
  const auto refuse = [](std::string_view option, std::string_view reason) {
    throw Error{fmt::format("{} has no effect: {}; leave it out", option, reason)};
  };
  using Kind = RenderOutput::Kind;
  const bool takes_sound = std::ranges::any_of(outputs, &RenderOutput::has_sound);
  const bool speaks = has(outputs, Kind::Sound) && options.audio == kVoice;
  if (options.audio && !takes_sound && !speaks) refuse("--audio", "only .mp4 and .webm have sound");
  if (options.at_ms && !has(outputs, Kind::Still)) refuse("--at", "only one .png shows an instant");
  if (!options.rate_factor) return;
  const auto* factor = std::ranges::max(outputs, {}, [](const RenderOutput& output) {
                         return output.form != nullptr && output.form->factor;
                       }).form;
  if (factor == nullptr || !factor->factor) refuse("--crf", "only .mp4 and .webm are coded by it");
}

/// Of a film, whose colours are coded for two by two pixels.
void refuse_odd_sizes(const synth::View& view, const std::vector<RenderOutput>& outputs) {
  if ((view.width % 2 == 0 && view.height % 2 == 0) || !has(outputs, RenderOutput::Kind::Film)) {
    return;
  }
  throw Error{fmt::format(
      "--size: a film cannot have {} x {} pixels; give even numbers", view.width, view.height)};
}

/// Tracks say themselves what the face does.
void refuse_options_of_speech(const RenderOptions& options) {
  const SpokenOptions none;
  const auto& spoken = options.spoken;
  if (!spoken.method && !spoken.from && !spoken.voice && spoken.rate == none.rate &&
      spoken.segments == none.segments && options.account == RenderOptions{}.account) {
    return;
  }
  throw Error{fmt::format(
      "'{}' holds tracks, which are drawn as they are; leave out --method, --from, --voice, "
      "--rate, --segments and --account, or give them to 'bimodal tracks'",
      spoken.text)};
}

/// At the very end the last phone is over.
void refuse_instant_outside(const RenderOptions& options, const SeenSpeech& seen) {
  if (!options.at_ms) return;
  const double end = seen.end.count();
  if (*options.at_ms >= 0.0 && *options.at_ms <= end) return;
  throw Error{
      fmt::format("--at {:g}: there is nothing to be seen; it begins at 0 and ends at {:.1f} ms; "
                  "give an instant between",
                  *options.at_ms,
                  end)};
}

SeenSpeech seen_speech(const RenderOptions& options, bool voiced) {
  if (!names_tracks(options.spoken.text)) {
    return articulated_speech(options.spoken, account_from_name(options.account).value(), voiced);
  }
  refuse_options_of_speech(options);
  if (voiced) {
    throw Error{fmt::format(
        "no voice says the tracks '{}'; give a sound of your own by --audio FILE.wav, or none",
        options.spoken.text)};
  }
  return tracked_speech(options.spoken.text);
}

ExitCode render(const RenderOptions& options) {
  stop_at_interrupt();
  const auto outputs = outputs_of(options);
  refuse_idle_options(options, outputs);
  const auto view = face_view(options.view);
  refuse_odd_sizes(view, outputs);
  for (const auto& output : outputs) require_place_for(output);
  const bool voiced = options.audio == kVoice || has(outputs, RenderOutput::Kind::Sound);
  std::optional<Clip> own_sound;
  if (options.audio && options.audio != kVoice) {
    own_sound = read_sound(*options.audio, Channels::MixDown);
  }
  const auto expressions = read_expressions(options.expressions);
  const auto seen = with_expressions(seen_speech(options, voiced), expressions);
  refuse_instant_outside(options, seen);
  const Clip* sound = own_sound ? &*own_sound : options.audio ? &seen.sound.value() : nullptr;
  const RenderStyle style{
      .view = view,
      .appearance = face_appearance(options.appearance, view),
      .rate = parse_frame_rate(options.fps).value(),
      .rate_factor = options.rate_factor,
      .instant = options.at_ms ? std::optional{Milliseconds{*options.at_ms}} : std::nullopt};
  const synth::Head head{asset("synth/assets/head")};
  for (const auto& output : outputs) write_rendered(output, seen, sound, head, style);
  return ExitCode::Done;
}

}  // namespace

void add_render(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand(
      "render",
      "Lets the face say a text, a transcription or a score, or do what tracks say, as a film or\n"
      "pictures. What is written is said by how its name ends:\n"
      "  .mp4 (H.264, AAC), .webm (VP9, Opus)   a film; sound begins with the first picture\n"
      "  .gif                                   without sound; a frame lasts whole hundredths of\n"
      "                                         a second, so that 60 a second become 50\n"
      "  .png                                   one picture at the centre of each phone, side by\n"
      "                                         side; with --at, the face at that instant\n"
      "  %04d.png, or a folder (ends with /)    one picture a frame\n"
      "  .wav                                   the voice alone\n"
      "Without a voice, phones have their intrinsic durations; with one, Festival times them.\n"
      "Exit code: 0 done, 2 wrong usage (also a folder that is not there), 3 errors.\n\n"
      "Examples:\n"
      "  bimodal render \"Temporary food, stew.\" --audio -o stew.mp4\n"
      "  bimodal render stew -o stew.png --view mouth          one picture a phone\n"
      "  bimodal render stew -o stew.webm -o stew.wav --audio --voice slt --fps 29.97\n"
      "  bimodal render --from arpabet \"B~W:3/8 AA\" -o between.gif --height 360\n"
      "  bimodal render tracks.csv --audio mine.wav -o mine.mp4 --size 1280x720\n"
      "  bimodal render score.json -o frames/ --fps 25");
  auto options = std::make_shared<RenderOptions>();
  add_spoken_options(*verb, options->spoken);
  verb->get_option("SCORE|TEXT")
      ->description(
          "a text; a transcription with --from; a score (.json); or tracks (.csv, .json)");
  add_account_option(*verb, options->account);
  verb->add_option("-o,--output", options->outputs, "what to write; may be given several times")
      ->required()
      ->allow_extra_args(false)
      ->check(CLI::Validator{[](std::string& text) { return place_fault(text); }, ""});
  verb->add_option("--audio",
                   options->audio,
                   "with the voice; or, with a file (WAV, FLAC), with a sound of your own, which "
                   "begins with the face")
      ->expected(0, 1)
      ->default_str(kVoice)
      ->check(CLI::Validator{[](std::string& text) { return audio_fault(text); }, ""})
      ->type_name("[FILE]");
  verb->add_option("--at", options->at_ms, "instant in ms of the one picture in a .png")
      ->check(finite_number());
  verb->add_option("--fps", options->fps, "frames a second (60): e.g. 25, 29.97 or 30000/1001")
      ->check(CLI::Validator{[](std::string& text) { return rate_fault(text); }, ""})
      ->type_name("RATE");
  verb->add_option("--crf",
                   options->rate_factor,
                   "how coarse films are coded: 0 (finest) to 51 in .mp4 (16), to 63 in .webm (18)")
      ->check(CLI::Range(0, 63));
  add_view_options(*verb, options->view);
  add_appearance_options(*verb, options->appearance);
  add_expression_option(*verb, options->expressions);
  verb->callback([options, &chosen] { chosen = [options] { return render(*options); }; });
}

}  // namespace bimodal::runner
