package badlog.viewer.choices.range

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.Span
import badlog.core.analysis.StateRuns

/** The range of x in which this line's recording has samples; a single x is widened, see [Viewport.of]. */
val GraphSeries.wholeRange: Span get() = Viewport.of(recorded).full

/** The x until which the last value of this line holds: the end of its recording. Null if its samples are joined by straight lines. */
val GraphSeries.holdsUntil: Double? get() = if (holds) wholeRange.to else null

/** Returns the runs of this line's states; the last one lasts until the end of its recording. */
fun GraphSeries.stateRuns(): StateRuns = StateRuns(data, wholeRange.to)
