#include <memory>

#include "analysis/cli/verb.hpp"

namespace bimodal::analysis {

void add_report_verb(CLI::App& program, Verb& chosen) {
  static_cast<void>(program);
  static_cast<void>(chosen);
}

}  // namespace bimodal::analysis
