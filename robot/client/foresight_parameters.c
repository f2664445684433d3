// proto/foresight/live_parameters.proto documents the two objects that this file writes and reads.
#include <foresight_fields.h>
#include <foresight_parameters.h>

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NUMBER = 1, WHOLE, YES_NO, TEXT, CHOICE, BUTTON };  // foresight.LiveParameter.Type
enum { MAX_TEXT_BYTES = 200, MAX_ENCODED_BYTES = 4096, VALUE_BYTES = 300 };

static const uint64_t kLostNs = 100 * 1000 * 1000;      // until the next attempt after a failed announcement
static const uint64_t kUnheardNs = 1000 * 1000 * 1000;  // and after one that the runtime has not answered
static const char kTopic[] = "live_parameters";

typedef struct {
  double number;
  char text[MAX_TEXT_BYTES + 1];
} Value;

typedef struct {
  char* name;
  int type;
  void* variable;
  size_t room;            // of a text's variable [bytes]
  char (*choices)[64];    // copies
  int count;              // of the choices
  double presses;         // of a button, as the runtime counts them; it may know those of a former process
  int heard;              // the runtime has told `presses`
  Value initial;          // the value at the time of adding
  unsigned char* fields;  // all fields of foresight.LiveParameter but the present value, encoded
  size_t size;
} Parameter;

struct ForesightParameters {
  char* name;
  ForesightWriter* announcement;
  ForesightReader* values;
  Parameter* all;
  int count;
  uint64_t announce_at_ns;  // [monotonic] time of the next announcement unless the runtime knows us
  int announced;            // all parameters, at least once
  int known;                // the runtime's newest message shows this process
  char fault[96];           // in our own definitions
  char problem[512];        // in the runtime's newest message
};

static char* copy_of(const char* text) {
  const size_t size = strlen(text) + 1;
  char* copy = malloc(size);
  if (copy) memcpy(copy, text, size);
  return copy;
}

static void copy_bytes(char* to, size_t room, const void* from, size_t size) {
  if (size > room - 1) size = room - 1;
  memcpy(to, from, size);
  to[size] = '\0';
}

static void put_text(ForesightBytes* to, int field, const char* text) {
  if (text && *text) foresight_put_bytes(to, field, text, strlen(text));
}

static void put_number(ForesightBytes* to, int field, double number) {
  if (number != 0) foresight_put_double(to, field, number);
}

ForesightParameters* foresight_parameters(const char* name, const char* door) {
  char topic[160];
  ForesightObject object;
  ForesightParameters* parameters = calloc(1, sizeof *parameters);
  if (!parameters) return NULL;
  snprintf(topic, sizeof topic, "%s/%s", kTopic, name);
  memset(&object, 0, sizeof object);
  object.topic = topic;
  object.type = "foresight.LiveParameters";
  object.message_encoding = "protobuf";
  object.schema_encoding = "protobuf";
  parameters->name = copy_of(name);
  parameters->announcement = foresight_announce_as(&object, door);
  parameters->values = foresight_want_from(kTopic, door);
  if (parameters->name && parameters->announcement && parameters->values) return parameters;
  foresight_end_parameters(parameters);
  return NULL;
}

void foresight_end_parameters(ForesightParameters* parameters) {
  int i;
  if (!parameters) return;
  for (i = 0; i < parameters->count; ++i) {
    free(parameters->all[i].name);
    free(parameters->all[i].choices);
    free(parameters->all[i].fields);
  }
  free(parameters->all);
  free(parameters->name);
  foresight_close(parameters->announcement);
  foresight_end(parameters->values);
  free(parameters);
}

const char* foresight_parameters_problem(const ForesightParameters* parameters) {
  if (parameters->fault[0]) return parameters->fault;
  if (parameters->problem[0]) return parameters->problem;
  if (*foresight_problem(parameters->announcement)) return foresight_problem(parameters->announcement);
  return foresight_reader_problem(parameters->values);
}

