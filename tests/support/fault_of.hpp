#pragma once

#include <string>

#include "stimuli/base/error.hpp"

namespace bimodal {

/// What `deed` is refused with; empty if it is not.
template <typename Deed>
std::string fault_of(const Deed& deed) {
  try {
    static_cast<void>(deed());
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace bimodal
