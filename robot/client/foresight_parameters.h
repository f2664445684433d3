// Live parameters: people change them in the viewer while this process runs. Together with foresight.h.
//
//   double step_height = 0.02;                                                    // from your own file
//   ForesightParameters* walk = foresight_parameters("walk", NULL);               // once
//   foresight_add_number(walk, "step_height", &step_height, 0, 0.05, "m", "Height of a foot over the ground.");
//
//   foresight_poll_parameters(walk);                                              // in every cycle
//
// A poll never waits. It writes the values that people set into your variables, and nothing else writes them. The
// runtime checks type, range and choices before, so a variable always holds a value that you announced as allowed.
//
// A value that was set is kept while this process or the runtime lives. The runtime hands it to a process that starts
// again, and this process hands it to a runtime that starts again. If both end, your own file counts again; people can
// save the values as a file in the viewer. During a game nobody sets values from another machine (match mode).
//
// Limits: 256 parameters of all processes; the name of a process has at most 32 letters, digits, '_' and '-', that of a
// parameter 48 with '.' too; a unit 16 bytes, a description and a text 200; 32 choices of at most 48 bytes. A parameter
// beyond a limit is refused, the others are taken; foresight_parameters_problem() gives the reason.
//
// One thread uses one ForesightParameters. One process at a time has a name such as "walk".
#ifndef FORESIGHT_PARAMETERS_H
#define FORESIGHT_PARAMETERS_H

#include <foresight.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct ForesightParameters ForesightParameters;

/// Makes the parameters of the process `name`, with the door at `door`; NULL: the door of foresight_announce(). Returns
/// NULL only if out of memory.
ForesightParameters* foresight_parameters(const char* name, const char* door);

/// Adds a parameter. `value` points to its variable, which holds the value from your file and outlives `parameters`.
/// Numbers lie between `min` and `max`, both included; both 0: no range; an infinite one: no limit. All texts are copied.
/// `unit` may be "". Add all parameters before the first poll; a parameter that is added later is announced then.
void foresight_add_number(ForesightParameters* parameters, const char* name, double* value, double min, double max,
                          const char* unit, const char* description);
void foresight_add_whole(ForesightParameters* parameters, const char* name, int* value, int min, int max,
                         const char* unit, const char* description);

/// `value` is 1 for yes and 0 for no.
void foresight_add_yes_no(ForesightParameters* parameters, const char* name, int* value, const char* description);

/// `value` has room for `room` bytes with the final zero. A longer text is cut off there.
void foresight_add_text(ForesightParameters* parameters, const char* name, char* value, size_t room,
                        const char* description);

/// `value` is the index of the choice among `choices`.
void foresight_add_choice(ForesightParameters* parameters, const char* name, int* value, const char* const* choices,
                          int count, const char* description);

/// A button. `presses` counts how often it was pressed since this call.
void foresight_add_button(ForesightParameters* parameters, const char* name, int* presses, const char* description);

/// Takes the values that people set into the variables, and announces the parameters where needed. Returns the number of
/// variables that changed.
int foresight_poll_parameters(ForesightParameters* parameters);

/// Returns the reason why the runtime refused a parameter or cannot be reached, in one sentence; "" if all is well.
const char* foresight_parameters_problem(const ForesightParameters* parameters);

/// Closes the connections and frees `parameters`. Viewers then show the parameters as gone.
void foresight_end_parameters(ForesightParameters* parameters);

#ifdef __cplusplus
}
#endif

#endif
