// Where writers put their bytes: a file, a shared file or memory.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace paver {

class ByteSink {
 public:
  virtual ~ByteSink() = default;
  virtual void write(const void* data, std::size_t bytes) = 0;

  void write(std::string_view text) { write(text.data(), text.size()); }
  /// As it lies in memory.
  template <class T>
  void write_packed(T value) {
    write(&value, sizeof value);
  }
};

class MemorySink : public ByteSink {
 public:
  using ByteSink::write;
  void write(const void* data, std::size_t bytes) override { content.append(static_cast<const char*>(data), bytes); }

  std::string content;
};

}  // namespace paver
