package badlog.viewer.text

import badlog.core.recording.Severity

/** The displayed word for a severity. */
val Severity.word: String get() = name.lowercase()
