// Where writers put their bytes: a file or memory.
#pragma once

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace paver {

/// Collects what is written, often few bytes at a time, and hands it on in large pieces.
class ByteSink {
 public:
  virtual ~ByteSink() = default;
  ByteSink(const ByteSink&) = delete;
  ByteSink& operator=(const ByteSink&) = delete;

  void write(const void* data, std::size_t bytes) {
    if (bytes > buffer_.size() - used_) return write_on(static_cast<const char*>(data), bytes);
    std::memcpy(buffer_.data() + used_, data, bytes);
    used_ += bytes;
  }
  void write(std::string_view text) {
    if (!text.empty()) write(text.data(), text.size());
  }
  /// As it lies in memory.
  template <class T>
  void write_packed(T value) {
    write(&value, sizeof value);
  }
  /// What is written from now on belongs at `offset` and behind it. A sink without places takes all as it comes.
  virtual void seek([[maybe_unused]] long offset) {}

 protected:
  explicit ByteSink(std::size_t capacity) : buffer_(capacity) {}
  std::size_t waiting() const { return used_; }
  void flush() {
    drain(buffer_.data(), used_);
    used_ = 0;
  }
  /// Takes the bytes.
  virtual void drain(const char* data, std::size_t bytes) = 0;

 private:
  void write_on(const char* data, std::size_t bytes) {
    while (bytes > 0) {
      std::size_t part = std::min(bytes, buffer_.size() - used_);
      std::memcpy(buffer_.data() + used_, data, part);
      used_ += part;
      data += part;
      bytes -= part;
      if (used_ == buffer_.size()) flush();
    }
  }

  std::vector<char> buffer_;
  std::size_t used_ = 0;
};

class MemorySink : public ByteSink {
 public:
  MemorySink() : ByteSink(4096) {}
  /// All that was written so far.
  const std::string& content() {
    flush();
    return content_;
  }

 private:
  void drain(const char* data, std::size_t bytes) override { content_.append(data, bytes); }

  std::string content_;
};

}  // namespace paver
