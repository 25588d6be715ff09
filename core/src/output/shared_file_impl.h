// One file that several ranks write at the same time, whole or not at all.
#pragma once

#include <functional>
#include <string>

#include "output/byte_sink_impl.h"
#include "paver/progress.h"
#include "paver/ranks.h"

namespace paver {

/// Collective: calls `work`, and when it throws an Error on any rank, all ranks throw that of the lowest such rank. So
/// no rank waits for one that has given up. `work` itself must call nothing collective.
void do_together(Ranks& ranks, const std::function<void()>& work);

/// Rank 0 creates the file under a temporary name in its final size, which finds a full disk early; each rank then
/// writes its pieces. The file system must be one that all ranks see. Destroyed before commit(): removed.
/// Every failure is Error{unwritable_output} with the path and the reason, the same on all ranks.
class SharedFile : public ByteSink {
 public:
  /// Collective. `bytes`: the whole size. `progress` is checked for cancel while writing.
  SharedFile(const std::string& path, long bytes, const Progress& progress, Ranks& ranks);
  ~SharedFile() override;
  SharedFile(const SharedFile&) = delete;
  SharedFile& operator=(const SharedFile&) = delete;

  /// What is written from now on goes to `offset` and behind it.
  void seek(long offset);
  /// Makes the part of this rank safe on disk. Not collective.
  void finish();
  /// Gives the file its name; rank 0 calls it once all ranks have finished.
  void commit();

 private:
  void create(long bytes);
  void drain(const char* data, std::size_t bytes) override;

  std::string path_, target_, temporary_;
  const Progress& progress_;
  const bool is_first_;
  int descriptor_ = -1;
  bool is_created_ = false;
  long at_ = 0;  // where what waits belongs
};

}  // namespace paver
