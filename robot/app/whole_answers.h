// The answers of `GET /api/whole/…` about the whole of the played recording.
#pragma once

#include "robot/lab/whole/whole_recording.h"
#include "robot/net/serve/backend.h"

namespace robot::app {

/// Answers in JSON. Times are capture times [ns since the epoch] as texts. A wrong request gets one sentence with status
/// 400. Called by any thread; ends early when the client has left.
///
///   /api/whole/events                        {"events": [{"at", "kind", "text", "robot"}], "full", "damages"}
///   /api/whole/numbers?fields=/14/2/ball.x /14/2/pose.y&from=&to=&intervals=800
///                                            {"from", "step_ns", "damages", "fields": [{"field", "least": [], "most": [],
///                                            "mean": []}]}; null: no value in this interval; "problem" instead of the
///                                            lists: a sentence that says why the field has none. Without from and to:
///                                            the whole recording. The first interval begins at or before `from`
///   /api/whole/runs?topic=/14/2/decision&fields=skill role
///                                            {"from", "words": [], "full", "runs": [[begin, length, word, word]]};
///                                            begin in ns after "from", length in ns, words as indices
net::HttpResponse whole_answer(lab::WholeRecording& recording, const net::Target& target, const net::ClientLeft& left);

}  // namespace robot::app
