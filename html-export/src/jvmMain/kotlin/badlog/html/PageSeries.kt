package badlog.html

import badlog.analysis.Series

/**
 * A line that was calculated from a recording.
 *
 * @property name its name; `/` makes folders within its hook's.
 * @property unit its unit, empty for none.
 * @property data its samples over the recording's x; x never goes back, a y may be NaN.
 */
class PageSeries(val name: String, val unit: String, val data: Series)
