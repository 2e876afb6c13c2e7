package badlog.rules

import badlog.core.recording.Recording
import badlog.core.recording.Value

/** The name of the value that marks a log as part of another one. */
const val PART_VALUE: String = "Part"

/** Whether this is a part that was cut out of a log, so that its start and end are not those of a run. */
internal val Recording.isPart: Boolean get() = values.any { it.name == PART_VALUE }

/** Returns these values of a log, plus one that marks it as the part [text], such as `90 s to 98.5 s`. */
fun List<Value>.ofPart(text: String): List<Value> = filter { it.name != PART_VALUE } + Value(PART_VALUE, text)
