package badlog.report.hook

import badlog.analysis.Series
import badlog.recording.Severity

/**
 * What a hook returned about a recording, checked.
 *
 * @property values names with texts or numbers, as texts.
 * @property findings what it found.
 * @property series lines over the recording's x.
 * @property figures pictures.
 */
public class HookResult internal constructor(
    public val values: Map<String, String>,
    public val findings: List<HookFinding>,
    public val series: List<HookSeries>,
    public val figures: List<HookFigure>,
)

/**
 * Something that a hook found.
 *
 * @property time its place, in the unit of the recording's x; NaN if it is about the whole recording.
 * @property until where it ends; NaN if it is a moment, or about the whole recording.
 */
public class HookFinding internal constructor(
    public val severity: Severity,
    public val text: String,
    public val time: Double,
    public val until: Double,
)

/**
 * A line that a hook calculated.
 *
 * @property unit its unit; empty if it has none.
 * @property data its samples; x never decreases, and y may be NaN.
 */
public class HookSeries internal constructor(public val name: String, public val unit: String, public val data: Series)

/**
 * A picture that a hook drew.
 *
 * @property title its heading.
 * @property mediaType `image/svg+xml` or `image/png`.
 * @property bytes the picture. Embed an SVG in a page as an image, not as elements, since it may contain scripts.
 */
public class HookFigure internal constructor(public val title: String, public val mediaType: String, public val bytes: ByteArray)
