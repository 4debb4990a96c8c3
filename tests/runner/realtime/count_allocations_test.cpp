#include "tests/runner/realtime/count_allocations.hpp"

#include <cstdlib>
#include <memory>
#include <new>

#include <gtest/gtest.h>

#if defined(__SANITIZE_ADDRESS__)
// As <sanitizer/allocator_interface.h> says, which g++ does not bring.
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*malloc_hook)(const volatile void*,
                                                                             std::size_t),
                                                         void (*free_hook)(const volatile void*));
#endif

namespace bimodal::runner {

namespace {

thread_local std::size_t allocations = 0;

}  // namespace

std::size_t allocations_of_this_thread() {
  return allocations;
}

TEST(CountAllocations, SeesAnAllocation) {
  const auto before = allocations_of_this_thread();
  const auto number = std::make_unique<int>(1);
  EXPECT_EQ(allocations_of_this_thread(), before + static_cast<std::size_t>(*number));
}

}  // namespace bimodal::runner

#if defined(__SANITIZE_ADDRESS__)

namespace {

void count(const volatile void* /*memory*/, std::size_t /*size*/) {
  ++bimodal::runner::allocations;
}

// The sanitizer has operators of its own, and takes a driver's nothrow new, freed by ours, for a
// mismatch: here it tells of what it gives out.
const int counting =
    __sanitizer_install_malloc_and_free_hooks(count, [](const volatile void* /*memory*/) {});

}  // namespace

#else

// Replaces the operators of the whole test program; all other forms of new and delete call these.
// Not inlined, or the compiler takes malloc and delete for a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++bimodal::runner::allocations;
  void* const memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc{};
  return memory;
}

[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}

[[gnu::noinline]] void operator delete(void* memory, std::size_t /*size*/) noexcept {
  std::free(memory);
}

#endif
