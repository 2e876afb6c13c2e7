package badlog.viewer.app

/**
 * Something a person waits for.
 *
 * @property id tells it from the others.
 * @property title what is being done, as the status bar says it.
 * @property share how much is done, from 0 to 1; null while that is not known.
 * @property cancel gives it up.
 */
internal data class LongTask(val id: Int, val title: String, val share: Float?, val cancel: () -> Unit)
