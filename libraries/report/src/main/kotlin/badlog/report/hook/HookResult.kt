package badlog.report.hook

import badlog.core.analysis.Series
import badlog.core.recording.Severity

/**
 * The checked result of a hook for a recording.
 *
 * @property values the named texts and numbers, as texts.
 * @property findings its findings.
 * @property series its lines over the recording's x.
 * @property figures its pictures.
 */
class HookResult internal constructor(
    val values: Map<String, String>,
    val findings: List<HookFinding>,
    val series: List<HookSeries>,
    val figures: List<HookFigure>,
)

/**
 * Something that a hook found.
 *
 * @property time its place, in the unit of the recording's x; NaN if it is about the whole recording.
 * @property until its end; NaN if it is a moment, or about the whole recording.
 */
class HookFinding internal constructor(val severity: Severity, val text: String, val time: Double, val until: Double)

/**
 * A line that a hook calculated.
 *
 * @property unit its unit; empty if it has none.
 * @property data its samples; x never decreases, and y may be NaN.
 */
class HookSeries internal constructor(val name: String, val unit: String, val data: Series)

/**
 * A picture that a hook drew.
 *
 * @property title its heading.
 * @property mediaType `image/svg+xml` or `image/png`.
 * @property bytes the picture. Embed an SVG in a page as an image, not as elements, since it may contain scripts.
 */
class HookFigure internal constructor(val title: String, val mediaType: String, val bytes: ByteArray)
