#pragma once

namespace bimodal::runner {

/// Handlers of the alternatives of a variant, for std::visit.
template <typename... Handlers>
struct Match : Handlers... {
  using Handlers::operator()...;
};

template <typename... Handlers>
Match(Handlers...) -> Match<Handlers...>;  // needed by clang 14, and so by clang-tidy 14

}  // namespace bimodal::runner
