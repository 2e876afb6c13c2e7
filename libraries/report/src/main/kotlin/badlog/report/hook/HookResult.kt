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
 * @property time where, in the unit of the recording's x; NaN when it is about the whole.
 * @property until where it ends; NaN when it is a moment or about the whole.
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
 * @property unit empty when it has none.
 * @property data its samples; x never goes back, a y may be NaN.
 */
public class HookSeries internal constructor(public val name: String, public val unit: String, public val data: Series)

/**
 * A picture that a hook drew.
 *
 * @property title what stands above it.
 * @property mediaType `image/svg+xml` or `image/png`.
 * @property bytes the picture. An SVG is not to be put into a page as elements, since it may hold scripts, but as an image.
 */
public class HookFigure internal constructor(public val title: String, public val mediaType: String, public val bytes: ByteArray)
