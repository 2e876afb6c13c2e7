package badlog.viewer.library.index

import badlog.analysis.SeriesStatistics
import badlog.recording.TopicKind

/**
 * What is kept of a topic with numbers without its samples.
 *
 * @property name the full name.
 * @property unit the unit, `ul` for none.
 * @property statistics over all of the recording.
 * @property preview its course.
 */
internal data class TopicSummary(
    val name: String,
    val unit: String,
    val kind: TopicKind,
    val statistics: SeriesStatistics,
    val preview: PreviewLine,
)
