// tools/run/large_pages.cpp: large arrays on large pages. Meshes are walked at random, and with pages of 4 KiB the
// address translation costs more than the memory itself; first touching them costs the kernel a fault each, too.
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t page = std::size_t{1} << 21;

void* allocate(std::size_t size) noexcept {
  if (size < 2 * page) return std::malloc(size == 0 ? 1 : size);
  const std::size_t whole = (size + page - 1) / page * page;
  void* const memory = whole < size ? nullptr : std::aligned_alloc(page, whole);
  if (memory != nullptr) (void)madvise(memory, whole, MADV_HUGEPAGE);  // a wish: nothing is lost if it is not heard
  return memory;
}

}  // namespace

// The forms that are not replaced here call these.
void* operator new(std::size_t size) {
  for (;;) {
    if (void* const memory = allocate(size)) return memory;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
#endif
