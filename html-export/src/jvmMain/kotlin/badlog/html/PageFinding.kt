package badlog.html

import badlog.analysis.Span
import badlog.recording.Severity

/**
 * Something that was found in a recording, which its page lists and marks.
 *
 * @property source what found it: the name of a rule or a hook.
 * @property severity how much it matters.
 * @property text what was found, as a sentence.
 * @property time where, in the unit of the recording's x axis; NaN when it is about the whole.
 * @property until where it ends, not before [time]; NaN when it is a moment or about the whole.
 * @property further where else it was found; marked, but not listed by themselves.
 */
class PageFinding(
    val source: String,
    val severity: Severity,
    val text: String,
    val time: Double,
    val until: Double,
    val further: List<Span> = emptyList(),
)
