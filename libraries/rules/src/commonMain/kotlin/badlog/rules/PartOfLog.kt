package badlog.rules

import badlog.recording.Recording
import badlog.recording.Value

/** What the value is called in which a log says that it is a part of another one. */
public const val PART_VALUE: String = "Part"

/** Whether this is a part that was cut out of a log, so that neither its begin nor its end was that of a run. */
internal val Recording.isPart: Boolean get() = values.any { it.name == PART_VALUE }

/** These values of a log, and that it is the part of it that [text] names, such as `90 s to 98.5 s`. */
public fun List<Value>.ofPart(text: String): List<Value> = filter { it.name != PART_VALUE } + Value(PART_VALUE, text)
