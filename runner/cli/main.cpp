#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "runner/cli/verbs.hpp"
#include "runner/devices/device_error.hpp"
#include "runner/store/store_error.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/nearest.hpp"

namespace {

using bimodal::ExitCode;

ExitCode complain(const std::exception& error, ExitCode code) {
  fmt::print(stderr, "bimodal: {}\n", bimodal::describe(error));
  return code;
}

ExitCode perform(const bimodal::runner::Verb& verb) {
  try {
    return verb();
  } catch (const bimodal::runner::StoreError& error) {
    return complain(error, ExitCode::Store);
  } catch (const bimodal::runner::DeviceError& error) {
    return complain(error, ExitCode::Device);
  } catch (const bimodal::Error& error) {
    return complain(error, ExitCode::InvalidInput);
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) return ExitCode::InvalidInput;  // told at the end
    return complain(error, ExitCode::Internal);
  }
}

/// Options are left to the parser.
bool knows(const CLI::App& app, const std::string& first) {
  return first.empty() || first.front() == '-' ||
         !app.get_subcommands([&](const CLI::App* verb) { return verb->get_name() == first; })
              .empty();
}

std::string suggestion(const CLI::App& app, const std::string& typed) {
  std::vector<std::string> names;
  for (const auto* verb : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(verb->get_name());
  const std::vector<std::string_view> known(names.begin(), names.end());
  if (const auto near = bimodal::nearest(typed, known)) {
    return fmt::format("; did you mean '{}'? See --help.", *near);
  }
  return fmt::format("; there are {} (see --help)", fmt::join(known, ", "));
}

ExitCode perform_what_is_asked(int count, char** arguments) {
  CLI::App app{
      "bimodal runs perceptual experiments on bimodal speech: what people understand from a "
      "voice,\n"
      "from a face, and from both.\n\n"
      "Examples:\n"
      "  bimodal check words414                        is everything there that the protocol "
      "needs?\n"
      "  bimodal rehearse words414 --participants 20 --data trial.sqlite\n"
      "  bimodal run words414 --participant P01        a real session\n"
      "  bimodal monitor words414.sqlite               ... watched by the experimenter\n"
      "  bimodal-analysis report words414.sqlite -o report",
      "bimodal"};
  app.set_version_flag("--version", BIMODAL_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  bimodal::runner::Verb verb;
  bimodal::runner::add_check(app, verb);
  bimodal::runner::add_run(app, verb);
  bimodal::runner::add_monitor(app, verb);
  bimodal::runner::add_rehearse(app, verb);
  bimodal::runner::add_align(app, verb);
  bimodal::runner::add_phones(app, verb);
  bimodal::runner::add_tracks(app, verb);
  bimodal::runner::add_continuum(app, verb);
  bimodal::runner::add_segments(app, verb);
  bimodal::runner::add_figures(app, verb);
  bimodal::runner::add_labels(app, verb);
  bimodal::runner::add_fit_segments(app, verb);
  bimodal::runner::add_validate_lips(app, verb);
  bimodal::runner::add_stimuli(app, verb);
  bimodal::runner::add_render(app, verb);
  bimodal::runner::add_face(app, verb);
  bimodal::runner::add_measures(app, verb);
  bimodal::runner::add_sheets(app, verb);
  bimodal::runner::add_devices(app, verb);
  bimodal::runner::add_levels(app, verb);
  bimodal::runner::add_corpus(app, verb);
  bimodal::runner::add_timing(app, verb);
  if (const std::string first = count > 1 ? arguments[1] : ""; !knows(app, first)) {
    fmt::print(stderr, "bimodal: there is no verb '{}'{}\n", first, suggestion(app, first));
    return ExitCode::Usage;
  }
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? ExitCode::Done : ExitCode::Usage;
  }
  return perform(verb);
}

/// Whether everything that was printed has arrived; tells if it has not (a full disk).
bool has_arrived() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return true;
  fmt::print(stderr,
             "bimodal: standard output cannot be written: {}; what was printed is not whole\n",
             std::strerror(errno));
  return false;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    const auto code = perform_what_is_asked(count, arguments);
    const bool has_failed = code != ExitCode::Done && code != ExitCode::Findings;
    return static_cast<int>(has_arrived() || has_failed ? code : ExitCode::InvalidInput);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bimodal: %s\n", error.what());
    return static_cast<int>(ExitCode::Internal);
  }
}
