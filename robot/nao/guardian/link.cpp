#include "robot/nao/guardian/link.h"

namespace robot::nao {

const char* sentence_of(Reason reason) {
  switch (reason) {
    case Reason::none: return "";
    case Reason::stopping: return "the guardian was told to end: it sits down first";
    case Reason::head_touched: return "the three head sensors were held: it is soft until the chest button is pressed";
    case Reason::asked_soft: return "it was told to be soft, until the chest button is pressed";
    case Reason::fell: return "it fell: it is soft until it is upright again";
    case Reason::crashed:
      return "the runtime crashed three times within a minute: it stays seated until the chest button is pressed";
    case Reason::hot: return "a joint is too hot: it sits until that has cooled";
    case Reason::battery_empty: return "the battery is empty: it sits until it is charged";
    case Reason::sensors_missing: return "LoLA's frames cannot be read: it holds still, then sits";
    case Reason::runtime_late: return "the runtime says nothing: it holds still, then sits";
    case Reason::runtime_gone: return "there is no runtime: it holds still, then sits";
    case Reason::waits_for_button: return "it waits for the chest button";
    case Reason::waits_for_game: return "after a restart it waits for the GameController, or the chest button";
    case Reason::not_upright: return "it does not stand up: expected the torso upright";
    case Reason::feet_unloaded: return "it does not stand up: expected weight on its feet";
    case Reason::warm: return "a joint is warm: it moves at half the speed";
    case Reason::battery_low: return "the battery is low: it moves at half the speed";
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
  }
  return "?";
}

}  // namespace robot::nao