// ------------------------------------------------------------------------------------------------------ variables

static Value value_of(const Parameter* parameter) {
  Value value;
  memset(&value, 0, sizeof value);
  switch (parameter->type) {
    case NUMBER: value.number = *(double*)parameter->variable; break;
    case WHOLE:
    case YES_NO: value.number = *(int*)parameter->variable; break;
    case BUTTON: value.number = parameter->presses; break;
    case TEXT: copy_bytes(value.text, sizeof value.text, parameter->variable, strlen(parameter->variable)); break;
    case CHOICE: {
      const int index = *(int*)parameter->variable;
      if (index >= 0 && index < parameter->count)
        copy_bytes(value.text, sizeof value.text, parameter->choices[index], strlen(parameter->choices[index]));
    }
  }
  return value;
}

static int set_int(int* variable, double number) {
  if (!(number >= INT_MIN && number <= INT_MAX) || *variable == (int)number) return 0;
  *variable = (int)number;
  return 1;
}

/// Adds the presses since the last message to the variable. Returns 1 if there were any.
static int take_presses(Parameter* parameter, double presses) {
  const double more = parameter->heard ? presses - parameter->presses : 0;
  parameter->heard = 1;
  parameter->presses = presses;
  return more > 0 && set_int(parameter->variable, *(int*)parameter->variable + more);
}

/// Writes the value into the variable. Returns 1 if it changed.
static int take(Parameter* parameter, const Value* value) {
  int i;
  switch (parameter->type) {
    case NUMBER:
      if (*(double*)parameter->variable == value->number) return 0;
      *(double*)parameter->variable = value->number;
      return 1;
    case WHOLE:
    case YES_NO: return set_int(parameter->variable, value->number);
    case BUTTON: return take_presses(parameter, value->number);
    case TEXT: {
      const Value held = value_of(parameter);
      size_t size = strlen(value->text);
      if (size > parameter->room - 1) size = parameter->room - 1;
      if (strlen(held.text) == size && memcmp(held.text, value->text, size) == 0) return 0;
      copy_bytes(parameter->variable, parameter->room, value->text, size);
      return 1;
    }
    default:
      for (i = 0; i < parameter->count; ++i)
        if (strcmp(parameter->choices[i], value->text) == 0) return set_int(parameter->variable, i);
      return 0;
  }
}

// ---------------------------------------------------------------------------------------------------- definitions

typedef struct {
  double min, max;
  const char* unit;
  const char* description;
  size_t room;
  const char* const* choices;
  int count;
} Definition;

static void add(ForesightParameters* parameters, const char* name, int type, void* variable,
                const Definition* definition) {
  unsigned char room[MAX_ENCODED_BYTES];
  ForesightBytes fields = foresight_bytes(room, sizeof room);
  Parameter added;
  Parameter* grown;
  int i;
  memset(&added, 0, sizeof added);
  added.name = copy_of(name);
  added.type = type;
  added.variable = variable;
  added.room = definition->room;
  added.count = definition->count;
  if (added.count > 0) added.choices = calloc((size_t)added.count, sizeof *added.choices);
  for (i = 0; i < added.count && added.choices; ++i)
    copy_bytes(added.choices[i], sizeof *added.choices, definition->choices[i], strlen(definition->choices[i]));
  if (added.count == 0 || added.choices) added.initial = value_of(&added);

  foresight_put_bytes(&fields, 1, name, strlen(name));
  foresight_put_uint(&fields, 2, (uint64_t)type);
  put_number(&fields, 5, added.initial.number);
  put_text(&fields, 6, added.initial.text);
  put_number(&fields, 7, definition->min);
  put_number(&fields, 8, definition->max);
  put_text(&fields, 9, definition->unit);
  put_text(&fields, 10, definition->description);
  for (i = 0; i < added.count; ++i)
    foresight_put_bytes(&fields, 11, definition->choices[i], strlen(definition->choices[i]));
  added.size = fields.size;
  added.fields = malloc(fields.size);
  grown = realloc(parameters->all, ((size_t)parameters->count + 1) * sizeof *grown);
  if (grown) parameters->all = grown;
  if (grown && added.name && added.fields && (added.count == 0 || added.choices) && !fields.overflow) {
    memcpy(added.fields, fields.bytes, fields.size);
    parameters->all[parameters->count++] = added;
    parameters->announced = 0;
    parameters->announce_at_ns = 0;
    return;
  }
  snprintf(parameters->fault, sizeof parameters->fault, "parameter '%.48s': %s", name,
           fields.overflow ? "its texts are too long" : "out of memory");
  free(added.name);
  free(added.choices);
  free(added.fields);
}

