// Libraries that must be refused, each for its own reason.
#include <foresight_behaviour.h>

#ifndef NO_ENTRY

static void* create(const ForesightPlayer* player) { return (void*)player; }
static void destroy(void* self) { (void)self; }
static void decide(void* self, const ForesightMoment* moment, ForesightCommand* command) {
  (void)self, (void)moment, (void)command;
}
static size_t save(const void* self, void* bytes, size_t room) { return (void)self, (void)bytes, (void)room, 0; }

const ForesightBehaviour* foresight_behaviour(void) {
  static ForesightBehaviour behaviour = {FORESIGHT_BEHAVIOUR_HEAD, "wrong", create, destroy, decide, NULL, NULL};
#ifdef OLD_VERSION
  behaviour.version = 0;
#endif
#ifdef OTHER_SIZE
  behaviour.moment_bytes = 12;
#endif
#ifdef NO_DECIDE
  behaviour.decide = NULL;
#endif
#ifdef SAVE_ALONE
  behaviour.save = save;
#endif
  (void)save;
  return &behaviour;
}

#else
typedef int nothing;
#endif
