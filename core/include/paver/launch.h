// Meshing in several processes (ranks) of this machine, which MPI starts; and the job file that tells them what to do.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "paver/option_table.h"
#include "paver/output.h"
#include "paver/progress.h"
#include "paver/result.h"

namespace paver {

/// One run as data. core/docs/ranks.md lists the keys of the file.
struct Job {
  std::string input;                 ///< CAD file
  std::string name;                  ///< stands for the file in messages and in the report; empty: its path
  std::vector<std::string> labels;   ///< of faces, as read_bytes() takes them
  std::vector<GivenOption> options;  ///< as for read_options(); the number of ranks is not looked for there
  OutputFiles files;
  std::string events;  ///< where rank 0 says how far it is: "-": stdout, a path: that pipe; empty: lines for a terminal
  std::string folder;  ///< temporary folder of the run, for what goes back to the process that asked; empty: none
  bool returns_mesh = false;  ///< the mesh goes back, too, not only the report
};

/// What a job came to.
struct RanksResult {
  MeshResult result;                 ///< the mesh is empty unless Job::returns_mesh
  std::vector<double> busy_seconds;  ///< per rank: its time less what it waited for others
};

/// The text of a job file.
std::string job_text(const Job& job);

/// Throws Error{file_missing} or Error{bad_option} that names the file and what is wrong in it.
Job read_job(const std::string& path);
Job parse_job(const std::string& text, const std::string& path);

/// Runs a job on `ranks` processes and waits for them; Job::events and Job::folder are not used, and where Job::input
/// is empty `content` stands for the file. Temporary folders go whatever happens, also when this process is killed.
/// `progress` follows rank 0; when it is cancelled, all processes end within two seconds. Throws what reading, meshing
/// and writing throw in one process, Error{bad_option} when no mpirun or no paver-worker is found, and
/// Error{out_of_memory} or Error{internal} when a rank ends by a signal.
RanksResult mesh_in_ranks(const Job& job, int ranks, Progress& progress, std::span<const char> content = {});

}  // namespace paver
