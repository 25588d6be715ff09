// Counts who wants silence; the first takes the printers' levels up, the last puts them back.
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <mutex>
#include <utility>
#include <vector>

#include "brep/occt_impl.h"

namespace paver {
namespace {

constexpr auto above_all = static_cast<Message_Gravity>(Message_Fail + 1);

std::mutex mutex;
int living = 0;
std::vector<std::pair<Handle(Message_Printer), Message_Gravity>> saved;

}  // namespace

QuietMessages::QuietMessages() {
  std::lock_guard lock(mutex);
  if (living++ > 0) return;
  for (const Handle(Message_Printer) & printer : Message::DefaultMessenger()->Printers()) {
    saved.emplace_back(printer, printer->GetTraceLevel());
    printer->SetTraceLevel(above_all);
  }
}

QuietMessages::~QuietMessages() {
  std::lock_guard lock(mutex);
  if (--living > 0) return;
  for (auto& [printer, level] : saved) printer->SetTraceLevel(level);
  saved.clear();
}

}  // namespace paver
