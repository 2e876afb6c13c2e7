package badlog.viewer.state

import badlog.viewer.shown.folder.LogColumn

/** A person's action on the list of a folder's logs. */
sealed interface FolderAction : Action {
    /** Sorts the logs by [column]; in the opposite order if they already are. */
    class Sort(val column: LogColumn) : FolderAction

    /** Checks the log at [path] for a comparison, or unchecks it. */
    data class Check(val path: String) : FolderAction

    /** Opens the log at [path]; at its worst finding if it [showsFinding]. */
    data class Open(val path: String, val showsFinding: Boolean) : FolderAction

    /** Makes the choices [state] for the statistics across logs. */
    class MeasureAcross(val state: AcrossState) : FolderAction

    /** Makes the choices [state] for the statistic of many topics. */
    class MeasureTopics(val state: TopicsState) : FolderAction
}
