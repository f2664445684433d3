#include "robot/nao/guardian/link.h"

namespace robot::nao {

const char* sentence_of(Reason reason) {
  switch (reason) {
    case Reason::none: return "";
    case Reason::stopping: return "the guardian ends: the robot sits down first";
    case Reason::head_touched:
      return "the three head sensors were held: the robot is soft until the chest button is pressed";
    case Reason::asked_soft:
      return "a client asked for sit_and_soft: the robot is soft until the chest button is pressed";
    case Reason::fell: return "the robot fell: it is soft until it is upright again";
    case Reason::crashed:
      return "the runtime crashed three times within a minute: the robot sits until the chest button is pressed";
    case Reason::hot: return "a joint is too hot: the robot sits until the joint has cooled";
    case Reason::battery_empty: return "the battery is empty: the robot sits until it is charged";
    case Reason::sensors_missing: return "LoLA's frames cannot be read: the robot holds still, then sits";
    case Reason::runtime_late: return "the runtime sends no orders: the robot holds still, then sits";
    case Reason::runtime_gone: return "there is no runtime: the robot holds still, then sits";
    case Reason::waits_for_button: return "the robot waits for the chest button";
    case Reason::waits_for_game: return "after a restart the robot waits for the GameController or the chest button";
    case Reason::not_upright: return "the robot does not stand up: expected an upright torso";
    case Reason::feet_unloaded: return "the robot does not stand up: expected weight on its feet";
    case Reason::stays_down: return "the robot did not get up in three attempts: it is soft until it is upright again";
    case Reason::warm: return "a joint is warm: the robot moves at half its speed";
    case Reason::battery_low: return "the battery is low: the robot moves at half its speed";
  }
  return "?";
}

const char* name_of(Mode mode) {
  switch (mode) {
    case Mode::unstiff: return "unstiff";
    case Mode::initial: return "initial";
    case Mode::penalised: return "penalised";
    case Mode::playing: return "playing";
  }
  return "?";
}

const char* name_of(Doing doing) {
  switch (doing) {
    case Doing::soft: return "soft";
    case Doing::standing_up: return "standing up";
    case Doing::standing: return "standing";
    case Doing::holding: return "holding";
    case Doing::sitting_down: return "sitting down";
    case Doing::falling: return "falling";
    case Doing::fallen: return "fallen";
    case Doing::getting_up: return "getting up";
  }
  return "?";
}

}  // namespace robot::nao
