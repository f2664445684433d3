// A behaviour in C that lets foresight choose its strategy: it asks once a second and continues meanwhile.
//
//   ./strategy [SECONDS]
#include <foresight.h>
#include <foresight_what_if.h>
#include <stdio.h>
#include <stdlib.h>

int main(int count, char** words) {
  const uint64_t end_ns = foresight_now_ns() + (uint64_t)(count > 1 ? atoi(words[1]) : 30) * 1000000000u;
  // the names of foresight-robot --strategies; the one that is played now goes first
  const char* strategies[] = {"baseline", "passing", "kick_now"};
  ForesightAdviser adviser = foresight_adviser(NULL);
  ForesightAdvice advice;
  uint64_t asked_ns = 0;
  int answers = 0;
  while (foresight_now_ns() < end_ns) {
    // the behaviour decides here, 30 times a second; neither of these calls waits
    if (foresight_now_ns() - asked_ns > 1000000000u && foresight_ask(&adviser, strategies, 3, 20, 300))
      asked_ns = foresight_now_ns();
    if (foresight_answer(&adviser, &advice)) {
      ++answers;
      printf("%s\n", advice.reason);
      for (int i = 1; advice.change && i < 3; ++i)
        if (strcmp(strategies[i], advice.choice) == 0) {
          const char* played = strategies[0];
          strategies[0] = strategies[i];
          strategies[i] = played;
          advice.change = 0;
        }
    }
    foresight_wait(adviser.forecasts, 33);
  }
  printf("%d answers; plays %s\n", answers, strategies[0]);
  foresight_close(adviser.questions);
  foresight_end(adviser.forecasts);
  return 0;
}
