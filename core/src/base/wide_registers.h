// For loops over several numbers side by side, compiled once more for processors with wider registers.
#pragma once

/// Becomes part of its caller, and with it is compiled for the caller's processors.
#define PAVER_IN_PLACE inline __attribute__((always_inline))

#if defined(__x86_64__) && defined(__GNUC__)
#define PAVER_HAS_AVX2 1

namespace paver {

/// Whether this processor has registers of four doubles.
inline bool has_avx2() {
  static const bool has = __builtin_cpu_supports("avx2");
  return has;
}

}  // namespace paver
#endif
