// Logs of the TeamCommunicationMonitor: the packets of the Standard Platform League's teams, as a listener heard them.
//
// A stream of Java's serialisation (version 5), all big endian. Each packet has two parts. The first is a block of 9 bytes:
// the time [ms, u64] and a flag. The second is an object SPLStandardMessagePackage: the team (i32), the sender's address
// (string) and the bytes of the packet. Classes and strings may be references to earlier ones.
//
// A packet is an SPLStandardMessage of version 6 (2015), little endian: "SPL ", u8 version, player, team, fallen. Then
// float32 x, y [mm, team_field], heading, targets x, y of the walk and of the kick. Then float32 age of the ball, its x, y
// [mm, robot] and its velocity. The rest is not used.
// By the league's rules the heading is in radians and the age in seconds. Teams differ, so the importer looks at the whole log:
//
// - A heading beyond half a turn means that all are in degrees.
// - Ages that are all multiples of 30000 count images without the ball: 30 a second. Northern Bites multiplied by 30 and
//   1000 (the known log); their ball was 1 to 5 images older after a packet without it.
// - A negative age means that the ball was never seen.
//
// Each packet of the known log is there twice. The second one is left out.
#pragma once

#include <cstdint>
#include <string_view>

#include "robot/core/result.h"
#include "robot/lab/import/import_sink.h"

namespace robot::lab {

/// Reports whether a file begins as such a log.
bool is_teamcomm_log(std::string_view file_bytes);

/// Passes `team` to `sink`, one message for each packet, with the newest of each sender. The robot of the session is the
/// listener. `received_ns` is `epoch_ns` and the time of the log; `sent_ns` is not known. The packets of the first team
/// count, others are counted in a warning. From a damaged log it imports everything before, and the report names the damage.
/// Returns an Error for another file, or if the sink returns one.
Result<ImportReport> import_teamcomm(std::string_view file_bytes, std::uint64_t epoch_ns, ImportSink& sink);

}  // namespace robot::lab
