#pragma once

#include <functional>

#include <CLI/CLI.hpp>

#include "stimuli/base/exit_code.hpp"

namespace bimodal::runner {

/// What the command line asked for; set by the verb that was named.
using Verb = std::function<ExitCode()>;

// Each adds one verb with its options and help to the program, and sets `chosen` if it is named.
void add_check(CLI::App& app, Verb& chosen);
void add_run(CLI::App& app, Verb& chosen);
void add_monitor(CLI::App& app, Verb& chosen);
void add_rehearse(CLI::App& app, Verb& chosen);
void add_align(CLI::App& app, Verb& chosen);
void add_phones(CLI::App& app, Verb& chosen);
void add_figures(CLI::App& app, Verb& chosen);
void add_segments(CLI::App& app, Verb& chosen);
void add_continuum(CLI::App& app, Verb& chosen);
void add_tracks(CLI::App& app, Verb& chosen);
void add_labels(CLI::App& app, Verb& chosen);
void add_fit_segments(CLI::App& app, Verb& chosen);
void add_validate_lips(CLI::App& app, Verb& chosen);
void add_stimuli(CLI::App& app, Verb& chosen);
void add_render(CLI::App& app, Verb& chosen);
void add_face(CLI::App& app, Verb& chosen);
void add_measures(CLI::App& app, Verb& chosen);
void add_sheets(CLI::App& app, Verb& chosen);
void add_devices(CLI::App& app, Verb& chosen);
void add_levels(CLI::App& app, Verb& chosen);
void add_corpus(CLI::App& app, Verb& chosen);
void add_timing(CLI::App& app, Verb& chosen);

}  // namespace bimodal::runner
