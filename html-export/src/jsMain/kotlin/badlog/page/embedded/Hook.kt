package badlog.page.embedded

import badlog.analysis.Series
import badlog.page.view.Finding
import badlog.recording.Value

/**
 * What a program returned that looked at the recording.
 *
 * @property name the program.
 * @property error why something is missing, or null.
 */
internal class Hook(
    val name: String,
    val error: String?,
    val values: List<Value>,
    val findings: List<Finding>,
    val series: List<HookSeries>,
    val figures: List<HookFigure>,
)

/** A line that a hook calculated; [unit] is empty for none. */
internal class HookSeries(val name: String, val unit: String, val data: Series)

/** A picture that a hook drew: its bytes in [base64]. */
internal class HookFigure(val title: String, val mediaType: String, val base64: String)
