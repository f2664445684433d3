// Uses each header that a team includes once.
#include <foresight.h>
#include <foresight_fields.h>
#include <foresight_parameters.h>
#include <foresight_what_if.h>

int main(void) {
  unsigned char room[16];
  ForesightBytes message = foresight_bytes(room, sizeof room);
  foresight_put_float(&message, 1, 1);
  foresight_put_floats(&message, 2, NULL, 0);
  foresight_put_uint(&message, 3, 1);
  ForesightField field = foresight_fields(message.bytes, message.size);
  while (foresight_next_field(&field))
    if (foresight_float(&field) > 1) return 1;
  const char* strategies[] = {"baseline"};
  ForesightAdviser adviser = foresight_adviser("/nowhere");
  ForesightAdvice advice;
  if (foresight_what_if(&adviser, strategies, 1, 30, 10, &advice)) return 1;
  double height = 0.02;
  ForesightParameters* parameters = foresight_parameters("walk", "/nowhere");
  foresight_add_number(parameters, "height", &height, 0, 0.05, "m", "Height of a foot.");
  if (foresight_poll_parameters(parameters) != 0) return 1;
  foresight_end_parameters(parameters);
  return foresight_now_ns() == 0;
}
