package badlog.cli.output

import badlog.cli.topic.part
import badlog.recording.Recording
import badlog.wpilog.WpilogWriter

/** Writes the rows [runs] of [recording], or all samples of one without rows, as a WPILOG; returns what that cannot carry. */
internal fun writeSamples(
    recording: Recording,
    runs: List<IntRange>,
    changesOnly: Boolean,
    progress: (done: Long, total: Long) -> Unit,
    sink: (ByteArray, Int) -> Unit,
): LeftOut = LeftOut(omissions = WpilogWriter(recording.part(runs), changesOnly).write(progress, sink))
