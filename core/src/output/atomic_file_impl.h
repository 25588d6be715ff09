// A file that appears whole or not at all, written by one process or by several ranks at the same time.
#pragma once

#include <string>

#include "output/byte_sink_impl.h"
#include "paver/progress.h"
#include "paver/ranks.h"

namespace paver {

/// "Cannot write 'PATH': REASON; what to do."
[[noreturn]] void fail_to_write(const std::string& path, int error_number);

/// What is written goes to places of a file.
class PlacedSink : public ByteSink {
 public:
  void seek(long offset) override {
    if (offset == at_ + static_cast<long>(waiting())) return;
    flush();
    at_ = offset;
  }

 protected:
  using ByteSink::ByteSink;

 private:
  virtual void write_at(const char* data, std::size_t bytes, long offset) const = 0;
  void drain(const char* data, std::size_t bytes) override {
    write_at(data, bytes, at_);
    at_ += static_cast<long>(bytes);
  }

  long at_ = 0;  // where what waits belongs
};

/// Written under a temporary name beside its path. Destroyed before commit(): removed. Every failure throws
/// Error{unwritable_output} with the path and the reason. `progress` (may be null) is checked for cancel while writing.
class AtomicFile : public PlacedSink {
 public:
  /// By this process alone.
  explicit AtomicFile(const std::string& path, const Progress* progress = nullptr);
  /// Collective. Rank 0 creates the file in its final size, which finds a full disk early; each rank then writes its
  /// pieces. `bytes`: the whole size; 0: not known. The file system must be one that all ranks see. An Error is the
  /// same on all ranks.
  AtomicFile(const std::string& path, long bytes, const Progress* progress, Ranks& ranks);
  ~AtomicFile() override;
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// From any thread, beside what goes on here.
  void write_at(const char* data, std::size_t bytes, long offset) const override;
  /// Makes what this rank has written safe on disk. Not collective.
  void finish();
  /// Gives the file its name; rank 0 calls it once all ranks have finished.
  void commit();
  /// Puts back what had that name before; where the file system cannot keep it, the new file stays. Never throws.
  void undo();

 private:
  AtomicFile(const Progress* progress, const std::string& path);
  void create(long bytes);

  std::string path_, target_, temporary_, earlier_;
  const Progress* progress_;
  int descriptor_ = -1;
  bool is_created_ = false;   // here, and has not got its name yet
  bool is_new_ = false;       // has its name, which no file had before
  bool has_earlier_ = false;  // what had its name is kept as `earlier_` until this is destroyed
};

/// What a thread by itself writes at places of a file.
class FilePiece : public PlacedSink {
 public:
  explicit FilePiece(const AtomicFile& file) : PlacedSink(std::size_t{1} << 18), file_(file) {}
  /// The last call.
  void finish() { flush(); }

 private:
  void write_at(const char* data, std::size_t bytes, long offset) const override {
    file_.write_at(data, bytes, offset);
  }

  const AtomicFile& file_;
};

}  // namespace paver