void foresight_add_number(ForesightParameters* parameters, const char* name, double* value, double min, double max,
                          const char* unit, const char* description) {
  Definition definition = {0, 0, NULL, NULL, 0, NULL, 0};
  definition.min = min;
  definition.max = max;
  definition.unit = unit;
  definition.description = description;
  add(parameters, name, NUMBER, value, &definition);
}

void foresight_add_whole(ForesightParameters* parameters, const char* name, int* value, int min, int max,
                         const char* unit, const char* description) {
  Definition definition = {0, 0, NULL, NULL, 0, NULL, 0};
  definition.min = min == 0 && max == 0 ? INT_MIN : min;
  definition.max = min == 0 && max == 0 ? INT_MAX : max;
  definition.unit = unit;
  definition.description = description;
  add(parameters, name, WHOLE, value, &definition);
}

void foresight_add_yes_no(ForesightParameters* parameters, const char* name, int* value, const char* description) {
  Definition definition = {0, 0, NULL, NULL, 0, NULL, 0};
  definition.description = description;
  *value = *value != 0;
  add(parameters, name, YES_NO, value, &definition);
}

void foresight_add_text(ForesightParameters* parameters, const char* name, char* value, size_t room,
                        const char* description) {
  Definition definition = {0, 0, NULL, NULL, 0, NULL, 0};
  definition.description = description;
  definition.room = room;
  add(parameters, name, TEXT, value, &definition);
}

void foresight_add_choice(ForesightParameters* parameters, const char* name, int* value, const char* const* choices,
                          int count, const char* description) {
  Definition definition = {0, 0, NULL, NULL, 0, NULL, 0};
  definition.description = description;
  definition.choices = choices;
  definition.count = count;
  add(parameters, name, CHOICE, value, &definition);
}

void foresight_add_button(ForesightParameters* parameters, const char* name, int* presses, const char* description) {
  Definition definition = {0, 0, NULL, NULL, 0, NULL, 0};
  definition.description = description;
  *presses = 0;
  add(parameters, name, BUTTON, presses, &definition);
}

// ----------------------------------------------------------------------------------------------------------- poll

/// Writes all definitions with the present values. Returns 1 if they were sent.
static int announce(ForesightParameters* parameters) {
  size_t room = 0;
  ForesightBytes message;
  int i, sent = 0;
  for (i = 0; i < parameters->count; ++i) room += parameters->all[i].size + VALUE_BYTES;
  message = foresight_bytes(malloc(room + 1), room);
  if (!message.bytes) return 0;
  for (i = 0; i < parameters->count; ++i) {
    const Parameter* parameter = &parameters->all[i];
    const Value value = value_of(parameter);
    unsigned char value_room[VALUE_BYTES], head[20];
    ForesightBytes present = foresight_bytes(value_room, sizeof value_room);
    size_t head_size = 0;
    put_number(&present, 3, value.number);
    put_text(&present, 4, value.text);
    head[head_size++] = 1 << 3 | 2;
    head_size += foresight_varint(head + head_size, parameter->size + present.size);
    memcpy(message.bytes + message.size, head, head_size);
    memcpy(message.bytes + message.size + head_size, parameter->fields, parameter->size);
    memcpy(message.bytes + message.size + head_size + parameter->size, present.bytes, present.size);
    message.size += head_size + parameter->size + present.size;
  }
  sent = foresight_write(parameters->announcement, foresight_now_ns(), message.bytes, message.size);
  free(message.bytes);
  return sent;
}

