#include "job.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <future>
#include <mutex>
#include <set>
#include <string>

namespace py = pybind11;

namespace paver::python {
namespace {

constexpr std::chrono::milliseconds interval(50);

std::mutex jobs_mutex;
std::condition_variable job_ended;
std::set<Progress*> jobs;

/// Listed as long as it lives, for cancel_all_jobs().
class Listed {
 public:
  explicit Listed(Progress& progress) : progress_(progress) {
    std::lock_guard lock(jobs_mutex);
    jobs.insert(&progress_);
  }
  ~Listed() {
    {
      std::lock_guard lock(jobs_mutex);
      jobs.erase(&progress_);
    }
    job_ended.notify_all();
  }
  Listed(const Listed&) = delete;
  Listed& operator=(const Listed&) = delete;

 private:
  Progress& progress_;
};

/// Throws KeyboardInterrupt or what `poll` throws; false when the answer is to stop.
bool ask(const py::object& poll, const char* stage, double fraction) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  return poll.is_none() || !poll(stage, fraction).is(py::bool_(false));
}

/// After at most `interval`.
bool has_ended(const std::future<void>& job) {
  py::gil_scoped_release free;
  return job.wait_for(interval) == std::future_status::ready;
}

}  // namespace

py::str to_python(const std::string& text) {
  PyObject* decoded = PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace");
  if (!decoded) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(decoded);
}

void run_job(const py::object& poll, const std::function<void(Progress&)>& work) {
  if (!ask(poll, stage_name(Stage::read), 0)) throw Error(ErrorCode::cancelled, "Cancelled before the start.");
  std::exception_ptr stopped;  // what ended it from the Python side
  {
    Progress progress;
    Listed listed(progress);
    std::future<void> job = std::async(std::launch::async, [&] {
      try {
        work(progress);
      } catch (...) {
        throw current_error();
      }
    });
    while (!has_ended(job)) {
      if (progress.is_cancelled()) continue;
      try {
        if (!ask(poll, stage_name(progress.stage()), progress.fraction())) progress.cancel();
      } catch (const py::error_already_set&) {
        stopped = std::current_exception();
        progress.cancel();
      }
    }
    if (!stopped) job.get();
  }
  if (stopped) std::rethrow_exception(stopped);
  if (!poll.is_none()) poll(stage_name(Stage::done), 1.0);
}

void cancel_all_jobs() {
  py::gil_scoped_release free;
  std::unique_lock lock(jobs_mutex);
  for (Progress* progress : jobs) progress->cancel();
  job_ended.wait_for(lock, std::chrono::seconds(5), [] { return jobs.empty(); });
}

}  // namespace paver::python
