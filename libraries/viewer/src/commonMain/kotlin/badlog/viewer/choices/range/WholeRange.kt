package badlog.viewer.choices.range

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.Span
import badlog.core.analysis.StateRuns

/** All of x in which the recording of this line has samples; wider than that where there is a single x, see [Viewport.of]. */
val GraphSeries.wholeRange: Span get() = Viewport.of(recorded).full

/** Until where the last value of this line holds: the end of its recording; null if its samples are joined by straight lines. */
val GraphSeries.holdsUntil: Double? get() = if (holds) wholeRange.to else null

/** Returns the runs of this line's states; the last one lasts until the end of its recording. */
fun GraphSeries.stateRuns(): StateRuns = StateRuns(data, wholeRange.to)