/// Returns the name after "PROCESS." if it is one of ours, else NULL.
static const unsigned char* own_part(const ForesightParameters* parameters, const unsigned char* name, size_t* size,
                                     char sign) {
  const size_t own = strlen(parameters->name);
  if (*size <= own || memcmp(name, parameters->name, own) != 0 || name[own] != (unsigned char)sign) return NULL;
  *size -= own + 1;
  return name + own + 1;
}

/// Takes one parameter of the runtime's message. Returns 1 if the variable changed.
static int hear_parameter(ForesightParameters* parameters, const ForesightField* outer) {
  ForesightField field = foresight_fields(outer->bytes, outer->size);
  Value value, initial;
  const unsigned char* name = NULL;
  size_t name_size = 0;
  int i, type = 0, gone = 0;
  memset(&value, 0, sizeof value);
  memset(&initial, 0, sizeof initial);
  while (foresight_next_field(&field)) {
    switch (field.number) {
      case 1:
        name_size = field.size;
        name = own_part(parameters, field.bytes, &name_size, '.');
        if (!name) return 0;
        break;
      case 2: type = (int)field.value; break;
      case 3: value.number = foresight_double(&field); break;
      case 4: copy_bytes(value.text, sizeof value.text, field.bytes, field.size); break;
      case 5: initial.number = foresight_double(&field); break;
      case 6: copy_bytes(initial.text, sizeof initial.text, field.bytes, field.size); break;
      case 12: gone = field.value != 0; break;
      default: break;
    }
  }
  if (!name || gone) return 0;
  parameters->known = 1;
  for (i = 0; i < parameters->count; ++i) {
    Parameter* ours = &parameters->all[i];
    if (strlen(ours->name) != name_size || memcmp(ours->name, name, name_size) != 0) continue;
    // another initial value: this is the answer to a former process's announcement
    if (ours->type != type || ours->initial.number != initial.number || strcmp(ours->initial.text, initial.text) != 0)
      return 0;
    return take(ours, &value);
  }
  return 0;
}

/// Takes the runtime's message. Returns the number of variables that changed.
static int hear(ForesightParameters* parameters, const ForesightMessage* message) {
  ForesightField field = foresight_fields(message->bytes, message->size);
  int changed = 0;
  const int was_known = parameters->known;
  parameters->known = 0;
  parameters->problem[0] = '\0';
  while (foresight_next_field(&field)) {
    if (field.number == 1) changed += hear_parameter(parameters, &field);
    if (field.number == 2) {
      size_t size = field.size;
      const unsigned char* sentence = own_part(parameters, field.bytes, &size, ':');
      if (!sentence) continue;
      parameters->known = 1;
      snprintf(parameters->problem, sizeof parameters->problem, "the runtime refuses:%.*s", (int)size,
               (const char*)sentence);
    }
  }
  if (was_known && !parameters->known) parameters->announce_at_ns = 0;
  return changed;
}

int foresight_poll_parameters(ForesightParameters* parameters) {
  int changed = 0;
  ForesightMessage message;
  uint64_t now_ns;
  if (foresight_read_newest(parameters->values, &message)) changed = hear(parameters, &message);
  now_ns = foresight_now_ns();
  // the runtime may still know a former process of this name, so the first announcement does not depend on it
  if ((parameters->known && parameters->announced) || now_ns < parameters->announce_at_ns || parameters->count == 0)
    return changed;
  parameters->announced = announce(parameters);
  parameters->announce_at_ns = now_ns + (parameters->announced ? kUnheardNs : kLostNs);
  return changed;
}
