package badlog.window.settings

import kotlinx.serialization.Serializable

/**
 * The widths of the parts beside the graphs, in dp.
 *
 * @property logs the width of the list of logs.
 * @property topics the width of the list of topics.
 * @property details the width of the panel on the right.
 */
@Serializable
internal data class PaneWidths(val logs: Float = 280f, val topics: Float = 240f, val details: Float = 348f) {
    /**
     * Returns the widths in a window [room] wide. A closed part has no width. No part is narrower than its minimum, and if possible, all
     * leave enough room for the graphs.
     */
    fun within(room: Float, hasLogs: Boolean, hasTopics: Boolean, hasDetails: Boolean): PaneWidths {
        val least = MIN_WIDTHS.only(hasLogs, hasTopics, hasDetails)
        val wanted = PaneWidths(
            logs = logs.from(MIN_WIDTHS.logs),
            topics = topics.from(MIN_WIDTHS.topics),
            details = details.from(MIN_WIDTHS.details),
        ).only(hasLogs, hasTopics, hasDetails)
        val spare = wanted.sum - least.sum
        val share = if (spare > 0) ((room - GRAPHS - least.sum) / spare).coerceIn(0f, 1f) else 0f
        return PaneWidths(
            logs = least.logs + (wanted.logs - least.logs) * share,
            topics = least.topics + (wanted.topics - least.topics) * share,
            details = least.details + (wanted.details - least.details) * share,
        )
    }

    /** Returns the widths after a drag [by] from the [seen] widths; invisible parts do not change. */
    fun draggedFrom(seen: PaneWidths, by: PaneWidths): PaneWidths = PaneWidths(
        logs = if (seen.logs > 0) seen.logs + by.logs else logs,
        topics = if (seen.topics > 0) seen.topics + by.topics else topics,
        details = if (seen.details > 0) seen.details + by.details else details,
    )

    private val sum get() = logs + topics + details

    private fun only(hasLogs: Boolean, hasTopics: Boolean, hasDetails: Boolean) =
        PaneWidths(if (hasLogs) logs else 0f, if (hasTopics) topics else 0f, if (hasDetails) details else 0f)

    companion object {
        /**
         * Returns whether topics and a panel leave the graphs at least half of a window [room] wide. Their default widths count, not the
         * widths to which a person drags them: no part may vanish under the pointer.
         */
        fun leaveHalf(room: Float, hasLogs: Boolean): Boolean =
            PaneWidths().only(hasLogs, hasTopics = true, hasDetails = true).sum <= room / 2

        private val MIN_WIDTHS = PaneWidths(logs = 150f, topics = 140f, details = 200f)
        private const val GRAPHS = 400f
        private const val MAX_WIDTH = 1200f

        /** Returns a valid width, since a damaged file may have any number. */
        private fun Float.from(least: Float) = if (isNaN()) least else coerceIn(least, MAX_WIDTH)
    }
}
