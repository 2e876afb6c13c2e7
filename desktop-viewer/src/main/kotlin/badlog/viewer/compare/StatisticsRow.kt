package badlog.viewer.compare

import badlog.analysis.SeriesStatistics
import java.nio.file.Path

/**
 * A recording in the table of statistics.
 *
 * @property label the match, or else the name of the file.
 * @property date when it was recorded, as text that sorts by time; empty when not known.
 * @property path its file.
 * @property statistics of each topic that it has and that was asked for, by name.
 * @property units of those topics, by name; `ul` for none.
 * @property xUnit the unit of its x axis, null where that is not known.
 */
internal class StatisticsRow(
    val label: String,
    val date: String,
    val path: Path,
    val statistics: Map<String, SeriesStatistics>,
    val units: Map<String, String>,
    val xUnit: String? = null,
)
