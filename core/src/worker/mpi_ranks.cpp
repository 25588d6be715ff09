// The queues are counters in the memory of rank 0 that all ranks increase by remote access. Where the network cannot do
// that by itself, rank 0 has to lend a hand, and it may be busy paving: a thread of its own calls MPI once in a while.
#include "worker/mpi_ranks.h"

#include <algorithm>
#include <climits>
#include <numeric>

namespace paver {
namespace {

constexpr std::chrono::microseconds shortest_sleep(10), longest_sleep(500);
constexpr std::chrono::milliseconds pump_interval(1);
constexpr int polls_without_sleep = 50;

}  // namespace

MpiRanks::MpiRanks(const Progress& progress, std::size_t most_bytes)
    : progress_(progress), most_bytes_(std::min(most_bytes, static_cast<std::size_t>(INT_MAX))) {
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
  MPI_Comm here = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
  MPI_Comm_size(here, &count_here_);
  MPI_Comm_free(&here);
  MPI_Aint bytes = rank_ == 0 ? windows * static_cast<MPI_Aint>(sizeof(std::int64_t)) : 0;
  MPI_Win_allocate(bytes, sizeof(std::int64_t), MPI_INFO_NULL, MPI_COMM_WORLD, &counters_, &window_);
  if (rank_ == 0) std::fill_n(counters_, windows, 0);
  MPI_Barrier(MPI_COMM_WORLD);
  MPI_Win_lock_all(0, window_);
  if (rank_ == 0 && count_ > 1) thread_ = std::thread([this] { keep_going(); });
}

MpiRanks::~MpiRanks() { stop_thread(); }

void MpiRanks::stop_thread() {
  is_stopping_.store(true);
  if (thread_.joinable()) thread_.join();
}

void MpiRanks::finish() {
  add_up({});  // a barrier: rank 0 must not stop helping while others still take
  stop_thread();
  std::lock_guard lock(mutex_);
  MPI_Win_unlock_all(window_);
  MPI_Win_free(&window_);
}

void MpiRanks::keep_going() {
  while (!is_stopping_.load()) {
    {
      std::lock_guard lock(mutex_);
      if (is_abandoned_) return;
      int is_there = 0;
      MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &is_there, MPI_STATUS_IGNORE);
    }
    std::this_thread::sleep_for(pump_interval);
  }
}

void MpiRanks::wait(MPI_Request& request) {
  auto start = Clock::now();
  auto pause = shortest_sleep;
  for (int polls = 0;; ++polls) {
    {
      std::lock_guard lock(mutex_);
      int is_done = 0;
      MPI_Test(&request, &is_done, MPI_STATUS_IGNORE);
      if (is_done) break;
      if (progress_.is_cancelled()) is_abandoned_ = true;  // MPI still has the caller's memory
      progress_.check();
    }
    if (polls < polls_without_sleep) {
      std::this_thread::yield();
    } else {
      std::this_thread::sleep_for(pause);
      pause = std::min(2 * pause, longest_sleep);
    }
  }
  waited_ += std::chrono::duration<double>(Clock::now() - start).count();
}

/// start(request) begins what is waited for.
template <class Start>
void MpiRanks::complete(Start start) {
  MPI_Request request;
  {
    std::lock_guard lock(mutex_);
    start(&request);
  }
  wait(request);
}

long MpiRanks::take(int queue) {
  std::lock_guard lock(mutex_);
  if (is_abandoned_) progress_.check();
  std::int64_t one = 1, number = 0;
  MPI_Fetch_and_op(&one, &number, MPI_INT64_T, 0, queue, MPI_SUM, window_);
  MPI_Win_flush(0, window_);
  return static_cast<long>(number);
}

template <class T>
void MpiRanks::reduce(std::span<T> values, MPI_Datatype type, MPI_Op operation) {
  progress_.check();
  std::vector<T> mine(values.begin(), values.end());
  if (mine.empty()) mine.push_back(0);
  std::vector<T> all(mine.size());
  for (std::size_t at = 0; at < mine.size(); at += most_bytes_ / sizeof(T)) {
    int part = static_cast<int>(std::min(most_bytes_ / sizeof(T), mine.size() - at));
    complete([&](MPI_Request* request) {
      MPI_Iallreduce(mine.data() + at, all.data() + at, part, type, operation, MPI_COMM_WORLD, request);
    });
  }
  std::copy_n(all.begin(), values.size(), values.begin());
}

void MpiRanks::add_up(std::span<long> values) { reduce(values, MPI_LONG, MPI_SUM); }
void MpiRanks::find_least(std::span<double> values) { reduce(values, MPI_DOUBLE, MPI_MIN); }

