// Memory of the programs: large arrays lie on large pages where the kernel gives those only to who asks. A mesh touches
// each of its pages once or twice, and the first touch of every small page costs a trap into the kernel: a sixth of
// the time of a run on one thread, and more on several, which wait for one another there.
#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t page = 1 << 21;  // bytes of a large page on x86-64 and on 64-bit Arm

void* allocate(std::size_t size) {
  constexpr std::size_t least = 2 * page;  // an array that has at least one page whole
  if (size < least) return std::malloc(size > 0 ? size : 1);
  void* array = std::aligned_alloc(page, (size + page - 1) / page * page);
  if (array) ::madvise(array, size / page * page, MADV_HUGEPAGE);
  return array;
}

}  // namespace

// As the standard asks: again after each call of the handler, until there is none.
void* operator new(std::size_t size) {
  while (true) {
    if (void* memory = allocate(size)) return memory;
    const std::new_handler handler = std::get_new_handler();
    if (!handler) throw std::bad_alloc();
    handler();
  }
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
