#include "sundrape/app/executor.hpp"

#include "dask_executor.hpp"
#include "local_executor.hpp"
#include "slurm_executor.hpp"

namespace sundrape {

std::unique_ptr<Executor> make_executor(const ExecutorOptions& options, const std::filesystem::path& folder) {
  switch (options.kind) {
    case ExecutorKind::slurm:
      return std::make_unique<SlurmExecutor>(options, folder);
    case ExecutorKind::dask:
      return std::make_unique<DaskExecutor>(options, folder);
    case ExecutorKind::local:
      break;
  }
  return std::make_unique<LocalExecutor>(options.jobs);
}

}  // namespace sundrape