void MpiRanks::spread(char* data, std::uint64_t bytes, int root) {
  for (std::uint64_t at = 0; at < bytes; at += most_bytes_) {
    int part = static_cast<int>(std::min<std::uint64_t>(most_bytes_, bytes - at));
    complete([&](MPI_Request* request) { MPI_Ibcast(data + at, part, MPI_CHAR, root, MPI_COMM_WORLD, request); });
  }
}

void MpiRanks::spread(std::string& text) {
  progress_.check();
  std::uint64_t size = text.size();
  spread(reinterpret_cast<char*>(&size), sizeof size, 0);
  text.resize(size);
  spread(text.data(), size, 0);
}

std::vector<std::string> MpiRanks::gather(std::string_view mine) {
  progress_.check();
  auto ranks = static_cast<std::size_t>(count_);
  std::int64_t size = static_cast<std::int64_t>(mine.size());
  std::vector<std::int64_t> sizes(ranks);
  complete([&](MPI_Request* request) {
    MPI_Iallgather(&size, 1, MPI_INT64_T, sizes.data(), 1, MPI_INT64_T, MPI_COMM_WORLD, request);
  });
  std::vector<std::string> all(ranks);
  std::int64_t total = std::accumulate(sizes.begin(), sizes.end(), std::int64_t(0));
  if (total > static_cast<std::int64_t>(most_bytes_)) {
    for (std::size_t r = 0; r < ranks; ++r) {
      if (static_cast<int>(r) == rank_) all[r] = mine;
      all[r].resize(static_cast<std::size_t>(sizes[r]));
      spread(all[r].data(), all[r].size(), static_cast<int>(r));
    }
    return all;
  }
  std::vector<int> counts(sizes.begin(), sizes.end()), starts(ranks, 0);
  std::partial_sum(counts.begin(), counts.end() - 1, starts.begin() + 1);
  std::string joined(static_cast<std::size_t>(total), '\0');
  complete([&](MPI_Request* request) {
    MPI_Iallgatherv(mine.data(), counts[rank_], MPI_CHAR, joined.data(), counts.data(), starts.data(), MPI_CHAR,
                    MPI_COMM_WORLD, request);
  });
  for (std::size_t r = 0; r < ranks; ++r)
    all[r] = joined.substr(static_cast<std::size_t>(starts[r]), static_cast<std::size_t>(counts[r]));
  return all;
}

// In as many rounds as the longest message takes.
std::vector<std::string> MpiRanks::exchange(const std::vector<std::string>& mine) {
  progress_.check();
  const auto ranks = static_cast<std::size_t>(count_);
  std::vector<std::int64_t> mine_sizes(ranks), sizes(ranks);
  for (std::size_t r = 0; r < ranks; ++r) mine_sizes[r] = static_cast<std::int64_t>(mine[r].size());
  complete([&](MPI_Request* request) {
    MPI_Ialltoall(mine_sizes.data(), 1, MPI_INT64_T, sizes.data(), 1, MPI_INT64_T, MPI_COMM_WORLD, request);
  });
  const auto slice = static_cast<std::int64_t>(std::max<std::size_t>(most_bytes_ / ranks, 1));
  double last = -static_cast<double>(*std::ranges::max_element(mine_sizes));
  find_least({&last, 1});
  std::vector<std::string> theirs(ranks);
  for (std::int64_t from = 0; static_cast<double>(from) < -last; from += slice) {
    std::vector<int> mine_counts(ranks), counts(ranks), mine_starts(ranks + 1), starts(ranks + 1);
    std::string sent;
    for (std::size_t r = 0; r < ranks; ++r) {
      mine_counts[r] = static_cast<int>(std::clamp<std::int64_t>(mine_sizes[r] - from, 0, slice));
      counts[r] = static_cast<int>(std::clamp<std::int64_t>(sizes[r] - from, 0, slice));
      if (mine_counts[r] > 0)
        sent.append(mine[r], static_cast<std::size_t>(from), static_cast<std::size_t>(mine_counts[r]));
      mine_starts[r + 1] = mine_starts[r] + mine_counts[r];
      starts[r + 1] = starts[r] + counts[r];
    }
    std::string received(static_cast<std::size_t>(starts[ranks]), '\0');
    complete([&](MPI_Request* request) {
      MPI_Ialltoallv(sent.data(), mine_counts.data(), mine_starts.data(), MPI_CHAR, received.data(), counts.data(),
                     starts.data(), MPI_CHAR, MPI_COMM_WORLD, request);
    });
    for (std::size_t r = 0; r < ranks; ++r)
      theirs[r].append(received, static_cast<std::size_t>(starts[r]), static_cast<std::size_t>(counts[r]));
  }
  return theirs;
}

}  // namespace paver
