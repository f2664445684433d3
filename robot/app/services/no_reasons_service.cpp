// Links a program without the services of reasons: their code would make the programs for robots larger.
#include "robot/app/services/futures_service.h"
#include "robot/app/services/reasons_service.h"

namespace robot::app {

void add_reasons_service(net::Services&, const memory::Channels&, const ReasonsOptions&) {}
void add_futures_service(net::Services&, const memory::Channels&, const FuturesOptions&) {}

}  // namespace robot::app
