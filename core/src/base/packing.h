// Values as bytes and back, for another process of the same build: no versions, no byte order.
//
// A struct is packed by PAVER_FIELDS, which names its fields: a new one that it does not name fails to compile.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "paver/error.h"

namespace paver {

/// `T` with or without const, for the `fields` templates.
template <class T, class Plain>
concept Is = std::same_as<std::remove_const_t<T>, Plain>;

/// All fields of a struct, in their order.
#define PAVER_FIELDS(Struct, ...)                    \
  template <class A>                                 \
  void fields(A& archive, Is<Struct> auto& packed) { \
    auto& [__VA_ARGS__] = packed;                    \
    archive(__VA_ARGS__);                            \
  }

template <class T>
constexpr bool is_plain = std::is_trivially_copyable_v<T>;

class Packer {
 public:
  template <class... Values>
  void operator()(const Values&... values) {
    (put(values), ...);
  }
  std::string take() { return std::move(bytes_); }

 private:
  template <class T>
  void put(const T& value) {
    if constexpr (is_plain<T>) {
      add(&value, sizeof value);
    } else {
      fields(*this, value);
    }
  }
  template <class T>
  void put(const std::vector<T>& values) {
    put(static_cast<std::uint64_t>(values.size()));
    if constexpr (is_plain<T>) {
      add(values.data(), values.size() * sizeof(T));
    } else {
      for (const T& value : values) put(value);
    }
  }
  void put(const std::string& text) {
    put(static_cast<std::uint64_t>(text.size()));
    add(text.data(), text.size());
  }
  template <class A, class B>
  void put(const std::pair<A, B>& pair) {
    put(pair.first);
    put(pair.second);
  }
  template <class T, std::size_t n>
  void put(const std::array<T, n>& values) {
    for (const T& value : values) put(value);
  }
  template <class T>
  void put(const std::optional<T>& value) {
    put(value.has_value());
    if (value) put(*value);
  }
  void add(const void* data, std::size_t bytes) {
    if (bytes > 0) bytes_.append(static_cast<const char*>(data), bytes);
  }

  std::string bytes_;
};

/// Reads what a Packer made, in the same order. Throws Error{internal} when the bytes end early.
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : left_(bytes) {}
  template <class... Values>
  void operator()(Values&... values) {
    (get(values), ...);
  }
  std::string_view rest() const { return left_; }

 private:
  template <class T>
  void get(T& value) {
    if constexpr (is_plain<T>) {
      std::memcpy(&value, cut(sizeof value), sizeof value);
    } else {
      fields(*this, value);
    }
  }
  template <class T>
  void get(std::vector<T>& values) {
    if constexpr (is_plain<T>) {
      std::uint64_t size = count(sizeof(T));
      values.resize(size);
      if (size > 0) std::memcpy(values.data(), cut(size * sizeof(T)), size * sizeof(T));
    } else {
      values.resize(count(1));
      for (T& value : values) get(value);
    }
  }
  void get(std::string& text) {
    std::uint64_t size = count(1);
    text.assign(cut(size), size);
  }
  template <class A, class B>
  void get(std::pair<A, B>& pair) {
    get(pair.first);
    get(pair.second);
  }
  template <class T, std::size_t n>
  void get(std::array<T, n>& values) {
    for (T& value : values) get(value);
  }
  template <class T>
  void get(std::optional<T>& value) {
    bool is_set = false;
    get(is_set);
    value.reset();
    if (is_set) get(value.emplace());
  }
  /// A number of items of at least `bytes` each that follow.
  std::uint64_t count(std::size_t bytes) {
    std::uint64_t size = 0;
    get(size);
    if (size > left_.size() / bytes) fail();
    return size;
  }
  const char* cut(std::size_t bytes) {
    if (bytes > left_.size()) fail();
    const char* at = left_.data();
    left_.remove_prefix(bytes);
    return at;
  }
  [[noreturn]] static void fail() {
    throw Error(ErrorCode::internal, "Packed data end too early; report it with the model.");
  }

  std::string_view left_;
};

template <class T>
std::string pack(const T& value) {
  Packer packer;
  packer(value);
  return packer.take();
}

template <class T>
T unpack(std::string_view bytes) {
  T value;
  Unpacker unpacker(bytes);
  unpacker(value);
  return value;
}

}  // namespace paver
