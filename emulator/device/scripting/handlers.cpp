// spec/scripting.yaml: running scripts.

#include "device/handlers.hpp"

#include "device/scripting/scripts.hpp"
#include "device/storage/file_system.hpp"

namespace sbgc::emulator {

Reaction handle(RequestContext& context, const msg::RunScript& request, Scripts& scripts,
                const FileSystem& files) {
  std::optional<std::size_t> debug_port;
  switch (request.mode) {
    case msg::ScriptMode::stop:
      if (request.slot >= Scripts::slots) return context.refuse(msg::BoardErrorCode::wrong_params);
      if (scripts.running() == request.slot) scripts.stop();
      return context.confirm();
    case msg::ScriptMode::start: break;
    case msg::ScriptMode::start_debug: debug_port = context.port; break;
    default: return context.refuse(msg::BoardErrorCode::wrong_params);
  }
  const auto refusal = scripts.start(files, request.slot, debug_port, context.now);
  return refusal ? context.refuse(*refusal) : context.confirm();
}

}  // namespace sbgc::emulator
