#include "support/thread_ranks.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <thread>

#include "base/packing.h"

namespace paver::test {
namespace {

class ThreadRank : public Ranks {
 public:
  ThreadRank(Meeting& meeting, int rank) : meeting_(meeting), rank_(rank) {}

  int rank() const override { return rank_; }
  int count() const override { return meeting_.count(); }
  std::vector<std::string> gather(std::string_view mine) override { return meeting_.exchange(rank_, "gather", mine); }
  std::vector<std::string> exchange(const std::vector<std::string>& mine) override {
    std::vector<std::string> theirs;
    for (const std::string& all : meeting_.exchange(rank_, "exchange", pack(mine)))
      theirs.push_back(unpack<std::vector<std::string>>(all)[static_cast<std::size_t>(rank_)]);
    return theirs;
  }
  void add_up(std::span<long> values) override { reduce("add_up", values, std::plus<>()); }
  void find_least(std::span<double> values) override {
    reduce("find_least", values, [](double a, double b) { return std::min(a, b); });
  }
  long take(int queue) override { return meeting_.take(queue); }

 private:
  template <class T, class Operation>
  void reduce(const std::string& name, std::span<T> values, Operation operation) {
    const std::string mine(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    const std::vector<std::string> all = meeting_.exchange(rank_, name + " " + std::to_string(values.size()), mine);
    std::vector<T> theirs(values.size());
    for (std::size_t rank = 0; rank < all.size(); ++rank) {
      if (!theirs.empty()) std::memcpy(theirs.data(), all[rank].data(), all[rank].size());
      for (std::size_t i = 0; i < theirs.size(); ++i) values[i] = rank ? operation(values[i], theirs[i]) : theirs[i];
    }
  }

  Meeting& meeting_;
  const int rank_;
};

bool is_released(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const Released&) {
    return true;
  } catch (...) {
    return false;
  }
}

}  // namespace

std::vector<std::string> Meeting::exchange(int rank, const std::string& name, std::string_view mine) {
  std::unique_lock lock(mutex_);
  if (waiting_ == 0) name_ = name;
  if (name != name_) is_mismatched_ = true;
  given_[static_cast<std::size_t>(rank)] = mine;
  wait_for_all(lock);
  std::vector<std::string> all = given_;
  wait_for_all(lock);  // no one gives the next before all have this
  return all;
}

void Meeting::wait_for_all(std::unique_lock<std::mutex>& lock) {
  long round = round_;
  if (++waiting_ == count_) {
    waiting_ = 0;
    ++round_;
    changed_.notify_all();
  }
  is_mismatched_ = is_mismatched_ || (left_ > 0 && !is_broken_);
  if (is_mismatched_) changed_.notify_all();
  changed_.wait(lock, [&] { return round_ != round || is_broken_ || is_mismatched_; });
  if (is_mismatched_) throw std::logic_error("ranks differ in their collective calls");
  if (round_ == round) throw Released();
}

void Meeting::leave(bool has_failed) {
  std::lock_guard lock(mutex_);
  ++left_;
  is_broken_ = is_broken_ || has_failed;
  if (!has_failed && waiting_ > 0 && !is_broken_) is_mismatched_ = true;
  changed_.notify_all();
}

void run_on_ranks(int count, const std::function<void(Ranks&)>& task) {
  Meeting meeting(count);
  std::vector<std::exception_ptr> thrown(static_cast<std::size_t>(count));
  std::vector<std::thread> threads;
  for (int rank = 0; rank < count; ++rank) {
    threads.emplace_back([&, rank] {
      ThreadRank ranks(meeting, rank);
      std::exception_ptr& own = thrown[static_cast<std::size_t>(rank)];
      try {
        task(ranks);
      } catch (...) {
        own = std::current_exception();
      }
      meeting.leave(own != nullptr);
    });
  }
  for (std::thread& thread : threads) thread.join();
  std::exception_ptr first;
  for (const std::exception_ptr& e : thrown) {
    if (e && (!first || (is_released(first) && !is_released(e)))) first = e;
  }
  if (first) std::rethrow_exception(first);
}

}  // namespace paver::test
