#include "robot/app/rules_field.h"

#include "robot/bridge/to_messages.h"
#include "robot/foresight/foreseer.h"
#include "sim/io/rules.h"

namespace robot::app {

foresight::Field field_of(const std::string& rules) {
  auto loaded = sim::io::load_rules(rules.empty() ? foreseeing::kNewestRules : rules);
  if (!loaded) loaded = sim::io::load_rules(foreseeing::kNewestRules);
  foresight::Field field;
  if (loaded) bridge::to_proto(loaded->field, field);
  return field;
}

}  // namespace robot::app
