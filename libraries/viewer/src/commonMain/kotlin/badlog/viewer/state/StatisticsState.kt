package badlog.viewer.state

import badlog.viewer.shown.statistics.ChannelOrder

/**
 * A person's choices for the statistics of graphs.
 *
 * @property range their range.
 * @property order the order of the channels of the power distribution.
 */
data class StatisticsState(val range: StatisticsRange = StatisticsRange.SHOWN, val order: ChannelOrder = ChannelOrder.CHARGE)

/** The range of statistics. */
enum class StatisticsRange {
    /** The selection, otherwise the range between both cursors, otherwise the visible range. */
    SHOWN,

    /** The time in which the robot was enabled. */
    ENABLED,

    /** All of the log. */
    ALL,
}
