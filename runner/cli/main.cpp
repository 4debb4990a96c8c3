#include <cstdio>
#include <exception>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "runner/cli/verbs.hpp"
#include "runner/devices/device_error.hpp"
#include "runner/store/store_error.hpp"
#include "stimuli/base/error.hpp"

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
    return complain(error, ExitCode::Internal);
  }
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
      "  bimodal-analysis report words414.sqlite -o report",
      "bimodal"};
  app.set_version_flag("--version", BIMODAL_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  bimodal::runner::Verb verb;
  bimodal::runner::add_check(app, verb);
  bimodal::runner::add_run(app, verb);
  bimodal::runner::add_rehearse(app, verb);
  bimodal::runner::add_stimuli(app, verb);
  bimodal::runner::add_render(app, verb);
  bimodal::runner::add_devices(app, verb);
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? ExitCode::Done : ExitCode::Usage;
  }
  return perform(verb);
}

}  // namespace

int main(int count, char** arguments) {
  try {
    return static_cast<int>(perform_what_is_asked(count, arguments));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bimodal: %s\n", error.what());
    return static_cast<int>(ExitCode::Internal);
  }
}
