// The detection of robots and ball on synthetic images.
#pragma once

namespace bench {

/// Prints a line of JSON for each case, after this many images of it.
void truth_frames(int frames);

}  // namespace bench
