#pragma once

#include <cstddef>

namespace bimodal::runner {

/// How often this thread has called operator new since it began.
[[nodiscard]] std::size_t allocations_of_this_thread();

}  // namespace bimodal::runner
