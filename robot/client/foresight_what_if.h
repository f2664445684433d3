// Questions of a team's own behaviour to foresight: which of these strategies is best
// from now on? C99, with foresight.h.
//
//   ForesightAdviser adviser = foresight_adviser(NULL);                          // once
//   ForesightAdvice advice;
//   if (foresight_what_if(&adviser, names, 2, 30, 200, &advice))                 // waits 200 ms, or:
//     play(advice.choice);
//
//   foresight_ask(&adviser, names, 2, 30, 200);                                  // returns at once
//   if (foresight_answer(&adviser, &advice)) play(advice.choice);                // in a later cycle
//
// The runtime needs the objects pose, ball and game of the robot, and the names of the strategies (--strategies). One
// thread uses one adviser.
#ifndef FORESIGHT_WHAT_IF_H
#define FORESIGHT_WHAT_IF_H

#include <foresight.h>
#include <foresight_fields.h>
#include <string.h>

/// A connection for questions and their answers.
typedef struct {
  ForesightWriter* questions;
  ForesightReader* forecasts;
  uint64_t asked;  // number of the last question; 0: none yet
} ForesightAdviser;

/// The advice of a forecast. All figures are in the object `forecast` (proto/foresight/forecast.proto).
typedef struct {
  int known;         // 0: no forecast, or too little processor time for one; see `reason`
  int change;        // 1: another strategy than the first is better, with the required certainty
  char choice[64];   // the strategy to play: the first one unless `change`
  char reason[320];  // one sentence
} ForesightAdvice;

/// Makes an adviser with the door at `door`; NULL: the default door of this user's runtime.
static inline ForesightAdviser foresight_adviser(const char* door) {
  ForesightObject object;
  ForesightAdviser adviser;
  memset(&object, 0, sizeof object);
  object.topic = "what_if";
  object.type = "foresight.WhatIf";
  object.message_encoding = "protobuf";
  object.schema_encoding = "protobuf";
  object.delivery = FORESIGHT_RELIABLE;
  adviser.questions = foresight_announce_as(&object, door);
  adviser.forecasts = foresight_want_from("forecast", door);
  adviser.asked = 0;
  return adviser;
}

/// Asks which of `strategies` is best; the first is the one that is played now. Foresight looks `horizon` [s] ahead and
/// answers after `budget_ms`. Returns 1 if the question was sent.
static inline int foresight_ask(ForesightAdviser* adviser, const char* const* strategies, int count, float horizon,
                                unsigned budget_ms) {
  unsigned char room[1024];
  ForesightBytes question = foresight_bytes(room, sizeof room);
  int i;
  adviser->asked = foresight_now_ns();
  foresight_put_uint(&question, 1, adviser->asked);
  for (i = 0; i < count; ++i) foresight_put_bytes(&question, 2, strategies[i], strlen(strategies[i]));
  foresight_put_float(&question, 6, horizon);
  foresight_put_uint(&question, 7, budget_ms);
  return !question.overflow && foresight_write(adviser->questions, adviser->asked, question.bytes, question.size);
}

static inline void foresight_copy_text(char* to, size_t room, const ForesightField* field) {
  const size_t size = field->size < room - 1 ? field->size : room - 1;
  memcpy(to, field->bytes, size);
  to[size] = '\0';
}

/// Reads a forecast into `advice` and returns the number of the question that it answers.
static inline uint64_t foresight_read_forecast(const ForesightMessage* message, ForesightAdvice* advice) {
  uint64_t id = 0;
  ForesightField field = foresight_fields(message->bytes, message->size);
  memset(advice, 0, sizeof *advice);
  while (foresight_next_field(&field)) {
    if (field.number == 1) {
      ForesightField asked = foresight_fields(field.bytes, field.size);
      while (foresight_next_field(&asked))
        if (asked.number == 1) id = asked.value;
    }
    if (field.number == 3) {
      advice->known = field.value != 0;
      advice->change = field.value == 2;
    }
    if (field.number == 4) foresight_copy_text(advice->choice, sizeof advice->choice, &field);
    if (field.number == 5) foresight_copy_text(advice->reason, sizeof advice->reason, &field);
  }
  return id;
}

/// Reads the answer to the last question. Returns 0 if it has not come yet. Never waits.
static inline int foresight_answer(ForesightAdviser* adviser, ForesightAdvice* advice) {
  ForesightMessage message;
  while (foresight_read(adviser->forecasts, &message))
    if (foresight_read_forecast(&message, advice) == adviser->asked && adviser->asked != 0) return 1;
  return 0;
}

/// Returns the time from `now_ns` to `late_ns` [ms], rounded up: 0 if that has passed, and at most a minute.
static inline int foresight_ms_until(uint64_t late_ns, uint64_t now_ns) {
  const uint64_t left_ns = late_ns > now_ns ? late_ns - now_ns : 0;
  const uint64_t left_ms = left_ns / 1000000 + (left_ns % 1000000 != 0);
  return left_ms < 60000 ? (int)left_ms : 60000;
}

/// Asks and waits for the answer, at most 100 ms longer than the budget. Returns 0 if none came.
static inline int foresight_what_if(ForesightAdviser* adviser, const char* const* strategies, int count, float horizon,
                                    unsigned budget_ms, ForesightAdvice* advice) {
  const uint64_t late_ns = foresight_now_ns() + ((uint64_t)budget_ms + 100) * 1000000;
  foresight_answer(adviser, advice);  // discards earlier answers, and connects
  if (!foresight_ask(adviser, strategies, count, horizon, budget_ms)) return 0;
  for (;;) {
    // the clock is read once: between two reads this thread may wait long for the processor
    const int left_ms = foresight_ms_until(late_ns, foresight_now_ns());
    if (foresight_answer(adviser, advice)) return 1;
    if (left_ms == 0) return 0;
    foresight_wait(adviser->forecasts, left_ms);
  }
}

#endif
