#pragma once

#include "runner/cli/verbs.hpp"

namespace bimodal::runner {

/// Adds the verb "show" to "segments".
void add_segments_show(CLI::App& segments, Verb& chosen);

/// Adds the verb "contacts" to "segments".
void add_segments_contacts(CLI::App& segments, Verb& chosen);

}  // namespace bimodal::runner
