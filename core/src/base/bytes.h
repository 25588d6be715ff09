// Arrays as bytes, to give them to other ranks.
#pragma once

#include <cstring>
#include <string_view>
#include <type_traits>
#include <vector>

namespace paver {

/// The array as it lies in memory; valid as long as `values` stays as it is.
template <class T>
std::string_view bytes_of(const std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

template <class T>
std::vector<T> from_bytes(std::string_view bytes) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::vector<T> values(bytes.size() / sizeof(T));
  if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

}  // namespace paver
