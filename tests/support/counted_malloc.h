// tests/support/counted_malloc.h: counts the calls of malloc; to be included by one source of a program.
#pragma once
#include <atomic>
#include <cstdlib>

// `new` and Eigen call malloc, too. Sanitizers have a malloc of their own, which is not counted.
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define PLIANT_OWN_MALLOC
#endif
#endif
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(PLIANT_OWN_MALLOC)
#define PLIANT_COUNTS_MALLOC

inline std::atomic<long> allocations{0};

extern "C" void* __libc_malloc(std::size_t);  // NOLINT: glibc names it
// NOLINTNEXTLINE(misc-definitions-in-headers): one source of a program includes this
extern "C" void* malloc(std::size_t size) noexcept {
  ++allocations;
  return __libc_malloc(size);
}

#endif
