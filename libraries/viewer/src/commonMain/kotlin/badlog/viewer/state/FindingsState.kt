package badlog.viewer.state

import badlog.signals.logging.LoggingLibrary

/**
 * A person's search in the findings of a log.
 *
 * @property query the text of the search; empty for none.
 * @property listed the number of listed findings beside the incidents; null for only the first few.
 * @property library the library of the lines shown for missing signals.
 * @property refusal the reason why a topic was not assigned to a signal, as a sentence; null if nothing was refused.
 */
data class FindingsState(
    val query: String = "",
    val listed: Int? = null,
    val library: LoggingLibrary = LoggingLibrary.WPILIB,
    val refusal: String? = null,
)
